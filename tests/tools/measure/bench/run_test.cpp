// SPDX-License-Identifier: MIT
// A bench without GL: failures, going on after a stop, and what comes first.
#include "tools/measure/bench/bench.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/small.h"

using namespace crevice;

namespace {

/// On a device on which one config fails.
MeasureSummary run(const TemporaryFolder& folder, const BenchPlan& plan,
                   const std::string& fails = "")
{
    BenchFile file = need(openBench(folder.path.string()));
    MeasureWorld world;
    world.seconds = [] { return 0.0; };
    world.interrupted = [] { return false; };
    world.begin = world.say = [](const std::string&) {};
    const auto measure = [&](const BenchTask& task) -> Result<BenchSample> {
        if (task.sample.config == fails) return Diagnostic{Code::gl_error, "it broke"};
        BenchSample sample = task.sample;
        sample.error.rmse = 0.125;
        return sample;
    };
    return measureAll(benchJob(plan, "fake", file.done, measure), file.lines, world);
}

}  // namespace

TEST_CASE("What is unusable fails, the rest is measured, and a second run tries failures again")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane"};
    const BenchPlan planned = plan(options);
    const TemporaryFolder folder("bench_broken");
    const MeasureSummary summary = run(folder, planned, "thesis");
    CHECK(summary.measured == 2);
    REQUIRE(summary.failures.size() == 6);
    CHECK(summary.failures[0].find("learnopengl samples=4, nowhere, 64x36: CV7001: ") == 0);
    const std::vector<BenchSample> samples = need(readBenchSamples({folder.path.string()}));
    CHECK(samples.size() == 8);
    CHECK(samples[0].device == "fake");
    const MeasureSummary again = run(folder, planned);
    CHECK(again.kept == 2);
    CHECK(again.measured == 2);
}

TEST_CASE("Presets are measured first, in all scenes, unless configs were named")
{
    BenchOptions options = smallOptions();
    options.configs = {};
    options.samples = {};
    const std::set<std::string> presets = {"mobile_low", "mobile", "balanced", "high"};
    std::set<std::string> first;
    const std::vector<BenchTask> tasks = plan(options).tasks;
    for (std::size_t i = 0; i < 2 * presets.size(); ++i) {
        CHECK(presets.count(tasks[i].sample.config) == 1);
        first.insert(tasks[i].sample.config + tasks[i].sample.scene);
    }
    CHECK(first.size() == 2 * presets.size());
    options.configs = {"thesis", "mobile"};
    CHECK(plan(options).tasks[0].sample.config == "thesis");
}
