// SPDX-License-Identifier: MIT
// Breakdown points as sentences, their order, and the pictures they are shown by: no GL.
#include "tests/tools/measure/stress/made_records.h"
#include "tools/measure/stress/pictures.h"
#include "tools/show/report/stress_report.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <stdexcept>

using namespace crevice;

namespace {

const StressCase& caseNamed(const std::string& name)
{
    for (const StressCase& stress : stressCases())
        if (stress.name == name) return stress;
    throw std::runtime_error(name);
}

/// The records of a case of which nothing fails; a tenth of it is occluded, on 100 pixels.
std::vector<StressRecord> recordsOf(const StressCase& stress, const std::string& format = "")
{
    std::vector<StressRecord> records;
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        StressRecord record = good();
        record.config = "gtao";
        record.case_name = stress.name;
        record.format = format;
        record.step = static_cast<int>(i);
        record.key = stress.name + format + std::to_string(i);
        record.label = stress.steps[i].label;
        record.value = stress.steps[i].value;
        record.height_px = 100;
        record.radius_px = 20.0 * static_cast<double>(i + 1);
        records.push_back(record);
    }
    return records;
}

/// 3 % of the ground truth's occlusion, from the step on.
void lose(std::vector<StressRecord>& records, std::size_t from)
{
    for (std::size_t i = from; i < records.size(); ++i) {
        records[i].exact = 0.1;
        records[i].occlusion = 0.003;
        records[i].rmse = 0.1;
    }
}

struct Run {
    std::vector<StressRecord> records;

    void add(const std::vector<StressRecord>& more)
    {
        records.insert(records.end(), more.begin(), more.end());
    }

    std::vector<std::string> sentences() const
    {
        std::vector<std::string> all;
        for (const BreakdownPoint& point : breakdownPoints(seriesOf(records)))
            all.push_back(sentenceOf(point));
        return all;
    }
};

using Sentences = std::vector<std::string>;

}  // namespace

TEST_CASE("Every case says where it breaks, how many users meet that and why")
{
    for (const StressCase& stress : stressCases()) {
        INFO(stress.name);
        CHECK_FALSE(stress.words.because.empty());
        const bool kinds = stress.unit.empty();
        const bool has_up = kinds || stress.ordinary + 1 < stress.steps.size();
        const bool has_down = !kinds && stress.ordinary > 0;
        CHECK((stress.words.up.where.find("{}") != std::string::npos) == has_up);
        CHECK((stress.words.down.where.find("{}") != std::string::npos || !has_down));
    }
}

TEST_CASE("A breakdown point is told between the last step that holds and the first that breaks")
{
    Run run;
    run.add(recordsOf(caseNamed("wall_walk")));
    CHECK(run.sentences().empty());
    lose(run.records, 4);
    CHECK(
        run.sentences() ==
        Sentences{"AO of `gtao` is lost where the radius is taller than 0.8 screens: at 1, 3 % of "
                  "the ground truth's occlusion (a corner of a room walked up to)."});
    const auto points = breakdownPoints(seriesOf(run.records));
    REQUIRE(points.size() == 1);
    CHECK(points[0].before->step == 3);
    CHECK(points[0].after->step == 4);
    CHECK(likelihoodOf(points[0]) == "Every application meets it: cameras walk up to walls.");
}

TEST_CASE("Cases of one cause are one sentence, of the case that breaks first and the likeliest")
{
    Run run;
    for (const char* name : {"radius_growing", "wall_walk"}) {
        std::vector<StressRecord> records = recordsOf(caseNamed(name));
        lose(records, std::string(name) == "wall_walk" ? 5 : 2);
        run.add(records);
    }
    const auto points = breakdownPoints(seriesOf(run.records));
    REQUIRE(points.size() == 1);
    CHECK(points[0].held == "0.4");
    CHECK(points[0].others == Sentences{"`wall_walk` at 1.2"});
    CHECK(points[0].likelihood == Likelihood::every);
    CHECK(points[0].because == "cameras walk up to walls");
}

TEST_CASE("Two sides of a case that break alike are one sentence")
{
    Run run;
    run.add(recordsOf(caseNamed("off_centre")));
    run.records[0].change = run.records[3].change = run.records[4].change = 0.1;
    CHECK(run.sentences() ==
          Sentences{"AO of `gtao` changes where the frustum is shifted by more than 0 % of the "
                    "width: at 12, mean change 0.1."});
}

TEST_CASE("What more users meet comes first, then what fewer steps lead to")
{
    Run run;
    std::vector<StressRecord> broken = recordsOf(caseNamed("host_depth"));
    broken[1].change = 0.5;
    std::vector<StressRecord> far = recordsOf(caseNamed("offset"));
    for (std::size_t i = 4; i < far.size(); ++i) far[i].change = 0.1;
    std::vector<StressRecord> low = recordsOf(caseNamed("low_eye"));
    lose(low, 2);
    std::vector<StressRecord> near = recordsOf(caseNamed("wall_walk"));
    lose(near, 6);
    for (const auto& records : {broken, far, low, near}) run.add(records);
    std::vector<std::string> order;
    for (const BreakdownPoint& point : breakdownPoints(seriesOf(run.records)))
        order.push_back(point.stress->name);
    CHECK(order == Sentences{"wall_walk", "low_eye", "offset", "host_depth"});
}

TEST_CASE("Of kinds all that break are told, those of one effect together")
{
    Run run;
    run.add(recordsOf(caseNamed("orientation")));
    for (const int kind : {1, 3, 4}) run.records[kind].change = 0.1 * kind;
    run.records[2].bad_pixels = 1;
    CHECK(run.sentences() ==
          Sentences{
              "AO of `gtao` changes where the projection is flipped in y, turned by 90 or turned "
              "by 180: mean "
              "change 0.4.",
              "AO of `gtao` has values that are not numbers where the projection is flipped in x: "
              "pass '' writes 1 pixels that are not finite."});
}

TEST_CASE("A format is told only where it breaks earlier than the config's own")
{
    Run run;
    for (const char* format : {"", "depth=depth16", "depth=depth24"}) {
        std::vector<StressRecord> records = recordsOf(caseNamed("plane_near_far"), format);
        const std::size_t from = format == std::string("depth=depth16") ? 2 : 3;
        for (std::size_t i = from; i < records.size(); ++i) records[i].judged_mean = 0.5;
        run.add(records);
    }
    CHECK(
        run.sentences() ==
        Sentences{
            "AO of `gtao` darkens a flat plane where near:far is wider than 0.1:316 with depth16: "
            "at 0.01:1e4, mean 0.5, least 1.",
            "AO of `gtao` darkens a flat plane where near:far is wider than 0.01:1e4: at 1e-3:3e5, "
            "mean 0.5, least 1."});
}

TEST_CASE("Lost occlusion is told even where the format is to blame")
{
    Run run;
    run.add(recordsOf(caseNamed("near_far")));
    StressRecord& last = run.records.back();
    last.step_share = 1;
    last.resolved = 0;
    last.stored = "depth24";
    last.exact = 0.1;
    last.occlusion = 0.09;
    CHECK(run.sentences().empty());
    last.occlusion = 0.01;
    CHECK(run.sentences() ==
          Sentences{"AO of `gtao` is lost where near:far is wider than 1e-3:3e5: at 1e-4:1e7, 90 % "
                    "of the occlusion lost, mean change 0, more than depth24 can resolve."});
}

TEST_CASE("A config whose ordinary pictures are wrong says so first, and once")
{
    Run run;
    for (const char* name : {"offset", "wall_walk", "units", "sizes", "low_eye", "mirrored"}) {
        std::vector<StressRecord> records = recordsOf(caseNamed(name));
        lose(records, caseNamed(name).ordinary);
        run.add(records);
    }
    REQUIRE_FALSE(run.sentences().empty());
    CHECK(run.sentences()[0] ==
          "AO of `gtao` is wrong to begin with: the ordinary picture has 3 % of the ground truth's "
          "occlusion (also 5 other cases).");
    CHECK(run.sentences().size() == 1);
}

TEST_CASE("The pictures before and after a breakdown point are drawn where they are not there")
{
    const TemporaryFolder folder("stress_pictures");
    const StressCase& stress = caseNamed("wall_walk");
    Run run;
    run.add(recordsOf(stress));
    lose(run.records, 4);
    std::vector<StressTask> tasks;
    MeasureJob steps;
    for (const StressRecord& record : run.records) {
        tasks.push_back({{}, &stress, "", record.step});
        steps.tasks.push_back({record.key, record.label, {}});
    }
    std::vector<int> drawn;
    const auto draw = [&](const StressTask& task) {
        drawn.push_back(task.step);
        StressDrawing done;
        done.ao = done.ground_truth = Image({2, 2}, 1, 1.0f);
        return done;
    };
    const auto points = breakdownPoints(seriesOf(run.records));
    const std::string path = folder.path.string();
    const MeasureJob job = pictureJob(tasks, steps, points, path, draw);
    REQUIRE(job.tasks.size() == 2);
    for (std::size_t i = 0; i < job.tasks.size(); ++i) CHECK(job.measure(i).ok());
    CHECK(drawn == std::vector<int>{3, 4});
    CHECK(pictureJob(tasks, steps, points, path, draw).tasks.empty());

    const std::string page = stressHtml(run.records, path);
    CHECK(page.find("where the radius is taller than 0.8 screens") != std::string::npos);
    for (const char* caption : {"holds at 0.8", "breaks at 1", "ground truth of that"})
        CHECK(page.find(std::string("\"caption\":\"") + caption) != std::string::npos);
    for (const char* picture : {"wall_walk3.png", "wall_walk4.png", "wall_walk4_truth.png"})
        CHECK(page.find(std::string("\"pictures/") + picture + "\":\"data:image/png") !=
              std::string::npos);
}
