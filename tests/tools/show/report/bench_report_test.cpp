// SPDX-License-Identifier: MIT
// The report's files: complete, self-contained, and safe from what names may hold.
#include "tools/show/report/bench_report.h"

#include "tests/support/catch.h"
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
    const auto html = reportHtml(samples);
    REQUIRE(html.ok());
    return *html;
}

bool holds(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a report names fronts, slopes and advice")
{
    const auto report = nlohmann::json::parse(reportJson(sweep()));
    CHECK(report["bench_samples"].size() == 6);
    REQUIRE(report["views"].size() == 1);
    const auto& view = report["views"][0];
    CHECK(view["front_ms"] == nlohmann::json({0, 2, 4}));
    CHECK(view["front_ratio"] == view["front_ms"]);
    const auto curve = std::find_if(
        view["curves"].begin(), view["curves"].end(),
        [](const auto& c) { return c["kind"] == "error_samples" && c["family"] == "a"; });
    REQUIRE(curve != view["curves"].end());
    CHECK((*curve)["slope"].get<double>() == Approx(-1));
    const auto& advice = report["advice"][0];
    CHECK(advice["steps"].size() == 3);
    CHECK(advice["steps"][0]["roles"][0] == "cheapest");
    CHECK(advice["steps"][2]["roles"].back() == "most accurate");
}

TEST_CASE("a report puts nothing on a front that is no better than no ambient occlusion")
{
    auto samples = sweep();
    for (BenchSample& sample : samples) sample.error_without_ao = 0.04;
    const auto report = nlohmann::json::parse(reportJson(samples));
    CHECK(report["views"][0]["front_ms"] == nlohmann::json({2, 4}));
    CHECK(report["views"][0]["error_without_ao"] == 0.04);
    CHECK(report["advice"][0]["steps"].size() == 2);
    CHECK(report["advice"][0]["harmful"].size() == 4);
}

TEST_CASE("a report names a scene's camera only where there are several")
{
    auto samples = sweep();
    for (BenchSample& sample : samples) sample.camera = "main";
    CHECK(nlohmann::json::parse(reportJson(samples))["views"][0]["name"] == "room");
    samples[0].camera = "door";
    CHECK(nlohmann::json::parse(reportJson(samples))["views"][0]["name"] == "room from door");
}

TEST_CASE("a report knows cost over pixels, radius and triangles")
{
    auto samples = sweep();
    for (const double factor : {2.0, 4.0}) {
        BenchSample large = benchSample("a", 4, 0.4 * factor * factor, 0.05);
        large.extent = {static_cast<int>(960 * factor), static_cast<int>(540 * factor)};
        BenchSample wide = benchSample("a", 4, 0.4 * factor, 0.05);
        wide.radius = factor;
        wide.radius_px = 80 * factor;
        BenchSample dense = benchSample("a", 4, 0.4, 0.05, "dense" + std::to_string(factor));
        dense.triangles = static_cast<long long>(1000 * factor);
        samples.insert(samples.end(), {large, wide, dense});
    }
    const auto report = nlohmann::json::parse(reportJson(samples));
    const auto slope = [](const nlohmann::json& curves, const char* kind) {
        for (const auto& curve : curves)
            if (curve["kind"] == kind && curve["label"] == "a samples=4")
                return curve["slope"].get<double>();
        return -99.0;
    };
    for (const auto& view : report["views"]) {
        if (view["scene"] != "room" || !view["main"]) continue;
        CHECK(slope(view["curves"], "cost_pixels") == Approx(1));
        CHECK(slope(view["curves"], "cost_radius") == Approx(1));
    }
    CHECK(slope(report["advice"][0]["curves"], "cost_triangles") == Approx(0).margin(1e-9));
}

TEST_CASE("every device of a report has advice of its own")
{
    auto samples = sweep();
    samples.push_back(benchSample("c", 4, 9, 0.01));
    samples.back().device = "device B";
    const auto report = nlohmann::json::parse(reportJson(samples));
    REQUIRE(report["advice"].size() == 2);
    CHECK(report["advice"][1]["device"] == "device B");
    CHECK(report["advice"][1]["steps"][0]["bench_sample"] == 6);
}

TEST_CASE("a report's page asks nothing of a network")
{
    const std::string html = page(sweep());
    CHECK(!holds(html, "https:"));
    CHECK(!holds(html, "src=\"/"));
    CHECK(!holds(html, "@import"));
    std::string rest = html;  // the namespace of SVG is a name, not an address to fetch
    const std::string name = "http://www.w3.org/2000/svg";
    for (std::size_t at; (at = rest.find(name)) != std::string::npos;) rest.erase(at, name.size());
    CHECK(!holds(rest, "http:"));
    CHECK(!holds(html, "/*report."));
}

TEST_CASE("a name cannot end the script that holds a report's figures")
{
    auto samples = sweep();
    samples[0].config = "</script><script>alert(1)</script><!--";
    CHECK(!holds(page(samples), "<script>alert"));
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
    CHECK(holds(html, "base64,iVBORw0KGgpN\""));
    CHECK(holds(html, "base64,iVBORw0KGgr//v0=\""));
}

TEST_CASE("a report embeds nothing but PNGs below the folder of its results")
{
    const TemporaryFolder folder("bench_report_outside");
    folder.write("secret.png", kPng + "hunter2");
    folder.write("mine/secret.txt", "hunter2");
    std::filesystem::create_symlink("../secret.png", folder.path / "mine/link.png");
    for (const char* name : {"../secret.png", "link.png", "secret.txt"}) {
        auto samples = sweep();
        samples[0].folder = (folder.path / "mine").string();
        samples[0].ao_picture = (folder.path / "mine" / name).string();
        const auto html = reportHtml(samples);
        INFO(name);
        REQUIRE(html.diagnostics().size() == 1);
        CHECK(html.diagnostics()[0].code == Code::image_broken);
        CHECK(!holds(*html, "data:image"));
    }
}

TEST_CASE("no name in a page turns the direction of its text")
{
    auto samples = sweep();
    samples[0].config =
        "a\xE2\x80\xAE"
        "b\xC2\x9B";
    const std::string html = page(samples);
    CHECK(!holds(html, "\xE2\x80\xAE"));
    CHECK(holds(html, "a\\\\u202eb\\\\u009b"));
}

TEST_CASE("a picture that is gone costs a warning")
{
    auto samples = sweep();
    samples[0].ground_truth_picture = "/nowhere/ground_truth.png";
    const auto html = reportHtml(samples);
    REQUIRE(html.ok());
    REQUIRE(html.diagnostics().size() == 1);
    CHECK(html.diagnostics()[0].severity == Severity::warning);
    CHECK(reportHtml(samples, false).diagnostics().empty());
}

TEST_CASE("a report says what failed, even where everything did")
{
    BenchSample failed = benchSample("a", 4, 0, 0);
    failed.failure = "the shader does not link";
    const auto report = nlohmann::json::parse(reportJson({failed}));
    CHECK(report["failures"][0]["title"] == "a samples=4, room, 960x540");
    CHECK(report["failures"][0]["reason"] == "the shader does not link");
    CHECK(report["views"].empty());
    CHECK(holds(page({failed}), "the shader does not link"));
    CHECK(!page({}).empty());
}

TEST_CASE("a report has motion where it was measured")
{
    auto samples = sweep();
    samples[1].motion.paths["pan"] = {0.0123, 0.05, 0.25, 0.004, 0.0678, 1000};
    samples[1].motion.settled_after = 3;
    const auto report = nlohmann::json::parse(reportJson(samples));
    CHECK_FALSE(report["bench_samples"][0].contains("motion"));
    CHECK(report["bench_samples"][1]["motion"]["paths"]["pan"]["rms"] == 0.0123);
    const std::string csv = reportCsv(samples);
    CHECK(holds(csv, ",pan_rms,"));
    CHECK(holds(csv, ",0.0123,"));
    CHECK(holds(csv, ",0.0678,3,"));
}

TEST_CASE("the CSV has a row a sample, and quotes what needs it")
{
    auto samples = sweep();
    samples[0].device = "Mesa, \"llvmpipe\"";
    samples[1].failure = "no memory";
    const std::string csv = reportCsv(samples);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 7);
    CHECK(csv.rfind("config,", 0) == 0);
    CHECK(holds(csv, ",\"Mesa, \"\"llvmpipe\"\"\","));
    CHECK(holds(csv, ",geometry=0.4 ao=0.4,"));
    CHECK(holds(csv, ",no memory,"));
}
