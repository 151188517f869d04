// SPDX-License-Identifier: MIT
// Situations, turns, and the table.
#include "tools/bench/ablation.h"

#include <crevice/renderer.h>

#include "core/base/numbers.h"
#include "core/run/frame_clock.h"
#include "tools/bench/times.h"
#include "tools/bench/views.h"
#include "tools/cli/output.h"
#include "tools/measure/line_file.h"
#include "tools/plan/costs.h"
#include "tools/plan/without_occlusion.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

namespace crevice {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeFigures, median, q1, q3)

static void to_json(json& line, const AblationRow& row)
{
    line = {{"key", row.key},
            {"config", row.config},
            {"scene", row.scene},
            {"camera", row.camera},
            {"width", row.extent.width},
            {"height", row.extent.height},
            {"situation", row.situation},
            {"optimization", row.optimization},
            {"ms", row.ms},
            {"factor", row.factor},
            {"texture_bytes", row.texture_bytes},
            {"elided", row.elided},
            {"clock", row.clock},
            {"repeats", row.repeats},
            {"device", row.device},
            {"version", row.version}};
}

/// Rows of earlier versions have no key; they are measured again.
static void from_json(const json& line, AblationRow& row)
{
    row = {line.value("key", ""),
           line.at("config"),
           line.at("scene"),
           line.at("camera"),
           {line.at("width"), line.at("height")},
           line.at("situation"),
           line.at("optimization"),
           line.at("ms"),
           line.at("factor"),
           line.at("texture_bytes"),
           line.at("elided"),
           line.value("clock", "wall"),
           line.at("repeats"),
           line.at("device"),
           line.at("version")};
}

namespace {

constexpr const char* kAllOptimizations = "all";

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
    const FrameClock clock(device.caps().software);
    const double begin = clock.now();
    if (const Status drawn = renderer.render(frame); !drawn) return drawn.diagnostics();
    device.finish();
    return clock.now() - begin;
}

/// A renderer without an optimization, and what its turns took.
struct Contender {
    std::string optimization;
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
    for (const Optimization& optimization : kOptimizations) all.push_back({optimization.name});
    all.push_back({kAllOptimizations});
    for (Contender& each : all) {
        CompileOptions options;
        options.extent = extent;
        if (situation.alone) options.outputs = {"ao"};
        if (!each.optimization.empty()) options.disable = {each.optimization};
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

/// Equal for rows that measure the same on the same device.
std::string identityOf(const AblationRow& row)
{
    return row.config + '\n' + row.scene + '\n' + row.camera + '\n' + extentName(row.extent) +
           '\n' + row.situation + '\n' + row.optimization + '\n' + row.device;
}

AblationRow rowOf(const BenchTask& task, const BenchView& view, const Situation& situation,
                  const Contender& contender, const Contender& with_all)
{
    const Plan& plan = contender.renderer->plan();
    AblationRow row;
    row.config = sampleLabel(task.sample);
    row.scene = task.sample.scene;
    row.camera = task.sample.camera;
    row.extent = view.extent;
    row.situation = situation.name;
    row.optimization = contender.optimization;
    row.ms = timeFigures(contender.turns);
    row.factor = ratioFigures(contender.turns, with_all.turns);
    row.texture_bytes = plan.texture_bytes;
    row.elided = static_cast<int>(allElided(plan).size());
    row.repeats = static_cast<int>(contender.turns.size());
    row.version = task.sample.version;
    return row;
}

bool isLast(const AblationRow& row)
{
    return row.optimization == kAllOptimizations && row.situation == std::end(kSituations)[-1].name;
}

/// FOLDER/ablation.jsonl of each folder among the paths, or beside each file, once each.
std::set<std::string> ablationFiles(const std::vector<std::string>& paths)
{
    std::set<std::string> files;
    for (const std::string& path : paths) {
        std::error_code unreadable;
        const std::filesystem::path folder = std::filesystem::is_directory(path, unreadable)
                                                 ? std::filesystem::path(path)
                                                 : std::filesystem::path(path).parent_path();
        const std::string file = (folder / "ablation.jsonl").string();
        if (std::filesystem::exists(file, unreadable)) files.insert(file);
    }
    return files;
}

}  // namespace

std::string toJsonLine(const AblationRow& row) { return jsonLine(row); }

Result<std::vector<AblationRow>> readAblation(const std::vector<std::string>& paths)
{
    std::vector<AblationRow> rows;
    std::map<std::string, std::size_t> known;
    Diagnostics diagnostics;
    for (const std::string& file : ablationFiles(paths))
        append(diagnostics,
               readLines(file, {"row of an ablation", "crevice bench --ablate"}, [&](json&& line) {
                   AblationRow row = line.get<AblationRow>();
                   const auto [at, fresh] = known.insert({identityOf(row), rows.size()});
                   if (fresh)
                       rows.push_back(std::move(row));
                   else
                       rows[at->second] = std::move(row);
               }));
    if (hasErrors(diagnostics)) return diagnostics;
    return {std::move(rows), std::move(diagnostics)};
}

Result<std::vector<AblationRow>> ablate(Device& device, const BenchTask& task,
                                        const BenchView& view, int repeats,
                                        const std::function<bool()>& interrupted)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, *view.scene);
    if (!scene) return scene.diagnostics();
    std::vector<AblationRow> rows;
    for (const Situation& situation : kSituations) {
        Frame frame = makeFrame(*scene, view.camera, view.extent);
        Description description = task.description;
        if (situation.off) description = withoutOcclusion(std::move(description));
        auto host = HostTextures::make(device, description, view.extent, frame);
        if (!host) return host.diagnostics();
        Result<Frame> hosted = host->frameOf(frame);
        if (!hosted) return hosted.diagnostics();
        frame = std::move(*hosted);  // cameras move by so little that the textures do for all
        auto all = contenders(device, description, situation, frame, view.extent);
        if (!all) return all.diagnostics();
        const Status taken = takeTurns(device, situation, frame, repeats, *all, interrupted);
        if (!taken) return taken.diagnostics();
        if (interrupted()) break;
        for (const Contender& each : *all) {
            rows.push_back(rowOf(task, view, situation, each, all->front()));
            rows.back().device = device.caps().name;
            rows.back().clock = clockName(FrameClock(device.caps().software).method());
            rows.back().key = keyOnDevice(task.sample.key, device.caps().name);
        }
    }
    return rows;
}

MeasureJob ablationJob(Device& device, const BenchPlan& plan, const std::vector<AblationRow>& known,
                       int repeats, std::function<bool()> interrupted)
{
    MeasureJob job;
    for (const AblationRow& row : known)
        if (isLast(row)) job.done.insert(row.key);
    for (const BenchTask& task : plan.tasks)
        job.tasks.push_back({keyOnDevice(task.sample.key, device.caps().name),
                             sampleTitle(task.sample), task.sample.failure});
    job.measure = [&device, &plan, repeats, interrupted](std::size_t index) -> Result<Measured> {
        const BenchTask& task = plan.tasks[index];
        const auto rows = ablate(device, task, plan.views[task.view], repeats, interrupted);
        if (!rows) return rows.diagnostics();
        std::string lines;
        for (const AblationRow& row : *rows) lines += (lines.empty() ? "" : "\n") + toJsonLine(row);
        return Measured{std::move(lines), std::to_string(rows->size()) + " rows"};
    };
    return job;
}

std::vector<AblationRow> rowsOf(const std::vector<AblationRow>& rows, const std::string& key)
{
    std::vector<AblationRow> found;
    for (const AblationRow& row : rows)
        if (row.key == key) found.push_back(row);
    return found;
}

std::string toText(const std::vector<AblationRow>& rows)
{
    std::string text;
    for (const AblationRow& row : rows) {
        if (row.optimization.empty()) {
            char cell[64];
            std::snprintf(cell, sizeof cell, "\n%-14s %9s ms;", row.situation.c_str(),
                          fixed(row.ms.median, 3).c_str());
            text += cell;
            continue;
        }
        const std::string without =
            row.optimization == kAllOptimizations ? "none of them" : "not " + row.optimization;
        text += "  " + without + " x" + significant(row.factor.median, 3);
    }
    return text + "\n";
}

}  // namespace crevice
