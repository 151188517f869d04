// SPDX-License-Identifier: MIT
// Stress cases without GL: their shots, and what a run keeps.
#include "tools/measure/stress/figures.h"
#include "tools/measure/stress/run.h"
#include "tools/measure/stress/scenes.h"

#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/stress/made_records.h"

#include <set>

using namespace crevice;

namespace {

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

TEST_CASE("A stress run keeps records of all steps and pictures of failures")
{
    const TemporaryFolder folder("stress_run");
    const std::string path = (folder.path / "new").string();
    const auto records = need(runStress(fewTasks(), path, [](const StressTask& task) {
        StressDrawing done;
        done.record = good();
        done.record.config = task.config.config;
        done.record.case_name = task.stress->name;
        done.record.step = task.step;
        done.record.judged_mean = task.config.config == "learnopengl" ? 0.5 : 1;
        done.ao = done.ground_truth = Image({2, 2}, 1, 1.0f);
        return done;
    }));
    REQUIRE(records.size() == 6);
    CHECK(need(readStressRecords(path + "/stress.jsonl")).size() == 6);
    const std::vector<StressSeries> series = seriesOf(records);
    REQUIRE(series.size() == 2);
    CHECK(findBreakdown(*series[0].stress, series[0].steps).failures == 0);
    CHECK(findBreakdown(*series[1].stress, series[1].steps).failures == 3);
    CHECK(records[0].picture.empty());
    CHECK(std::filesystem::exists(path + "/" + records[5].picture));
    CHECK(std::filesystem::exists(path + "/" + truthPictureOf(records[5])));
}

TEST_CASE("Stress records come back from their file as they were, and a broken line is named")
{
    const TemporaryFolder folder("stress_records");
    StressRecord record = good();
    record.bad_pass = "a \"pass\"";
    record.change = 0.125;
    const std::string line = toJsonLine(record);
    const auto read = readStressRecords(folder.write("good.jsonl", line + "\n"));
    REQUIRE(read.ok());
    REQUIRE(read->size() == 1);
    CHECK(toJsonLine(read->front()) == line);
    const auto broken = readStressRecords(folder.write("bad.jsonl", line + "\n{\"config\": 1}\n"));
    REQUIRE_FALSE(broken.ok());
    CHECK(broken.diagnostics()[0].code == Code::results_broken);
    CHECK(broken.diagnostics()[0].place.line == 2);
}
