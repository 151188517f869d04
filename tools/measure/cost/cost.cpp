// SPDX-License-Identifier: MIT
#include "tools/measure/cost/cost.h"

#include "core/base/text.h"
#include "tools/measure/cost/counting_device.h"
#include "tools/measure/cost/gpus.h"
#include "tools/measure/cost/loops.h"
#include "tools/render/scene_upload.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <crevice/recording_device.h>

#include <cmath>

namespace crevice {
namespace {

using Json = CostReport;

/// As many digits as tell two shaders apart, so that files stay short.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

double pixelsOf(const Extent& extent) { return double(extent.width) * extent.height; }

Result<std::vector<const CostGpu*>> findGpus(const std::vector<std::string>& names)
{
    std::vector<const CostGpu*> gpus;
    std::vector<std::string> known;
    for (const CostGpu& gpu : costGpus()) known.push_back(gpu.name);
    for (const std::string& name : names.empty() ? known : names) {
        gpus.push_back(findCostGpu(name));
        if (!gpus.back())
            return Diagnostic{Code::usage, "'" + name + "' is no GPU that is known",
                              "--gpu takes " + joined(known)};
    }
    return gpus;
}

/// The plan for the scene on a device that no machine needs to have, so that figures are the same
/// everywhere.
Result<Plan> planFor(const Description& description, const SceneView& view)
{
    RecordingDevice device;
    const Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    return compile(description, traitsOf(makeFrame(*scene, view.camera, view.extent)), usualCaps(),
                   {view.extent});
}

Json figuresJson(const CostGpu& gpu, const CompilerFigures& figures)
{
    Json json = {{"gpu", gpu.name}};
    if (!figures.refusal.empty()) {
        json["refusal"] = figures.refusal;
        return json;
    }
    json["instructions"] = figures.instructions;
    json["run"] = rounded(figures.run);
    json["spills"] = figures.spills;
    json["fills"] = figures.fills;
    json["threads"] = figures.threads;
    json["most_threads"] = gpu.most_threads;
    if (figures.cycles >= 0) json["cycles"] = rounded(figures.cycles);
    for (std::size_t i = 0; i < gpu.units.size(); ++i)
        json["cycles_" + gpu.units[i]] = rounded(figures.unit_cycles[i]);
    if (figures.registers >= 0) json["registers"] = figures.registers;
    json["code_bytes"] = figures.code_bytes;
    if (figures.arithmetic < 0) return json;
    json["arithmetic"] = figures.arithmetic;
    json["arithmetic_16_bit"] = figures.half_arithmetic;
    return json;
}

/// A pass but for what compilers say. `count` is that of the frame; null where not counted.
Json passJson(const Plan& plan, const PlanPass& pass, PassRole role, const PassCount* count)
{
    const MovedBytes bytes = movedBytes(plan, pass);
    Json json = {{"pass", pass.name},
                 {"for", nameOf(role)},
                 {"size", {pass.extent.width, pass.extent.height}},
                 {"pixels", rounded((count ? count->pixels : pixelsOf(pass.extent)) /
                                    pixelsOf(plan.extent))}};
    if (count) json["fetches"] = rounded(count->fetches / pixelsOf(plan.extent));
    json["tile_bytes"] = std::llround(bytes.written + bytes.loaded);
    json["read_bytes"] = std::llround(bytes.read - bytes.loaded);
    json["loaded_bytes"] = std::llround(bytes.loaded);
    json["gpus"] = Json::array();
    return json;
}

/// Fetches are left out, and it says why, where no frame could be drawn and counted.
Json passesJson(const Result<PassCounts>& counted, const Plan& plan,
                const std::vector<PassRole>& roles, Json& config)
{
    if (!counted) config["uncounted"] = counted.diagnostics().front().message;
    Json passes = Json::array();
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const PlanPass& pass = plan.passes[i];
        const bool known = counted && counted->count(pass.name) > 0;
        passes.push_back(passJson(plan, pass, roles[i], known ? &counted->at(pass.name) : nullptr));
        if (counted && !known && pass.type == PassType::fullscreen)
            config["uncounted"] = "pass '" + pass.name + "' could not be counted";
    }
    return passes;
}

/// A plan's programs, and each without loops: all bodies once, and each of them twice.
struct Variants {
    std::vector<PlanProgram> programs;
    std::vector<std::size_t> first;            ///< By the plan's program, in `programs`.
    std::vector<std::vector<GlslLoop>> loops;  ///< By the plan's program.

    explicit Variants(const std::vector<PlanProgram>& of)
    {
        for (const PlanProgram& program : of) {
            first.push_back(programs.size());
            loops.push_back(loopsOf(program.fragment.text));
            programs.push_back(program);
            const int last = loops.back().empty() ? -2 : static_cast<int>(loops.back().size()) - 1;
            for (int twice = -1; twice <= last; ++twice) {
                programs.push_back(program);
                programs.back().fragment.text =
                    withoutLoops(program.fragment.text, loops.back(), twice);
            }
        }
    }
};

/// A program's figures with loops as often as they run in a pass. `compiled` has all variants.
CompilerFigures figuresOf(const std::vector<CompilerFigures>& compiled, const Variants& variants,
                          std::size_t program, const PassCount* count)
{
    const std::vector<GlslLoop>& loops = variants.loops[program];
    const CompilerFigures* figures = &compiled[variants.first[program]];
    CompilerFigures whole = *figures;
    if (loops.empty() || !count || count->runs.size() != loops.size()) return whole;
    for (std::size_t i = 1; i < loops.size() + 2; ++i)
        if (!figures[i].refusal.empty()) whole.refusal = "without loops: " + figures[i].refusal;
    if (!whole.refusal.empty()) return whole;
    const auto asItRuns = [&](auto&& cost) {
        std::vector<double> twice;
        for (std::size_t i = 0; i < loops.size(); ++i) twice.push_back(cost(figures[i + 2]));
        return costAsItRuns(loops, cost(figures[1]), twice, count->runs);
    };
    whole.run = asItRuns([](const CompilerFigures& each) { return each.run; });
    whole.cycles = whole.unit_cycles.empty() ? -1 : 0;
    for (std::size_t unit = 0; unit < whole.unit_cycles.size(); ++unit) {
        whole.unit_cycles[unit] =
            asItRuns([unit](const CompilerFigures& each) { return each.unit_cycles[unit]; });
        whole.cycles = std::max(whole.cycles, whole.unit_cycles[unit]);
    }
    return whole;
}

/// What one GPU's compiler makes of several passes of a picture of so many pixels: the `index`th of
/// each. Its time is that of the busiest unit of all cores, were nothing ever waited for.
Json gpuSum(const std::vector<const Json*>& passes, std::size_t index, double pixels)
{
    Json sum = {{"gpu", passes.front()->at("gpus").at(index).at("gpu")},
                {"instructions", 0},
                {"run", 0.0},
                {"largest_spills", 0},
                {"its_fills", 0},
                {"lowest_threads", 0},
                {"most_threads", 0},
                {"code_bytes", 0}};
    const auto raise = [&sum](const char* key, const auto& more) {
        sum[key] = sum.value(key, decltype(+more)()) + more;
    };
    for (const Json* pass : passes) {
        const Json& gpu = pass->at("gpus").at(index);
        if (gpu.contains("refusal")) {
            sum["refused"] = true;  // the rest is of the others
            continue;
        }
        const int threads = gpu.at("threads");
        if (sum["most_threads"] == 0 || threads < sum["lowest_threads"])
            sum["lowest_threads"] = threads;
        sum["most_threads"] = gpu.at("most_threads");
        if (std::pair(gpu.at("spills").get<int>(), gpu.at("fills").get<int>()) >
            std::pair(sum["largest_spills"].get<int>(), sum["its_fills"].get<int>())) {
            sum["largest_spills"] = gpu.at("spills");
            sum["its_fills"] = gpu.at("fills");
        }
        for (const char* key : {"instructions", "code_bytes", "arithmetic", "arithmetic_16_bit"})
            if (gpu.contains(key)) raise(key, gpu.at(key).get<int>());
        for (const char* key : {"run", "cycles"})
            if (gpu.contains(key))
                raise(key, gpu.at(key).get<double>() * pass->at("pixels").get<double>());
    }
    for (const char* key : {"run", "cycles"})
        if (sum.contains(key)) sum[key] = rounded(sum[key]);
    const CostGpu& gpu = *findCostGpu(sum["gpu"].get<std::string>());
    const double cycles =
        sum.contains("cycles") ? double(sum["cycles"]) : double(sum["run"]) / gpu.lanes;
    sum["megacycles"] = rounded(cycles * pixels * 1e-6);
    sum["milliseconds"] = rounded(cycles * pixels * 1e-3 / (gpu.cores * gpu.megahertz));
    return sum;
}

Json sumJson(const Json& config, bool with_geometry)
{
    std::vector<const Json*> passes;
    double fetches = 0, tile_bytes = 0, read_bytes = 0;
    for (const Json& pass : config.at("passes")) {
        const Json& role = pass.at("for");
        const bool geometry = with_geometry && role == nameOf(PassRole::geometry_for_ao);
        if (role != nameOf(PassRole::ao) && !geometry) continue;
        passes.push_back(&pass);
        fetches += pass.value("fetches", 0.0);
        tile_bytes += pass.at("tile_bytes").get<double>();
        read_bytes += pass.at("read_bytes").get<double>();
    }
    if (with_geometry) tile_bytes += config.at("geometry_bytes_for_ao").get<double>();
    Json sum = {{"passes", passes.size()}};
    if (!config.contains("uncounted")) sum["fetches"] = rounded(fetches);
    sum["tile_bytes"] = std::llround(tile_bytes);
    sum["read_bytes"] = std::llround(read_bytes);
    sum["gpus"] = Json::array();
    if (passes.empty()) return sum;
    for (std::size_t i = 0; i < passes.front()->at("gpus").size(); ++i)
        sum["gpus"].push_back(gpuSum(passes, i, config.at("frame_pixels")));
    return sum;
}

Result<Json> costOf(const CostOptions& options, const std::string& name, const SourceSet& sources,
                    const SceneView& view, const std::vector<const CostGpu*>& gpus,
                    const std::string& compilers, Json& report)
{
    ConfigOptions chosen = options.config;
    chosen.config = name;
    Result<Description> description =
        loadDescription(chosen, sources, isFileScene(options.scene.scene));
    if (!description) return description.diagnostics();
    if (const auto known = resolveLengths(*description, view); !known) return known.diagnostics();
    const Result<Plan> plan = planFor(*description, view);
    if (!plan) return plan.diagnostics();
    const std::vector<PassRole> roles = passRoles(*plan);
    Json config = {{"config", name}, {"frame_pixels", std::llround(pixelsOf(view.extent))}};
    const Result<PassCounts> counted = countFrame(*description, view);
    Json passes = passesJson(counted, *plan, roles, config);
    const Variants variants(plan->programs);
    for (const CostGpu* gpu : gpus) {
        const Result<CompiledPrograms> compiled =
            compilePrograms(compilers, *gpu, variants.programs);
        if (!compiled) return compiled.diagnostics();
        report["compilers"] = compiled->version;
        for (std::size_t i = 0; i < plan->passes.size(); ++i) {
            const PlanPass& pass = plan->passes[i];
            const bool known = counted && counted->count(pass.name) > 0;
            const CompilerFigures figures =
                figuresOf(compiled->figures, variants, static_cast<std::size_t>(pass.program),
                          known ? &counted->at(pass.name) : nullptr);
            passes[i]["gpus"].push_back(figuresJson(*gpu, figures));
        }
    }
    config["geometry_bytes_for_ao"] = std::llround(bytesForAo(*plan, roles));
    config["ao"] = nullptr;  // both sums have their places before the passes
    config["ao_with_geometry"] = nullptr;
    config["passes"] = std::move(passes);
    addSums(config);
    return config;
}

}  // namespace

void addSums(CostReport& config)
{
    config["ao"] = sumJson(config, false);
    config["ao_with_geometry"] = sumJson(config, true);
}

std::string costJson(const CostReport& report) { return jsonLines(report) + "\n"; }

Result<CostReport> measureCost(const CostOptions& options, const SourceSet& sources)
{
    const Result<std::vector<const CostGpu*>> gpus = findGpus(options.gpus);
    if (!gpus) return gpus.diagnostics();
    const Result<std::string> compilers = findCompilers(options.compilers);
    if (!compilers) return compilers.diagnostics();
    const Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return view.diagnostics();
    Json report = {
        {"scene", options.scene.scene},    {"size", {view->extent.width, view->extent.height}},
        {"camera", options.scene.camera},  {"variant", options.config.variant},
        {"set", options.config.overrides}, {"compilers", ""},
        {"gpus", Json::array()},           {"configs", Json::array()}};
    for (const CostGpu* gpu : *gpus) report["gpus"].push_back(gpu->name);
    for (const std::string& config : options.configs) {
        Result<Json> cost = costOf(options, config, sources, *view, *gpus, *compilers, report);
        if (!cost) return cost.diagnostics();
        report["configs"].push_back(std::move(*cost));
    }
    return {std::move(report), view.diagnostics()};
}

}  // namespace crevice
