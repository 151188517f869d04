// SPDX-License-Identifier: MIT
#include "tools/measure/cost/cost.h"

#include "core/base/text.h"
#include "tools/measure/cost/fetches.h"
#include "tools/render/scene_upload.h"
#include "tools/show/plan/planning.h"

#include <crevice/compile.h>
#include <crevice/recording_device.h>

#include <algorithm>

namespace crevice {

namespace {

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
    CompileOptions options;
    options.extent = view.extent;
    return compile(description, traitsOf(makeFrame(*scene, view.camera, view.extent)), usualCaps(),
                   options);
}

/// A pass but for fetches and what compilers say.
PassCost passCost(const Plan& plan, const PlanPass& pass, PassRole role)
{
    PassCost cost;
    cost.pass = pass.name;
    cost.role = role;
    cost.extent = pass.extent;
    cost.pixels = pixelsOf(pass.extent) / pixelsOf(plan.extent);
    cost.bytes = movedBytes(plan, pass);
    return cost;
}

/// Leaves them out, and says why, where no frame can be drawn and counted.
void addFetches(const Description& description, const SceneView& view, const Plan& plan,
                ConfigCost& cost)
{
    const Result<std::map<std::string, double>> counted = countFetches(description, view);
    if (!counted) {
        cost.uncounted = counted.diagnostics().front().message;
        return;
    }
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const auto found = counted->find(plan.passes[i].name);
        if (found != counted->end()) {
            cost.passes[i].fetches = found->second / pixelsOf(view.extent);
        } else if (plan.passes[i].type == PassType::fullscreen) {
            cost.uncounted = "pass '" + plan.passes[i].name + "' could not be counted";
        }
    }
}

Result<ConfigCost> costOf(const CostOptions& options, const std::string& config,
                          const SourceSet& sources, const SceneView& view,
                          const Compilers& compilers, CostReport& report)
{
    ConfigOptions chosen = options.config;
    chosen.config = config;
    const Result<Description> description = loadDescription(chosen, sources);
    if (!description) return description.diagnostics();
    const Result<Plan> plan = planFor(*description, view);
    if (!plan) return plan.diagnostics();
    ConfigCost cost;
    cost.config = config;
    const std::vector<PassRole> roles = passRoles(*plan);
    cost.geometry_bytes_for_ao = bytesForAo(*plan, roles);
    for (std::size_t i = 0; i < plan->passes.size(); ++i)
        cost.passes.push_back(passCost(*plan, plan->passes[i], roles[i]));
    for (const CostGpu* gpu : report.gpus) {
        const Result<CompiledPrograms> compiled = compilePrograms(compilers, *gpu, plan->programs);
        if (!compiled) return compiled.diagnostics();
        report.version = compiled->version;
        for (std::size_t i = 0; i < plan->passes.size(); ++i)
            cost.passes[i].figures.push_back(compiled->figures[plan->passes[i].program]);
    }
    addFetches(*description, view, *plan, cost);
    return cost;
}

void add(const CompilerFigures& figures, double pixels, GpuSum& sum)
{
    if (!figures.refusal.empty()) {
        sum.refused = true;
        return;
    }
    if (figures.spills > sum.spills ||
        (figures.spills == sum.spills && figures.fills > sum.fills)) {
        sum.spills = figures.spills;
        sum.fills = figures.fills;
    }
    sum.threads = sum.instructions == 0 ? figures.threads : std::min(sum.threads, figures.threads);
    sum.instructions += figures.instructions;
    sum.code_bytes += figures.code_bytes;
    if (figures.cycles >= 0) sum.cycles = std::max(sum.cycles, 0.0) + figures.cycles * pixels;
    if (figures.arithmetic < 0) return;
    sum.arithmetic = std::max(sum.arithmetic, 0) + figures.arithmetic;
    sum.half_arithmetic = std::max(sum.half_arithmetic, 0) + figures.half_arithmetic;
}

}  // namespace

CostSum sumOfAo(const CostReport& report, const ConfigCost& config, bool with_geometry)
{
    CostSum sum;
    sum.gpus.resize(report.gpus.size());
    if (config.uncounted.empty()) sum.fetches = 0;
    for (const PassCost& pass : config.passes) {
        const bool geometry = pass.role == PassRole::geometry_for_ao;
        if (pass.role != PassRole::ao && !(geometry && with_geometry)) continue;
        ++sum.passes;
        if (sum.fetches && pass.fetches) *sum.fetches += *pass.fetches;
        sum.bytes.read += pass.bytes.read;
        sum.bytes.loaded += pass.bytes.loaded;
        sum.bytes.written += pass.bytes.written;
        for (std::size_t i = 0; i < pass.figures.size(); ++i)
            add(pass.figures[i], pass.pixels, sum.gpus[i]);
    }
    if (with_geometry) sum.bytes.written += config.geometry_bytes_for_ao;
    return sum;
}

Result<CostReport> measureCost(const CostOptions& options, const SourceSet& sources)
{
    const Result<std::vector<const CostGpu*>> gpus = findGpus(options.gpus);
    if (!gpus) return gpus.diagnostics();
    const Result<Compilers> compilers = findCompilers(options.compilers);
    if (!compilers) return compilers.diagnostics();
    const Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return view.diagnostics();
    CostReport report;
    report.scene = options.scene.scene;
    report.extent = view->extent;
    report.camera = options.scene.camera;
    report.variant = options.config.variant;
    report.set = options.config.overrides;
    report.gpus = *gpus;
    for (const std::string& config : options.configs) {
        Result<ConfigCost> cost = costOf(options, config, sources, *view, *compilers, report);
        if (!cost) return cost.diagnostics();
        report.configs.push_back(std::move(*cost));
    }
    return {std::move(report), view.diagnostics()};
}

}  // namespace crevice
