// SPDX-License-Identifier: MIT
// Results as JSON, TAP and JUnit XML.
#include "tools/measure/matrix/run.h"

#include "core/base/text.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

using nlohmann::json;

constexpr std::pair<const char*, std::string CheckResult::*> kTexts[] = {
    {"title", &CheckResult::title},   {"state", &CheckResult::state},
    {"text", &CheckResult::text},     {"got", &CheckResult::got},
    {"wanted", &CheckResult::wanted}, {"difference", &CheckResult::difference}};

constexpr const char* kStates[] = {"passed", "failed", "skipped", "new", "changed", "unchanged"};

/// Without those that are empty.
json textsOf(const CheckResult& check)
{
    json texts = json::object();
    for (const auto& [key, member] : kTexts)
        if (!(check.*member).empty()) texts[key] = check.*member;
    return texts;
}

/// On one line, with `escape` in place of each character that is special.
template <class Escape>
std::string escaped(const std::string& text, std::string_view special, Escape escape)
{
    std::string safe;
    for (const char c : printableLine(text)) {
        const std::size_t at = special.find(c);
        safe += at == special.npos ? std::string(1, c) : escape(at);
    }
    return safe;
}

std::string xml(const std::string& text)
{
    const char* const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
    return escaped(text, "&<>\"'", [&](std::size_t at) { return std::string(names[at]); });
}

/// In TAP, where '#' begins a directive.
std::string tapName(const std::string& text)
{
    return escaped(text, "#\\", [](std::size_t at) { return std::string("\\") + "#\\"[at]; });
}

/// ` tests="3" failures="1" errors="0" skipped="0" time="0.210"`
std::string counts(const MatrixResults& results)
{
    std::size_t tests = 0;
    double time_s = 0;
    for (const CellResult& cell : results.cells)
        for (const CheckResult& check : cell.checks) ++tests, time_s += check.time_s;
    return " tests=\"" + std::to_string(tests) + "\" failures=\"" +
           std::to_string(results.count("failed")) + "\" errors=\"0\" skipped=\"" +
           std::to_string(results.count("skipped")) + "\" time=\"" + fixed(time_s, 3) + "\"";
}

}  // namespace

int MatrixResults::count(std::string_view state) const
{
    int sum = 0;
    for (const CellResult& cell : cells)
        for (const CheckResult& check : cell.checks) sum += check.state == state;
    return sum;
}

std::string countsOf(const MatrixResults& results)
{
    std::vector<std::string> texts;
    for (const char* state : kStates)
        if (const int count = results.count(state))
            texts.push_back(std::to_string(count) + " " + state);
    return texts.empty() ? "none" : joined(texts);
}

json toJson(const CellResult& result)
{
    json checks = json::array();
    for (const CheckResult& check : result.checks) {
        checks.push_back(textsOf(check));
        checks.back()["check"] = check.check;
        checks.back()["time_s"] = check.time_s;
    }
    return {{"cell", result.cell}, {"key", result.key}, {"checks", std::move(checks)}};
}

CellResult cellResultFrom(const json& from)
{
    CellResult result{from.at("cell"), from.at("key")};
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
    for (const char* state : kStates) all[state] = results.count(state);
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
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" +
                       xml(results.matrix.file) + "\"" + counts(results) + ">\n";
    for (const CellResult& cell : results.cells) {
        const std::string name = xml(results.matrix.cells[cell.cell].name);
        text += " <testsuite name=\"" + name + "\"" + counts({results.matrix, {cell}}) + ">\n";
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
