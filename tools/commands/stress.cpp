// SPDX-License-Identifier: MIT
// crevice stress: at which scales, cameras and inputs a config holds, and where it breaks.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/reference/tracer.h"
#include "tools/measure/stress/run.h"
#include "tools/render/device/open_device.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/options.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

constexpr const char* kKnownSize = "256x144";  // of docs/stress/known.jsonl

struct StressCommand {
    StressOptions stress;
    ConfigOptions config;
    CacheOptions cache;
    std::string backend;
    std::string precision;
    std::string size = kKnownSize;
    std::string out = "stress";  ///< A folder.
    std::string against;         ///< The folder of another run.
    bool list = false;
    bool json = false;
};

int listCases(const std::vector<StressTask>& tasks)
{
    const StressCase* last = nullptr;
    std::size_t cases = 0;
    for (const StressTask& task : tasks) {
        if (task.config.config != tasks.front().config.config) break;
        if (task.stress == last) continue;
        last = task.stress;
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
    int series = 0, failing = 0, failures = 0;

    void add(const Breakdown& found)
    {
        series += !found.absent;
        failing += found.failures > 0;
        failures += found.failures;
    }
};

void printPoints(const std::vector<BreakdownPoint>& points, const std::string& config)
{
    bool any = false;
    for (const BreakdownPoint& point : points) {
        if (point.config != config) continue;
        any = true;
        print("  %s\n", sentenceOf(point).c_str());
    }
    if (!any) print("  Nothing breaks.\n");
    print("\n");
}

void printTable(const std::vector<StressSeries>& all)
{
    const std::vector<BreakdownPoint> points = breakdownPoints(all);
    std::string config;
    Totals totals;
    for (const StressSeries& series : all) {
        if (series.config != config) {
            config = series.config;
            print("%s\n", config.c_str());
            printPoints(points, config);
        }
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        print("  %-34s %s\n", series.stress->name.c_str(), describe(*series.stress, found).c_str());
        totals.add(found);
    }
    print("%d cases, %d of them fail in %d steps\n", totals.series, totals.failing,
          totals.failures);
}

/// Whose known steps each config is compared with, by its name in records.
std::map<std::string, KnownConfig> knownConfigs(const StressCommand& command,
                                                const std::vector<StressTask>& tasks,
                                                const SourceSet& sources)
{
    std::map<std::string, KnownConfig> all;
    for (const StressTask& task : tasks) {
        const auto [place, is_new] = all.try_emplace(nameOf(task.config));
        if (!is_new) continue;
        place->second.name = place->first;
        if (!command.against.empty()) continue;
        place->second.name = shippedNameOf(task.config, sources);
        place->second.same = place->second.name == place->first && task.config.overrides.empty() &&
                             command.size == kKnownSize;
        place->second.known_only = !place->second.name.empty();
    }
    return all;
}

void printJson(const std::vector<StressSeries>& all, const std::string& device,
               const std::vector<std::string>& worse, int unjudged)
{
    std::vector<std::string> points;
    for (const BreakdownPoint& point : breakdownPoints(all)) points.push_back(sentenceOf(point));
    nlohmann::json cases = nlohmann::json::array();
    Totals totals;
    for (const StressSeries& series : all) {
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        cases.push_back({{"config", series.config},
                         {"case", series.stress->name},
                         {"failures", found.failures},
                         {"text", describe(*series.stress, found)}});
        totals.add(found);
    }
    printAsJson({{"device", device},
                 {"breakdown_points", points},
                 {"cases", cases},
                 {"series", totals.series},
                 {"failing", totals.failing},
                 {"failures", totals.failures},
                 {"worse", worse},
                 {"unjudged", unjudged}});
}

/// Returns how the command ends.
int showAll(const StressCommand& command, const KnownSteps& known,
            const std::map<std::string, KnownConfig>& configs,
            const std::vector<StressRecord>& records, const std::string& device)
{
    const std::vector<StressSeries> all = seriesOf(records);
    std::vector<std::string> worse;
    int unjudged = 0;
    for (const StressSeries& series : all)
        for (std::string& each : worseThan(known, configs.at(series.config), series, unjudged))
            worse.push_back(std::move(each));
    if (command.json) {
        printJson(all, device, worse, unjudged);
    } else {
        printTable(all);
        for (const std::string& each : worse) print("  %s\n", each.c_str());
        print("%zu steps are worse than known\n", worse.size());
        if (unjudged > 0) print("%d steps have no known error and are not judged\n", unjudged);
    }
    return worse.empty() ? kExitOk : kExitDiffers;
}

int stress(StressCommand command)
{
    const Result<Extent> size = parseSize(command.size);
    if (!size) return report(size.diagnostics(), command.json);
    command.stress.variant = command.config.variant;
    command.stress.overrides = command.config.overrides;
    command.stress.roots = command.config.roots;
    const CheckoutSources sources(command.config.checkout, command.config.roots);
    const Result<std::vector<StressTask>> tasks = planStress(command.stress, sources);
    if (!tasks) return report(tasks.diagnostics(), command.json);
    if (command.list) return listCases(*tasks);

    const Result<KnownSteps> known =
        command.against.empty() ? shippedSteps() : readKnownSteps(command.against + "/known.jsonl");
    if (!known) return report(known.diagnostics(), command.json);
    const Result<OpenDevice> open = openDevice(command.backend, command.precision);
    if (!open) return report(open.diagnostics(), command.json);
    report(open.diagnostics(), false);
    StressRunner runner(*open->device, sources, command.cache.path());
    const std::string device = open->device->caps().name;
    Progress progress;
    std::size_t count = 0;
    const auto draw = [&](const StressTask& task) {
        progress.begin("[" + std::to_string(++count) + "/" + std::to_string(tasks->size()) + "] " +
                       stepTitle(task));
        StressDrawing done = runner.measure(task, *size);
        done.record.device = device;
        done.record.version = CREVICE_VERSION;
        return done;
    };
    const Result<std::vector<StressRecord>> records = runStress(*tasks, command.out, draw);
    progress.wipe();
    if (!records) return report(records.diagnostics(), command.json);
    return showAll(command, *known, knownConfigs(command, *tasks, sources), *records, device);
}

}  // namespace

void addStressCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("stress", "Find at which scales, cameras and inputs configs break");
    auto options = std::make_shared<StressCommand>();
    command->add_option("CONFIG", options->stress.configs,
                        "Shipped configs' names, or files. Default: all shipped ones");
    addList(*command, "--case", options->stress.cases, "NAME", "Only this case; may be repeated");
    addText(*command, "--size", options->size, "WxH", "Size of most pictures, in pixels");
    command->add_flag("--quick", options->stress.quick, "Two or three steps of each case");
    addText(*command, "--against", options->against, "FOLDER",
            "Folder of a run before, in the place of what is known of shipped configs");
    addText(*command, "--out", options->out, "FOLDER",
            "Folder for known.jsonl, stress.jsonl and pictures of failures");
    addConfigOptions(*command, options->config);
    addCacheOptions(*command, options->cache);
    addBackendOption(*command, options->backend);
    addPrecisionOption(*command, options->precision);
    command->add_flag("--list", options->list, "Print the cases and stop");
    command->add_flag("--json", options->json, "Print the table as JSON");
    command->footer(
        "Exit code 5 where a step fails that held in the shipped config, or is worse. A config of\n"
        "one's own is compared with the shipped one that it extends.\n"
        "Examples:\n"
        "  crevice stress gtao mobile --case plane_near_far --case offset\n"
        "  crevice stress my.json --quick --out mine");
    command->callback([options, &exit_code] { exit_code = stress(*options); });
}

}  // namespace crevice
