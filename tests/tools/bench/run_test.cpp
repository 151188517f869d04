// SPDX-License-Identifier: MIT
// The loop of a bench without GL: failures, the time budget, and going on after what may stop it.
#include "tools/bench/bench.h"

#include "tests/support/temporary_folder.h"
#include "tests/tools/bench/small.h"

#include <filesystem>

using namespace crevice;

namespace {

/// A world in which each point takes ten seconds.
struct FakeWorld : BenchWorld {
    FakeWorld()
    {
        measure = [this](const BenchTask& task) -> Result<BenchPoint> {
            now += 10;
            order.push_back(task.point.key);
            if (task.point.config == fails) return Diagnostic{Code::gl_error, "it broke"};
            if (order.size() == full_after) return Diagnostic{Code::cannot_write, "no space"};
            BenchPoint point = task.point;
            point.error.rmse = 0.125;
            return point;
        };
        seconds = [this] { return now; };
        interrupted = [this] { return order.size() >= stop_after; };
        say = [this](const std::string& line) { lines.push_back(line); };
        device = "fake";
    }

    double now = 100;
    std::string fails;
    std::size_t full_after = 1000;
    std::size_t stop_after = 1000;
    std::vector<std::string> order;
    std::vector<std::string> lines;
};

BenchSummary run(const std::string& folder, const BenchWorld& world, const BenchPlan& planned)
{
    Result<ResultFile> file = ResultFile::open(folder);
    INFO(toText(file.diagnostics()));
    REQUIRE(file.ok());
    return runBench(planned.tasks, *file, world);
}

std::size_t figuresIn(const TemporaryFolder& folder)
{
    const auto points = readBenchPoints({(folder.path / "results.jsonl").string()});
    REQUIRE(points.ok());
    std::size_t count = 0;
    for (const BenchPoint& point : *points) count += point.failure.empty() && point.error.rmse > 0;
    return count;
}

}  // namespace

TEST_CASE("What is unusable fails, and the rest is measured")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane"};
    options.configs = {"nothing", "learnopengl"};
    const TemporaryFolder folder("bench_broken");
    const BenchSummary summary = run(folder.path.string(), FakeWorld(), plan(options));
    CHECK(summary.measured == 2);
    REQUIRE(summary.failures.size() == 4);
    CHECK(summary.failures[0].find("nothing, nowhere, 64x36: CV7001: ") == 0);
}

TEST_CASE("A second run measures nothing again but tries failures once more")
{
    const TemporaryFolder folder("bench_resume");
    const BenchPlan planned = plan(smallOptions());
    const int all = static_cast<int>(planned.tasks.size());
    FakeWorld world;
    world.fails = "thesis";
    const BenchSummary first = run(folder.path.string(), world, planned);
    CHECK(first.measured == all - 4);
    CHECK(first.failures.size() == 4);
    CHECK(world.lines.size() == planned.tasks.size());

    FakeWorld mended;
    const BenchSummary second = run(folder.path.string(), mended, planned);
    CHECK(second.kept == all - 4);
    CHECK(second.measured == 4);
    CHECK(mended.order.size() == 4);
    CHECK(figuresIn(folder) == planned.tasks.size());

    FakeWorld elsewhere;
    elsewhere.device = "another device";
    CHECK(run(folder.path.string(), elsewhere, planned).measured == all);
}

TEST_CASE("No point begins after the time budget, and what is missing is told")
{
    const TemporaryFolder folder("bench_time");
    const BenchPlan planned = plan(smallOptions());
    FakeWorld world;
    world.time_budget_s = 25;
    const BenchSummary summary = run(folder.path.string(), world, planned);
    CHECK(summary.measured == 3);
    CHECK(summary.missing.size() == planned.tasks.size() - 3);
    CHECK(summary.missing[0] == pointTitle(planned.tasks[3].point));
    CHECK(world.lines[0].find("left") != std::string::npos);
}

TEST_CASE("An interrupt drops the point under way and the next run goes on from there")
{
    const TemporaryFolder folder("bench_interrupt");
    const BenchPlan planned = plan(smallOptions());
    FakeWorld world;
    world.stop_after = 3;
    const BenchSummary summary = run(folder.path.string(), world, planned);
    CHECK(summary.interrupted);
    CHECK(summary.measured == 2);
    CHECK(figuresIn(folder) == 2);
    FakeWorld next;
    CHECK(run(folder.path.string(), next, planned).kept == 2);
    CHECK(next.order.front() == planned.tasks[2].point.key);
}

TEST_CASE("A full disk ends the run and loses nothing that was measured")
{
    const TemporaryFolder folder("bench_full");
    const BenchPlan planned = plan(smallOptions());
    FakeWorld world;
    world.full_after = 3;
    const BenchSummary summary = run(folder.path.string(), world, planned);
    REQUIRE_FALSE(summary.written.ok());
    CHECK(summary.written.diagnostics()[0].code == Code::cannot_write);
    CHECK(summary.missing.size() == planned.tasks.size() - 2);
    CHECK(figuresIn(folder) == 2);
}

TEST_CASE("A results file that is deleted or replaced during the run ends it")
{
    const TemporaryFolder folder("bench_deleted");
    const BenchPlan planned = plan(smallOptions());
    const std::filesystem::path file = folder.path / "results.jsonl";
    const bool replace = GENERATE(false, true);
    FakeWorld world;
    const auto measure = world.measure;
    world.measure = [&](const BenchTask& task) {
        if (world.order.size() == 2) {
            std::filesystem::rename(file, folder.path / "moved.jsonl");
            if (replace) std::filesystem::copy_file(folder.path / "moved.jsonl", file);
        }
        return measure(task);
    };
    const BenchSummary summary = run(folder.path.string(), world, planned);
    REQUIRE_FALSE(summary.written.ok());
    CHECK(summary.measured == 2);
    CHECK(summary.missing.size() == planned.tasks.size() - 2);
    CHECK(std::filesystem::exists(file) == replace);
}

TEST_CASE("A warning of a measurement is said once and the point counts")
{
    const TemporaryFolder folder("bench_warned");
    const BenchPlan planned = plan(smallOptions());
    FakeWorld world;
    const auto measure = world.measure;
    world.measure = [&measure](const BenchTask& task) -> Result<BenchPoint> {
        Diagnostic warning{Code::cannot_write, "the cache is full"};
        warning.severity = Severity::warning;
        return {*measure(task), {warning}};
    };
    const BenchSummary summary = run(folder.path.string(), world, planned);
    CHECK(summary.measured == static_cast<int>(planned.tasks.size()));
    CHECK(world.lines.size() == planned.tasks.size() + 1);
    CHECK(world.lines[0].find("the cache is full") != std::string::npos);
}

TEST_CASE("A line that was cut short is cut off, and its point measured again")
{
    const TemporaryFolder folder("bench_torn");
    const BenchPlan planned = plan(smallOptions());
    run(folder.path.string(), FakeWorld(), planned);
    const auto file = folder.path / "results.jsonl";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 30);
    FakeWorld world;
    const BenchSummary summary = run(folder.path.string(), world, planned);
    CHECK(summary.measured == 1);
    CHECK(world.order[0] == planned.tasks.back().point.key);
    CHECK(figuresIn(folder) == planned.tasks.size());
}

TEST_CASE("Two benches cannot write to one folder")
{
    const TemporaryFolder folder("bench_locked");
    const Result<ResultFile> first = ResultFile::open(folder.path.string());
    REQUIRE(first.ok());
    const Result<ResultFile> second = ResultFile::open(folder.path.string());
    REQUIRE_FALSE(second.ok());
    CHECK(second.diagnostics()[0].code == Code::cannot_write);
}

TEST_CASE("A stopped bench knows how much of it was measured, and a finished one that it is whole")
{
    const TemporaryFolder folder("bench_coverage");
    const BenchPlan planned = plan(smallOptions());
    const std::string file = (folder.path / "results.jsonl").string();
    const auto coverage = [&] {
        const auto results = readBenchResults({file});
        REQUIRE(results.ok());
        return coverageOf(*results);
    };
    const auto go = [&](const FakeWorld& world) {
        Result<ResultFile> opened = ResultFile::open(folder.path.string());
        REQUIRE(opened.ok());
        PlannedBench whole = planned.planned;
        whole.device = world.device;
        REQUIRE(opened->plan(whole).ok());
        (void)runBench(planned.tasks, *opened, world);
    };
    FakeWorld stopped;
    stopped.time_budget_s = 25;
    go(stopped);
    CHECK(coverage().measured == 3);
    CHECK(coverage().planned == planned.tasks.size());
    CHECK(coverageText(coverage()).find("3 of " + std::to_string(planned.tasks.size()) +
                                        " points measured: balanced") == 0);
    FakeWorld failing;
    failing.fails = "thesis";
    go(failing);
    CHECK(coverage().failed == 4);
    CHECK(coverage().whole());
    go(FakeWorld());
    CHECK(coverage().measured == planned.tasks.size());
    CHECK(coverage().whole());
    CHECK(coverageText(coverage()).empty());
}

TEST_CASE("Each shard knows of the points of all, and together they are the whole")
{
    BenchOptions options = smallOptions();
    const BenchPlan whole = plan(options);
    BenchResults all;
    for (int share = 1; share <= 3; ++share) {
        options.shard = {share, 3};
        const BenchPlan part = plan(options);
        CHECK(part.planned.command == whole.planned.command);
        CHECK(part.planned.points.size() == whole.tasks.size());
        BenchResults own{{}, {part.planned}};
        for (const BenchTask& task : part.tasks) own.points.push_back(task.point);
        CHECK(coverageOf(own).planned == whole.tasks.size());
        CHECK_FALSE(coverageOf(own).whole());
        all.points.insert(all.points.end(), own.points.begin(), own.points.end());
        all.planned.push_back(part.planned);
    }
    CHECK(coverageOf(all).whole());
    CHECK(coverageOf(all).planned == whole.tasks.size());
}

TEST_CASE("Presets are measured first, in all scenes, unless configs were named")
{
    BenchOptions options = smallOptions();
    const std::set<std::string> presets = {"mobile_low", "mobile", "balanced", "high"};
    std::set<std::string> first;
    bool others = false;
    for (const BenchTask& task : plan(options).tasks) {
        const bool preset = presets.count(task.point.config) > 0;
        CHECK_FALSE((preset && others));
        others = others || !preset;
        if (preset) first.insert(task.point.config + task.point.scene);
    }
    CHECK(first.size() == 2 * presets.size());
    options.configs = {"thesis", "mobile"};
    CHECK(plan(options).tasks[0].point.config == "thesis");
}

TEST_CASE("A command that is run again, as its configs have changed, plans what they are now")
{
    const TemporaryFolder folder("bench_replan");
    PlannedBench planned{"device", "command", {"old", "kept"}};
    for (const char* changed : {"old", "new", "new"}) {
        Result<ResultFile> file = ResultFile::open(folder.path.string());
        REQUIRE(file.ok());
        planned.points[0] = changed;
        REQUIRE(file->plan(planned).ok());
    }
    const auto results = readBenchResults({folder.path.string()});
    REQUIRE(results.ok());
    REQUIRE(results->planned.size() == 1);
    CHECK(results->planned[0].points == std::vector<std::string>{"new", "kept"});
}
