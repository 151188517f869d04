// SPDX-License-Identifier: MIT
// Breakdown points as sentences, and two runs compared: no GL.
#include "tools/measure/stress/breakdown.h"
#include "tests/tools/measure/stress/made_records.h"

#include "tests/support/catch.h"

#include <algorithm>

using namespace crevice;

namespace {

using Sentences = std::vector<std::string>;

const StressCase& caseNamed(const std::string& name)
{
    return *std::find_if(stressCases().begin(), stressCases().end(),
                         [&](const StressCase& each) { return each.name == name; });
}

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

TEST_CASE("A run differs from the one before where an outcome or a figure is another")
{
    Run old;
    old.add("mirrored");
    Run edited = old;
    const auto differences = [&] {
        return differencesSince(seriesOf(old.records), seriesOf(edited.records));
    };
    edited.records[1].mean -= 0.0019;
    CHECK(differences().empty());
    edited.records[1].mean -= 0.0002;
    CHECK(differences() == Sentences{"gtao, mirrored, by a matrix: mean 0.9979, was 1"});
    edited.records[1] = old.records[1];
    old.records[2].change = edited.records[2].change = 0.003;  // a failure that hides nothing
    CHECK(differences().empty());
    edited.records[2].change = 0.006;
    edited.records[2].departing_pass = "filter_x";
    CHECK(differences() == Sentences{"gtao, mirrored, in the vertices: change 0.006, was 0.003, "
                                     "first in pass 'filter_x'"});
    old.records[2].change = 0;
    CHECK(differences() == Sentences{"gtao, mirrored, in the vertices: breaks: mean change 0.006, "
                                     "first in pass 'filter_x'"});
}
