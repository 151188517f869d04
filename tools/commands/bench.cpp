// SPDX-License-Identifier: MIT
// crevice bench: error against run time of many configs, scenes, sizes and sample counts.
#include "tools/bench/ablation.h"
#include "tools/bench/measure.h"
#include "tools/cli/long_run.h"
#include "tools/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/device/open_device.h"
#include "tools/reference/reference_cache.h"
#include "tools/scene/builtin_scenes.h"
#include "tools/scene/options.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace crevice {
namespace {

struct BenchCommand {
    BenchOptions bench;
    MeasureOptions measure;
    CacheOptions cache;
    std::string checkout;
    std::string backend;
    std::string shard = "1/1";
    std::string time_budget;
    std::string out = "bench";
    bool no_budget = false;
    bool list = false;
    bool ablate = false;
};

int listTasks(const BenchPlan& plan)
{
    for (const BenchTask& task : plan.tasks)
        print("%s  %s%s%s\n", task.point.key.c_str(), pointTitle(task.point).c_str(),
              task.point.failure.empty() ? "" : ": ", task.point.failure.c_str());
    return exitCodeOf(plan.diagnostics);
}

void printMissing(const BenchSummary& summary, const std::string& file)
{
    for (const std::string& failure : summary.failures)
        printMessage("failed: %s\n", failure.c_str());
    for (const std::string& title : summary.missing)
        printMessage("missing: %s\n", title.c_str());
    printMessage("%d measured, %d were there already, %zu failed, %zu not begun: %s\n",
                 summary.measured, summary.kept, summary.failures.size(), summary.missing.size(),
                 file.c_str());
    if (const Result<BenchResults> results = readBenchResults({file}); results)
        if (const std::string part = coverageText(coverageOf(*results)); !part.empty())
            printMessage("%s\n", part.c_str());
    if (!summary.missing.empty() || !summary.failures.empty())
        printMessage("the same command goes on where this one stopped\n");
}

int exitCodeOf(const BenchSummary& summary, const BenchPlan& plan)
{
    if (!summary.written) return exitCodeOf(summary.written.diagnostics());
    if (summary.interrupted) return kExitInterrupted;
    return summary.failures.empty() ? exitCodeOf(plan.diagnostics) : kExitBadInput;
}

/// The results file, with what is to be measured in it.
Result<ResultFile> openResults(const std::string& folder, const BenchPlan& plan,
                               const std::string& device)
{
    Result<ResultFile> file = ResultFile::open(folder);
    if (!file) return file;
    PlannedBench planned = plan.planned;
    planned.device = device;
    if (const Status written = file->plan(planned); !written) return written.diagnostics();
    return file;
}

int measureAll(const BenchCommand& command, const BenchPlan& plan, const SourceSet& sources,
               double time_budget)
{
    const Result<OpenDevice> open = openDevice(command.backend);
    if (!open) return report(open.diagnostics(), false);
    report(open.diagnostics(), false);
    catchInterrupts();
    Result<ResultFile> file = openResults(command.out, plan, open->device->caps().name);
    if (!file) return report(file.diagnostics(), false);

    Progress progress;
    MeasureOptions measure = command.measure;
    measure.rays = command.bench.rays;
    measure.budget = !command.no_budget;
    measure.cache_folder = command.cache.path();
    measure.out_folder = command.out;
    measure.interrupted = interrupted;
    measure.tracing = [&progress](double done) { progress.update(done); };
    BenchMeter meter(*open->device, plan, sources, measure);
    BenchWorld world;
    world.measure = [&](const BenchTask& task) {
        progress.begin("measuring " + pointTitle(task.point));
        return meter.measure(task);
    };
    world.seconds = clockSeconds;
    world.interrupted = measure.interrupted;
    world.say = [&progress](const std::string& line) {
        progress.wipe();
        printMessage("%s\n", printableLine(line).c_str());
    };
    world.device = open->device->caps().name;
    world.time_budget_s = time_budget;
    const BenchSummary summary = runBench(plan.tasks, *file, world);
    progress.wipe();
    report(summary.written.diagnostics(), false);
    printMissing(summary, command.out + "/results.jsonl");
    return exitCodeOf(summary, plan);
}

/// Times the rules of every task, and prints a table of each.
int ablateAll(const BenchCommand& command, const BenchPlan& plan, double time_budget)
{
    const Result<OpenDevice> open = openDevice(command.backend);
    report(open.diagnostics(), false);
    if (!open) return exitCodeOf(open.diagnostics());
    Result<LineFile> file = LineFile::open(command.out + "/ablation.jsonl");
    if (!file) return report(file.diagnostics(), false);
    catchInterrupts();
    Progress progress;
    const double begin = clockSeconds();
    int missing = 0;
    int worst = exitCodeOf(plan.diagnostics);
    for (const BenchTask& task : plan.tasks) {
        if (time_budget > 0 && clockSeconds() - begin > time_budget) ++missing;
        if (missing > 0 || interrupted()) continue;
        const std::string title = pointTitle(task.point);
        if (!task.point.failure.empty()) {
            printMessage("failed: %s: %s\n", title.c_str(), task.point.failure.c_str());
            worst = std::max(worst, static_cast<int>(kExitBadInput));
            continue;
        }
        progress.begin("timing the rules of " + title);
        const auto rows = ablate(*open->device, task, plan.views[task.view],
                                 command.measure.repeats, interrupted);
        progress.wipe();
        report(rows.diagnostics(), false);
        if (!rows) worst = std::max(worst, exitCodeOf(rows.diagnostics()));
        if (!rows || interrupted()) continue;
        print("%s, %s%s\n", title.c_str(), open->device->caps().name.c_str(),
              toText(*rows).c_str());
        for (const AblationRow& row : *rows)
            if (const Status written = file->append(toJsonLine(row)); !written)
                return report(written.diagnostics(), false);
    }
    if (missing > 0) printMessage("%d not begun, for time\n", missing);
    return interrupted() ? kExitInterrupted : worst;
}

int bench(BenchCommand command)
{
    const Result<Shard> shard = parseShard(command.shard);
    if (!shard) return report(shard.diagnostics(), false);
    command.bench.shard = *shard;
    double time_budget = 0;
    if (!command.time_budget.empty()) {
        const Result<double> seconds = parseDuration(command.time_budget);
        if (!seconds) return report(seconds.diagnostics(), false);
        time_budget = *seconds;
    }
    if (command.bench.scenes.empty())
        command.bench.scenes = command.ablate ? builtinSceneNames() : std::vector<std::string>{"room"};
    const CheckoutSources sources(command.checkout, command.bench.roots);
    const Result<BenchPlan> plan = planBench(command.bench, sources);
    if (!plan) return report(plan.diagnostics(), false);
    report(plan->diagnostics, false);
    if (command.list) return listTasks(*plan);
    if (plan->tasks.empty()) {
        printMessage("there is no point to measure\n");
        return exitCodeOf(plan->diagnostics);
    }
    return command.ablate ? ablateAll(command, *plan, time_budget)
                          : measureAll(command, *plan, sources, time_budget);
}

void addPointOptions(CLI::App& app, BenchCommand& command)
{
    BenchOptions& bench = command.bench;
    const auto repeatable = [](CLI::Option* option) {
        option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    repeatable(app.add_option("--config", bench.configs,
                              "A shipped config's name or a file; may be repeated. Default: all "
                              "shipped ones"));
    repeatable(app.add_option("--scene", bench.scenes,
                              "A file or a built-in scene; may be repeated. Default: room, and all "
                              "built-in ones for --ablate"));
    addImportOptions(app, bench.import);
    app.add_option("--size", bench.sizes, "Pixels; several as 480x270,960x540")
        ->type_name("WxH,...")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--radius", bench.radii,
                   "Radius of the configs and of the truth, scene units; several as 0.5,1. Default: "
                   "each config's own")
        ->type_name("R,...")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    app.add_option("--samples", bench.samples,
                   "Sample counts, such as 4,8,16,32,64. Default: each config's own")
        ->type_name("N,...")
        ->delimiter(',')
        ->check(CLI::PositiveNumber);
    repeatable(app.add_option("--set", bench.overrides,
                              "Set a value in every config, as for crevice render; may be repeated")
                   ->type_name("NAME=VALUE"));
    app.add_option("--camera", bench.camera, "As for crevice render");
    app.add_option("--rays", bench.rays, "Rays a pixel of the truth")->capture_default_str();
}

}  // namespace

void addBenchCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("bench", "Measure error against run time");
    auto options = std::make_shared<BenchCommand>();
    options->bench.version = CREVICE_VERSION;
    addPointOptions(*command, *options);
    command->add_option("--repeats", options->measure.repeats,
                        "Timed turns a point, at least; more while ratios are restless")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--no-budget", options->no_budget,
                      "Leave out noise, model error and precision error: much quicker");
    command->add_option("--time-budget", options->time_budget,
                        "Begin no point after this time: 90s, 5m, 1.5h");
    command->add_option("--shard", options->shard, "Measure the Ith of N shares of the points")
        ->type_name("I/N");
    command->add_option("--out", options->out,
                        "Folder for results.jsonl and pictures; what is there already is not "
                        "measured again")
        ->type_name("FOLDER")
        ->capture_default_str();
    addCacheOptions(*command, options->cache);
    addBackendOption(*command, options->backend);
    command->add_option("--effects", options->checkout,
                        "Read effects/ and configs/ below this folder before those embedded")
        ->type_name("FOLDER");
    addRootOption(*command, options->bench.roots);
    command->add_flag("--ablate", options->ablate,
                      "Time frames with all rules that leave things out, without each and without "
                      "any, into ablation.jsonl");
    command->add_flag("--list", options->list, "Print the points and stop");
    command->footer("Examples:\n"
                    "  crevice bench --config learnopengl --config thesis --samples 4,16,64\n"
                    "  crevice bench --scene model.glb --radius 0.5 --time-budget 10m --out mine\n"
                    "  crevice bench --samples 4,8,16,32,64 --shard 3/8 --out shard3");
    command->callback([options, &exit_code] { exit_code = bench(*options); });
}

}  // namespace crevice
