// SPDX-License-Identifier: MIT
// What presets with a mean over frames promise against the same config without: less error at rest
// and after the camera has jumped, and a picture that stands still where the camera does.
#include "tests/support/gl_fixture.h"
#include "tools/image/image_metrics.h"
#include "tools/reference/tracer.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <string>
#include <vector>

using namespace crevice;

namespace {

constexpr Extent kExtent = {192, 108};
constexpr double kAspect = 192.0 / 108.0;
constexpr int kSettled = 32;  ///< Frames by which a still picture stands still.

const char* const kHere = "eye=3.2,2,4.2;at=0,0.6,0;fov=50";
const char* const kAside = "eye=2.2,2,4.2;at=-1,0.6,0;fov=50";

/// The room, drawn by a preset.
class Preset {
public:
    Preset(const std::string& name, std::vector<std::string> overrides)
    {
        overrides.push_back("radius=1");
        const Node document = need(loadConfig(shippedSources(), {name, {}, overrides}));
        look(kHere);
        renderer_ = need(Renderer::create(*gl_.device, need(decode(document, shippedSources())),
                                          {kExtent, {"ao"}, {}}, traitsOf(frame_)));
    }

    void look(const char* camera)
    {
        frame_ = makeFrame(
            uploaded_, need(chooseCamera(scene_, uploaded_.bounds(), camera, kAspect)), kExtent);
    }

    Image draw(int frames)
    {
        for (int i = 0; i < frames; ++i) need(renderer_->render(frame_));
        return gl_.read(renderer_->output("ao"));
    }

    Image truth()
    {
        TraceOptions options;
        options.rays = 64;
        options.radius = 1;
        return need(traceAmbientOcclusion(scene_, frame_.camera, kExtent, options));
    }

private:
    GlFixture gl_;
    Scene scene_ = need(loadScene("room"));
    UploadedScene uploaded_ = need(UploadedScene::upload(*gl_.device, scene_));
    Frame frame_;
    std::unique_ptr<Renderer> renderer_;
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

double rmseOf(const Image& drawn, const Image& truth)
{
    return need(compareImages(drawn, truth)).rmse;
}

}  // namespace

TEST_CASE("Under a still camera the picture stands still after 32 frames, also after it has moved")
{
    for (const Pair& pair : kPairs) {
        INFO(pair.preset);
        Preset preset(pair.preset, {});
        for (const char* camera : {kAside, kHere}) {
            preset.look(camera);
            const Image settled = preset.draw(kSettled);
            CHECK(need(compareImages(preset.draw(1), settled)).rmse == 0.0);
            CHECK(need(compareImages(preset.draw(8), settled)).rmse == 0.0);
        }
    }
}

TEST_CASE("What a moving camera has gathered gives way to what a still one sees")
{
    for (const Pair& pair : kPairs) {
        Preset preset(pair.preset, {});
        preset.look(kHere);
        const Image fresh = preset.draw(kSettled);
        for (int step = 1; step <= 24; ++step) {
            const std::string x = std::to_string(3.2 - 0.01 * (24 - step));
            preset.look(("eye=" + x + ",2,4.2;at=0,0.6,0;fov=50").c_str());
            preset.draw(1);
        }
        const double gathered = rmseOf(preset.draw(1), fresh);
        const double later = rmseOf(preset.draw(kSettled), fresh);
        INFO(pair.preset << ": " << gathered << ", then " << later);
        CHECK(3.0 * later < gathered);
    }
}

TEST_CASE("A mean over frames errs less than each frame does, at rest and four frames after a jump")
{
    for (const Pair& pair : kPairs) {
        Preset preset(pair.preset, {});
        Preset single(pair.preset, {pair.without_history});
        const Image truth = preset.truth();
        const double without = rmseOf(single.draw(1), truth);
        const double rest = rmseOf(preset.draw(kSettled), truth);
        preset.look(kAside);
        preset.draw(kSettled);
        preset.look(kHere);
        const double jumped = rmseOf(preset.draw(4), truth);
        INFO(pair.preset << ": " << rest << " at rest, " << jumped << " after a jump, " << without
                         << " without a history");
        CHECK(rest < 0.98 * without);
        CHECK(jumped < without);
    }
}
