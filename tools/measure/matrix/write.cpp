// SPDX-License-Identifier: MIT
// Results as JSON, TAP and JUnit XML.
#include "tools/measure/matrix/result.h"

#include "core/base/text.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

using nlohmann::json;

constexpr std::pair<const char*, std::string CheckResult::*> kTexts[] = {
    {"title", &CheckResult::title},   {"state", &CheckResult::state},
    {"text", &CheckResult::text},     {"got", &CheckResult::got},
    {"wanted", &CheckResult::wanted}, {"difference", &CheckResult::difference}};

/// Without those that are empty.
json textsOf(const CheckResult& check)
{
    json texts = json::object();
    for (const auto& [key, member] : kTexts)
        if (!(check.*member).empty()) texts[key] = check.*member;
    return texts;
}

std::string xml(const std::string& text)
{
    std::string safe;
    for (const char c : printableLine(text)) {
        const std::size_t at = std::string_view("&<>\"'").find(c);
        const char* const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
        safe += at == std::string_view::npos ? std::string(1, c) : names[at];
    }
    return safe;
}

/// A test's name in TAP, where '#' begins a directive.
std::string tapName(const std::string& text)
{
    std::string safe;
    for (const char c : printableLine(text)) {
        if (c == '#' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

/// " tests="3" failures="1" skipped="0" time="0.210"", over the cells from `begin` to `end`.
std::string counts(const CellResult* begin, const CellResult* end)
{
    int tests = 0, failures = 0, skipped = 0;
    double time_s = 0;
    for (; begin != end; ++begin)
        for (const CheckResult& check : begin->checks) {
            ++tests;
            failures += check.state == "failed";
            skipped += check.state == "skipped";
            time_s += check.time_s;
        }
    return " tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
           "\" errors=\"0\" skipped=\"" + std::to_string(skipped) + "\" time=\"" +
           fixed(time_s, 3) + "\"";
}

}  // namespace

bool CellResult::is(const char* state) const
{
    return anyOf(checks, [&](const CheckResult& check) { return check.state == state; });
}

int MatrixResults::count(const char* state) const
{
    int sum = 0;
    for (const CellResult& cell : cells)
        for (const CheckResult& check : cell.checks) sum += check.state == state;
    return sum;
}

json toJson(const CellResult& result)
{
    json checks = json::array();
    for (const CheckResult& check : result.checks) {
        json item = textsOf(check);
        item["check"] = check.check;
        item["time_s"] = check.time_s;
        checks.push_back(std::move(item));
    }
    return {{"cell", result.cell}, {"key", result.key}, {"checks", std::move(checks)}};
}

CellResult cellResultFrom(const json& from)
{
    CellResult result;
    result.cell = from.at("cell");
    result.key = from.at("key");
    for (const json& item : from.at("checks")) {
        CheckResult check;
        check.check = item.at("check");
        check.time_s = item.at("time_s");
        for (const auto& [key, member] : kTexts) check.*member = item.value(key, std::string());
        result.checks.push_back(std::move(check));
    }
    return result;
}

json resultsJson(const MatrixResults& results)
{
    json cells = json::array();
    for (const CellResult& result : results.cells) {
        const MatrixCell& cell = results.matrix.cells[result.cell];
        json values = json::object(), checks = json::array();
        for (std::size_t axis = 0; axis < cell.choice.size(); ++axis) {
            const std::string& name = results.matrix.value(cell.choice, axis).name;
            if (!name.empty()) values[results.matrix.axes[axis].name] = name;
        }
        for (const CheckResult& check : result.checks) checks.push_back(textsOf(check));
        cells.push_back(
            {{"name", cell.name}, {"values", std::move(values)}, {"checks", std::move(checks)}});
    }
    json all = {{"matrix", results.matrix.file}, {"cells", std::move(cells)}};
    for (const char* state : {"passed", "failed", "skipped", "new", "changed", "unchanged"})
        all[state] = results.count(state);
    return all;
}

std::string tapText(const MatrixResults& results)
{
    std::string points;
    int number = 0;
    for (const CellResult& cell : results.cells)
        for (const CheckResult& check : cell.checks) {
            const bool failed = check.state == "failed";
            points += (failed ? "not ok " : "ok ") + std::to_string(++number) + " - " +
                      tapName(results.matrix.cells[cell.cell].name + ": " + check.title);
            if (check.state == "skipped") points += " # SKIP " + tapName(check.text);
            points += '\n';
            if (failed) points += "  ---\n  message: " + jsonString(check.text) + "\n  ...\n";
        }
    return "TAP version 13\n1.." + std::to_string(number) + "\n" + points;
}

std::string junitXml(const MatrixResults& results)
{
    const CellResult* const cells = results.cells.data();
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" +
                       xml(results.matrix.file) + "\"" +
                       counts(cells, cells + results.cells.size()) + ">\n";
    for (const CellResult& cell : results.cells) {
        const std::string name = xml(results.matrix.cells[cell.cell].name);
        text += " <testsuite name=\"" + name + "\"" + counts(&cell, &cell + 1) + ">\n";
        for (const CheckResult& check : cell.checks) {
            text += "  <testcase classname=\"" + name + "\" name=\"" + xml(check.title) +
                    "\" time=\"" + fixed(check.time_s, 3) + "\">";
            const bool failed = check.state == "failed";
            if (failed || check.state == "skipped")
                text += std::string(failed ? "<failure" : "<skipped") + " message=\"" +
                        xml(check.text) + "\"/>";
            text += "</testcase>\n";
        }
        text += " </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

}  // namespace crevice
