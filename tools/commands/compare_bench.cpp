// SPDX-License-Identifier: MIT
// crevice compare-bench: what has changed since an older bench.
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/bench/compare.h"

#include "core/base/numbers.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace crevice {
namespace {

struct CompareBenchOptions {
    std::string before;
    std::string now;
    std::optional<double> max_error;
    BenchLimits limits;
};

void printChanges(const char* title, const std::vector<BenchChange>& changes)
{
    for (const BenchChange& change : changes)
        print("%s: %s: %s was %s and is %s (up to %s is the same)\n", title, change.sample.c_str(),
              change.figure.c_str(), significant(change.before, 7).c_str(),
              significant(change.now, 7).c_str(), significant(change.limit, 7).c_str());
}

int printComparison(const BenchComparison& comparison)
{
    printChanges("better", comparison.better);
    printChanges("better, which may be a fault", comparison.better_errors);
    printChanges("worse", comparison.worse);
    for (const std::string& sample : comparison.missing) print("missing now: %s\n", sample.c_str());
    for (const std::string& failure : comparison.failed) print("fails now: %s\n", failure.c_str());
    if (comparison.without_ratios > 0)
        print(
            "%d of %d bench samples were measured on another device or by another clock: cost "
            "ratios not compared\n",
            comparison.without_ratios, comparison.compared);
    print("%d bench samples compared: %zu figures worse, %zu better; %zu fail, %zu missing\n",
          comparison.compared, comparison.worse.size(),
          comparison.better.size() + comparison.better_errors.size(), comparison.failed.size(),
          comparison.missing.size());
    return comparison.differs() ? kExitDiffers : kExitOk;
}

int compareBenchFiles(const CompareBenchOptions& options)
{
    const Result<std::vector<BenchSample>> before = readBenchSamples({options.before});
    const Result<std::vector<BenchSample>> now = readBenchSamples({options.now});
    report(before.diagnostics(), false);
    report(now.diagnostics(), false);
    if (!before || !now) return kExitBadInput;
    BenchLimits limits = options.limits;
    if (options.max_error) limits.error = limits.other_error = *options.max_error;
    const BenchComparison comparison = compareBenches(*before, *now, limits);
    if (comparison.compared == 0 && comparison.failed.empty()) {
        Diagnostic error{Code::results_broken, "no bench sample is in both '" + options.before +
                                                   "' and '" + options.now + "'"};
        error.help = "give 'crevice bench' the configs, scenes, sizes and radii of the older run";
        return report({error}, false);
    }
    return printComparison(comparison);
}

}  // namespace

void addCompareBenchCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand(
        "compare-bench",
        "Fail (5) where a bench has other errors than an older one, or costs more");
    auto options = std::make_shared<CompareBenchOptions>();
    command->add_option("OLD", options->before, "Folder or results file of the older bench")
        ->required();
    command->add_option("NEW", options->now, "Folder or results file of the new bench")->required();
    command
        ->add_option("--max-error", options->max_error,
                     "Largest change of an error that counts as equal. Default: 1e-6, or 1e-4 if "
                     "the device, its driver or crevice's version differs")
        ->check(CLI::NonNegativeNumber);
    command
        ->add_option("--max-ratio", options->limits.ratio,
                     "Largest relative increase of a cost ratio that counts as equal: 0.15 is 15 %")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    command->add_flag("--errors-only", options->limits.errors_only,
                      "Compare errors, but no cost ratios");
    command->footer(
        "Absolute times are never compared. A bench sample that fails or is missing is worse.\n"
        "Example:\n"
        "  crevice compare-bench docs/bench fresh");
    command->callback([options, &exit_code] { exit_code = compareBenchFiles(*options); });
}

}  // namespace crevice
