// SPDX-License-Identifier: MIT
// A bench without GL: failures, going on after a stop, shards, and what comes first.
#include "tools/measure/bench/bench.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/small.h"

using namespace crevice;

namespace {

/// A device on which each sample takes ten seconds, and one config fails.
struct FakeBench {
    std::string fails;
    double time_budget_s = 0;

    MeasureSummary run(const std::string& folder, const BenchPlan& plan) const
    {
        PlannedBench planned = plan.planned;
        planned.device = "fake";
        BenchFile file = need(openBench(folder, planned));
        double now = 100;
        MeasureWorld world;
        world.seconds = [&now] { return now; };
        world.interrupted = [] { return false; };
        world.begin = world.say = [](const std::string&) {};
        world.time_budget_s = time_budget_s;
        const auto measure = [&](const BenchTask& task) -> Result<BenchSample> {
            now += 10;
            if (task.sample.config == fails) return Diagnostic{Code::gl_error, "it broke"};
            BenchSample sample = task.sample;
            sample.error.rmse = 0.125;
            return sample;
        };
        return measureAll(benchJob(plan, planned.device, file.done, measure), file.lines, world);
    }
};

}  // namespace

TEST_CASE("What is unusable fails, and the rest is measured")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane"};
    options.configs = {"nothing", "learnopengl"};
    const TemporaryFolder folder("bench_broken");
    const MeasureSummary summary = FakeBench().run(folder.path.string(), plan(options));
    CHECK(summary.measured == 2);
    REQUIRE(summary.failures.size() == 4);
    CHECK(summary.failures[0].find("nothing, nowhere, 64x36: CV7001: ") == 0);
}

TEST_CASE("A stopped bench knows how much of it was measured, and a finished one that it is whole")
{
    const TemporaryFolder folder("bench_coverage");
    const BenchPlan planned = plan(smallOptions());
    const std::string path = folder.path.string();
    const auto coverage = [&] { return coverageOf(need(readBenchResults({path}))); };
    FakeBench{"", 25}.run(path, planned);
    CHECK(coverage().measured == 3);
    CHECK(coverage().planned == planned.tasks.size());
    CHECK(coverageText(coverage())
              .find("3 of " + std::to_string(planned.tasks.size()) +
                    " bench samples measured: learnopengl") == 0);
    CHECK(FakeBench{"thesis"}.run(path, planned).kept == 3);
    CHECK(coverage().failed == 3);
    CHECK(coverage().whole());
    CHECK(FakeBench().run(path, planned).measured == 3);
    CHECK(coverage().measured == planned.tasks.size());
    CHECK(coverage().whole());
    CHECK(coverageText(coverage()).empty());
}

TEST_CASE("Each shard knows of the samples of all, and together they are the whole")
{
    BenchOptions options = smallOptions();
    const BenchPlan whole = plan(options);
    BenchResults all;
    for (int share = 1; share <= 3; ++share) {
        options.shard = {share, 3};
        const BenchPlan part = plan(options);
        CHECK(part.planned.command == whole.planned.command);
        CHECK(part.planned.bench_samples.size() == whole.tasks.size());
        BenchResults own{{}, {part.planned}};
        for (const BenchTask& task : part.tasks) own.samples.push_back(task.sample);
        CHECK(coverageOf(own).planned == whole.tasks.size());
        CHECK_FALSE(coverageOf(own).whole());
        all.samples.insert(all.samples.end(), own.samples.begin(), own.samples.end());
        all.planned.push_back(part.planned);
    }
    CHECK(coverageOf(all).whole());
    CHECK(coverageOf(all).planned == whole.tasks.size());
}

TEST_CASE("Presets are measured first, in all scenes, unless configs were named")
{
    BenchOptions options = smallOptions();
    options.configs = {};
    options.samples = {};
    const std::set<std::string> presets = {"mobile_low", "mobile", "balanced", "high"};
    std::set<std::string> first;
    bool others = false;
    for (const BenchTask& task : plan(options).tasks) {
        const bool preset = presets.count(task.sample.config) > 0;
        CHECK_FALSE((preset && others));
        others = others || !preset;
        if (preset) first.insert(task.sample.config + task.sample.scene);
    }
    CHECK(first.size() == 2 * presets.size());
    options.configs = {"thesis", "mobile"};
    CHECK(plan(options).tasks[0].sample.config == "thesis");
}

TEST_CASE("A command that is run again, as its configs have changed, plans what they are now")
{
    const TemporaryFolder folder("bench_replan");
    PlannedBench planned{"device", "command", {"old", "kept"}};
    for (const char* changed : {"old", "new", "new"}) {
        planned.bench_samples[0] = changed;
        need(openBench(folder.path.string(), planned));
    }
    const auto results = readBenchResults({folder.path.string()});
    REQUIRE(results.ok());
    REQUIRE(results->planned.size() == 1);
    CHECK(results->planned[0].bench_samples == std::vector<std::string>{"new", "kept"});
}
