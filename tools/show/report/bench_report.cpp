// SPDX-License-Identifier: MIT
// Writes the report's page and CSV.
#include "tools/show/report/bench_report.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/measure/bench/choice.h"
#include "tools/measure/line_file.h"
#include "tools/show/plan/print.h"

#include <nlohmann/json.hpp>

namespace crevice {

std::string_view benchPage();  // bench.html and what it names, put together at build

namespace {

using nlohmann::json;

constexpr std::size_t kMaxPictureBytes = 64u << 20;

std::string base64(std::string_view bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view three = bytes.substr(i, 3);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= three.size() ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

/// A PNG as text that an <img> shows; empty where the file cannot be read, is no PNG, or lies
/// outside of the folder once links are resolved.
std::string pictureUri(const std::string& path, const std::string& folder)
{
    if (!isBelow(path, {folder.empty() ? "." : folder})) return {};
    const FileBytes file = readBytes(path, kMaxPictureBytes);
    const bool png = startsWith(file.bytes, "\x89PNG\r\n\x1a\n");
    return png ? "data:image/png;base64," + base64(file.bytes) : std::string();
}

/// Each picture by its path, read once however many samples share it.
json picturesOf(const std::vector<BenchSample>& samples, Diagnostics& warnings)
{
    json found = json::object();
    for (const BenchSample& sample : samples)
        for (const std::string& path :
             {sample.ao_picture, sample.ground_truth_picture, sample.difference_picture}) {
            if (path.empty() || found.contains(path)) continue;
            const std::string uri = pictureUri(path, sample.folder);
            found[path] = uri;
            if (!uri.empty()) continue;
            warnings.push_back(asWarning(
                {Code::image_broken,
                 "the picture '" + path + "' is no PNG below the folder of its results file",
                 "the report leaves it out; keep pictures in the folder of their results file"}));
        }
    return found;
}

/// The candidates worth taking, by rising cost, with the part each plays.
json stepsOf(const std::vector<Candidate>& list)
{
    json steps = json::array();
    const std::vector<std::size_t> front = frontOf(list);
    if (front.empty()) return steps;
    const std::size_t balanced = balancedOf(list, front);
    for (const std::size_t i : front) {
        json roles = json::array();
        if (i == front.front()) roles.push_back("cheapest");
        if (i == balanced) roles.push_back("balanced");
        if (i == front.back()) roles.push_back("most accurate");
        steps.push_back({{"label", list[i].label},
                         {"ms", list[i].ms},
                         {"ratio", list[i].ratio},
                         {"error", list[i].error},
                         {"roles", std::move(roles)}});
    }
    return steps;
}

/// Requires a device that has samples with figures.
json adviceFor(const std::vector<BenchSample>& samples, const std::string& device)
{
    std::vector<BenchSample> own;
    for (const BenchSample& sample : samples)
        if (sample.device == device) own.push_back(sample);
    const Result<Candidates> candidates = findCandidates(own, {});
    json views = json::array();
    for (const ResultView& view : candidates->views) views.push_back(view.name);
    return {{"device", device},
            {"software", own.front().software},
            {"clock", own.front().clock},
            {"size", sizeText(candidates->views.front().extent)},
            {"views", std::move(views)},
            {"steps", stepsOf(candidates->list)},
            {"elided", candidates->elided},
            {"harmful", candidates->harmful},
            {"error_without_ao", candidates->error_without_ao}};
}

std::string quoted(const json& value)
{
    if (!value.is_string()) return jsonLine(value);
    std::string text = printable(value.get<std::string>());
    if (!text.empty() && std::string_view("=+-@\t\n'").find(text[0]) != std::string_view::npos)
        text.insert(0, 1, '\'');  // else a spreadsheet runs it [OWASP, "CSV Injection"]
    if (text.find_first_of(",;\"\t\r\n") == std::string::npos) return text;
    std::string safe = "\"";
    for (const char c : text) safe += c == '"' ? std::string("\"\"") : std::string(1, c);
    return safe + '"';
}

/// The columns of the CSV: what they are called and, where that differs, the JSON pointer into a
/// sample without its first slash; what a sample does not have stays empty. The config comes first
/// and free of commas, so that awk can distinguish the rows.
constexpr std::string_view kColumns =
    "config overrides family samples scene camera width=extent/width "
    "height=extent/height radius rays radius_px triangles rmse=error/rmse "
    "bias=error/bias p99=error/p99 pattern=error/pattern rmse_fit=error/rmse_fit "
    "power_fit=error/power_fit rmse_without_ao=error_without_ao "
    "still_rms=motion/paths/still/rms sub_pixel_rms=motion/paths/sub-pixel/rms "
    "pan_rms=motion/paths/pan/rms strafe_rms=motion/paths/strafe/rms "
    "disocclusion_rms=motion/paths/disocclusion/rms pan_rmse=motion/paths/pan/rmse "
    "settled_after=motion/settled_after clock repeats cost_ms=cost/median "
    "cost_ms_q1=cost/q1 cost_ms_q3=cost/q3 "
    "cost_with_geometry_ms=cost_with_geometry/median total_ms=total/median "
    "passes_ms=passes ratio_learnopengl ratio_with_geometry texture_bytes "
    "bytes_read bytes_written failure device version key";

/// Lists become words: "samples=16 bias=0.1", "geometry=1.2 ao=3.4".
json flat(const json& value)
{
    if (!value.is_array()) return value;
    std::string text;
    for (const json& item : value) {
        if (!text.empty()) text += ' ';
        if (item.is_string())
            text += item.get<std::string>();
        else
            text += item["name"].get<std::string>() + "=" + jsonLine(item["ms"]["median"]);
    }
    return text;
}

/// Where in the page the figures go.
constexpr std::string_view kDataMark = "/*report.json*/";

/// The same with every text as it can be shown.
json shown(const json& data)
{
    if (data.is_string()) return printable(data.get_ref<const std::string&>());
    if (!data.is_structured()) return data;
    json copy = data.is_array() ? json::array() : json::object();
    for (const auto& [key, value] : data.items()) {
        if (data.is_array())
            copy.push_back(shown(value));
        else
            copy[printable(key)] = shown(value);
    }
    return copy;
}

}  // namespace

json reportModel(const std::vector<BenchSample>& samples)
{
    json model = {
        {"bench_samples", json::array()}, {"views", json::array()}, {"advice", json::array()}};
    for (const BenchSample& sample : samples) {
        json item = json::parse(toJsonLine(sample));
        item["label"] = sampleLabel(sample);
        item["title"] = sampleTitle(sample);
        model["bench_samples"].push_back(std::move(item));
    }
    for (const std::string& device : benchDevices(samples))
        model["advice"].push_back(adviceFor(samples, device));
    const std::vector<ResultView> views = benchViews(samples);
    for (const ResultView& view : views) {
        const auto main = mainViews(views, view.device);
        const bool is_main =
            anyOf(main, [&view](const ResultView& each) { return each.samples == view.samples; });
        model["views"].push_back(
            {{"device", view.device},
             {"name", view.name},
             {"size", sizeText(view.extent)},
             {"radius", view.radius},
             {"main", is_main},
             {"bench_samples", view.samples},
             {"error_without_ao", samples[view.samples.front()].error_without_ao}});
    }
    return model;
}

std::string reportCsv(const std::vector<BenchSample>& samples)
{
    std::vector<std::string> names;
    std::vector<json::json_pointer> places;
    for (const std::string_view column : split(kColumns, ' ')) {
        const std::string_view name = column.substr(0, column.find('='));
        const bool same = name.size() == column.size();
        names.emplace_back(name);
        places.emplace_back("/" + std::string(same ? name : column.substr(name.size() + 1)));
    }
    std::string csv = joined(names, ",") + "\r\n";
    for (const BenchSample& sample : samples) {
        const json row = json::parse(toJsonLine(sample));
        std::vector<std::string> cells;
        for (const json::json_pointer& place : places)
            cells.push_back(row.contains(place) ? quoted(flat(row[place])) : "");
        csv += joined(cells, ",") + "\r\n";
    }
    return csv;
}

Result<std::string> reportHtml(const std::vector<BenchSample>& samples, bool with_pictures)
{
    Diagnostics warnings;
    json model = reportModel(samples);
    model["pictures"] = with_pictures ? picturesOf(samples, warnings) : json::object();
    return {pageOf(benchPage(), model), std::move(warnings)};
}

std::string pageOf(std::string_view page, const json& model)
{
    std::string figures;
    for (const char c : jsonLine(shown(model)))  // in which "</script>" must end nothing
        c == '<' ? figures += "\\u003c" : figures += c;
    std::string text(page);
    text.replace(text.find(kDataMark), kDataMark.size(), figures);
    return text;
}

}  // namespace crevice
