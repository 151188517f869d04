// SPDX-License-Identifier: MIT
// Benches without GL: keys, shards, going on after an interrupt, the time budget, figures.
#include "tools/bench.h"

#include "core/plan.h"
#include "effects/catalog.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"
#include "tools/bench_errors.h"
#include "tools/bench_times.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

BenchOptions smallOptions()
{
    BenchOptions options;
    options.scenes = {"plane", "spheres"};
    options.sizes = {"64x36"};
    options.samples = {4, 16};
    return options;
}

BenchPlan plan(const BenchOptions& options)
{
    const Result<BenchPlan> made = planBench(options, shippedSources());
    INFO(toText(made.diagnostics()));
    REQUIRE(made.ok());
    return *made;
}

std::vector<std::string> keys(const BenchOptions& options)
{
    std::vector<std::string> all;
    for (const BenchTask& task : plan(options).tasks) all.push_back(task.point.key);
    return all;
}

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

TEST_CASE("A bench crosses scenes, sizes, radii, configs and samples")
{
    BenchOptions options = smallOptions();
    options.configs = {"learnopengl", "thesis"};
    options.sizes = {"64x36", "32x18"};
    options.radii = {0.25, 1};
    const BenchPlan planned = plan(options);
    CHECK(planned.tasks.size() == 2 * 2 * 2 * 2 * 2);
    CHECK(planned.views.size() == 4);
    const BenchPoint& point = planned.tasks[1].point;
    CHECK(pointTitle(point) == "learnopengl radius=0.25 samples=16, plane, 64x36");
    CHECK(point.family == "learnopengl");
    CHECK(point.samples == 16);
    CHECK(point.radius == 0.25);
    CHECK(point.triangles > 0);
}

TEST_CASE("The key of a point is the same in every plan and changes with what decides its figures")
{
    const BenchOptions options = smallOptions();
    const std::vector<std::string> first = keys(options);
    CHECK(std::set<std::string>(first.begin(), first.end()).size() == first.size());
    CHECK(keys(options) == first);

    BenchOptions other = options;
    other.rays = 64;
    CHECK(keys(other).front() != first.front());
    other = options;
    other.version = "next";
    CHECK(keys(other).front() != first.front());
    other = options;
    other.overrides = {"intensity=2"};
    CHECK(keys(other).front() != first.front());
    CHECK(keyOnDevice(first[0], "a") != keyOnDevice(first[0], "b"));
}

TEST_CASE("An edited shader is another point")
{
    const std::string text = shippedSources().find("ssao/hemisphere.frag")->text;
    MemorySources edited;
    edited.add("ssao/hemisphere.frag", text + "// edited\n");
    const LayeredSources sources({&edited, &shippedSources()});
    BenchOptions options = smallOptions();
    options.configs = {"learnopengl"};
    const Result<BenchPlan> other = planBench(options, sources);
    REQUIRE(other.ok());
    CHECK(other->tasks[0].point.key != keys(options)[0]);
}

TEST_CASE("Shards share the points out exactly, whatever their number")
{
    BenchOptions options = smallOptions();
    const std::vector<std::string> all = keys(options);
    for (const int count : {1, 2, 3, 8, 100}) {
        std::vector<std::string> together;
        for (int index = 1; index <= count; ++index) {
            options.shard = {index, count};
            for (const std::string& key : keys(options)) together.push_back(key);
        }
        INFO(count);
        CHECK(together.size() == all.size());
        CHECK(std::set<std::string>(together.begin(), together.end()) ==
              std::set<std::string>(all.begin(), all.end()));
    }
}

TEST_CASE("Sample counts that a config cannot take are left out with a warning")
{
    BenchOptions options = smallOptions();
    options.scenes = {"plane"};
    options.configs = {"learnopengl"};
    options.samples = {4, 1000};
    const BenchPlan planned = plan(options);
    CHECK(planned.tasks.size() == 1);
    REQUIRE(planned.diagnostics.size() == 1);
    CHECK(planned.diagnostics[0].severity == Severity::warning);
}

TEST_CASE("A scene that cannot be loaded is left out, and a broken config becomes a failure")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane"};
    options.configs = {"nothing", "learnopengl"};
    const BenchPlan planned = plan(options);
    CHECK(hasErrors(planned.diagnostics));
    REQUIRE(planned.tasks.size() == 3);
    CHECK(!planned.tasks[0].point.failure.empty());
    CHECK(planned.tasks[1].point.failure.empty());
    const TemporaryFolder folder("bench_broken");
    const BenchSummary summary = run(folder.path.string(), FakeWorld(), planned);
    CHECK(summary.measured == 2);
    CHECK(summary.failures.size() == 1);
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

TEST_CASE("Shards and lengths of time are read strictly")
{
    CHECK(parseShard("3/8")->index == 3);
    for (const char* text : {"", "3", "0/8", "9/8", "-1/8", "3/8x", "/8", "3/"})
        CHECK_FALSE(parseShard(text).ok());
    CHECK(*parseDuration("90") == 90);
    CHECK(*parseDuration("90s") == 90);
    CHECK(*parseDuration("5m") == 300);
    CHECK(*parseDuration("1.5h") == 5400);
    for (const char* text : {"", "m", "0", "-5m", "5 m", "5d", "inf", "nan"})
        CHECK_FALSE(parseDuration(text).ok());
}

TEST_CASE("Medians and quartiles lie between neighbours")
{
    const TimeFigures five = timeFigures({5, 1, 4, 2, 3});
    CHECK(five.median == 3);
    CHECK(five.q1 == 2);
    CHECK(five.q3 == 4);
    CHECK(timeFigures({1, 2}).median == 1.5);
    CHECK(timeFigures({7}).q3 == 7);
}

TEST_CASE("The cost of the occlusion is every pass but the draw passes")
{
    Plan made;
    made.passes.resize(3);
    made.passes[0].type = PassType::draw;
    FrameTimes times;
    times.pass_ms = {100, 2, 0.5};
    CHECK(occlusionCost(made, times) == 2.5);
}

TEST_CASE("The radius on screen is that of the median depth, for both kinds of projection")
{
    Image depth({101, 100}, 1, 1.0f);
    Camera camera;
    camera.clip_from_view = glm::perspective(1.0f, 1.01f, 0.1f, 100.0f);
    CHECK(radiusOnScreen(1, camera, depth) == 0.0);
    const auto window = [&camera](float z) {
        const glm::vec4 clip = camera.clip_from_view * glm::vec4(0, 0, z, 1);
        return clip.z / clip.w * 0.5f + 0.5f;
    };
    depth.at(0, 0) = window(-2);
    depth.at(1, 0) = window(-4);
    depth.at(2, 0) = window(-50);
    CHECK(radiusOnScreen(1, camera, depth) == Approx(50 / std::tan(0.5) / 4).epsilon(1e-3));

    camera.clip_from_view = glm::ortho(-3.0f, 3.0f, -2.5f, 2.5f, 0.0f, 10.0f);
    CHECK(radiusOnScreen(1, camera, depth) == Approx(20));
}

TEST_CASE("The budget is measured where the truth is known, and -1 where a picture is missing")
{
    Image truth({2, 1}, 1, 0.5f);
    truth.at(1, 0) = std::nanf("");
    Image ao({2, 1}, 1, 0.75f), converged({2, 1}, 1, 0.625f);
    ao.at(1, 0) = 1.0f;
    const Image unfiltered({2, 1}, 1, 1.0f);
    const ErrorBudget budget = budgetOf({ao, truth, converged, unfiltered, Image()});
    CHECK(budget.sampling == 0.375);
    CHECK(budget.noise == 0.125);
    CHECK(budget.model == 0.125);
    CHECK(budget.precision == -1);
}

TEST_CASE("A ratio is taken turn by turn, so that moments which slow both sides cancel")
{
    const std::vector<double> unit = {99, 10, 30, 10, 10};  // the first turn was another point's
    const TimeFigures ratio = ratioFigures({5, 15, 5, 6}, unit);
    CHECK(ratio.median == 0.5);
    CHECK(ratio.q1 == 0.5);
    CHECK(ratioFigures({1, 2}, {0, 0}).median == 0.0);
    CHECK(ratioFigures({}, unit).median == 0.0);
}

TEST_CASE("The quickest turns are those that no slow moment reaches")
{
    std::vector<double> costs(20, 100.0);
    costs[4] = costs[7] = costs[11] = 2.0;
    CHECK(quickest(costs) == 2.0);
    CHECK(quickest({3.0}) == 3.0);
}

TEST_CASE("A median is settled by more turns or by steadier ones")
{
    const TimeFigures steady{1.0, 0.99, 1.01}, restless{1.0, 0.8, 1.2};
    CHECK(isSettled(steady, 4));
    CHECK(!isSettled(restless, 7));
    CHECK(isSettled(restless, 1000));
}
