// SPDX-License-Identifier: MIT
// Frames of two views, drawn for real: each view's picture is that of its camera alone.
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {96, 54};

/// A config over a scene in a GL context, with a renderer for each of several frames side by side.
struct Stage {
    explicit Stage(const std::string& config_name)
        : description(need(
              decode(need(loadConfig(shippedSources(), {config_name, {}, {}})), shippedSources()))),
          set(need(loadScene("spheres"))),
          uploaded(need(UploadedScene::upload(*gl.device, set)))
    {
    }

    std::unique_ptr<Renderer> renderer(const Frame& frame)
    {
        return need(Renderer::create(*gl.device, description, {kExtent}, traitsOf(frame)));
    }

    /// A frame from a place that moves with time, off-centre by `shift` pictures.
    Frame seen(double right, double shift, int time)
    {
        const std::string x = std::to_string(1.0 + right + 0.05 * time);
        const std::string camera = "eye=" + x + ",1.5,4;at=" + std::to_string(right) +
                                   ",0.5,0;fov=45;shift=" + std::to_string(shift) + ",0.05";
        const double aspect = double(kExtent.width) / kExtent.height;
        return makeFrame(uploaded, need(chooseCamera(set, uploaded.bounds(), camera, aspect)),
                         kExtent);
    }

    GlFixture gl;
    Description description;
    Scene set;
    UploadedScene uploaded;
};

Frame together(const Frame& left, const Frame& right)
{
    Frame both = left;
    both.other_views = {{right.camera, {}}};
    return both;
}

}  // namespace

TEST_CASE("Each view of a frame is the picture of its camera alone, bit for bit")
{
    const std::string config = GENERATE("learnopengl", "gtao", "gtao_temporal");
    INFO(config);
    Stage stage(config);
    const auto left = [&](int time) { return stage.seen(-0.1, 0.08, time); };
    const auto right = [&](int time) { return stage.seen(0.1, -0.08, time); };
    auto left_alone = stage.renderer(left(0));
    auto right_alone = stage.renderer(right(0));
    auto both = stage.renderer(together(left(0), right(0)));
    for (int time = 0; time < 4; ++time) {
        need(left_alone->render(left(time)));
        need(right_alone->render(right(time)));
        need(both->render(together(left(time), right(time))));
        for (const PlanOutput& output : both->plan().outputs) {
            INFO(output.name << " of frame " << time);
            const Image alone = stage.gl.read(left_alone->output(output.name));
            const Image right_eye = stage.gl.read(both->output(output.name, 1));
            CHECK(stage.gl.read(both->output(output.name, 0)).pixels == alone.pixels);
            CHECK(right_eye.pixels == stage.gl.read(right_alone->output(output.name)).pixels);
            CHECK(meanChange(alone, right_eye) > 0.001);
        }
    }
}

TEST_CASE("A host's depth texture for each view is seen by that view")
{
    Stage stage("learnopengl");
    stage.description.outputs = {OutputDesc{}};
    stage.description.outputs[0].name = "depth";
    stage.description.outputs[0].target.name = "depth";
    const Frame left = stage.seen(-0.2, 0.0, 0), right = stage.seen(0.2, 0.0, 0);
    auto host = stage.renderer(together(left, right));
    need(host->render(together(left, right)));

    MemorySources mine;
    mine.add("configs/mine.json", R"({"format": 1, "extends": ["geometry/host_depth",
        "ssao/hemisphere", "filter/none"]})");
    const LayeredSources sources({&mine, &shippedSources()});
    stage.description = need(decode(need(loadConfig(sources, {"mine", {}, {}})), sources));
    const auto with = [&](Frame frame, int view) {
        frame.textures = {{"depth", host->output("depth", view)}};
        return frame;
    };
    Frame both = together(with(left, 0), right);
    both.other_views[0].textures = with(right, 1).textures;
    auto stereo = stage.renderer(both);
    auto alone = stage.renderer(right);
    need(stereo->render(both));
    need(alone->render(with(right, 1)));
    const Image wanted = stage.gl.read(alone->output("ao"));
    CHECK(mean(wanted) < 0.99);
    CHECK(stage.gl.read(stereo->output("ao", 1)).pixels == wanted.pixels);
}
