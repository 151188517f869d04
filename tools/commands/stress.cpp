// SPDX-License-Identifier: MIT
// crevice stress: how far each config holds on stiff and extreme cases, and where it breaks.
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/reference/reference_cache.h"
#include "tools/measure/run_options.h"
#include "tools/measure/stress/breakdown.h"
#include "tools/measure/stress/differences.h"
#include "tools/measure/stress/pictures.h"
#include "tools/render/device/open_device.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/options.h"
#include "tools/show/report/stress_report.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace crevice {
namespace {

struct StressCommand {
    StressOptions stress;
    ConfigOptions config;
    CacheOptions cache;
    std::string backend;
    std::string precision;
    std::string size = "256x144";
    RunOptions run{"", "stress"};
    std::string against;  ///< The folder of another run.
    bool list = false;
    bool json = false;
};

int listCases(const std::vector<StressTask>& tasks)
{
    const StressCase* last = nullptr;
    std::string last_config;
    std::size_t cases = 0;
    for (const StressTask& task : tasks) {
        if (task.stress == last && task.config.config == last_config) continue;
        if (!last_config.empty() && task.config.config != last_config) break;
        last = task.stress;
        last_config = task.config.config;
        ++cases;
        std::string steps;
        for (const StressStep& step : last->steps)
            steps += (steps.empty() ? "" : ", ") + step.label;
        print("%-20s %s\n%-20s %s%s%s\n", last->name.c_str(), last->what.c_str(), "", steps.c_str(),
              last->unit.empty() ? "" : " ", last->unit.c_str());
    }
    print("%zu cases, %zu steps over all configs\n", cases, tasks.size());
    return kExitOk;
}

struct Totals {
    int series = 0, failing = 0, failures = 0, invalid = 0, beyond = 0, refused = 0;
};

Totals totalsOf(const std::vector<StressSeries>& all)
{
    Totals totals;
    for (const StressSeries& series : all) {
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        totals.series += !found.absent;
        totals.failing += found.failures > 0;
        totals.failures += found.failures;
        totals.invalid += !found.invalid.empty();
        totals.beyond += !found.beyond.empty();
        totals.refused += found.refused;
    }
    return totals;
}

void printPoints(const std::vector<BreakdownPoint>& points, const std::string& config)
{
    bool any = false;
    for (const BreakdownPoint& point : points) {
        if (point.config != config) continue;
        any = true;
        print("  %s %s\n", sentenceOf(point).c_str(), likelihoodOf(point).c_str());
    }
    if (!any) print("  Nothing breaks.\n");
    print("\n");
}

void printTable(const std::vector<StressSeries>& all)
{
    const std::vector<BreakdownPoint> points = breakdownPoints(all);
    std::string config;
    for (const StressSeries& series : all) {
        if (series.config != config) {
            config = series.config;
            print("%s\n", config.c_str());
            printPoints(points, config);
        }
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        print("  %-34s %s\n", seriesName(series).c_str(), describe(*series.stress, found).c_str());
    }
    const Totals totals = totalsOf(all);
    print(
        "%d cases, %d of them fail in %d steps (%d are void), %d go beyond the format, %d steps "
        "refused\n",
        totals.series, totals.failing, totals.failures, totals.invalid, totals.beyond,
        totals.refused);
}

nlohmann::json pointsJson(const std::vector<StressSeries>& all)
{
    nlohmann::json points = nlohmann::json::array();
    for (const BreakdownPoint& point : breakdownPoints(all))
        points.push_back({{"config", point.config},
                          {"case", point.stress->name},
                          {"format", point.format},
                          {"likelihood", nameOf(point.likelihood)},
                          {"because", point.because},
                          {"effect", point.effect},
                          {"condition", point.condition},
                          {"holds_at", point.held},
                          {"breaks_at", point.broke},
                          {"others", point.others},
                          {"text", sentenceOf(point)}});
    return points;
}

nlohmann::json casesJson(const std::vector<StressSeries>& all)
{
    nlohmann::json cases = nlohmann::json::array();
    for (const StressSeries& series : all) {
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        const auto label = [&](int step) {
            return step < 0 ? nlohmann::json() : nlohmann::json(series.stress->steps[step].label);
        };
        cases.push_back({{"config", series.config},
                         {"case", series.stress->name},
                         {"format", series.format},
                         {"holds_from", label(found.down.holds_to)},
                         {"holds_to", label(found.up.holds_to)},
                         {"breaks_below", label(found.down.breaks_at)},
                         {"breaks_above", label(found.up.breaks_at)},
                         {"void", found.invalid},
                         {"beyond", found.beyond},
                         {"failures", found.failures},
                         {"refused", found.refused},
                         {"text", describe(*series.stress, found)}});
    }
    return cases;
}

/// What the run differs in from that of --against.
struct Against {
    std::vector<StressDifference> differences = {};
    std::size_t missing = 0;
};

Result<Against> compareRuns(const StressCommand& command, const std::vector<StressSeries>& all)
{
    Against against;
    const Result<std::vector<StressRecord>> before =
        readStressRecords(command.against + "/stress.jsonl");
    if (!before) return before.diagnostics();
    against.differences = differencesSince(seriesOf(*before), all, against.missing);
    return against;
}

void printAgainst(const StressCommand& command, const Against& against)
{
    for (const StressDifference& each : against.differences)
        print("  %s: %s\n", each.step.c_str(), each.what.c_str());
    print("%zu steps differ from %s", against.differences.size(), command.against.c_str());
    if (against.missing > 0) print(", which lacks %zu more", against.missing);
    print("\n");
}

void printJson(const std::vector<StressSeries>& all, const std::string& device,
               const Against& against)
{
    const Totals totals = totalsOf(all);
    nlohmann::json differs = nlohmann::json::array();
    for (const StressDifference& each : against.differences)
        differs.push_back({{"step", each.step}, {"what", each.what}});
    const nlohmann::json json = {{"device", device},          {"breakdown_points", pointsJson(all)},
                                 {"cases", casesJson(all)},   {"series", totals.series},
                                 {"failing", totals.failing}, {"failures", totals.failures},
                                 {"void", totals.invalid},    {"beyond", totals.beyond},
                                 {"refused", totals.refused}, {"differs", differs}};
    printAsJson(json);
}

/// The table and the page. Returns how the command ends.
int showAll(const StressCommand& command, const std::vector<StressRecord>& records,
            const std::string& device, int code)
{
    const std::vector<StressSeries> all = seriesOf(records);
    const Result<Against> against = command.against.empty() ? Against() : compareRuns(command, all);
    if (!against) return report(against.diagnostics(), command.json);
    if (command.json)
        printJson(all, device, *against);
    else
        printTable(all);
    if (!command.json && !command.against.empty()) printAgainst(command, *against);
    const Status page =
        writeFile(command.run.out + "/stress.html", stressHtml(records, command.run.out));
    report(page.diagnostics(), false);
    if (code != kExitOk) return code;
    if (!page) return kExitOutput;
    const bool differs =
        command.against.empty() ? totalsOf(all).failing > 0 : !against->differences.empty();
    return differs ? kExitDiffers : kExitOk;
}

int measureSteps(const StressCommand& command, const std::vector<StressTask>& tasks, Extent size,
                 const SourceSet& sources, double time_budget)
{
    const Result<OpenDevice> open = openDevice(command.backend, command.precision);
    if (!open) return report(open.diagnostics(), command.json);
    report(open.diagnostics(), false);
    Result<LineFile> file = LineFile::open(command.run.out + "/stress.jsonl");
    if (!file) return report(file.diagnostics(), command.json);
    const Result<std::vector<StressRecord>> known = readStressRecords(file->path());
    if (!known) return report(known.diagnostics(), command.json);

    StressRunner meter(*open->device, sources, command.cache.path());
    const std::string device = open->device->caps().name;
    StressHow how;
    how.key = [&](const StressTask& task) {
        return keyOnDevice(meter.contentOf(task, size) + CREVICE_VERSION, device);
    };
    how.measure = [&](const StressTask& task) { return meter.measure(task, size); };
    how.keep = [&](const StressDrawing& done) { return keepPictures(command.run.out, done); };
    how.device = device;
    how.version = CREVICE_VERSION;
    const MeasureJob job = stressJob(tasks, *known, std::move(how));
    Progress progress;
    const MeasureSummary summary = measureOnConsole(job, *file, time_budget, progress);
    const Result<std::vector<StressRecord>> records = recordsOf(job, file->path());
    if (!records) return report(records.diagnostics(), command.json);
    int code = exitCodeOf(summary);
    if (summary.missing.empty()) {
        const MeasureJob pictures =
            pictureJob(tasks, job, breakdownPoints(seriesOf(*records)), command.run.out,
                       [&](const StressTask& task) { return meter.measure(task, size); });
        if (!pictures.tasks.empty())
            code = std::max(code, exitCodeOf(measureOnConsole(pictures, *file, 0, progress)));
    }
    return showAll(command, *records, device, code);
}

int stress(StressCommand command)
{
    const Result<double> time_budget = timeBudgetOf(command.run);
    if (!time_budget) return report(time_budget.diagnostics(), command.json);
    const Result<Extent> size = parseSize(command.size);
    if (!size) return report(size.diagnostics(), command.json);
    command.stress.variant = command.config.variant;
    command.stress.overrides = command.config.overrides;
    command.stress.roots = command.config.roots;
    const CheckoutSources sources(command.config.checkout, command.config.roots);
    const Result<std::vector<StressTask>> tasks = planStress(command.stress, sources);
    if (!tasks) return report(tasks.diagnostics(), command.json);
    if (command.list) return listCases(*tasks);
    return measureSteps(command, *tasks, *size, sources, *time_budget);
}

}  // namespace

void addStressCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("stress", "Find where configs break on stiff and extreme cases");
    auto options = std::make_shared<StressCommand>();
    command->add_option("CONFIG", options->stress.configs,
                        "Shipped configs' names, or files. Default: all shipped ones");
    command->add_option("--case", options->stress.cases, "Only this case; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--size", options->size, "Size of most pictures, in pixels")
        ->type_name("WxH")
        ->capture_default_str();
    command->add_flag("--quick", options->stress.quick,
                      "Two or three steps of each case, in the configs' own formats");
    command
        ->add_option("--against", options->against,
                     "Folder of a run before: exit code 5 where a step differs from it, and not "
                     "where cases fail")
        ->type_name("FOLDER");
    addRunOptions(*command, options->run, "step", "stress.jsonl, stress.html and pictures");
    addConfigOptions(*command, options->config);
    addCacheOptions(*command, options->cache);
    addBackendOption(*command, options->backend);
    addPrecisionOption(*command, options->precision);
    command->add_flag("--list", options->list, "Print the cases and stop");
    command->add_flag("--json", options->json, "Print the table as JSON");
    command->footer(
        "Exit code 5 where a case fails.\n"
        "Examples:\n"
        "  crevice stress gtao mobile --case plane_near_far --case offset\n"
        "  crevice stress --time-budget 10m --out mine");
    command->callback([options, &exit_code] { exit_code = stress(*options); });
}

}  // namespace crevice
