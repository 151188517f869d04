// SPDX-License-Identifier: MIT
// Situations, turns, and the table.
#include "tools/bench/ablation.h"

#include "core/base/files.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/renderer/renderer.h"
#include "tools/bench/times.h"
#include "tools/bench/views.h"
#include "tools/cli/output.h"
#include "tools/measure/line_file.h"
#include "tools/render/scene_upload.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

namespace crevice {
namespace {

using nlohmann::json;

constexpr const char* kIntensity = "intensity";

struct Situation {
    const char* name;
    bool camera;  ///< Moves from frame to frame.
    bool light;   ///< The first one moves, and that of the surroundings changes.
    bool off;     ///< Intensity is 0.
    bool alone;   ///< Nothing but `ao` is asked for.
};

constexpr Situation kSituations[] = {
    {"moving camera", true, false, false, false}, {"moving light", false, true, false, false},
    {"still", false, false, false, false},        {"off", true, false, true, false},
    {"ao alone", true, false, false, true},
};

/// Moves to and fro by little, so that every frame costs the same.
void advance(const Situation& situation, Frame& frame, double step)
{
    if (situation.camera) frame.camera.view_from_world[3][0] += step;
    if (!situation.light) return;
    frame.ambient_light.x += static_cast<float>(step);
    if (!frame.lights.empty()) frame.lights[0].position.x += step;
}

Result<double> millisecondsOf(Device& device, Renderer& renderer, const Frame& frame)
{
    const auto begin = std::chrono::steady_clock::now();
    if (const Status drawn = renderer.render(frame); !drawn) return drawn.diagnostics();
    device.finish();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    return took.count();
}

/// A renderer without a rule, and what its turns took.
struct Contender {
    std::string rule;
    std::unique_ptr<Renderer> renderer = {};
    std::vector<double> turns = {};  ///< Median milliseconds of each.
};

Status takeTurn(Device& device, const Situation& situation, Frame& frame, Contender& contender)
{
    std::vector<double> frames;
    double step = 1e-3;
    const Status drawn = drawTurn([&]() -> Result<double> {
        advance(situation, frame, step);
        step = -step;
        const Result<double> ms = millisecondsOf(device, *contender.renderer, frame);
        if (ms) frames.push_back(*ms);
        return ms;
    });
    if (!drawn) return drawn;
    contender.turns.push_back(timeFigures(std::move(frames)).median);
    return {};
}

Result<std::vector<Contender>> contenders(Device& device, const Description& description,
                                          const Situation& situation, const Frame& frame,
                                          Extent extent)
{
    std::vector<Contender> all;
    all.push_back({""});
    for (const RuleInfo& rule : kRules) all.push_back({rule.name});
    all.push_back({"all"});
    for (Contender& each : all) {
        CompileOptions options;
        options.extent = extent;
        if (situation.alone) options.outputs = {"ao"};
        if (!each.rule.empty()) options.keep = {each.rule};
        auto renderer = Renderer::create(device, description, options, traitsOf(frame));
        if (!renderer) return renderer.diagnostics();
        each.renderer = std::move(*renderer);
    }
    return all;
}

Status takeTurns(Device& device, const Situation& situation, Frame& frame, int repeats,
                 std::vector<Contender>& all, const std::function<bool()>& interrupted)
{
    for (int turn = -1; turn < repeats && !interrupted(); ++turn) {  // the first one warms up
        for (Contender& each : all)
            if (const Status taken = takeTurn(device, situation, frame, each); !taken) return taken;
        if (turn < 0)
            for (Contender& each : all) each.turns.clear();
    }
    return {};
}

/// What says the same of the same thing on the same device.
std::string identityOf(const AblationRow& row)
{
    return row.config + '\n' + row.scene + '\n' + row.camera + '\n' + extentName(row.extent) + '\n' +
           row.situation + '\n' + row.rule + '\n' + row.device;
}

json toJson(const TimeFigures& figures)
{
    return {{"median", figures.median}, {"q1", figures.q1}, {"q3", figures.q3}};
}

TimeFigures figuresFrom(const json& value)
{
    return {value.at("median").get<double>(), value.at("q1").get<double>(),
            value.at("q3").get<double>()};
}

/// Null where the line is no row.
std::optional<AblationRow> rowFrom(const std::string& line)
{
    const json value = json::parse(line, nullptr, false);
    const auto has = [&](const char* key, json::value_t type) {
        return value.contains(key) && (value.at(key).type() == type ||
                                       (type == json::value_t::number_float &&
                                        value.at(key).is_number()));
    };
    constexpr auto kText = json::value_t::string;
    constexpr auto kNumber = json::value_t::number_float;
    if (!value.is_object()) return std::nullopt;
    for (const char* key : {"config", "scene", "camera", "situation", "rule", "device", "version"})
        if (!has(key, kText)) return std::nullopt;
    for (const char* key : {"width", "height", "repeats", "left_out", "texture_bytes"})
        if (!has(key, kNumber)) return std::nullopt;
    for (const char* key : {"ms", "factor"}) {
        if (!has(key, json::value_t::object)) return std::nullopt;
        for (const char* part : {"median", "q1", "q3"})
            if (!value.at(key).contains(part) || !value.at(key).at(part).is_number())
                return std::nullopt;
    }
    return AblationRow{value["config"], value["scene"], value["camera"], {value["width"], value["height"]},
                       value["situation"], value["rule"], figuresFrom(value["ms"]),
                       figuresFrom(value["factor"]), value["texture_bytes"], value["left_out"],
                       value["repeats"], value["device"], value["version"]};
}

}  // namespace

std::string toJsonLine(const AblationRow& row)
{
    const json value = {{"config", row.config}, {"scene", row.scene}, {"camera", row.camera},
                        {"width", row.extent.width}, {"height", row.extent.height}, {"situation", row.situation},
                        {"rule", row.rule}, {"ms", toJson(row.ms)}, {"factor", toJson(row.factor)},
                        {"texture_bytes", row.texture_bytes}, {"left_out", row.left_out},
                        {"repeats", row.repeats}, {"device", row.device}, {"version", row.version}};
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<std::vector<AblationRow>> readAblation(const std::vector<std::string>& paths)
{
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code unreadable;
        const std::filesystem::path folder = std::filesystem::is_directory(path, unreadable)
                                                 ? std::filesystem::path(path)
                                                 : std::filesystem::path(path).parent_path();
        files.push_back((folder / "ablation.jsonl").string());
    }
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    std::vector<AblationRow> rows;
    std::map<std::string, std::size_t> known;
    for (const std::string& file : files) {
        FileBytes read = readBytes(file, kMaxResultBytes);
        if (!read && !read.missing)
            return Diagnostic{Code::results_broken,
                              "no results can be read from '" + file + "': " + read.failure};
        int number = 0;
        for (const std::string_view line : split(read.bytes, '\n')) {
            ++number;
            if (line.empty()) continue;
            const std::optional<AblationRow> row = rowFrom(std::string(line));
            if (!row) {
                Diagnostic error{Code::results_broken, file + ":" + std::to_string(number) +
                                                         ": this line is no row of an ablation"};
                error.help = "delete the line, and run 'crevice bench --ablate' again";
                return error;
            }
            const auto [at, fresh] = known.insert({identityOf(*row), rows.size()});
            if (fresh) rows.push_back(*row);
            else rows[at->second] = *row;
        }
    }
    return rows;
}

Result<std::vector<AblationRow>> ablate(Device& device, const BenchTask& task, const BenchView& view,
                                        int repeats, const std::function<bool()>& interrupted)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, *view.scene);
    if (!scene) return scene.diagnostics();
    std::vector<AblationRow> rows;
    for (const Situation& situation : kSituations) {
        Frame frame = makeFrame(*scene, view.camera, view.extent);
        Description description = task.description;
        for (ParamDesc& param : description.params)
            if (situation.off && param.name == kIntensity) param.value.fill(0);
        auto all = contenders(device, description, situation, frame, view.extent);
        if (!all) return all.diagnostics();
        const Status taken = takeTurns(device, situation, frame, repeats, *all, interrupted);
        if (!taken) return taken.diagnostics();
        if (interrupted()) break;
        for (const Contender& each : *all) {
            const Plan& plan = each.renderer->plan();
            AblationRow row;
            row.config = pointLabel(task.point);
            row.scene = task.point.scene;
            row.camera = task.point.camera;
            row.extent = view.extent;
            row.situation = situation.name;
            row.rule = each.rule;
            row.ms = timeFigures(each.turns);
            row.factor = ratioFigures(each.turns, all->front().turns);
            row.texture_bytes = plan.texture_bytes;
            row.left_out = static_cast<int>(plan.left_out.size());
            row.repeats = static_cast<int>(each.turns.size());
            row.device = device.caps().name;
            row.version = task.point.version;
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

std::string toText(const std::vector<AblationRow>& rows)
{
    std::string text;
    for (const AblationRow& row : rows) {
        if (row.rule.empty()) {
            char cell[64];
            std::snprintf(cell, sizeof cell, "\n%-14s %9s ms;", row.situation.c_str(),
                          fixed(row.ms.median, 3).c_str());
            text += cell;
            continue;
        }
        const std::string without = row.rule == "all" ? "none of them" : "not " + row.rule;
        text += "  " + without + " x" + significant(row.factor.median, 3);
    }
    return text + "\n";
}

}  // namespace crevice
