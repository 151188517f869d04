// SPDX-License-Identifier: MIT
// Contexts: several at once, switched back and forth.
// A host's locale changes no pixel: shaders are assembled and pictures drawn while it is in force.
// Frames timed for real. No absolute time is asserted: machines are shared and noisy.
// The configs of the corpus whose mistake only a driver sees: GLSL that does not compile.
#include "tests/support/gl_fixture.h"

#include "backends/gl/timers.h"
#include "tests/backends/stage.h"
#include "tests/support/bad_corpus.h"
#include "tests/support/catch.h"
#include "tests/support/comma_locale.h"

#include <numeric>

namespace crevice {

namespace {

/// A context with a device and one pixel to clear.
struct Room {
    explicit Room(std::unique_ptr<Context> made)
        : context(std::move(made)),
          device(need(makeGlDevice(context->loader())))
    {
        pixel = need(device->createTexture({"pixel", Format::rgba8, {1, 1}}));
        framebuffer = need(device->createFramebuffer({"pixel", {pixel}, {}}));
    }

    ~Room()
    {
        (void)context->makeCurrent();
        device.reset();
    }

    void clear(float value)
    {
        need(context->makeCurrent());
        PassInfo pass = wholePass(framebuffer, {1, 1});
        pass.clear_color[0][0] = value;
        need(device->beginFrame());
        device->beginPass(pass);
        device->endPass();
        need(device->endFrame());
    }

    float read()
    {
        need(context->makeCurrent());
        return need(device->readTexture(pixel)).at(0, 0);
    }

    std::unique_ptr<Context> context;
    std::unique_ptr<Device> device;
    TextureId pixel;
    FramebufferId framebuffer;
};

void takeTurns(Room& first, Room& second)
{
    for (int turn = 0; turn < 3; ++turn) {
        first.clear(turn % 2 ? 1.0f : 0.0f);
        second.clear(turn % 2 ? 0.0f : 1.0f);
        CHECK(first.read() == (turn % 2 ? 1.0f : 0.0f));
        CHECK(second.read() == (turn % 2 ? 0.0f : 1.0f));
        CHECK(first.read() == (turn % 2 ? 1.0f : 0.0f));
    }
}

}  // namespace

TEST_CASE("EGL and OSMesa live in one process")
{
    Result<std::unique_ptr<Context>> egl = makeEglContext();
    Result<std::unique_ptr<Context>> osmesa = makeOsmesaContext();
    if (!egl || !osmesa) {
        WARN("one of the two is not there");
        return;
    }
    need((*egl)->makeCurrent());
    Room first(std::move(*egl));
    need((*osmesa)->makeCurrent());
    Room second(std::move(*osmesa));
    takeTurns(first, second);
}

TEST_CASE("Shipped configs draw the same bits under a locale with a decimal comma")
{
    GlFixture gl;
    const Stage stage(*gl.device);
    const std::vector<Subject> subjects = sampledSubjects();
    const auto draw = [&stage](const Subject& subject) {
        return stage.draw(*stage.make(descriptionOf(subject)));
    };
    std::vector<Pixels> ordinary;
    for (const Subject& subject : subjects) ordinary.push_back(draw(subject));
    const auto locale = commaLocale();
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        INFO(subjects[i].config);
        CHECK((draw(subjects[i]) == ordinary[i]));
    }
}

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
    GlTimer timer;
    const TextureId target = gl.texture(Format::rgba8, {64, 64});
    const ProgramId program = gl.program("out vec4 color; void main() { color = vec4(1.0); }");
    CHECK(timers.exist() == (api.GetQueryObjectui64v != nullptr));
    if (!timers.exist()) return;
    timers.begin(api, timer);
    gl.drawInto(target, program, {64, 64});
    timers.end(api);
    CHECK(timers.read(api, timer) >= 0);
    CHECK(timers.read(api, {}) < 0);
    CHECK(takeErrors(api, "timers").ok());
}

TEST_CASE_METHOD(GlFixture,
                 "GLSL of the corpus that does not compile is reported in its author's line")
{
    int checked = 0;
    for (const CorpusCase& config : corpus().cases()) {
        if (!config.options.find("driver")) continue;
        const Diagnostics reported = diagnosticsOf(config, *device);
        checkReported(config, reported);
        ++checked;
    }
    CHECK(checked >= 3);
}

}  // namespace crevice
