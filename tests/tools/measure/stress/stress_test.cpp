// SPDX-License-Identifier: MIT
// Stress cases without GL: their shots, and a run that stops and goes on.
#include "tools/measure/stress/figures.h"
#include "tools/measure/stress/run.h"
#include "tools/measure/stress/scenes.h"
#include "tools/show/report/stress_report.h"

#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/stress/made_records.h"

#include <set>

using namespace crevice;

namespace {

/// A device on which each step takes ten seconds and the planes of one config are grey.
struct FakeStress {
    MeasureSummary run(const TemporaryFolder& folder, const std::vector<StressTask>& tasks)
    {
        LineFile file = need(LineFile::open((folder.path / "stress.jsonl").string()));
        const auto known = need(readStressRecords(file.path()));
        StressHow how;
        how.key = [](const StressTask& task) { return stepTitle(task); };
        how.measure = [this](const StressTask& task) { return draw(task); };
        how.keep = [this](const StressDrawing& done) {
            pictures.push_back(done.record.picture);
            return Status();
        };
        how.device = "fake";
        MeasureWorld world;
        world.seconds = [this] { return 10.0 * static_cast<double>(drawn.size()); };
        world.interrupted = [this] { return drawn.size() >= stop_after; };
        world.begin = [](const std::string&) {};
        world.say = [this](const std::string& line) { lines.push_back(line); };
        const MeasureJob job = stressJob(tasks, known, std::move(how));
        const MeasureSummary summary = measureAll(job, file, world);
        records = need(recordsOf(job, file.path()));
        return summary;
    }

    StressDrawing draw(const StressTask& task)
    {
        drawn.push_back(stepTitle(task));
        StressDrawing done;
        done.record = good();
        done.record.config = task.config.config;
        done.record.case_name = task.stress->name;
        done.record.step = task.step;
        done.record.judged_mean = task.config.config == grey ? 0.5 : 1;
        done.ao = Image({2, 2}, 1, 1.0f);
        return done;
    }

    std::string grey;
    std::size_t stop_after = 1000;
    std::vector<std::string> drawn;
    std::vector<std::string> pictures;
    std::vector<std::string> lines;
    std::vector<StressRecord> records;
};

std::vector<StressTask> plan(StressOptions options)
{
    const auto tasks = planStress(options, shippedSources());
    INFO(toText(tasks.diagnostics()));
    REQUIRE(tasks.ok());
    return *tasks;
}

std::vector<StressTask> fewTasks()
{
    StressOptions options;
    options.configs = {"gtao", "learnopengl"};
    options.cases = {"plane_fov"};
    options.quick = true;
    return plan(options);
}

}  // namespace

TEST_CASE("Formats resolve as their closed forms say")
{
    StressShot shot;
    shot.camera = cameraOf({}, {16, 9});
    shot.near_distance = 0.1;
    shot.far_distance = 1e6;
    CHECK(formatStep(Format::depth24, 100, shot) == Approx(0.00596).epsilon(0.01));
    CHECK(formatStep(Format::depth16, 10, shot) == Approx(0.01526).epsilon(0.01));
    CHECK(formatStep(Format::rgba16f, 100, shot) == 0.0625);
    CHECK(formatStep(Format::rgba16f, 1000, shot) == 0.5);
}

TEST_CASE("Every case has an ordinary step, a shot for each step and a name of its own")
{
    std::set<std::string> names;
    for (const StressCase& stress : stressCases()) {
        INFO(stress.name);
        CHECK(names.insert(stress.name).second);
        REQUIRE(stress.ordinary < stress.steps.size());
        for (const StressStep& step : stress.steps) {
            const StressShot shot = stress.shot(step.value, {32, 18});
            CHECK(shot.extent.width > 0);
            CHECK(shot.near_distance < shot.far_distance);
            if (!shot.distances.pixels.empty()) CHECK(shot.distances.extent == shot.extent);
        }
    }
}

TEST_CASE("A stress run keeps what it drew, goes on from there, and shows failures on its page")
{
    const TemporaryFolder folder("stress_resume");
    const std::vector<StressTask> tasks = fewTasks();
    REQUIRE(tasks.size() == 6);
    FakeStress stopped;
    stopped.stop_after = 3;
    CHECK(stopped.run(folder, tasks).measured == 2);
    CHECK(stopped.records.size() == 2);
    CHECK(stopped.pictures.empty());

    FakeStress next;
    next.grey = "learnopengl";
    CHECK(next.run(folder, tasks).kept == 2);
    CHECK(next.records.size() == 6);
    CHECK(next.pictures.size() == 3);
    CHECK(next.drawn.front() == "gtao, plane_fov, 170");
    CHECK(next.lines[0].find("[1/4] gtao, plane_fov, 170: holds; about 30 s left") == 0);
    CHECK(next.lines[3].find("[4/4] learnopengl, plane_fov, 170: breaks: mean 0.5") == 0);
    const std::vector<StressSeries> series = seriesOf(next.records);
    REQUIRE(series.size() == 2);
    CHECK(findBreakdown(*series[0].stress, series[0].steps).failures == 0);
    CHECK(findBreakdown(*series[1].stress, series[1].steps).failures == 3);

    const std::string page = stressHtml(next.records, folder.path.string());
    CHECK(page.find("breaks at 45: mean 0.5") != std::string::npos);
    CHECK(page.find("/*report.json*/") == std::string::npos);
    CHECK(page.find("src=\"http") == std::string::npos);
}

TEST_CASE("Stress records come back from their file as they were, and a broken line is named")
{
    const TemporaryFolder folder("stress_records");
    StressRecord record = good();
    record.key = "0123456789abcdef";
    record.bad_pass = "a \"pass\"";
    record.change = 0.125;
    const std::string line = toJsonLine(record);
    const auto read = readStressRecords(folder.write("good.jsonl", line + "\n"));
    REQUIRE(read.ok());
    REQUIRE(read->size() == 1);
    CHECK(toJsonLine(read->front()) == line);
    const auto broken = readStressRecords(folder.write("bad.jsonl", line + "\n{\"key\": 1}\n"));
    REQUIRE_FALSE(broken.ok());
    CHECK(broken.diagnostics()[0].code == Code::results_broken);
    CHECK(broken.diagnostics()[0].place.line == 2);
}
