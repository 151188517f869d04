// SPDX-License-Identifier: MIT
// The engine without GL: failures, the time budget, and going on after what may stop it.
// Depth taps a pixel of configs that count them and of configs that march in slices.
#include "tools/measure/bench/run.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/measure/taps.h"

#include <nlohmann/json.hpp>

using namespace crevice;

namespace {

/// Samples a to f, each of which takes ten seconds.
struct FakeRun {
    FakeRun()
    {
        for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
            plan.tasks.emplace_back();
            plan.tasks.back().sample.config = plan.tasks.back().sample.key = name;
        }
        world.measure = [this](const BenchTask& task) -> Result<BenchSample> {
            now += 10;
            order += task.sample.config;
            if (task.sample.config == fails) return Diagnostic{Code::gl_error, "it broke"};
            if (order.size() == full_after) return Diagnostic{Code::cannot_write, "no space"};
            return {task.sample, warnings};
        };
        world.seconds = [this] { return now; };
        world.interrupted = [this] { return order.size() >= stop_after; };
        world.begin = [](const std::string&) {};
        world.say = [this](const std::string& line) { lines.push_back(line); };
    }

    MeasureSummary run(const TemporaryFolder& folder)
    {
        BenchFile file = need(openBench(folder.path.string()));
        return measureAll(plan, file, world);
    }

    static std::string pathIn(const TemporaryFolder& folder)
    {
        return (folder.path / "results.jsonl").string();
    }

    BenchPlan plan;
    MeasureWorld world;
    Diagnostics warnings;
    double now = 100;
    std::string fails;
    std::size_t full_after = 1000;
    std::size_t stop_after = 1000;
    std::string order;
    std::vector<std::string> lines;
};

int linesIn(const TemporaryFolder& folder)
{
    int count = 0;
    const Diagnostics read = readLines(FakeRun::pathIn(folder), {"task", "a test"},
                                       [&count](nlohmann::json&&) { ++count; });
    CHECK(read.empty());
    return count;
}

ParamDesc whole(const char* name, int value, int max)
{
    ParamDesc param;
    param.name = name;
    param.value[0] = static_cast<float>(value);
    param.min = 1;
    param.max = max;
    return param;
}

Description marching(int slices, int steps)
{
    Description description;
    description.params = {whole("slices", slices, 16), whole("steps", steps, 32)};
    return description;
}

Description counting(int samples)
{
    Description description;
    description.params = {whole("samples", samples, 128)};
    return description;
}

}  // namespace

TEST_CASE("A second run measures nothing again but tries failures once more")
{
    const TemporaryFolder folder("measure_resume");
    FakeRun first;
    first.fails = "c";
    first.plan.tasks[4].sample.failure = "there is no such scene";
    const MeasureSummary broken = first.run(folder);
    CHECK(broken.measured == 4);
    CHECK(broken.failures == std::vector<std::string>{"c, , 0x0: CV6005: it broke",
                                                      "e, , 0x0: there is no such scene"});
    CHECK(first.order == "abcdf");
    CHECK(first.lines[0] ==
          "[1/6] a, , 0x0: rmse 0.0000, 0.00 ms, 0.00 x learnopengl; about 50 s left");
    CHECK(first.lines[2].find("[3/6] c, , 0x0: failed: CV6005: it broke; about") == 0);
    CHECK(first.lines[5] == "[6/6] f, , 0x0: rmse 0.0000, 0.00 ms, 0.00 x learnopengl");

    FakeRun mended;
    const MeasureSummary second = mended.run(folder);
    CHECK(second.kept == 4);
    CHECK(second.measured == 2);
    CHECK(mended.order == "ce");
    CHECK(linesIn(folder) == 8);
}

TEST_CASE("The time budget, an interrupt and a full disk end a run that goes on from there")
{
    struct Row {
        const char* what;
        void (*stop)(FakeRun&);
        int measured;
        const char* left;
    };
    const Row rows[] = {
        {"time", [](FakeRun& run) { run.world.time_budget_s = 25; }, 3, "def"},
        {"interrupt", [](FakeRun& run) { run.stop_after = 3; }, 2, "cdef"},  // c is under way
        {"disk", [](FakeRun& run) { run.full_after = 3; }, 2, "cdef"}};
    for (const Row& row : rows) {
        INFO(row.what);
        const TemporaryFolder folder("measure_stopped");
        FakeRun stopped;
        row.stop(stopped);
        const MeasureSummary summary = stopped.run(folder);
        CHECK(summary.measured == row.measured);
        REQUIRE(static_cast<int>(summary.missing.size()) == 6 - row.measured);
        CHECK(summary.missing[0] == std::string(1, row.left[0]) + ", , 0x0");
        CHECK(summary.interrupted == (stopped.stop_after < 6));
        CHECK(linesIn(folder) == row.measured);
        CHECK(summary.written.ok() == (stopped.full_after > 6));
        if (!summary.written.ok()) {
            CHECK(summary.written.diagnostics()[0].code == Code::cannot_write);
            CHECK(summary.written.diagnostics()[0].help == LineFile::wayOut());
        }
        FakeRun next;
        CHECK(next.run(folder).kept == row.measured);
        CHECK(next.order == row.left);
    }
}

TEST_CASE("A warning of a measurement is said once and the task counts")
{
    const TemporaryFolder folder("measure_warned");
    FakeRun run;
    run.warnings = {{Code::cannot_write, "the cache is full"}};
    run.warnings[0].severity = Severity::warning;
    CHECK(run.run(folder).measured == 6);
    CHECK(run.lines.size() == 7);
    CHECK(run.lines[0].find("the cache is full") != std::string::npos);
}

TEST_CASE("Two runs cannot write to one file")
{
    const TemporaryFolder folder("measure_locked");
    const LineFile first = need(LineFile::open(FakeRun::pathIn(folder)));
    const Result<LineFile> second = LineFile::open(FakeRun::pathIn(folder));
    REQUIRE_FALSE(second.ok());
    CHECK(second.diagnostics()[0].code == Code::cannot_write);
}

TEST_CASE("A failure names the place of its first error and passes over warnings")
{
    Diagnostic warning{Code::not_finite, "odd"};
    warning.severity = Severity::warning;
    Diagnostic error{Code::shader_compile, "syntax error"};
    CHECK(failureText({warning, error}) == "CV5001: syntax error");
    error.place = {std::make_shared<SourceText>(SourceText{"my.frag", "one\ntwo\n"}), 2, 3, 1};
    CHECK(failureText({warning, error}) == "my.frag:2:3: CV5001: syntax error");
    error.help = "add ';'";
    CHECK(failureText({warning, error}) == "my.frag:2:3: CV5001: syntax error; add ';'");
}

TEST_CASE("Lengths of time are read strictly")
{
    const auto read = [](const char* text) { return timeBudgetOf({text, ""}); };
    CHECK(*read("90s") == 90);
    CHECK(*read("5m") == 300);
    CHECK(*read("1.5h") == 5400);
    for (const char* text : {"m", "0", "90", "-5m", "5 m", "5d", "inf", "nan"})
        CHECK_FALSE(read(text).ok());
}

TEST_CASE("taps a pixel are counted by samples or by slices both ways")
{
    CHECK(samplesOf(counting(64)) == 64);
    CHECK(samplesOf(marching(3, 3)) == 18);
    CHECK(samplesOf({}) == 0);
}

TEST_CASE(
    "another count is one override, or shared between slices and steps in the config's own ratio")
{
    CHECK(overridesFor(counting(64), 16) == std::vector<std::string>{"samples=16"});
    CHECK(overridesFor(counting(64), 129).empty());
    const auto split = [](const Description& description, int count) {
        return overridesFor(description, count);
    };
    CHECK(split(marching(2, 4), 16) == std::vector<std::string>{"slices=2", "steps=4"});
    CHECK(split(marching(2, 4), 64) == std::vector<std::string>{"slices=4", "steps=8"});
    CHECK(split(marching(3, 3), 8) == std::vector<std::string>{"slices=2", "steps=2"});
    CHECK(split(marching(1, 8), 8) == std::vector<std::string>{"slices=1", "steps=4"});
    CHECK(split(marching(2, 4), 7).empty());       // not the same on both ways
    CHECK(split(marching(2, 4), 2 * 37).empty());  // 37 fits neither range
}
