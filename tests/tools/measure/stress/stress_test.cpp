// SPDX-License-Identifier: MIT
// Stress cases without GL: their shots, and what a run keeps.
#include "tools/measure/stress/figures.h"
#include "tools/measure/stress/known.h"
#include "tools/measure/stress/scenes.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/stress/made_records.h"

#include <cmath>
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
    CHECK(std::filesystem::exists(path + "/stress.jsonl"));
    CHECK(need(readKnownSteps(path + "/known.jsonl")).size() == 2);
    const std::vector<StressSeries> series = seriesOf(records);
    REQUIRE(series.size() == 2);
    CHECK(findBreakdown(*series[0].stress, series[0].steps).failures == 0);
    CHECK(findBreakdown(*series[1].stress, series[1].steps).failures == 3);
    CHECK(records[0].picture.empty());
    CHECK(std::filesystem::exists(path + "/" + records[5].picture));
    CHECK(std::filesystem::exists(path + "/" + truthPictureOf(records[5])));
}

TEST_CASE("Light that occlusion dims exactly has no error, and light that it does not reach has")
{
    Image without({2, 1}, 4, 0.04f), color = without, ao({2, 1}, 1, 0.5f);
    for (int x = 0; x < 2; ++x)
        for (int channel = 0; channel < 3; ++channel) color.at(x, 0, channel) = 0.02f;
    CHECK(errorOfLight(without, color, ao) == Approx(0).margin(1e-9));
    CHECK(errorOfLight(without, without, ao) > kSameLight);
    color.at(0, 0, 1) = 0.0f;
    CHECK(errorOfLight(without, color, ao) > 1e-5);
}

TEST_CASE("The least value where no surface is seen is noted, and others are not")
{
    Image ground_truth({2, 1}, 1, 0.5f), ao({2, 1}, 1, 0.25f);
    StressRecord record;
    describeError(ao, ground_truth, record);
    CHECK(record.background == 1);
    ground_truth.pixels[1] = std::nanf("");
    describeError(ao, ground_truth, record);
    CHECK(record.background == 0.25);
}
