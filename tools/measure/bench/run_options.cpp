// SPDX-License-Identifier: MIT
#include "tools/measure/bench/run_options.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace crevice {
namespace {

constexpr std::size_t kTitlesShown = 20;

void printNamed(const char* what, const std::vector<std::string>& titles)
{
    for (std::size_t i = 0; i < titles.size() && i < kTitlesShown; ++i)
        printMessage("%s: %s\n", what, titles[i].c_str());
    if (titles.size() > kTitlesShown)
        printMessage("%s: %zu more\n", what, titles.size() - kTitlesShown);
}

void printSummary(const MeasureSummary& summary, const std::string& file)
{
    printNamed("failed", summary.failures);
    printNamed("missing", summary.missing);
    printMessage("%d measured, %d were there already, %zu failed, %zu not begun: %s\n",
                 summary.measured, summary.kept, summary.failures.size(), summary.missing.size(),
                 file.c_str());
    if (!summary.missing.empty() || !summary.failures.empty())
        printMessage("run the same command again to measure the rest\n");
}

}  // namespace

void addRunOptions(CLI::App& app, RunOptions& options)
{
    app.add_option("--time-budget", options.time_budget,
                   "Begin no bench sample after this time: 90s, 5m, 1.5h");
    app.add_option("--out", options.out,
                   "Folder for results.jsonl and pictures; what is there already is not measured "
                   "again")
        ->type_name("FOLDER")
        ->capture_default_str();
}

Result<double> timeBudgetOf(const RunOptions& options)
{
    if (options.time_budget.empty()) return 0.0;
    std::string_view unit = options.time_budget;
    const double number = takeNumber(unit).value_or(0.0);
    const double factor = unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
    const double seconds = number * factor;
    if (seconds > 0.0 && std::isfinite(seconds)) return seconds;
    return Diagnostic{Code::usage,
                      "'" + options.time_budget + "' is not a time above 0 with its unit",
                      "write --time-budget 90s, 5m or 1.5h"};
}

MeasureSummary measureOnConsole(const BenchPlan& plan, BenchFile& file, MeasureWorld world,
                                Progress& progress)
{
    world.seconds = clockSeconds;
    world.interrupted = interrupted;
    world.begin = [&progress](const std::string& title) { progress.begin("measuring " + title); };
    world.say = [&progress](const std::string& line) {
        progress.wipe();
        printMessage("%s\n", printableLine(line).c_str());
    };
    catchInterrupts();
    MeasureSummary summary = measureAll(plan, file, world);
    progress.wipe();
    report(summary.written.diagnostics(), false);
    printSummary(summary, file.lines.path());
    return summary;
}

int exitCodeOf(const MeasureSummary& summary)
{
    if (!summary.written) return exitCodeOf(summary.written.diagnostics());
    if (summary.interrupted) return kExitInterrupted;
    return summary.failures.empty() ? kExitOk : kExitBadInput;
}

}  // namespace crevice
