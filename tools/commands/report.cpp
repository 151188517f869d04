// SPDX-License-Identifier: MIT
// crevice report: bench results as a page, and the figures beside it; or what has changed since an
// older bench.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/bench/choice.h"
#include "tools/render/image/image_file.h"
#include "tools/show/report/bench_report.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

struct ReportOptions {
    std::vector<std::string> results;
    std::string out = "report.html";
    bool no_pictures = false;
    std::string against;
    bool errors_only = false;
};

int makeReport(const ReportOptions& options)
{
    std::filesystem::path path = options.out;
    if (path.extension() != ".html")
        return report({{Code::usage, "--out '" + options.out + "' does not end in .html",
                        "a .csv of the same name is written beside it"}},
                      false);
    const Status writable = checkWritable(options.out);
    if (!writable) return report(writable.diagnostics(), false);
    const Result<std::vector<BenchSample>> samples = readBenchSamples(options.results);
    report(samples.diagnostics(), false);
    if (!samples) return exitCodeOf(samples.diagnostics());
    const Result<std::string> page = reportHtml(*samples, !options.no_pictures);
    report(page.diagnostics(), false);
    Status written = writeFile(path.string(), *page);
    if (written) written = writeFile(path.replace_extension(".csv").string(), reportCsv(*samples));
    if (!written) return report(written.diagnostics(), false);
    print("wrote %s (%zu bench samples, %s MB), and a .csv beside it\n",
          printableLine(options.out).c_str(), samples->size(),
          fixed(static_cast<double>(page->size()) / 1e6, 1).c_str());
    return kExitOk;
}

void printChange(const BenchChange& change)
{
    const char* const words[] = {"better", "better, which may be a fault", "worse", "fails now",
                                 "missing now"};
    std::string line = words[static_cast<int>(change.kind)] + (": " + change.sample);
    if (!change.figure.empty()) line += ": " + change.figure;
    if (change.kind <= BenchChange::Kind::worse)
        line += " was " + significant(change.before, 7) + " and is " + significant(change.now, 7);
    print("%s\n", line.c_str());
}

int compareBench(const ReportOptions& options)
{
    const Result<std::vector<BenchSample>> before = readBenchSamples({options.against});
    const Result<std::vector<BenchSample>> now = readBenchSamples(options.results);
    report(before.diagnostics(), false);
    report(now.diagnostics(), false);
    if (!before || !now) return kExitBadInput;
    const BenchComparison comparison = compareBenches(*before, *now, options.errors_only);
    for (const BenchChange& change : comparison.changes) printChange(change);
    if (comparison.without_ratios > 0)
        print("%d were measured on another device or by another clock: cost ratios not compared\n",
              comparison.without_ratios);
    print("%d bench samples compared\n", comparison.compared);
    return comparison.differs() ? kExitDiffers : kExitOk;
}

}  // namespace

void addReportCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("report", "Show bench results in one HTML file");
    auto options = std::make_shared<ReportOptions>();
    command
        ->add_option("RESULTS", options->results,
                     "Folders of 'crevice bench', or the results files in them")
        ->required();
    command->add_option("--out", options->out, "HTML file to write. Default: report.html")
        ->type_name("FILE.html");
    command->add_flag("--no-pictures", options->no_pictures, "Write a page without pictures");
    CLI::Option* against =
        addText(*command, "--against", options->against, "FOLDER",
                "Write no page, but print what has changed since an older bench: exit "
                "code 5 where an error is another, a cost ratio is larger by 15 %, or a "
                "bench sample fails or is missing");
    command->add_flag("--errors-only", options->errors_only, "Compare no cost ratios")
        ->needs(against);
    command->footer(
        "Examples:\n"
        "  crevice report bench other/results.jsonl --out report.html --no-pictures\n"
        "  crevice report fresh --against docs/bench");
    command->callback([options, &exit_code] {
        exit_code = options->against.empty() ? makeReport(*options) : compareBench(*options);
    });
}

}  // namespace crevice
