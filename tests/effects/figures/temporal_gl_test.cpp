// SPDX-License-Identifier: MIT
// What presets with a mean over frames promise against the same config without: less error at rest
// and after the camera has jumped, and a picture that stands still where the camera does.
#include "tests/support/scene_rig.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_metrics.h"

using namespace crevice;

namespace {

const char* const kHere = "eye=3.2,2,4.2;at=0,0.6,0;fov=50";
const char* const kAside = "eye=2.2,2,4.2;at=-1,0.6,0;fov=50";

double rmseOf(const Image& drawn, const Image& truth)
{
    return need(compareImages(drawn, truth)).rmse;
}

/// The room, drawn by a preset.
struct Preset : SceneRig {
    Preset(const std::string& name, std::vector<std::string> overrides)
        : SceneRig("room", {192, 108})
    {
        overrides.push_back("radius=1");
        preset = renderer(descriptionOf({name}, overrides), now, {"ao"});
    }

    Image drawn(int frames)
    {
        for (int i = 0; i < frames; ++i) need(preset->render(now));
        return read(preset->output("ao"));
    }

    /// What a still camera sees after 32 frames, and from then on.
    Image settled()
    {
        const Image still = drawn(32);
        CHECK(rmseOf(drawn(1), still) == 0.0);
        CHECK(rmseOf(drawn(8), still) == 0.0);
        return still;
    }

    Image truth() const
    {
        TraceOptions options;
        options.rays = 64;
        options.radius = 1;
        return need(traceAmbientOcclusion(scene, now.camera, extent, options));
    }

    Frame now = frame(kHere);
    std::unique_ptr<Renderer> preset;
};

struct Pair {
    const char* preset;
    const char* without_history;
};

const Pair kPairs[] = {
    {"mobile_temporal", "filter/temporal_upsample=filter/upsample"},
    {"balanced_temporal", "filter/temporal_upsample=filter/upsample"},
    {"gtao_temporal", "filter/temporal_bilateral=filter/bilateral_normal"},
};

}  // namespace

TEST_CASE(
    "A mean over frames errs less than each frame, stands still, and gives way to what is new")
{
    for (const Pair& pair : kPairs) {
        INFO(pair.preset);
        Preset preset(pair.preset, {}), single(pair.preset, {pair.without_history});
        const Image truth = preset.truth();
        const double without = rmseOf(single.drawn(1), truth);
        const Image fresh = preset.settled();
        const double rest = rmseOf(fresh, truth);
        preset.now = preset.frame(kAside);
        preset.settled();
        preset.now = preset.frame(kHere);
        const double jumped = rmseOf(preset.drawn(4), truth);
        INFO(rest << " at rest, " << jumped << " after a jump, " << without << " alone");
        CHECK(rest < 0.98 * without);
        CHECK(jumped < without);

        for (int step = 1; step <= 24; ++step) {
            const std::string x = std::to_string(3.2 - 0.01 * (24 - step));
            preset.now = preset.frame("eye=" + x + ",2,4.2;at=0,0.6,0;fov=50");
            preset.drawn(1);
        }
        const double gathered = rmseOf(preset.drawn(1), fresh);
        const double later = rmseOf(preset.settled(), fresh);
        INFO(gathered << " gathered by a walk, then " << later);
        CHECK(3.0 * later < gathered);
    }
}
