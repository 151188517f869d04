// SPDX-License-Identifier: MIT
// Warming on a device that draws nothing: what it draws, and that no frame can tell.
#include "core/base/text.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/shipped_subjects.h"

#include <set>
#include <sstream>

using namespace crevice;

namespace {

/// What a driver may compile for: by pass its framebuffer, programs with state, textures, meshes.
std::set<std::string> compiledFor(const std::string& log)
{
    std::set<std::string> all;
    std::istringstream lines(log);
    std::string line, pass;
    while (std::getline(lines, line)) {
        if (line.rfind("beginPass", 0) == 0) pass = line.substr(0, line.find(' ', 10));
        const bool counts = anyOf(std::vector<const char*>{"setProgram", "setTexture", "draw"},
                                  [&](const char* word) { return line.rfind(word, 0) == 0; });
        if (counts) all.insert(pass + ": " + line);
    }
    return all;
}

/// Warms what a rig draws, and tells what that drew. There is one pixel of one pass in each call.
std::string warm(Rig& rig)
{
    std::string all;
    std::size_t calls = 0;
    for (bool ready = false; !ready; ++calls) {
        rig.device.clearLog();
        ready = need(rig.renderer->warm(rig.frame));
        CHECK(occurrences(rig.device.log(), " within 0 0 1x1") == 1);
        all += rig.device.log();
    }
    CHECK(calls == rig.renderer->plan().passes.size());
    return all;
}

bool isWarm(Rig& rig)
{
    rig.device.clearLog();
    return need(rig.renderer->warm(rig.frame)) && rig.device.log().empty();
}

}  // namespace

TEST_CASE("Warming draws a pixel of each pass as the first frame will, which stays what it was")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Description description = descriptionOf({name});
        Rig cold, rig;
        for (Rig* each : {&cold, &rig}) {
            each->frame.draws[0].bounds_radius = 1;  // which boxes ask for
            each->use(description);
        }
        const std::string frame = cold.draw(), next = cold.draw();
        CHECK(compiledFor(warm(rig)) == compiledFor(frame));
        CHECK(rig.draw() == frame);
        CHECK(rig.draw() == next);
        CHECK(isWarm(rig));
    }
}

TEST_CASE(
    "A failed pass is warmed again, a new plan anew, and a history goes on as if nothing had been")
{
    Rig rig(true), other(true);
    rig.device.failFrame();
    CHECK_FALSE(rig.renderer->warm(rig.frame).ok());
    const auto compare = [&] {
        const std::string frame = other.draw();
        CHECK(compiledFor(warm(rig)) == compiledFor(frame));
        CHECK(rig.draw() == frame);
        CHECK(isWarm(rig));
    };
    compare();
    for (Rig* each : {&rig, &other}) need(each->renderer->resize({32, 16}));
    compare();
    for (Rig* each : {&rig, &other}) need(each->renderer->setParam("edge", 0.25f));
    compare();
}
