// SPDX-License-Identifier: MIT
// crevice test: the cells of a matrix, each held against its checks.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/matrix/run.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_file.h"
#include "tools/show/report/matrix_report.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>

namespace crevice {
namespace {

struct TestOptions {
    std::string file;
    MatrixOptions matrix;
    RunMatrixOptions run;
    CacheOptions cache;
    std::string shard;  ///< "I/N".
    bool list = false;
    bool json = false;
};

/// Reads "2/4". Errors: CV8001.
Status readShard(const std::string& text, MatrixOptions& options)
{
    if (text.empty()) return {};
    const std::size_t slash = text.find('/');
    const auto part = parseNumber(text.substr(0, slash));
    const auto parts = slash == text.npos ? std::nullopt : parseNumber(text.substr(slash + 1));
    const auto whole = [](double number) { return number == std::floor(number); };
    if (!part || !parts || !(*part >= 1 && *part <= *parts && *parts <= 1e6) || !whole(*part) ||
        !whole(*parts))
        return Diagnostic{Code::usage, "--shard '" + text + "' is not a part of parts",
                          "write --shard 1/4 for the first of four"};
    options.shard = static_cast<std::size_t>(*part);
    options.shards = static_cast<std::size_t>(*parts);
    return {};
}

Status writeAll(const MatrixResults& results, const std::string& folder)
{
    const std::pair<const char*, std::string> files[] = {
        {"results.json",
         resultsJson(results).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"},
        {"results.tap", tapText(results)},
        {"junit.xml", junitXml(results)},
        {"index.html", matrixHtml(results)}};
    for (const auto& [name, text] : files)
        if (const Status written = writeFile(folder + "/" + name, text); !written) return written;
    return {};
}

void printResults(const MatrixResults& results)
{
    for (const CellResult& cell : results.cells)
        for (const CheckResult& check : cell.checks)
            if (check.state != "passed" && check.state != "unchanged")
                print("%s: %s: %s: %s\n", check.state.c_str(),
                      printableLine(results.matrix.cells[cell.cell].name).c_str(),
                      printableLine(check.title).c_str(), printableLine(check.text).c_str());
}

std::string summaryOf(const MatrixResults& results)
{
    std::vector<std::string> counts;
    for (const char* state : {"passed", "failed", "skipped", "new", "changed", "unchanged"})
        if (const int count = results.count(state))
            counts.push_back(std::to_string(count) + " " + state);
    return std::to_string(results.cells.size()) +
           " cells; checks: " + (counts.empty() ? "none" : joined(counts));
}

int exitCodeOf(const MatrixResults& results, const MatrixRun& run)
{
    if (run.interrupted) return kExitInterrupted;
    if (results.count("failed") > 0) return kExitDiffers;
    const bool all_skipped = allOf(results.cells, [](const CellResult& cell) {
        return allOf(cell.checks,
                     [](const CheckResult& check) { return check.state == "skipped"; });
    });
    return all_skipped && !results.cells.empty() ? kExitMachine : kExitOk;
}

int runTests(TestOptions& options, const Matrix& matrix, const MatrixPlan& plan)
{
    const std::string& folder = options.run.check.out_folder;
    std::error_code ignored;  // the first file reports it
    if (options.run.check.approve)
        std::filesystem::create_directories(matrix.approved_folder, ignored);
    catchInterrupts();
    Progress progress;
    std::size_t begun = 0;
    options.run.begin = [&](const std::string& what) {
        progress.begin("[" + std::to_string(++begun) + "] " + what);
    };
    Result<MatrixRun> run = runMatrix(plan, options.run);
    progress.wipe();
    if (!run) return report(run.diagnostics(), options.json);
    const MatrixResults results{matrix, std::move(run->cells)};
    if (const Status written = writeAll(results, folder); !written)
        return report(written.diagnostics(), options.json);
    if (options.json) {
        printAsJson(resultsJson(results));
    } else {
        printResults(results);
        print("%s%s; see %s/index.html\n", summaryOf(results).c_str(),
              run->kept ? (", " + std::to_string(run->kept) + " cells known already").c_str() : "",
              printableLine(folder).c_str());
    }
    if (run->interrupted)
        printMessage(
            "interrupted: %zu cells are missing; run the same command with --resume to go on\n",
            plan.cells.size() - results.cells.size());
    return exitCodeOf(results, *run);
}

int test(TestOptions& options)
{
    if (const Status shard = readShard(options.shard, options.matrix); !shard)
        return report(shard.diagnostics(), options.json);
    const CheckoutSources sources(options.matrix.checkout, options.matrix.roots);
    const Result<Matrix> matrix = readMatrix(options.file, sources);
    if (!matrix) return report(matrix.diagnostics(), options.json);
    const Result<MatrixPlan> plan = planMatrix(*matrix, options.matrix, sources);
    if (!plan) return report(plan.diagnostics(), options.json);
    report(plan->warnings, false);
    report(unusedApproved(*matrix), false);
    if (options.list) {
        for (const std::size_t cell : plan->cells)
            print("%s\n", printableLine(matrix->cells[cell].name).c_str());
        return kExitOk;
    }
    options.run.check.cache_folder = options.cache.path();
    return runTests(options, *matrix, *plan);
}

}  // namespace

void addTestCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand(
        "test", "Draw configs by a matrix of scenes, params, sizes and backends, and check each");
    auto options = std::make_shared<TestOptions>();
    options->matrix.version = options->run.version = CREVICE_VERSION;
    CheckOptions& check = options->run.check;
    check.out_folder = "crevice_test";
    command->add_option("MATRIX", options->file, "A matrix file")
        ->type_name("FILE.json")
        ->required();
    addText(*command, "--out", check.out_folder, "FOLDER",
            "Folder for index.html, junit.xml, results.tap, results.json and pictures");
    addText(*command, "--filter", options->matrix.filter, "TEXT",
            "Only cells whose name contains this");
    addText(*command, "--shard", options->shard, "I/N", "Only the I-th of N parts of the cells");
    command->add_option("--jobs", options->run.jobs, "Processes that draw side by side")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    CLI::Option* resume = command->add_flag(
        "--resume", options->run.resume,
        "Do not draw again what passed before in the same --out, unless something of it changed");
    command
        ->add_flag("--approve", check.approve,
                   "Write the approved files that are missing or that their check fails; check "
                   "nothing else")
        ->excludes(resume);
    command->add_flag("--require-backends", check.require_backends,
                      "Fail cells whose backend this machine lacks, instead of skipping them");
    addCacheOptions(*command, options->cache);
    addCheckoutOption(*command, options->matrix.checkout);
    addRootOption(*command, options->matrix.roots);
    command->add_flag("--list", options->list, "Print the names of the cells and stop");
    command->add_flag("--json", options->json, "Print the results as JSON");
    command->footer(
        "Exit code 5 where a check fails.\n"
        "Examples:\n"
        "  crevice test matrix.json --approve\n"
        "  crevice test matrix.json --jobs 4 --require-backends --out results");
    command->callback([options, &exit_code] { exit_code = test(*options); });
}

}  // namespace crevice
