// SPDX-License-Identifier: MIT
// SARIF logs: what the specification (OASIS SARIF 2.1.0) asks of each part, in its section numbers.
#include "tests/support/catch.h"

#include "tools/cli/sarif.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

using namespace crevice;
using Json = nlohmann::json;

namespace {

SourceRef source(const char* name, const char* text)
{
    return std::make_shared<SourceText>(SourceText{name, text});
}

Diagnostics sample()
{
    const SourceRef mine = source("my configs/a.json", "{\n  \"é\": { \"radius\": -1 } }\n");
    const SourceRef module = source("/opt/m.json", "{ }");
    Diagnostic first{Code::out_of_range, "radius default -1 is outside [0, 10]", {mine, 2, 21, 2}};
    first.pointer = "/params/radius/default";
    first.notes.resize(2);
    first.notes[0].place = {module, 1, 1, 3};
    first.notes[0].text = "the base value was set here";
    first.notes[1].text = "no place";
    first.help = "stay inside";
    Diagnostic second{Code::no_samples, "4 samples instead of 8"};
    second.severity = Severity::warning;
    Diagnostic third = first;
    third.place = {source("--set radius=-1", "radius=-1"), 1, 8, 2};
    return {first, second, third};
}

Json logOf(const Diagnostics& diagnostics) { return Json::parse(toSarif(diagnostics, "1.2.3")); }

std::string codesHeader()
{
    std::ifstream file(CREVICE_SOURCE_DIR "/core/base/codes.h");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("A SARIF log names its version, tool and rules")
{
    const Json log = logOf(sample());
    CHECK(log["version"] == "2.1.0");  // 3.13.2
    CHECK(log["$schema"].get<std::string>().find("sarif-2.1.0") != std::string::npos);
    REQUIRE(log["runs"].size() == 1);  // 3.13.4
    const Json driver = log["runs"][0]["tool"]["driver"];
    CHECK(driver["name"] == "crevice");  // 3.19.8
    CHECK(driver["version"] == "1.2.3");
    REQUIRE(driver["rules"].size() == 2);
    CHECK(driver["rules"][0]["id"] == "CV4001");  // 3.49.3
    CHECK(driver["rules"][0]["name"] == "out_of_range");
    CHECK(driver["rules"][0]["shortDescription"]["text"] == "A value outside its range.");
}

TEST_CASE("Each SARIF result has rule, level, message and the place in characters")
{
    const Json results = logOf(sample())["runs"][0]["results"];
    REQUIRE(results.size() == 3);
    const Json first = results[0];
    CHECK(first["ruleId"] == "CV4001");  // 3.27.5
    CHECK(first["ruleIndex"] == 0);
    CHECK(first["level"] == "error");  // 3.27.10
    CHECK(first["message"]["text"] == "radius default -1 is outside [0, 10]\nhelp: stay inside");
    REQUIRE(first["locations"].size() == 1);
    const Json place = first["locations"][0]["physicalLocation"];
    CHECK(place["artifactLocation"]["uri"] == "my%20configs/a.json");  // 3.4.3, RFC 3986
    CHECK(place["region"]["startLine"] == 2);  // 3.30.5
    CHECK(place["region"]["startColumn"] == 20);  // é is two bytes and one character
    CHECK(place["region"]["endColumn"] == 22);  // one past the end, 3.30.8
    CHECK(first["locations"][0]["logicalLocations"][0]["fullyQualifiedName"] ==
          "/params/radius/default");  // 3.33.5
    CHECK(results[1]["level"] == "warning");
    CHECK(results[1]["ruleIndex"] == 1);
    CHECK(results[2]["ruleIndex"] == 0);
}

TEST_CASE("SARIF notes are related locations, and what has no file has no physical location")
{
    const Json results = logOf(sample())["runs"][0]["results"];
    const Json related = results[0]["relatedLocations"];
    REQUIRE(related.size() == 2);
    CHECK(related[0]["message"]["text"] == "the base value was set here");  // 3.28.5
    CHECK(related[0]["physicalLocation"]["artifactLocation"]["uri"] == "file:///opt/m.json");
    CHECK_FALSE(related[1].contains("physicalLocation"));
    CHECK_FALSE(results[1].contains("locations"));
    CHECK_FALSE(results[2]["locations"][0].contains("physicalLocation"));
    CHECK(results[2]["locations"][0].contains("logicalLocations"));
}

TEST_CASE("A SARIF log without a diagnostic has an empty list of results, as a run must")
{
    const Json run = logOf({})["runs"][0];
    CHECK(run["results"].is_array());  // 3.14.23: null or absent means that the check did not run
    CHECK(run["results"].empty());
    CHECK(run["tool"]["driver"]["rules"].empty());
}

TEST_CASE("Every code of the header is a rule with a sentence")
{
    const std::string header = codesHeader();
    const std::regex code(R"(= \d+,)");
    const auto count = std::distance(std::sregex_iterator(header.begin(), header.end(), code), {});
    CHECK(static_cast<long>(codeRules().size()) == count);
    for (const CodeRule& rule : codeRules()) {
        INFO(rule.name);
        CHECK(header.find(rule.name + " = " + std::to_string(static_cast<int>(rule.code)) + ",") !=
              std::string::npos);
        CHECK(rule.text.back() == '.');
    }
}
