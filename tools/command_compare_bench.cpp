// SPDX-License-Identifier: MIT
// crevice compare-bench: what got worse since an older bench.
#include "tools/cli_output.h"
#include "tools/commands.h"
#include "tools/compare_bench.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace crevice {
namespace {

struct CompareBenchOptions {
    std::string before;
    std::string now;
    BenchLimits limits;
};

void printChanges(const char* title, const std::vector<BenchChange>& changes)
{
    for (const BenchChange& change : changes)
        std::printf("%s: %s: %s was %.5g and is %.5g (at most %.5g is the same)\n", title,
                    change.point.c_str(), change.figure.c_str(), change.before, change.now,
                    change.limit);
}

int printComparison(const BenchComparison& comparison)
{
    printChanges("better", comparison.better);
    for (const std::string& point : comparison.not_measured)
        std::printf("not measured now: %s\n", point.c_str());
    printChanges("worse", comparison.worse);
    for (const std::string& failure : comparison.failed)
        std::printf("fails now: %s\n", failure.c_str());
    if (comparison.without_ratios > 0)
        std::printf("%d of %d points were measured on another device: cost ratios not compared\n",
                    comparison.without_ratios, comparison.compared);
    std::printf("%d points compared: %zu figures worse, %zu better, %zu points fail\n",
                comparison.compared, comparison.worse.size(), comparison.better.size(),
                comparison.failed.size());
    return comparison.worse.empty() && comparison.failed.empty() ? kExitOk : kExitDiffers;
}

int compareBenchFiles(const CompareBenchOptions& options)
{
    const Result<std::vector<BenchPoint>> before = readBenchPoints({options.before});
    const Result<std::vector<BenchPoint>> now = readBenchPoints({options.now});
    report(before.diagnostics(), false);
    report(now.diagnostics(), false);
    if (!before || !now) return kExitBadInput;
    const BenchComparison comparison = compareBenches(*before, *now, options.limits);
    if (comparison.compared == 0 && comparison.failed.empty()) {
        Diagnostic error{Code::results_broken,
                         "no point is in both '" + options.before + "' and '" + options.now + "'"};
        error.help = "give 'crevice bench' the configs, scenes, sizes and radii of the older run";
        return report({error}, false);
    }
    return printComparison(comparison);
}

}  // namespace

void addCompareBenchCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("compare-bench", "Fail (5) where a bench is worse than an older one");
    auto options = std::make_shared<CompareBenchOptions>();
    command->add_option("OLD", options->before, "Results of the older bench")->required();
    command->add_option("NEW", options->now, "Results of the fresh one")->required();
    command->add_option("--max-error", options->limits.error,
                        "How much more error counts as the same")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    command->add_option("--max-ratio", options->limits.ratio,
                        "How much more of a cost ratio does: 0.15 is 15 %")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    command->footer("Absolute times are never compared.\nExample:\n"
                    "  crevice compare-bench docs/bench/results.jsonl fresh/results.jsonl");
    command->callback([options, &exit_code] { exit_code = compareBenchFiles(*options); });
}

}  // namespace crevice
