// SPDX-License-Identifier: MIT
// Frames that are timed pass by pass: which clock is taken, in which order, and when it is void.
// What the clock of a software renderer counts, and what it does not.
#include <crevice/renderer.h>

#include "core/run/pass_timers.h"
#include "tests/support/catch.h"
#include "tests/support/renderer_rig.h"

#include <chrono>
#include <numeric>
#include <sstream>
#include <thread>

using namespace crevice;

namespace {

bool isTiming(const std::string& line)
{
    return line == "finish" || line.find("Timer") != std::string::npos;
}

/// The log without what happens inside of passes, and the passes by name alone.
std::string order(const std::string& log)
{
    std::istringstream lines(log);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const bool pass = line.rfind("beginPass ", 0) == 0;
        if (pass) line.resize(line.find(' ', sizeof "beginPass"));
        if (pass || line == "endPass" || line == "beginFrame" || line == "endFrame" ||
            (isTiming(line) && line != "createTimer"))
            text += line + '\n';
    }
    return text;
}

std::string withoutTiming(const std::string& log)
{
    std::istringstream lines(log);
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (!isTiming(line)) text += line + '\n';
    return text;
}

FrameTimes timed(Rig& rig)
{
    rig.device.clearLog();
    const FrameTimes times = need(rig.renderer->renderTimed(rig.frame));
    CHECK(rig.device.misuse().empty());
    CHECK(times.pass_ms.size() == rig.renderer->plan().passes.size());
    return times;
}

const std::vector<double> kFourTimes = {1.5, 0.25, 4.0, 2.0};

constexpr double kSpell = 40.0;  // milliseconds
constexpr double kMostPatience = 20e3;

}  // namespace

TEST_CASE("Passes are timed by the device's timers, or by the clock with a wait around each")
{
    for (const bool timers : {false, true}) {
        Rig rig;
        if (timers) rig.device.setTimers(kFourTimes);
        const FrameTimes times = timed(rig);
        CHECK(times.method == (timers ? TimingMethod::gpu_timer : TimingMethod::wall_clock));
        std::string wanted = "finish\nbeginFrame\n";
        for (const char* pass : {"geometry", "occlusion", "filter", "lighting"})
            wanted += std::string(timers ? "beginTimer\n" : "") + "beginPass " + pass +
                      "\nendPass\n" + (timers ? "endTimer\n" : "finish\n");
        wanted += "endFrame\nfinish\n";
        if (timers) wanted += "readTimer\nreadTimer\nreadTimer\nreadTimer\n";
        CHECK(order(rig.device.log()) == wanted);
        const double sum = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
        for (const double pass : times.pass_ms) CHECK(pass >= 0);
        CHECK(sum > 0);
        CHECK(sum <= times.total_ms * 1.000001);
        if (!timers) continue;
        CHECK(times.pass_ms == kFourTimes);
        CHECK(times.total_ms == Approx(7.75));
    }
}

TEST_CASE("A void time makes the total void, and the next frame is measured again")
{
    Rig rig;
    rig.device.setTimers({1, 2, -1, 4});
    const FrameTimes disturbed = timed(rig);
    CHECK(disturbed.method == TimingMethod::gpu_timer);
    CHECK(disturbed.total_ms == -1);
    CHECK(disturbed.pass_ms[2] < 0);
    CHECK(disturbed.pass_ms[3] == 4);
    rig.device.setTimers(kFourTimes);
    CHECK(timed(rig).total_ms == Approx(7.75));
}

TEST_CASE("A timed frame draws just what an untimed one does")
{
    Rig rig;
    rig.draw();
    ++rig.frame.revision;
    const std::string untimed = rig.draw();
    CHECK(withoutTiming(untimed) == untimed);
    SECTION("by the clock") { timed(rig); }
    SECTION("by timers")
    {
        rig.device.setTimers(kFourTimes);
        timed(rig);
    }
    CHECK(withoutTiming(rig.device.log()) == untimed);
}

TEST_CASE("While frames are shown, times of earlier ones come without a wait")
{
    Rig rig;
    rig.device.setTimers(kFourTimes);
    need(rig.renderer->setTiming(true));
    rig.device.holdResults(true);
    const auto show = [&rig] {
        rig.frame.revision += 1;  // so that all passes run
        rig.device.clearLog();
        need(rig.renderer->render(rig.frame));
        return rig.device.log().find("beginTimer") != std::string::npos;
    };
    for (int i = 0; i < kTimedFrames; ++i) CHECK(show());
    CHECK(rig.renderer->times() == nullptr);
    CHECK_FALSE(show());  // the ring is full, and nothing waits
    rig.device.holdResults(false);
    CHECK(show());
    REQUIRE(rig.renderer->times());
    CHECK(rig.renderer->times()->method == TimingMethod::gpu_timer);
    CHECK(rig.renderer->times()->pass_ms == kFourTimes);
    CHECK(rig.renderer->times()->total_ms == Approx(7.75));
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("Renderers of one device measure each for itself")
{
    Rig rig;
    std::unique_ptr<Renderer> other = rig.make(rig.device);
    const auto show = [&rig](Renderer& renderer, double ms) {
        rig.device.setTimers({ms});
        rig.frame.revision += 1;  // so that all four passes run
        need(renderer.render(rig.frame));
    };
    const auto total = [](Renderer& renderer) {
        renderer.takeTimes();
        return renderer.times() ? renderer.times()->total_ms : -1;
    };
    rig.device.setTimers(kFourTimes);
    need(rig.renderer->setTiming(true));
    need(other->setTiming(true));
    show(*rig.renderer, 1);
    show(*other, 2);
    CHECK(total(*rig.renderer) == 4);
    CHECK(total(*other) == 8);
    show(*rig.renderer, 3);
    show(*other, 4);
    rig.device.setTimers({5});
    CHECK(need(rig.renderer->renderTimed(rig.frame)).total_ms == 20);
    other.reset();
    CHECK(total(*rig.renderer) == 12);
    rig.renderer.reset();
    CHECK(rig.device.live(ObjectId::Kind::timer) == 0);
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("While frames are shown, a texel of an earlier one comes without a wait")
{
    Rig rig;
    const auto show = [&rig] {
        rig.draw();
        const std::array<float, 4>* const texel = rig.renderer->value("ao");
        return texel ? (*texel)[0] : -1.0f;
    };
    CHECK(show() == -1);
    CHECK_FALSE(rig.logged("beginRead"));
    rig.renderer->follow("ao");
    rig.renderer->follow("ao");
    rig.renderer->follow("none of that name");
    const auto write = [&rig](float value) {
        const TextureId ao = rig.renderer->output("ao");
        need(rig.device.writeTexture(ao, Image({64, 32}, 1, value)));
    };
    write(0.25f);
    CHECK(show() == -1);
    CHECK(rig.logged("beginRead"));
    rig.device.holdResults(true);
    write(0.5f);
    CHECK(show() == -1);
    CHECK_FALSE(rig.logged("beginRead"));  // one at a time
    rig.device.holdResults(false);
    CHECK(show() == 0.25f);
    const auto other = rig.make(rig.device);  // which reads for itself
    other->follow("ao");
    need(other->render(rig.frame));
    CHECK(show() == 0.5f);
    need(rig.renderer->setParam("intensity", 0));  // a new plan
    CHECK(show() == -1);
    CHECK(show() == 0);
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("Passes that were left out took nothing")
{
    Rig rig;
    rig.device.setTimers(kFourTimes);
    need(rig.renderer->setTiming(true));
    for (int i = 0; i < 3; ++i) need(rig.renderer->render(rig.frame));
    REQUIRE(rig.renderer->times());
    CHECK(rig.renderer->times()->pass_ms == std::vector<double>(4, 0.0));
    CHECK(rig.renderer->times()->total_ms == 0);
}

TEST_CASE("Timing goes on after a new plan, and says where nothing can be measured")
{
    Rig rig;
    const Status without = rig.renderer->setTiming(true);
    REQUIRE(without.diagnostics().size() == 1);
    CHECK(without.ok());
    CHECK(without.diagnostics()[0].code == Code::no_timers);
    need(rig.renderer->render(rig.frame));
    CHECK(rig.renderer->times() == nullptr);

    rig.device.setTimers(kFourTimes);
    need(rig.renderer->setTiming(true));
    need(rig.renderer->render(rig.frame));
    need(rig.renderer->render(rig.frame));
    CHECK(rig.renderer->times() != nullptr);
    need(rig.renderer->resize({32, 16}));
    CHECK(rig.renderer->times() == nullptr);
    need(rig.renderer->render(rig.frame));
    need(rig.renderer->render(rig.frame));
    CHECK(rig.renderer->times() != nullptr);
    need(rig.renderer->setTiming(false));
    CHECK(rig.renderer->times() == nullptr);
}

TEST_CASE("A software renderer's clock stands still while the process waits")
{
    const FrameClock processor(true), wall(false);
    REQUIRE(processor.method() == TimingMethod::processor_time);
    REQUIRE(wall.method() == TimingMethod::wall_clock);
    const double begin = processor.now(), wall_begin = wall.now();
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kSpell));
    CHECK(processor.now() - begin < kSpell / 2);
    CHECK(wall.now() - wall_begin >= kSpell * 0.99);
}

TEST_CASE("A software renderer's clock counts the work of other threads")
{
    const FrameClock processor(true), wall(false);
    const double begin = processor.now(), wall_begin = wall.now();
    std::thread worker([&] {
        while (processor.now() - begin < kSpell && wall.now() - wall_begin < kMostPatience)
            continue;
    });
    worker.join();
    CHECK(processor.now() - begin >= kSpell);
}
