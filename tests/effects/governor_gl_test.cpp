// SPDX-License-Identifier: MIT
// Levels drawn for real: each is the picture of its config, no step compiles, histories go on.
#include <crevice/effect.h>
#include <crevice/governor.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {128, 72};

/// A scene in an effect that is governed, and how many programs were asked for.
struct Governed {
    explicit Governed(std::vector<FrontLevel> levels, KeptPrograms& kept)
        : rig(need(loadScene("room")), kExtent, kept.options()),
          effect(need(Effect::create(*rig.device, levels.front().name, kExtent, {"ao"})))
    {
        effect.frame() = rig.frame();
        need(effect.govern(std::move(levels), {1e6}));
        need(effect.render());
    }

    Image draw(int level, int frames = 1)
    {
        effect.governor()->stayAt(level);
        for (int i = 0; i < frames; ++i) need(effect.render());
        CHECK(effect.renderer().level() == level);
        return rig.read(effect.output("ao"));
    }

    SceneRig rig;
    Effect effect;
};

}  // namespace

TEST_CASE("A level is the picture of its config, and no step to it asks for a program")
{
    const std::vector<FrontLevel> levels = {{{"mobile_low"}, {"radius=0.5"}, 1},
                                            {{"mobile"}, {"radius=1", "slices=1"}, 2},
                                            {{"balanced"}, {}, 3}};
    KeptPrograms kept;
    std::vector<Image> wanted;
    for (const FrontLevel& level : levels) {
        SceneRig rig("room", kExtent);
        const LoadRequest request{level.name, {}, level.set};
        const Description description =
            need(decode(need(loadConfig(shippedSources(), request)), shippedSources()));
        wanted.push_back(rig.draw(description, rig.frame()));
    }
    Governed governed(levels, kept);
    const int loads = kept.loads;
    REQUIRE(loads > 0);
    for (const int level : {0, 2, 1, 0, 1, 2}) {
        INFO(level);
        CHECK(meanChange(governed.draw(level), wanted[std::size_t(level)]) == 0);
    }
    CHECK(kept.loads == loads);
    CHECK(meanChange(wanted[0], wanted[2]) > 0.005);
}

TEST_CASE("A mean over frames goes on at another level of the same shape, and not after a cut")
{
    KeptPrograms kept;
    Governed governed({{{"gtao_temporal"}, {"radius=1", "steps=2"}, 1},
                       {{"gtao_temporal"}, {"radius=1", "steps=4"}, 2}},
                      kept);
    const Image settled = governed.draw(1, 48);
    Governed fresh({{{"gtao_temporal"}, {"radius=1", "steps=2"}, 1}}, kept);
    fresh.effect.frame().camera_cut = true;
    const double anew = meanChange(fresh.draw(0), settled);
    CHECK(meanChange(governed.draw(0), settled) < 0.5 * anew);
    CHECK(meanChange(governed.draw(1), settled) < 0.5 * anew);
    governed.effect.frame().camera_cut = true;
    CHECK(meanChange(governed.draw(0), settled) > 0.8 * anew);
}
