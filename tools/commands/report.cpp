// SPDX-License-Identifier: MIT
// crevice report: bench results as a page, and the figures beside it.
#include "tools/commands/cli/output.h"
#include "tools/commands/cli/output_request.h"
#include "tools/commands/commands.h"
#include "tools/render/image/image_file.h"
#include "tools/show/report/bench_report.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace crevice {
namespace {

struct ReportOptions {
    std::vector<std::string> results;
    std::string out = "report.html";
    bool no_pictures = false;
};

Status writeReport(const ReportOptions& options, const std::vector<BenchSample>& samples,
                   const BenchCoverage& coverage, const std::string& page)
{
    std::filesystem::path path = options.out;
    Status written = writeFile(path.string(), page);
    if (written) written = writeFile(path.replace_extension(".csv").string(), reportCsv(samples));
    if (written)
        written =
            writeFile(path.replace_extension(".json").string(), reportJson(samples, coverage));
    return written;
}

int makeReport(const ReportOptions& options)
{
    if (std::filesystem::path(options.out).extension() != ".html") {
        Diagnostic error{Code::usage, "--out '" + options.out + "' does not end in .html"};
        error.help = "a .csv and a .json of the same name are written beside it";
        return report({error}, false);
    }
    const Status writable = checkWritable(options.out);
    if (!writable) return report(writable.diagnostics(), false);
    const Result<BenchResults> results = readBenchResults(options.results);
    report(results.diagnostics(), false);
    if (!results) return exitCodeOf(results.diagnostics());
    const std::vector<BenchSample>& samples = results->samples;
    const BenchCoverage coverage = coverageOf(*results);
    const Result<std::string> page = reportHtml(samples, !options.no_pictures, coverage);
    report(page.diagnostics(), false);
    const Status written = writeReport(options, samples, coverage, *page);
    if (!written) return report(written.diagnostics(), false);
    print("wrote %s (%zu bench samples, %s MB), and a .csv and a .json beside it\n",
          printableLine(options.out).c_str(), samples.size(),
          fixed(static_cast<double>(page->size()) / 1e6, 1).c_str());
    if (!coverage.whole()) print("%s\n", coverageText(coverage).c_str());
    return kExitOk;
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
    command->footer(
        "Examples:\n"
        "  crevice report results.jsonl --out report.html\n"
        "  crevice report shards/*.jsonl --out report.html --no-pictures");
    command->callback([options, &exit_code] { exit_code = makeReport(*options); });
}

}  // namespace crevice
