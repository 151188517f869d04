// SPDX-License-Identifier: MIT
// crevice cost: what configs cost on phones' GPUs, by their compilers, and whether it is more than
// what was approved.
#include "tools/measure/cost/cost.h"
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/cost/gpus.h"
#include "tools/render/image/image_file.h"

#include "core/base/files.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

constexpr std::size_t kMaxCostBytes = 64u << 20;  // that of all shipped configs is below one

struct CostCommand {
    CostOptions cost;
    bool json = false;
    std::string out;
    std::string check;  ///< A file of approved costs.
};

int printComparison(const CostComparison& comparison)
{
    for (const std::string& each : comparison.better) print("better: %s\n", each.c_str());
    for (const std::string& each : comparison.worse) print("worse: %s\n", each.c_str());
    print("%zu figures worse, %zu better\n", comparison.worse.size(), comparison.better.size());
    return comparison.worse.empty() ? kExitOk : kExitDiffers;
}

int checkCosts(const CostCommand& command, const SourceSet& sources)
{
    const FileBytes file = readBytes(command.check, kMaxCostBytes);
    if (!file)
        return report({{Code::results_broken, "'" + command.check + "': " + file.failure,
                        "name a file that 'crevice cost CONFIG... --out FILE' wrote"}},
                      command.json);
    const Result<ApprovedCost> approved = readCost(command.check, file.bytes, command.cost);
    if (!approved) return report(approved.diagnostics(), command.json);
    const Result<CostReport> now = measureCost(approved->options, sources);
    if (!now) return report(now.diagnostics(), command.json);
    const auto version = [](const CostReport& costs) {
        return costs.at("compilers").get<std::string>();
    };
    if (version(*now) != version(approved->report))
        printMessage("approved with the compilers of %s, and these are of %s: figures may differ\n",
                     version(approved->report).c_str(), version(*now).c_str());
    const Result<CostComparison> comparison = compareCosts(approved->report, *now);
    if (!comparison) return report(comparison.diagnostics(), command.json);
    return printComparison(*comparison);
}

int cost(const CostCommand& command)
{
    const bool checks = !command.check.empty();
    if (checks != command.cost.configs.empty() ||
        (checks && (command.json || !command.out.empty())))
        return report({{Code::usage,
                        checks ? "--check takes no CONFIG, --json or --out: the file "
                                 "says what was measured"
                               : "a CONFIG is missing",
                        "see crevice cost --help"}},
                      false);
    const CheckoutSources sources(command.cost.config.checkout, command.cost.config.roots);
    if (checks) return checkCosts(command, sources);
    if (!command.out.empty())
        if (const Status writable = checkWritable(command.out); !writable)
            return report(writable.diagnostics(), command.json);
    const Result<CostReport> measured = measureCost(command.cost, sources);
    report(measured.diagnostics(), command.json && !measured);
    if (!measured) return exitCodeOf(measured.diagnostics());
    if (!command.out.empty())
        if (const Status written = writeFile(command.out, costJson(*measured)); !written)
            return report(written.diagnostics(), command.json);
    printLines(command.json ? costJson(*measured) : costText(*measured));
    return kExitOk;
}

}  // namespace

void addCostCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand(
        "cost",
        "Show what configs cost on phones' GPUs, by their own compilers; no phone is needed");
    auto options = std::make_shared<CostCommand>();
    command->add_option("CONFIG", options->cost.configs, "Shipped configs' names, or files");
    addConfigOptions(*command, options->cost.config);
    addSceneOptions(*command, options->cost.scene);
    std::string gpus = "Ask this GPU's compiler alone; may be repeated:";
    for (const CostGpu& gpu : costGpus())
        gpus += std::string(&gpu == &costGpus().front() ? " " : ", ") + gpu.name;
    addList(*command, "--gpu", options->cost.gpus, "NAME", gpus);
    addText(*command, "--compilers", options->cost.compilers, "FOLDER",
            "Where tools/scripts/mobile_compilers.sh built them. Default: "
            "CREVICE_MOBILE_COMPILERS, or the script's own");
    command->add_flag("--json", options->json, "Print all figures as JSON");
    addText(*command, "--out", options->out, "FILE", "Write that JSON to a file, for --check");
    addText(*command, "--check", options->check, "FILE",
            "Measure what that file of --out holds again, and fail (5) where a config's AO "
            "loses occupancy or takes a tenth more");
    command->footer(
        "Examples:\n"
        "  crevice cost mobile learnopengl\n"
        "  crevice cost my.json --set samples=4 --gpu Mali-G57\n"
        "  crevice cost mobile balanced --out before.json\n"
        "  crevice cost --check before.json");
    command->callback([options, &exit_code] { exit_code = cost(*options); });
}

}  // namespace crevice
