// SPDX-License-Identifier: MIT
// Bench results on disk: what is written comes back, and what an interrupt leaves does no harm.
// The regression guard: errors count in both directions, ratios that grow, absolute times never.
#include "tools/measure/bench/sample.h"

#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/fixture.h"
#include "tools/measure/bench/choice.h"

#include <limits>

using namespace crevice;

namespace {

std::string line(const BenchSample& sample) { return toJsonLine(sample) + "\n"; }

BenchSample sampleBefore()
{
    BenchSample sample = benchSample("a", 16, 2, 0.1);
    sample.motion.paths["pan"].rms = 0.02;
    sample.motion.paths["pan"].rmse = 0.05;
    return sample;
}

const BenchSample kBefore = sampleBefore();

/// "worse rmse, odd bias, cheaper ratio_learnopengl, no ratios": what a comparison says.
std::string told(const BenchComparison& comparison)
{
    const char* const words[] = {"cheaper", "odd", "worse", "fails", "missing"};
    std::vector<std::string> all;
    bool fine = true;
    for (const BenchChange& change : comparison.changes) {
        all.push_back(words[static_cast<int>(change.kind)] + (" " + change.figure));
        fine = fine && change.kind == BenchChange::Kind::cheaper;
    }
    CHECK(comparison.differs() == !fine);
    if (comparison.without_ratios > 0) all.push_back("no ratios");
    return joined(all);
}

struct Row {
    void (*edit)(BenchSample& now);
    const char* told;
    bool errors_only = false;
};

const Row kRows[] = {
    {[](BenchSample& now) {  // times and keys alone
         now.total.median *= 10;
         now.cost.median *= 10;
         now.key = "of an edited shader";
         now.version = "1.1";
     },
     ""},
    {[](BenchSample& now) { now.error.rmse += 0.9e-6; }, ""},
    {[](BenchSample& now) { now.error.rmse -= 0.9e-6; }, ""},
    {[](BenchSample& now) { now.error.rmse += 0.0002; }, "worse rmse"},
    {[](BenchSample& now) { now.error.rmse -= 0.0002; }, "odd rmse"},
    {[](BenchSample& now) { now.error.rmse_fit += 0.0002; }, "worse rmse_fit"},
    {[](BenchSample& now) { now.error.bias += 0.0002; }, "odd bias"},
    {[](BenchSample& now) { now.error.bias -= 0.0002; }, "worse bias"},
    {[](BenchSample& now) { now.error.bias = -now.error.bias + 0.01; }, "worse bias"},
    {[](BenchSample& now) { now.error.bias = -now.error.bias - 0.01; }, "odd bias"},
    {[](BenchSample& now) {  // across versions
         now.error.rmse += 0.9e-4;
         now.version = "1.1";
     },
     ""},
    {[](BenchSample& now) {
         now.error.rmse += 0.9e-4;
         now.device = "device B";
         now.ratio_learnopengl *= 5;
     },
     "no ratios"},
    {[](BenchSample& now) {
         now.error.rmse += 1.1e-4;
         now.device = "device B";
     },
     "worse rmse, no ratios"},
    {[](BenchSample& now) {
         now.error.rmse += 0.1;
         now.clock = "cpu";
         now.ratio_learnopengl *= 5;
     },
     "worse rmse, no ratios"},
    {[](BenchSample& now) { now.ratio_learnopengl *= 1.14; }, ""},
    {[](BenchSample& now) { now.ratio_learnopengl *= 1.16; }, "worse ratio_learnopengl"},
    {[](BenchSample& now) { now.ratio_learnopengl *= 1.16; }, "", true},
    {[](BenchSample& now) { now.ratio_learnopengl /= 2; }, "cheaper ratio_learnopengl"},
    {[](BenchSample& now) { now.ratio_learnopengl = 0; }, ""},
    {[](BenchSample& now) { now.motion = {}; }, ""},
    {[](BenchSample& now) {
         now.motion.paths["pan"].rms = 0.021;
         now.motion.paths["pan"].rmse = 0.049;
     },
     "worse motion pan, odd motion pan rmse"},
    {[](BenchSample& now) { now.disable = {"no_op"}; }, ""},  // which may change no pixel
    {[](BenchSample& now) { now.failure = "no memory"; }, "fails no memory"},
    {[](BenchSample& now) { now.config = "b"; }, "missing "},
    {[](BenchSample& now) { now.radius = 2; }, "missing "},
};

}  // namespace

TEST_CASE("a bench sample comes back as it was written")
{
    const TemporaryFolder folder("bench_sample");
    BenchSample sample = benchSample("mine \"quoted\"", 16, 1.0 / 3.0, 0.1);
    sample.camera = "above";
    sample.software = true;
    sample.texture_bytes = 1e9;
    const auto read = readBenchSamples({folder.write("a.jsonl", line(sample))});
    REQUIRE(read.ok());
    CHECK(read.diagnostics().empty());
    REQUIRE(read->size() == 1);
    CHECK(toJsonLine(read->front()) == toJsonLine(sample));
    CHECK(read->front().cost.median == 1.0 / 3.0);
    CHECK(read->front().passes.at(1).name == "ao");
}

TEST_CASE("of two lines about one bench sample the later one holds, whatever its key")
{
    const TemporaryFolder folder("bench_sample");
    const std::string first = folder.write(
        "a.jsonl", line(benchSample("a", 4, 1, 0.1)) + line(benchSample("b", 4, 1, 0.1)));
    BenchSample edited = benchSample("a", 4, 1, 0.2);
    edited.key = "of another shader";
    BenchSample elsewhere = benchSample("b", 4, 1, 0.3);
    elsewhere.device = "device B";
    const std::string second = folder.write("b.jsonl", line(edited) + line(elsewhere));
    const auto read = readBenchSamples({first, second});
    REQUIRE(read.ok());
    REQUIRE(read->size() == 3);
    CHECK(read->at(0).error.rmse == 0.2);
    CHECK(read->at(1).config == "b");
    CHECK(read->at(2).device == "device B");
}

TEST_CASE("motion comes back as it was written, and lines without it have none")
{
    const TemporaryFolder folder("bench_sample");
    BenchSample moving = benchSample("a", 4, 1, 0.1);
    moving.motion.paths["sub-pixel"] = {0.01, 0.02, 0.3, 0.004, 0.05, 1000};
    moving.motion.uncovered = {{1, 0.3}, {16, 0.1}};
    const BenchSample still = benchSample("c", 4, 1, 0.1);
    CHECK(line(still).find("motion") == std::string::npos);
    const auto read = readBenchSamples({folder.write("a.jsonl", line(moving) + line(still))});
    REQUIRE(read.ok());
    CHECK(line(read->at(0)) == line(moving));
    CHECK(read->at(0).motion.paths.at("sub-pixel").p999 == 0.3);
    CHECK(read->at(1).motion.paths.empty());
}

TEST_CASE("a bench failure hides no figures but of another shader, and figures end a failure")
{
    const TemporaryFolder folder("bench_sample");
    const BenchSample good = benchSample("a", 4, 1, 0.1);
    BenchSample failed = good, edited = good;
    failed.failure = edited.failure = "the device has no memory left";
    edited.key = "of another shader";
    for (const auto& [text, fails] : {std::pair(line(good) + line(failed), false),
                                      {line(failed) + line(good), false},
                                      {line(good) + line(edited), true}}) {
        const auto read = readBenchSamples({folder.write("a.jsonl", text)});
        REQUIRE(read.ok());
        REQUIRE(read->size() == 1);
        CHECK(read->front().failure.empty() != fails);
    }
}

TEST_CASE("a bench line that was cut short costs a warning and that line alone")
{
    const TemporaryFolder folder("bench_sample");
    const std::string whole = line(benchSample("a", 4, 1, 0.1));
    const std::string cut = toJsonLine(benchSample("b", 4, 1, 0.1)).substr(0, 200);
    const std::string after = line(benchSample("c", 4, 1, 0.1));
    const auto read =
        readBenchSamples({folder.write("a.jsonl", whole + cut + "\n\n" + after + cut)});
    REQUIRE(read.ok());
    REQUIRE(read->size() == 2);
    CHECK(read->at(1).config == "c");
    REQUIRE(read.diagnostics().size() == 2);
    CHECK(read.diagnostics()[0].severity == Severity::warning);
    CHECK(placeName(read.diagnostics()[0].place) == (folder.path / "a.jsonl").string() + ":2:1");
}

TEST_CASE("a line that is no bench sample is an error at its place")
{
    const TemporaryFolder folder("bench_sample");
    for (const char* text : {"{}", "[1, 2]", "no JSON", "{\"key\": 3}", "{}}"}) {
        CAPTURE(text);
        const auto read = readBenchSamples(
            {folder.write("a.jsonl", line(benchSample("a", 4, 1, 0.1)) + text + "\n")});
        REQUIRE(!read.ok());
        CHECK(read.diagnostics().front().code == Code::results_broken);
        CHECK(read.diagnostics().front().place.line == 2);
        CHECK(!read.diagnostics().front().help.empty());
    }
}

TEST_CASE("a bench figure that is not finite makes its sample a failure")
{
    const TemporaryFolder folder("bench_sample");
    BenchSample sample = benchSample("a", 4, 1, 0.1);
    sample.error.rmse = std::numeric_limits<double>::quiet_NaN();
    const auto read = readBenchSamples({folder.write("a.jsonl", line(sample))});
    REQUIRE(read.ok());
    REQUIRE(read->size() == 1);
    CHECK(read->front().failure == "a figure is not finite");
}

TEST_CASE("a bench counts errors in both directions, ratios that grow, and no times")
{
    for (const Row& row : kRows) {
        BenchSample now = kBefore;
        row.edit(now);
        INFO("row " << &row - kRows);
        CHECK(told(compareBenches({kBefore}, {now}, row.errors_only)) == row.told);
    }
}

TEST_CASE("of samples of one question that from the same device is compared, then one as it was")
{
    BenchSample elsewhere = kBefore, bare = kBefore;
    elsewhere.device = "device B";
    bare.disable = {"no_op"};
    bare.error.rmse += 0.1;
    elsewhere.error.rmse += 0.1;
    CHECK(told(compareBenches({kBefore}, {bare, elsewhere, kBefore})).empty());
    CHECK(told(compareBenches({bare}, {kBefore, bare})).empty());
    CHECK(told(compareBenches({kBefore}, {elsewhere, bare})) == "worse rmse");
}

TEST_CASE("what failed before does not count, whatever it is now")
{
    BenchSample failed = kBefore;
    failed.failure = "no memory";
    CHECK(told(compareBenches({failed}, {kBefore})).empty());
    CHECK(told(compareBenches({failed}, {})).empty());
}
