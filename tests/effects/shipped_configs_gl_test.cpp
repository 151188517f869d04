// SPDX-License-Identifier: MIT
// Every shipped config and variant, drawn for real. What else holds for them `crevice stress` asks,
// and tools/scripts/guard_bench.sh knows how far each is from the ground truth.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/stress/scenes.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {128, 72};

/// A floor before a wall, in such units.
struct Corner {
    Corner(Device& device, double scene_unit)
        : unit(scene_unit),
          scene(need(UploadedScene::upload(
              device, placed(cornerScene(), glm::scale(glm::dmat4(1.0), glm::dvec3(scene_unit)))))),
          frame(makeFrame(scene, SceneCamera(), kExtent))
    {
        StressView view;
        view.eye = glm::dvec3(0, 1, 4) * unit;
        view.near_distance *= unit;
        view.far_distance *= unit;
        frame.camera = cameraOf(view, kExtent);
    }

    Description inUnits(Description description) const
    {
        for (ParamDesc& param : description.params)
            if (param.unit == "scene units") param.value[0] *= static_cast<float>(unit);
        return description;
    }

    double unit;
    UploadedScene scene;
    Frame frame;
};

}  // namespace

TEST_CASE("Every shipped config darkens a corner, in any units, and nothing with an intensity of 0")
{
    DrawRig rig;
    const Corner corner(*rig.device, 1), large(*rig.device, 1000);
    for (const Subject& subject : subjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = descriptionOf(subject);
        Renderer& drawn = rig.reloaded(description, corner.frame, {kExtent, {}, {}});
        need(drawn.render(corner.frame));
        const Image ao = rig.read(drawn.output("ao"));
        CHECK(allVisibility(ao));
        CHECK(meanOfRows(ao, 13, 16) < meanOfRows(ao, 1, 6) - 0.02);
        CHECK(shareBelow(rig.read(drawn.output("color")), 0.02f) < 0.01);
        CHECK(meanChange(rig.draw(large.inUnits(description), large.frame), ao) < 0.003);
        CHECK(least(rig.draw(descriptionOf(subject, {"intensity=0"}), corner.frame)) == 1.0f);
    }
}
