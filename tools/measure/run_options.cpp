// SPDX-License-Identifier: MIT
#include "tools/measure/run_options.h"

#include "tools/commands/cli/long_run.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

namespace crevice {
namespace {

constexpr std::size_t kMostNamed = 20;

Diagnostic usageError(std::string message, std::string help)
{
    Diagnostic error{Code::usage, std::move(message)};
    error.help = std::move(help);
    return error;
}

void printNamed(const char* what, const std::vector<std::string>& titles)
{
    for (std::size_t i = 0; i < titles.size() && i < kMostNamed; ++i)
        printMessage("%s: %s\n", what, titles[i].c_str());
    if (titles.size() > kMostNamed)
        printMessage("%s: %zu more\n", what, titles.size() - kMostNamed);
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

void addRunOptions(CLI::App& app, RunOptions& options, const std::string& tasks,
                   const std::string& kept)
{
    app.add_option("--time-budget", options.time_budget,
                   "Begin no " + tasks + " after this time: 90s, 5m, 1.5h");
    app.add_option("--shard", options.shard, "Measure the Ith of N shares of the " + tasks + "s")
        ->type_name("I/N");
    app.add_option("--out", options.out,
                   "Folder for " + kept + "; what is there already is not measured again")
        ->type_name("FOLDER")
        ->capture_default_str();
}

Result<Shard> parseShard(const std::string& text)
{
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, shard.index);
    if (index.ec == std::errc() && index.ptr != end && *index.ptr == '/') {
        const auto count = std::from_chars(index.ptr + 1, end, shard.count);
        if (count.ec == std::errc() && count.ptr == end && shard.index >= 1 &&
            shard.index <= shard.count)
            return shard;
    }
    return usageError("--shard '" + text + "' is not I/N with 1 <= I <= N", "write --shard 3/8");
}

Result<double> parseDuration(const std::string& text)
{
    std::string_view unit = text;
    const double number = takeNumber(unit).value_or(0.0);
    const double factor = unit == "" || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
    const double seconds = number * factor;
    if (seconds > 0.0 && std::isfinite(seconds)) return seconds;
    return usageError("'" + text + "' is not a length of time above 0",
                      "write --time-budget 90s, 5m or 1.5h");
}

Result<RunLimits> limitsOf(const RunOptions& options)
{
    const Result<Shard> shard = parseShard(options.shard);
    if (!shard) return shard.diagnostics();
    if (options.time_budget.empty()) return RunLimits{*shard};
    const Result<double> seconds = parseDuration(options.time_budget);
    if (!seconds) return seconds.diagnostics();
    return RunLimits{*shard, *seconds};
}

MeasureSummary measureOnConsole(const MeasureJob& job, LineFile& file, double time_budget_s,
                                Progress& progress)
{
    MeasureWorld world;
    world.seconds = clockSeconds;
    world.interrupted = interrupted;
    world.begin = [&progress](const std::string& title) { progress.begin("measuring " + title); };
    world.say = [&progress](const std::string& line) {
        progress.wipe();
        printMessage("%s\n", printableLine(line).c_str());
    };
    world.time_budget_s = time_budget_s;
    catchInterrupts();
    MeasureSummary summary = measureAll(job, file, world);
    progress.wipe();
    report(summary.written.diagnostics(), false);
    printSummary(summary, file.path());
    return summary;
}

int exitCodeOf(const MeasureSummary& summary)
{
    if (!summary.written) return exitCodeOf(summary.written.diagnostics());
    if (summary.interrupted) return kExitInterrupted;
    return summary.failures.empty() ? kExitOk : kExitBadInput;
}

}  // namespace crevice
