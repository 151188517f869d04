// SPDX-License-Identifier: MIT
// Frames timed for real. No absolute time is asserted: machines are shared and noisy.
#include "backends/gl/timers.h"
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"

#include <algorithm>
#include <numeric>

namespace crevice {

namespace {

/// A device with a scene, drawn by one config at several costs.
struct TimedStage : GlFixture {
    Stage stage{*device, {256, 144}};

    std::unique_ptr<Renderer> renderer(const std::string& setting) const
    {
        return stage.make(descriptionOf({"learnopengl"}, {setting}));
    }

    /// Draws until a measurement is valid.
    FrameTimes time(Renderer& renderer)
    {
        FrameTimes times = need(renderer.renderTimed(stage.frame));
        for (int i = 0; i < 10 && times.total_ms < 0; ++i)
            times = need(renderer.renderTimed(stage.frame));
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

TEST_CASE_METHOD(TimedStage, "each pass takes time, and all together no more than the frame")
{
    const auto timed = renderer("samples=8");
    const FrameTimes times = time(*timed);
    REQUIRE(times.pass_ms.size() == timed->plan().passes.size());
    for (double pass : times.pass_ms) CHECK(pass > 0);
    const double sum = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
    CHECK(sum <= times.total_ms * 1.000001);
    if (device->caps().software) CHECK(times.method == TimingMethod::processor_time);
    const Image shown = read(timed->output("ao"));
    ++stage.frame.revision;
    need(timed->render(stage.frame));
    CHECK(read(timed->output("ao")).pixels == shown.pixels);  // of an untimed frame
}

TEST_CASE_METHOD(TimedStage, "a pass that does more work takes longer")
{
    const auto heavy = renderer("samples=64"), light = renderer("samples=2");
    CHECK(shortest(*heavy, "ssao") > shortest(*light, "ssao"));
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
