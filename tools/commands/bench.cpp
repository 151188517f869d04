// SPDX-License-Identifier: MIT
// crevice bench: error against run time of many configs, scenes, sizes and sample counts.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/bench/choice.h"
#include "tools/measure/bench/measure.h"
#include "tools/measure/bench/quick.h"
#include "tools/measure/bench/run.h"
#include "tools/measure/motion/figures.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/device/open_device.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/print.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <map>
#include <memory>

namespace crevice {
namespace {

constexpr double kFirstLookS = 10;

struct BenchCommand {
    BenchOptions bench;
    MeasureOptions measure;
    CacheOptions cache;
    std::string checkout;
    std::string backend;
    RunOptions run{"", "bench"};
    bool list = false;
};

int listTasks(const BenchPlan& plan)
{
    for (const BenchTask& task : plan.tasks)
        print("%s  %s%s%s\n", task.sample.key.c_str(), sampleTitle(task.sample).c_str(),
              task.sample.failure.empty() ? "" : ": ", task.sample.failure.c_str());
    return exitCodeOf(plan.diagnostics);
}

/// What the results have of the plan's motion, a table for each view and radius.
void printMotion(const BenchPlan& plan, const std::vector<BenchSample>& samples,
                 const std::string& device)
{
    std::map<std::string, const BenchSample*> known;
    for (const BenchSample& sample : samples) known[sample.key] = &sample;
    std::map<std::string, std::vector<MotionRow>> tables;  // by their titles
    for (const BenchTask& task : plan.tasks) {
        const auto found = known.find(keyOnDevice(task.sample.key, device));
        if (found == known.end() || found->second->motion.paths.empty()) continue;
        const BenchSample& sample = *found->second;
        const std::string title = viewName(sample.scene, sample.camera) + ", " +
                                  sizeText(sample.extent) + ", radius " + shortest(sample.radius);
        tables[title].push_back({sampleLabel(sample), sample.error.rmse, sample.motion});
    }
    for (const auto& [title, rows] : tables)
        print("%s\n\n%s\n", title.c_str(), motionTable(rows).c_str());
}

/// What a minute of `crevice choose` begins with, for all configs in the first view: a bench of
/// them takes long.
void printFirstLook(const BenchCommand& command, const BenchPlan& plan, const BenchTask& task,
                    const SourceSet& sources, Device& device)
{
    QuickOptions quick{task.sample.scene,   {}, command.bench.overrides,
                       command.bench.roots, {}, true};
    if (!command.bench.radii.empty())
        quick.overrides.push_back("radius=" + shortest(command.bench.radii.front()));
    quick.time_s = kFirstLookS;
    quick.interrupted = interrupted;
    QuickBench bench(device, plan.views[task.view], sources, std::move(quick));
    if (!bench.run()) return;  // the bench itself will say why
    printMessage("a first look, of %s:\n", viewName(task.sample.scene, "").c_str());
    for (const BenchSample& sample : bench.samples())
        printMessage("  %-24s error %s +- %s, %s ms, %s x learnopengl\n",
                     sampleLabel(sample).c_str(), fixed(sample.error.rmse, 3).c_str(),
                     fixed(bench.detailsOf(sample).error_margin, 3).c_str(),
                     significant(sample.cost.median, 3).c_str(),
                     fixed(sample.ratio_learnopengl, 2).c_str());
}

int measureErrors(const BenchCommand& command, const BenchPlan& plan, const SourceSet& sources,
                  Device& device, double time_budget)
{
    const std::string& name = device.caps().name;
    Result<BenchFile> file = openBench(command.run.out);
    if (!file) return report(file.diagnostics(), false);
    catchInterrupts();
    const auto is_new = [&](const BenchTask& task) {
        return task.sample.failure.empty() &&
               file->done.count(keyOnDevice(task.sample.key, name)) == 0;
    };
    const auto first = std::find_if(plan.tasks.begin(), plan.tasks.end(), is_new);
    const bool of_all = command.bench.configs.empty() && command.bench.samples.empty();
    if (of_all && first != plan.tasks.end()) printFirstLook(command, plan, *first, sources, device);
    Progress progress;
    MeasureOptions measure = command.measure;
    measure.rays = command.bench.rays;
    measure.motion = command.bench.motion;
    measure.cache_folder = command.cache.path();
    measure.out_folder = command.run.out;
    measure.interrupted = interrupted;
    measure.tracing = [&progress](double done) { progress.update(done, ": tracing ground truth"); };
    BenchMeter meter(device, plan, sources, measure);
    MeasureWorld world;
    world.device = name;
    world.measure = [&meter](const BenchTask& task) { return meter.measure(task); };
    world.time_budget_s = time_budget;
    const MeasureSummary summary = measureOnConsole(plan, *file, world, progress);
    if (measure.motion)
        if (const auto samples = readBenchSamples({file->lines.path()}); samples)
            printMotion(plan, *samples, name);
    return exitCodeOf(summary);
}

int measurePlan(const BenchCommand& command, const BenchPlan& plan, const SourceSet& sources,
                double time_budget)
{
    const Result<OpenDevice> open = openDevice(command.backend);
    report(open.diagnostics(), false);
    if (!open) return exitCodeOf(open.diagnostics());
    const int code = measureErrors(command, plan, sources, *open->device, time_budget);
    return code == kExitOk ? exitCodeOf(plan.diagnostics) : code;
}

int bench(BenchCommand command)
{
    const Result<double> time_budget = timeBudgetOf(command.run);
    if (!time_budget) return report(time_budget.diagnostics(), false);
    if (command.bench.scenes.empty()) command.bench.scenes = {"room"};
    const CheckoutSources sources(command.checkout, command.bench.roots);
    const Result<BenchPlan> plan = planBench(command.bench, sources);
    if (!plan) return report(plan.diagnostics(), false);
    report(plan->diagnostics, false);
    if (command.list) return listTasks(*plan);
    if (plan->tasks.empty()) {
        printMessage("there is nothing to measure\n");
        return exitCodeOf(plan->diagnostics);
    }
    return measurePlan(command, *plan, sources, *time_budget);
}

void addSampleOptions(CLI::App& app, BenchCommand& command)
{
    BenchOptions& bench = command.bench;
    app.add_option("--config", bench.configs,
                   "A shipped config's name or a file; may be repeated. Default: all shipped ones")
        ->allow_extra_args(false);
    app.add_option("--scene", bench.scenes,
                   "A file or a built-in scene; may be repeated. Default: room")
        ->allow_extra_args(false);
    addImportOptions(app, bench.import);
    app.add_option("--size", bench.sizes, "Sizes in pixels, such as 480x270,960x540")
        ->type_name("WxH,...")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option(
           "--radius", bench.radii,
           "Radius of the configs and of the ground truth, scene units; several as 0.5,1. Default: "
           "each config's own")
        ->type_name("R,...")
        ->delimiter(',')
        ->check(aboveZero("0.5,1"));
    app.add_option(
           "--samples", bench.samples,
           "Samples (depth taps) per pixel, such as 4,8,16,32,64. Default: each config's own")
        ->type_name("N,...")
        ->delimiter(',')
        ->check(aboveZero("4,16"));
    addList(app, "--set", bench.overrides, "NAME=VALUE",
            "Set a value in every config, as for crevice render; may be repeated");
    addHostDepthOption(app, bench.overrides);
    addText(app, "--output", bench.output, "NAME",
            "Time what this output needs: color for whole frames, with geometry, occlusion "
            "and light. The error stays that of ao");
    app.add_option("--camera", bench.camera, "A camera, written as for crevice render");
    app.add_option("--rays", bench.rays, "Rays per pixel of the ground truth")
        ->capture_default_str();
}

}  // namespace

void addBenchCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("bench", "Measure error against run time");
    auto options = std::make_shared<BenchCommand>();
    options->bench.version = CREVICE_VERSION;
    addSampleOptions(*command, *options);
    command
        ->add_option("--repeats", options->measure.repeats,
                     "Least number of timed repeats of each bench sample; more are taken while its "
                     "cost ratios vary")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--motion", options->bench.motion,
                      "Measure what changes while the camera moves, too, and print it; traces 13 "
                      "ground truths a view, so choose a small --size");
    addRunOptions(*command, options->run);
    addCacheOptions(*command, options->cache);
    addBackendOption(*command, options->backend);
    addCheckoutOption(*command, options->checkout);
    addRootOption(*command, options->bench.roots);
    addDisableOption(*command, options->bench.disable);
    command->add_flag("--list", options->list,
                      "Print the bench samples, each a config in one view, and measure nothing");
    command->footer(
        "Examples:\n"
        "  crevice bench --config learnopengl --config thesis --samples 4,16,64\n"
        "  crevice bench --scene model.glb --radius 0.5 --time-budget 10m --out mine");
    command->callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace crevice
