// SPDX-License-Identifier: MIT
// Frames timed for real. No absolute time is asserted: machines are shared and noisy.
#include "backends/gl/timers.h"
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"

#include <numeric>

namespace crevice {

TEST_CASE_METHOD(GlFixture, "each pass takes time, and all together no more than the frame")
{
    Stage stage(*device, {256, 144});
    const auto timed = stage.make("learnopengl");
    FrameTimes times = need(timed->renderTimed(stage.frame));
    for (int i = 0; i < 10 && times.total_ms < 0; ++i)
        times = need(timed->renderTimed(stage.frame));
    REQUIRE(times.total_ms >= 0);
    REQUIRE(times.pass_ms.size() == timed->plan().passes.size());
    for (double pass : times.pass_ms) CHECK(pass > 0);
    const double sum = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
    CHECK(sum <= times.total_ms * 1.000001);
    if (device->caps().software) CHECK(times.method == TimingMethod::processor_time);
    const Pixels shown = stage.shown(*timed);
    ++stage.frame.revision;
    CHECK((stage.draw(*timed) == shown));  // of an untimed frame
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
