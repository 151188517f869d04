// SPDX-License-Identifier: MIT
// Bench results on disk: what is written comes back, and what an interrupt leaves does no harm.
#include "tools/measure/bench/sample.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/fixture.h"

#include <limits>

using namespace crevice;

namespace {

std::string line(const BenchSample& sample) { return toJsonLine(sample) + "\n"; }

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
