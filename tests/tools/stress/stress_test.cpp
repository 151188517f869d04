// SPDX-License-Identifier: MIT
// Stress cases without GL: what figures mean, where a series breaks, and a run that stops and goes
// on.
#include "tools/report/stress_report.h"
#include "tools/stress/figures.h"
#include "tools/stress/run.h"
#include "tools/stress/scenes.h"

#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <set>

using namespace crevice;

namespace {

/// Five steps, of which the third is ordinary.
StressCase caseOf(Expectation expectation)
{
    StressCase stress;
    stress.name = "made_up";
    stress.steps = {{0, "a"}, {1, "b"}, {2, "c"}, {3, "d"}, {4, "e"}};
    stress.ordinary = 2;
    stress.expectation = expectation;
    return stress;
}

/// A step at which everything is as it should be.
StressRecord good()
{
    StressRecord record;
    record.mean = record.least = record.most = 1;
    record.judged = 100;
    record.judged_mean = record.judged_least = 1;
    return record;
}

/// A step whose exact answer has a tenth of occlusion, of which `strength` is drawn.
StressRecord occluded(double strength)
{
    StressRecord record = good();
    record.radius_px = 20;
    record.exact = 0.1;
    record.occlusion = 0.1 * strength;
    record.mean = record.least = 1 - record.occlusion;
    record.rmse_white = 0.2;
    record.rmse = 0.2 * std::abs(1 - strength);
    return record;
}

struct Series {
    StressCase stress;
    std::vector<StressRecord> records = std::vector<StressRecord>(5, good());

    std::vector<const StressRecord*> pointers() const
    {
        std::vector<const StressRecord*> all;
        for (const StressRecord& record : records) all.push_back(&record);
        return all;
    }
    Breakdown found() const { return findBreakdown(stress, pointers()); }
    Outcome outcome(std::size_t step) const { return judge(stress, pointers(), step).outcome; }
    std::string text() const { return describe(stress, found()); }
};

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

TEST_CASE("A case that holds everywhere reaches its ends")
{
    Series series{caseOf(Expectation::open)};
    CHECK(series.found().failures == 0);
    CHECK(series.text() == "holds from a to e");
}

TEST_CASE("The breakdown point is the first step that fails, walking away from the ordinary one")
{
    Series series{caseOf(Expectation::open)};
    series.records[0].judged_mean = 0.9;
    series.records[3].judged_below = 0.25;
    series.records[3].judged_least = 0.5;
    series.records[4].bad_pixels = 7;
    const Breakdown found = series.found();
    CHECK(found.down.holds_to == 1);
    CHECK(found.down.breaks_at == 0);
    CHECK(found.up.holds_to == 2);
    CHECK(found.up.breaks_at == 3);
    CHECK(found.failures == 3);
    CHECK(series.text() ==
          "holds from b to c; breaks at a: mean 0.9, least 1; breaks at d: mean 1, "
          "least 0.5, 25 % below 0.95");
}

TEST_CASE("A series whose ordinary step fails holds nowhere and breaks there, once")
{
    Series series{caseOf(Expectation::same)};
    series.records[2].out_of_range = 3;
    const Breakdown found = series.found();
    CHECK(found.down.holds_to == -1);
    CHECK(found.up.breaks_at == 2);
    CHECK(series.text() == "breaks at c: 3 pixels out of range, 1 to 1");
    series.records[2].bad_pass = "ssao";
    series.records[2].bad_target = "ao";
    series.records[2].bad_x = 4;
    series.records[2].bad_y = 2;
    series.records[2].bad_value = 1.7;
    CHECK(series.text() ==
          "breaks at c: pass 'ssao' writes 3 pixels out of range into 'ao', the first at (4, 2): "
          "1.7");
}

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
    CHECK(changeBetween(ordinary, turned, shot) > 1);
    shot.turned = {0, 1, -1, 0};
    CHECK(changeBetween(ordinary, turned, shot) == 0);
    CHECK(changeBetween(ordinary, flipped, shot) > 1);
    shot.turned = {1, 0, 0, -1};
    CHECK(changeBetween(ordinary, flipped, shot) == 0);
}

TEST_CASE("Where steps are coarse a picture may change, and what changed is said")
{
    Series series{caseOf(Expectation::same)};
    StressRecord& far = series.records[4];
    far.change = 0.0045;
    far.step_share = 0.019;
    CHECK(series.outcome(4) == Outcome::breaks);
    far.step_share = 0.04;
    far.stored = "depth24";
    far.radius_px = 20;
    far.exact = 0.1;
    far.occlusion = 0.06;
    CHECK(series.outcome(4) == Outcome::beyond);
    CHECK(series.found().failures == 0);
    CHECK(series.text() ==
          "holds from a to d; beyond depth24: 40 % of the occlusion lost, mean change 0.0045 at e");
    far.occlusion = 0.04;
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why == "60 % of the occlusion lost");
}

TEST_CASE("What a format cannot resolve must be sound, and is a figure and no tick")
{
    Series series{caseOf(Expectation::open)};
    series.records[4].resolved = 0;
    series.records[4].mean = 0.93;
    series.records[4].stored = "depth16";
    CHECK(series.outcome(4) == Outcome::beyond);
    CHECK(series.text() == "holds from a to d; beyond depth16: 7 % false occlusion at e");
    series.records[3] = series.records[4];
    series.records[3].mean = 1;
    CHECK(series.text() ==
          "holds from a to c; beyond depth16: 0 % false occlusion at d, 7 % false occlusion at e");
    series.records[4].bad_pixels = 1;
    series.records[4].bad_pass = "ssao";
    series.records[4].bad_target = "ao";
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why.find("pass 'ssao' writes 1 pixels that are not finite") == 0);
}

TEST_CASE(
    "Of every case but planes and no-ops, a white picture fails, and one of half the strength")
{
    const double strength = GENERATE(0.0, 0.14, 0.5);
    for (const StressCase& stress : stressCases()) {
        INFO(stress.name);
        const bool white =
            stress.expectation == Expectation::open || stress.expectation == Expectation::one;
        const StressRecord record = white ? good() : occluded(strength);
        const Series series{stress, std::vector<StressRecord>(stress.steps.size(), record)};
        const Breakdown found = series.found();
        CHECK((found.failures == 0) == white);
        if (white) continue;
        CHECK(found.up.holds_to == -1);
        CHECK(series.text().find("VOID: the ordinary picture has " +
                                 std::to_string(std::lround(strength * 100)) +
                                 " % of the ground truth's occlusion") == 0);
    }
}

TEST_CASE("An ordinary picture is valid by its strength, and closer to the truth than a grey one")
{
    Series series{caseOf(Expectation::same)};
    StressRecord& ordinary = series.records[2];
    const auto outcomeOf = [&](double strength) {
        ordinary = occluded(strength);
        return series.outcome(2);
    };
    CHECK(outcomeOf(0.66) == Outcome::invalid);
    CHECK(outcomeOf(0.67) == Outcome::holds);
    CHECK(outcomeOf(1.49) == Outcome::holds);
    CHECK(outcomeOf(1.51) == Outcome::invalid);
    ordinary = occluded(1);
    ordinary.rmse = 0.18;  // the truth deviates by the root of 0.2^2 - 0.1^2 from its mean
    CHECK(series.outcome(2) == Outcome::invalid);
    CHECK(series.text().find("VOID: the ordinary picture is no closer to the ground truth") == 0);
    ordinary.exact = 0.005;  // a plane
    CHECK(series.outcome(2) == Outcome::holds);
}

TEST_CASE("A step that lost more than half of the ground truth's occlusion fails")
{
    const auto expectation = GENERATE(Expectation::sound, Expectation::opens, Expectation::darkens);
    Series series{caseOf(expectation), std::vector<StressRecord>(5, occluded(0.9))};
    series.records[0].mean = 1;
    StressRecord& step = series.records[4];
    step.occlusion = 0.051;
    CHECK(series.outcome(4) == Outcome::holds);
    step.occlusion = 0.049;
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why == "49 % of the ground truth's occlusion");
    step.radius_px = 1.9;  // nothing of it is on the screen
    CHECK(series.outcome(4) == Outcome::holds);
}

TEST_CASE("What fails in a void case is told as well, and nothing of it holds")
{
    Series series{caseOf(Expectation::same), std::vector<StressRecord>(5, occluded(0.1))};
    series.records[3].change = 0.05;
    series.records[4].bad_pixels = 1;
    CHECK(series.outcome(0) == Outcome::invalid);
    CHECK(series.outcome(3) == Outcome::breaks);
    CHECK(series.found().failures == 3);
    CHECK(series.text() ==
          "VOID: the ordinary picture has 10 % of the ground truth's occlusion; "
          "breaks at d: mean change 0.05");
}

TEST_CASE("A refusal is no failure, and neither is what a config lacks")
{
    Series series{caseOf(Expectation::one)};
    series.records[0].refusal = "CV6011: the camera's clip_from_view has no inverse";
    series.records[4].absent = "no param 'samples'";
    CHECK(series.outcome(0) == Outcome::refused);
    CHECK(series.outcome(4) == Outcome::absent);
    CHECK(series.found().failures == 0);
    CHECK(series.text() == "holds from b to d; 1 refused");
}

TEST_CASE("A no-op must be exact and a change within the limit")
{
    Series one{caseOf(Expectation::one)};
    one.records[1].least = 0.9999;
    CHECK(one.outcome(1) == Outcome::breaks);
    Series same{caseOf(Expectation::same)};
    same.records[1].change = 0.0019;
    CHECK(same.outcome(1) == Outcome::holds);
    same.records[1].change = 0.0021;
    CHECK(same.outcome(1) == Outcome::breaks);
}

TEST_CASE("Smaller radii may not darken, and the smallest leaves all open")
{
    Series series{caseOf(Expectation::opens)};
    series.stress.ordinary = 4;
    for (int i = 0; i < 5; ++i) series.records[i].mean = 1 - 0.05 * i;
    CHECK(series.found().failures == 0);
    series.records[2].mean = 0.8;
    CHECK(series.outcome(2) == Outcome::breaks);
    series.records[0].mean = 0.99;
    CHECK(series.outcome(0) == Outcome::breaks);
}

TEST_CASE("Larger radii may not lighten a corner")
{
    Series series{caseOf(Expectation::darkens)};
    series.stress.ordinary = 0;
    for (int i = 0; i < 5; ++i) series.records[i].mean = 1 - 0.05 * i;
    CHECK(series.found().failures == 0);
    series.records[3].mean = 0.95;
    CHECK(series.found().up.breaks_at == 3);
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

TEST_CASE("Shards of a stress run share its cases out")
{
    StressOptions options;
    options.configs = {"gtao", "learnopengl"};
    const std::size_t all = plan(options).size();
    std::set<std::string> titles;
    for (int index = 1; index <= 3; ++index) {
        options.shard = {index, 3};
        for (const StressTask& task : plan(options)) CHECK(titles.insert(stepTitle(task)).second);
    }
    CHECK(titles.size() == all);
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
