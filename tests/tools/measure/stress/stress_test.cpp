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

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
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
        done.record.format = task.format;
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

TEST_CASE("A turned or flipped picture is compared where it shows the same")
{
    constexpr int kSide = 4;
    Image ordinary({kSide, kSide}, 1), turned({kSide, kSide}, 1), flipped({kSide, kSide}, 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            ordinary.at(x, y) = static_cast<float>(x + kSide * y);
            turned.at(kSide - 1 - y, x) = ordinary.at(x, y);
            flipped.at(x, kSide - 1 - y) = ordinary.at(x, y);
        }
    StressShot shot;
    CHECK(changeBetween(ordinary, turned, shot).change > 1);
    shot.turned = {0, 1, -1, 0};
    CHECK(changeBetween(ordinary, turned, shot).change == 0);
    CHECK(changeBetween(ordinary, flipped, shot).change > 1);
    shot.turned = {1, 0, 0, -1};
    CHECK(changeBetween(ordinary, flipped, shot).change == 0);
}

TEST_CASE("A part of a picture, and a shifted one, are compared where they show the same")
{
    Image ordinary({4, 4}, 1), quarter({2, 2}, 1), shifted({4, 4}, 1);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            ordinary.at(x, y) = static_cast<float>(x + 4 * y);
            if (x >= 2 && y < 2) quarter.at(x - 2, y) = ordinary.at(x, y);
            if (x >= 1) shifted.at(x - 1, y) = ordinary.at(x, y);
        }
    StressShot shot;
    shot.turned = glm::dmat2(2.0);
    shot.moved = {-1, 1};
    CHECK(changeBetween(ordinary, quarter, shot).change == 0);
    CHECK(changeBetween(ordinary, quarter, shot).ordinary == Approx(4.5));
    shot.moved = {1, 1};
    CHECK(changeBetween(ordinary, quarter, shot).change == 2);
    shot.turned = glm::dmat2(1.0);
    shot.moved = {-0.5, 0};
    shot.border_px = 1;
    CHECK(changeBetween(ordinary, shifted, shot).change == 0);
    shot.moved = {0, 0};
    CHECK(changeBetween(ordinary, shifted, shot).change == 1);
}

TEST_CASE("Frames before the last are those that the case says")
{
    const auto named = [](const char* name) -> const StressCase& {
        for (const StressCase& stress : stressCases())
            if (stress.name == name) return stress;
        throw std::runtime_error(name);
    };
    const Extent size = {96, 54};
    for (const char* name : {"history", "cut"}) {
        const StressCase& stress = named(name);
        for (std::size_t i = 0; i < stress.steps.size(); ++i) {
            INFO(name << ", " << stress.steps[i].label);
            const StressShot shot = stress.shot(stress.steps[i].value, size);
            const bool is_cut = stress.name == "cut";
            REQUIRE(shot.before.size() == (is_cut && i == 0 ? 0 : 16));
            std::size_t same = 0;
            for (const StressFrame& frame : shot.before) {
                same += frame.camera.view_from_world == shot.camera.view_from_world &&
                        frame.camera.clip_from_view == shot.camera.clip_from_view &&
                        frame.moved == glm::dvec3(0.0) && frame.origin == glm::dvec3(0.0);
            }
            CHECK(shot.cut == is_cut);
            if (is_cut)
                CHECK(same == (i == 1 ? 16 : 0));
            else
                CHECK(same == (i == 0 ? 16 : i == 1 || i == 6 || i == 8 ? 3 : 0));
        }
    }
    const StressCase& still = named("still");
    for (const StressStep& step : still.steps)
        CHECK(still.shot(step.value, size).before.at(0).times + 1 == step.value);
}

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

TEST_CASE("A plane's distances are those at which its pixels see it")
{
    const StressView view;
    const Extent size = {64, 36};
    const double tilt = GENERATE(0.0, 40.0, 80.0);
    const PlaneView plane = planeView(view, size, 5, tilt);
    const glm::dmat4 view_from_clip = glm::inverse(glm::dmat4(cameraOf(view, size).clip_from_view));
    const glm::dvec3 normal = {0, std::sin(glm::radians(tilt)), std::cos(glm::radians(tilt))};
    int seen = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double z = plane.distances.at(x, y);
            if (z <= 0) continue;
            ++seen;
            const glm::dvec4 far =
                view_from_clip * glm::dvec4((x + 0.5) / 32 - 1, (y + 0.5) / 18 - 1, 1, 1);
            const glm::dvec3 point = glm::dvec3(far) * (z / -far.z);
            CHECK(std::abs(glm::dot(point - glm::dvec3(0, 0, -5), normal)) < 1e-4 * z);
        }
    CHECK(seen > 64 * 36 / 3);
}

TEST_CASE("A stress run keeps what it drew, goes on from there and keeps pictures of failures")
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
    CHECK(next.lines[3].find("[4/4] learnopengl, plane_fov, 170: BREAKS: mean 0.5") == 0);
    const std::vector<StressSeries> series = seriesOf(next.records);
    REQUIRE(series.size() == 2);
    CHECK(findBreakdown(*series[0].stress, series[0].steps).failures == 0);
    CHECK(findBreakdown(*series[1].stress, series[1].steps).failures == 3);
}

TEST_CASE("A case that does not exist is named with what was meant")
{
    StressOptions options;
    options.cases = {"plane_fvo"};
    const auto tasks = planStress(options, shippedSources());
    REQUIRE_FALSE(tasks.ok());
    CHECK(tasks.diagnostics().size() == 1);
    CHECK(tasks.diagnostics()[0].code == Code::usage);
    CHECK(tasks.diagnostics()[0].help.find("plane_fov") != std::string::npos);
}

TEST_CASE("Stress records come back from their file as they were, and a broken line is named")
{
    const TemporaryFolder folder("stress_records");
    StressRecord record = good();
    record.key = "0123456789abcdef";
    record.overrides = {"radius=1"};
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

TEST_CASE("The stress page holds its figures and needs no other file")
{
    const TemporaryFolder folder("stress_page");
    FakeStress run;
    run.grey = "learnopengl";
    run.run(folder, fewTasks());
    const std::string page = stressHtml(run.records, folder.path.string());
    CHECK(page.find("learnopengl") != std::string::npos);
    CHECK(page.find("breaks at 45: mean 0.5") != std::string::npos);
    CHECK(page.find("/*report.json*/") == std::string::npos);
    CHECK(page.find("http://www.w3.org/2000/svg") != std::string::npos);
    CHECK(page.find("src=\"http") == std::string::npos);
}
