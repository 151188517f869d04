// SPDX-License-Identifier: MIT
// Rows of an ablation: written, read back, shown.
#include "tools/bench/ablation.h"
#include "tools/report/bench_report.h"

#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <fstream>

using namespace crevice;

namespace {

AblationRow row(const std::string& optimization, double ms, double factor)
{
    AblationRow row;
    row.key = "0123456789abcdef";
    row.config = "gtao";
    row.scene = "room";
    row.camera = "main";
    row.extent = {64, 36};
    row.situation = "off";
    row.optimization = optimization;
    row.ms = {ms, ms - 0.1, ms + 0.1};
    row.factor = {factor, factor, factor};
    row.texture_bytes = 4096;
    row.elided = 4;
    row.repeats = 7;
    row.device = "a GPU";
    row.version = "0.1.0";
    return row;
}

void write(const TemporaryFolder& folder, const std::vector<std::string>& lines)
{
    std::ofstream file(folder.path / "ablation.jsonl");
    for (const std::string& line : lines) file << line << '\n';
}

}  // namespace

TEST_CASE("Rows come back as they were written, the later of two with one key")
{
    const TemporaryFolder folder("ablation");
    write(folder, {toJsonLine(row("", 2, 1)), toJsonLine(row("no_op", 3, 1.5)),
                   toJsonLine(row("", 2.5, 1))});
    for (const std::string& path :
         {folder.path.string(), (folder.path / "results.jsonl").string()}) {
        const std::vector<AblationRow> rows = need(readAblation({path, path}));
        REQUIRE(rows.size() == 2);
        CHECK(toJsonLine(rows[0]) == toJsonLine(row("", 2.5, 1)));
        CHECK(toJsonLine(rows[1]) == toJsonLine(row("no_op", 3, 1.5)));
    }
    CHECK(need(readAblation({"/nowhere"})).empty());
}

TEST_CASE("A line that is no row is an error at its place")
{
    const TemporaryFolder folder("ablation_broken");
    for (const std::string& bad :
         {std::string("[]"), std::string("{}"), std::string(R"({"config": 1})")}) {
        INFO(bad);
        write(folder, {toJsonLine(row("", 2, 1)), bad});
        const auto rows = readAblation({folder.path.string()});
        REQUIRE_FALSE(rows.ok());
        CHECK(rows.diagnostics()[0].code == Code::results_broken);
        CHECK(rows.diagnostics()[0].place.line == 2);
    }
}

TEST_CASE("An ablation reads as a line a situation, and is part of the report")
{
    const std::vector<AblationRow> rows = {row("", 2, 1), row("no_op", 3, 1.5), row("all", 6, 3)};
    CHECK(toText(rows) == "\noff                2.000 ms;  not no_op x1.5  none of them x3\n");
    const auto report = nlohmann::json::parse(reportJson({}, rows));
    REQUIRE(report["ablation"].size() == 3);
    CHECK(report["ablation"][2]["optimization"] == "all");
    CHECK(need(reportHtml({}, false, rows)).find("\"optimization\":\"no_op\"") !=
          std::string::npos);
}
