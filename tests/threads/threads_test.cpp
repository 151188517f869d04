// SPDX-License-Identifier: MIT
// Threads side by side, each with a device and effects of its own, do what one does alone, call by
// call. No GL: so the thread sanitizer sees everything (the preset `tsan`).
#include <crevice/config.h>
#include <crevice/effect.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tests/support/catch.h"

#include <algorithm>
#include <atomic>
#include <thread>

using namespace crevice;

namespace {

constexpr int kThreads = 3;
constexpr Extent kExtent = {64, 36};

/// What was done for each config: calls of the device, and messages.
using Work = std::map<std::string, std::string>;

std::string onHostDepth(const std::string& config)
{
    return R"({ "format": 1, "name": "ao", "extends": [")" + config +
           R"(", "geometry/host_depth"] })";
}

/// Frames with all that may change between them; errors are part of what is compared.
void drawFrames(Effect& effect, std::string& said)
{
    const auto note = [&said](const Status& status) { said += toText(status.diagnostics()); };
    note(effect.setTexture("depth", 7, Format::depth24, kExtent));
    note(effect.render());
    note(effect.setParam("radius", 0.7f));
    note(effect.setParam("no_such_param", 1));
    note(effect.setFeature("quality", "low"));
    note(effect.render());
    note(effect.resize({32, 18}));
    note(effect.render());
    Description again = effect.renderer().description();
    CompileOptions options;
    options.extent = kExtent;
    note(effect.renderer().reload(std::move(again), options));
    note(effect.render());
}

std::string workOf(const std::string& config)
{
    std::string said;
    RecordingDevice device;
    {
        Result<Effect> effect = Effect::create(device, config, kExtent);
        said = toText(effect.diagnostics());
        if (effect) drawFrames(*effect, said);
    }
    return said + device.log();
}

/// Every shipped config, as it is and on a host's depth, beginning with another one in each thread.
Work workFrom(int thread)
{
    std::vector<std::string> configs = configNames(shippedSources());
    const auto first = static_cast<std::size_t>(thread) * configs.size() / kThreads;
    std::rotate(configs.begin(), configs.begin() + static_cast<std::ptrdiff_t>(first),
                configs.end());
    Work work;
    for (const std::string& config : configs) {
        work[config] = workOf(config);
        work[onHostDepth(config)] = workOf(onHostDepth(config));
    }
    return work;
}

/// The first config for which they differ; "" where none does.
std::string difference(const Work& a, const Work& b)
{
    for (const auto& [config, done] : a)
        if (b.at(config) != done) return config;
    return "";
}

}  // namespace

TEST_CASE("Threads, each with a device and effects of its own, do what one thread does")
{
    // They go first, so that they race for whatever is made on the first use.
    std::vector<Work> works(kThreads);
    std::atomic<int> waiting{kThreads};
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i)
        threads.emplace_back([&, i] {
            for (--waiting; waiting > 0;) std::this_thread::yield();
            works[i] = workFrom(i);
        });
    for (std::thread& thread : threads) thread.join();
    const Work alone = workFrom(0);
    CHECK(alone.size() > 40);
    CHECK(alone.at(onHostDepth("mobile")).find("drawFullscreen") != std::string::npos);
    for (const Work& work : works) CHECK(difference(alone, work) == "");
}
