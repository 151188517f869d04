// SPDX-License-Identifier: MIT
// Frames timed for real. No absolute time is asserted: machines are shared and noisy.
#include <crevice/renderer.h>

#include <crevice/config.h>
#include <crevice/shipped.h>

#include "backends/gl/timers.h"
#include "tests/support/gl_fixture.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <algorithm>
#include <numeric>

namespace crevice {

namespace {

constexpr Extent kExtent = {256, 144};

/// A scene on a device, to be drawn with one config or another.
struct Stage {
    GlFixture gl;
    Scene scene = need(loadScene("spheres"));
    UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    SceneCamera camera = need(chooseCamera(scene, uploaded.bounds(), "", 16.0 / 9.0));
    Frame frame = makeFrame(uploaded, camera, kExtent);

    std::unique_ptr<Renderer> renderer(const std::string& setting)
    {
        const SourceSet& sources = shippedSources();
        const Node document = need(loadConfig(sources, {"learnopengl", {}, {setting}}));
        return need(Renderer::create(*gl.device, need(decode(document, sources)), {kExtent},
                                     traitsOf(frame)));
    }

    /// Draws until a measurement is valid.
    FrameTimes time(Renderer& renderer)
    {
        FrameTimes times = need(renderer.renderTimed(frame));
        for (int i = 0; i < 10 && times.total_ms < 0; ++i)
            times = need(renderer.renderTimed(frame));
        REQUIRE(times.total_ms >= 0);
        return times;
    }

    /// The shortest time of that pass over a few frames, the first of which warms up.
    double shortest(Renderer& renderer, const std::string& pass)
    {
        const auto& passes = renderer.plan().passes;
        const auto found = std::find_if(passes.begin(), passes.end(),
                                        [&](const PlanPass& each) { return each.name == pass; });
        REQUIRE(found != passes.end());
        double least = time(renderer).pass_ms[found - passes.begin()];
        for (int i = 0; i < 4; ++i)
            least = std::min(least, time(renderer).pass_ms[found - passes.begin()]);
        return least;
    }
};

}  // namespace

TEST_CASE("each pass takes time, and all together no more than the frame")
{
    Stage stage;
    const auto renderer = stage.renderer("samples=8");
    const FrameTimes times = stage.time(*renderer);
    REQUIRE(times.pass_ms.size() == renderer->plan().passes.size());
    for (double pass : times.pass_ms) CHECK(pass > 0);
    const double sum = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
    CHECK(sum <= times.total_ms * 1.000001);
}

TEST_CASE("a pass that does more work takes longer")
{
    Stage stage;
    const auto heavy = stage.renderer("samples=64");
    const auto light = stage.renderer("samples=2");
    CHECK(stage.shortest(*heavy, "ssao") > stage.shortest(*light, "ssao"));
}

TEST_CASE("a software renderer is timed by processor time, whatever extensions it has")
{
    Stage stage;
    if (!stage.gl.device->caps().software) return;
    CHECK(stage.time(*stage.renderer("samples=2")).method == TimingMethod::processor_time);
}

TEST_CASE("a timed frame draws the picture of an untimed one")
{
    Stage stage;
    const auto renderer = stage.renderer("samples=8");
    need(renderer->render(stage.frame));
    const Image untimed = stage.gl.read(renderer->output("ao"));
    need(renderer->renderTimed(stage.frame));
    CHECK(stage.gl.read(renderer->output("ao")).pixels == untimed.pixels);
}

// Here the software renderer's queries are good enough: they must run and give something.
TEST_CASE("timer queries run without errors where the context has them")
{
    GlFixture gl;
    GlApi api = need(loadGlApi(testContext().loader()));
    const GlInfo info = need(readInfo(api, false));
    settleOptional(api, info, testContext().loader());
    GlTimers timers = GlTimers::make(api, info);
    const TextureId target = gl.texture(Format::rgba8, {64, 64});
    const ProgramId program = gl.program("out vec4 color; void main() { color = vec4(1.0); }");
    const bool began = timers.begin(api, 3);
    CHECK(began == (api.GetQueryObjectui64v != nullptr));
    if (!began) return;
    gl.drawInto(target, program, {64, 64});
    timers.end(api);
    CHECK(timers.read(api, 3) >= 0);
    CHECK(timers.read(api, 0) < 0);
    CHECK(takeErrors(api, "timers").ok());
}

}  // namespace crevice
