// SPDX-License-Identifier: MIT
// The report's files: complete, self-contained, and safe from what names may hold.
#include "tools/show/report/bench_report.h"

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace crevice;

namespace {

const std::string kPng = "\x89PNG\r\n\x1a\n";

std::vector<BenchSample> sweep()
{
    std::vector<BenchSample> samples;
    for (const int n : {4, 16, 64}) {
        samples.push_back(benchSample("a", n, 0.1 * n, 0.2 / n));
        samples.push_back(benchSample("b", n, 0.2 * n, 0.3));
    }
    return samples;
}

std::string page(const std::vector<BenchSample>& samples)
{
    const auto html = need(reportHtml(samples));
    return html;
}

}  // namespace

TEST_CASE("a report has advice for every device, views, and nothing harmful among its steps")
{
    auto samples = sweep();
    for (BenchSample& sample : samples) sample.error_without_ao = 0.04;
    samples.push_back(benchSample("c", 4, 9, 0.01));
    samples.back().device = "device B";
    const auto report = reportModel(samples);
    CHECK(report["bench_samples"].size() == 7);
    CHECK(report["bench_samples"][0]["label"] == "a samples=4");
    REQUIRE(report["views"].size() == 2);
    CHECK(report["views"][0]["bench_samples"].size() == 6);
    CHECK(report["views"][0]["main"] == true);
    REQUIRE(report["advice"].size() == 2);
    CHECK(report["advice"][1]["device"] == "device B");
    const auto& advice = report["advice"][0];
    REQUIRE(advice["steps"].size() == 2);
    CHECK(advice["steps"][0]["roles"][0] == "cheapest");
    CHECK(advice["steps"][1]["roles"].back() == "most accurate");
    CHECK(advice["harmful"].size() == 4);
}

TEST_CASE("a report names a scene's camera only where there are several")
{
    auto samples = sweep();
    for (BenchSample& sample : samples) sample.camera = "main";
    CHECK(reportModel(samples)["views"][0]["name"] == "room");
    samples[0].camera = "door";
    CHECK(reportModel(samples)["views"][0]["name"] == "room from door");
}

TEST_CASE("a name can neither end the script that holds a report's figures nor turn its text")
{
    auto samples = sweep();
    samples[0].config = "</script><script>alert(1)</script><!--";
    samples[1].config =
        "a\xE2\x80\xAE"
        "b\xC2\x9B";
    const std::string html = page(samples);
    CHECK(!has(html, "<script>alert"));
    CHECK(!has(html, "\xE2\x80\xAE"));
    CHECK(has(html, "a\\\\u202eb\\\\u009b"));
}

TEST_CASE("pictures become part of the page, each once")
{
    const TemporaryFolder folder("bench_report");
    auto samples = sweep();
    for (BenchSample& sample : samples) sample.folder = folder.path.string();
    samples[0].ao_picture = samples[1].ao_picture = folder.write("a.png", kPng + "Ma");
    samples[2].ao_picture = folder.write("b.png", kPng + "M");
    samples[3].ao_picture = folder.write("c/c.png", kPng + "\xff\xfe\xfd");
    const std::string html = page(samples);
    const std::string once = "base64,iVBORw0KGgpNYQ==\"";
    const std::size_t first = html.find("data:image/png;" + once);
    REQUIRE(first != std::string::npos);
    CHECK(html.find(once, first + 30) == std::string::npos);
    CHECK(has(html, "base64,iVBORw0KGgpN\""));
    CHECK(has(html, "base64,iVBORw0KGgr//v0=\""));
}

TEST_CASE("a report says what failed, even where everything did")
{
    BenchSample failed = benchSample("a", 4, 0, 0);
    failed.failure = "the shader does not link";
    CHECK(reportModel({failed})["views"].empty());
    CHECK(has(page({failed}), "the shader does not link"));
    CHECK(!page({}).empty());
}

TEST_CASE("the CSV has a row a sample, quotes what needs it, and motion where it was measured")
{
    auto samples = sweep();
    samples[0].device = "Mesa, \"llvmpipe\"";
    samples[1].failure = "no memory";
    samples[1].motion.paths["pan"] = {0.0123, 0.05, 0.25, 0.004, 0.0678, 1000};
    samples[1].motion.settled_after = 3;
    const std::string csv = reportCsv(samples);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 7);
    CHECK(csv.rfind("config,", 0) == 0);
    CHECK(has(csv, ",\"Mesa, \"\"llvmpipe\"\"\","));
    CHECK(has(csv, ",geometry=0.4 ao=0.4,"));
    CHECK(has(csv, ",no memory,"));
    CHECK(has(csv, ",0.0678,3,"));
}

TEST_CASE("no name in the CSV is a spreadsheet's formula, and each can be told from it")
{
    const std::string names[] = {"=1+1", "+geometry/a", "-2+3", "@SUM(1)",
                                 "\t=1", "\n=1",        "'a",   "a=1"};
    std::vector<BenchSample> samples;
    for (const std::string& name : names) {
        samples.push_back(benchSample(name, 4, 0.1, 0.2));
        samples.back().overrides = {"=x", "y"};
        samples.back().scene = "=cmd|' /C calc'!A0";
        samples.back().error.bias = -0.25;
    }
    const std::string csv = reportCsv(samples);
    for (const char* cell :
         {"\r\n'=1+1,", "\r\n'+geometry/a,", "\r\n'-2+3,", "\r\n'@SUM(1),", "\r\n\"'\t=1\",",
          "\r\n\"'\n=1\",", "\r\n''a,", "\r\na=1,", ",'=x y,", ",'=cmd|' /C calc'!A0,", ",-0.25,"})
        CHECK(has(csv, cell));
    for (const char* formula : {",=", ",+", ",@", "\n+", "\n-", "\n@"})
        CHECK_FALSE(has(csv, formula));
}
