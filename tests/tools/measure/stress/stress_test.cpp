// SPDX-License-Identifier: MIT
// Stress cases without GL: their shots, and what a run keeps.
// Breakdown points as sentences, and what is worse than known: no GL.
#include "tools/measure/stress/record.h"
#include "tools/measure/stress/run.h"
#include "tools/measure/stress/scenes.h"

#include "tests/support/need.h"
#include "tests/support/shipped_subjects.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/stress/made_records.h"

#include <set>

using namespace crevice;

namespace {

std::vector<StressTask> fewTasks()
{
    StressOptions options;
    options.configs = {"gtao", "learnopengl"};
    options.cases = {"plane_fov"};
    options.quick = true;
    return need(planStress(options, shippedSources()));
}

using Sentences = std::vector<std::string>;

const StressCase& caseNamed(const std::string& name) { return *findNamed(stressCases(), name); }

struct Run {
    std::vector<StressRecord> records;

    /// A case of which nothing fails. The first of its records.
    std::size_t add(const std::string& name)
    {
        const std::size_t first = records.size();
        for (std::size_t i = 0; i < caseNamed(name).steps.size(); ++i) {
            StressRecord record = good();
            record.config = "gtao";
            record.case_name = name;
            record.step = static_cast<int>(i);
            record.height_px = 100;
            record.radius_px = 20.0 * static_cast<double>(i + 1);
            records.push_back(record);
        }
        return first;
    }

    /// 3 % of the ground truth's occlusion, from the record on.
    void lose(std::size_t from)
    {
        for (std::size_t i = from; i < records.size(); ++i) {
            records[i].exact = 0.1;
            records[i].occlusion = 0.003;
            records[i].rmse = 0.1;
        }
    }

    Sentences sentences() const
    {
        Sentences all;
        for (const BreakdownPoint& point : breakdownPoints(seriesOf(records)))
            all.push_back(sentenceOf(point));
        return all;
    }
};

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

TEST_CASE("A breakdown point is told between the last step that holds and the first that breaks")
{
    Run run;
    run.add("wall_walk");
    CHECK(run.sentences().empty());
    run.lose(4);
    const Sentences told = {
        "AO of `gtao` is lost where the radius is taller than 0.8 screens: at 1, 3 % of the ground "
        "truth's occlusion."};
    CHECK(run.sentences() == told);

    // Another case breaks so later, which says no more.
    run.lose(run.add("corner_radius") + 11);
    CHECK(run.sentences() == told);
}

TEST_CASE("Of kinds all that break are told, those of one effect together")
{
    Run run;
    run.add("orientation");
    for (const int kind : {1, 3, 4}) run.records[kind].change = 0.1 * kind;
    run.records[2].bad_pixels = 1;
    CHECK(run.sentences() ==
          Sentences{"AO of `gtao` changes where the projection is flipped in y, turned by 90, "
                    "turned by 180: mean change 0.1.",
                    "AO of `gtao` has values that are not numbers where the projection is flipped "
                    "in x: pass '' writes 1 pixels that are not finite."});
}

TEST_CASE("A config whose ordinary pictures are wrong says so once")
{
    Run run;
    for (const char* name : {"offset", "wall_walk", "units"})
        run.lose(run.add(name) + caseNamed(name).ordinary);
    CHECK(run.sentences() == Sentences{"AO of `gtao` is wrong to begin with: the ordinary picture "
                                       "has 3 % of the ground truth's occlusion."});
}

namespace {

Sentences worseIn(const Run& now, const Run& before, const KnownConfig& config = {"gtao"})
{
    int unjudged = 0;
    Sentences all;
    for (const StressSeries& series : seriesOf(now.records))
        for (const std::string& each :
             worseThan(standingsOf(seriesOf(before.records)), config, series, unjudged))
            all.push_back(each);
    if (unjudged > 0) all.push_back(std::to_string(unjudged) + " unjudged");
    return all;
}

}  // namespace

TEST_CASE("A step that is not known counts as one that held, or is left unjudged")
{
    Run now;
    now.add("mirrored");
    now.records[1].change = 0.1;
    CHECK(worseIn(now, Run()).size() == 1);
    CHECK(worseIn(now, Run(), {"gtao", true, true}) ==
          Sentences{std::to_string(now.records.size()) + " unjudged"});
}

TEST_CASE("A step is worse where it fails and did not before, or where its error grew")
{
    Run old;
    old.add("mirrored");
    Run edited = old;
    edited.records[1].change = 0.0019;
    CHECK(worseIn(edited, old).empty());
    old.records[2].change = edited.records[2].change = 0.003;  // a known failure
    CHECK(worseIn(edited, old).empty());
    edited.records[2].change = 0.006;
    edited.records[2].departing_pass = "filter_x";
    CHECK(worseIn(edited, old) ==
          Sentences{"gtao, mirrored, in the vertices: error 0.006, was 0.003, first in pass "
                    "'filter_x'"});
    old.records[2].change = 0;
    CHECK(worseIn(edited, old) == Sentences{"gtao, mirrored, in the vertices: breaks: mean change "
                                            "0.006, first in pass 'filter_x'"});
    edited.records[2].change = 0;
    edited.records[1].background = 0;
    CHECK(worseIn(edited, old) == Sentences{"gtao, mirrored, by a matrix: breaks: 0 where no "
                                            "surface is seen"});
}

TEST_CASE("A config has up to twice the error of the one that it extends before it is worse")
{
    Run old;
    old.add("low_eye");
    old.records[0].rmse = 0.05;
    Run mine = old;
    mine.records[0].rmse = 0.099;
    CHECK(worseIn(mine, old, {"gtao", false}).empty());
    CHECK(worseIn(mine, old).size() == 1);
    mine.records[0].rmse = 0.101;
    CHECK(worseIn(mine, old, {"gtao", false}) ==
          Sentences{"gtao, low_eye, 1: error 0.101, `gtao` has 0.05"});
    mine.records[0].rmse = 0;
    mine.records[1].bad_pixels = 1;
    CHECK(worseIn(mine, old, {"gtao", false}).size() == 1);
}

TEST_CASE("Known steps come back from their file as they were, and a broken line is named")
{
    Run run;
    run.add("mirrored");
    run.records[1].change = 0.125;
    const KnownSteps known = standingsOf(seriesOf(run.records));
    const TemporaryFolder folder("known_steps");
    const KnownSteps read = need(readKnownSteps(folder.write("known.jsonl", toLines(known))));
    CHECK(toLines(read) == toLines(known));
    CHECK(read.at({"gtao", "mirrored"}).at("by a matrix").outcome == Outcome::breaks);
    const auto broken =
        readKnownSteps(folder.write("bad.jsonl", toLines(known) + "{\"case\": 1}\n"));
    CHECK(onlyError(broken, Code::results_broken).place.line == 2);
}

TEST_CASE(
    "Every shipped config has known steps of every case, and a config is known by what it extends")
{
    for (const std::string& config : configNames(shippedSources())) {
        const Description description = descriptionOf({config});
        const bool counted = findNamed(description.params, "samples") ||
                             findNamed(description.params, "steps");  // its taps
        for (const StressCase& stress : stressCases()) {
            INFO(config << ", " << stress.name);
            const auto known = shippedSteps().find({config, stress.name});
            const bool absent = stress.expectation == Expectation::settles ||
                                stress.name == "history" || stress.name == "cut" ||
                                (stress.unit == "taps" && !counted) ||
                                !stress.shot(0, {64, 36}).geometry.empty();
            CHECK((absent || known != shippedSteps().end()));
        }
    }
    const auto nameOf = [](const char* config) {
        return shippedNameOf({config, {}, {}, {}}, shippedSources());
    };
    CHECK(nameOf("gtao") == "gtao");
    CHECK(nameOf(R"({"format": 1, "extends": ["bitmask_back"]})") == "bitmask_back");
    CHECK(nameOf(R"({"format": 1, "extends": ["geometry/depth_normal", "ssao/gtao"]})").empty());
    CHECK(nameOf("nothing").empty());
}
