// SPDX-License-Identifier: MIT
// crevice test: the cells of a matrix, each held against its checks.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/matrix/run.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_file.h"
#include "tools/show/plan/print.h"
#include "tools/show/report/bench_report.h"

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
    std::string shard = "1/1";
    bool json = false;
};

/// Reads "2/4". Errors: CV8001.
Status readShard(const std::string& text, MatrixOptions& options)
{
    const std::vector<std::string_view> parts = split(text, '/');
    const auto whole = [&](std::size_t i) {
        const auto number = i < parts.size() ? parseNumber(std::string(parts[i])) : std::nullopt;
        return number && *number >= 1 && *number <= 1e6 && *number == std::floor(*number)
                   ? static_cast<std::size_t>(*number)
                   : 0;
    };
    options.shard = whole(0);
    options.shards = whole(1);
    if (options.shard >= 1 && options.shard <= options.shards && parts.size() == 2) return {};
    return Diagnostic{Code::usage, "--shard '" + text + "' is not a part of parts",
                      "write --shard 1/4 for the first of four"};
}

Status writeAll(const MatrixResults& results, const std::string& folder)
{
    const std::pair<const char*, std::string> files[] = {
        {"results.json",
         resultsJson(results).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"},
        {"results.tap", tapText(results)},
        {"junit.xml", junitXml(results)},
        {"index.html", pageOf(matrixPage(), resultsJson(results))}};
    for (const auto& [name, text] : files)
        if (const Status written = writeFile(folder + "/" + name, text); !written) return written;
    return {};
}

void printResults(const MatrixResults& results, const std::string& folder)
{
    for (const CellResult& cell : results.cells)
        for (const CheckResult& check : cell.checks)
            if (check.state != "passed" && check.state != "unchanged")
                print("%s: %s: %s: %s\n", check.state.c_str(),
                      printableLine(results.matrix.cells[cell.cell].name).c_str(),
                      printableLine(check.title).c_str(), printableLine(check.text).c_str());
    print("%s; checks: %s%s; see %s/index.html\n", counted(results.cells.size(), "cell").c_str(),
          countsOf(results).c_str(),
          results.kept ? (", " + counted(results.kept, "cell") + " known already").c_str() : "",
          printableLine(folder).c_str());
}

int exitCodeOf(const MatrixResults& results)
{
    if (results.interrupted) return kExitInterrupted;
    if (results.count("failed") > 0) return kExitDiffers;
    std::size_t checks = 0;
    for (const CellResult& cell : results.cells) checks += cell.checks.size();
    const std::size_t skipped = results.count("skipped");
    return skipped > 0 && skipped == checks ? kExitMachine : kExitOk;
}

int runTests(const TestOptions& options, const MatrixPlan& plan)
{
    std::error_code ignored;  // the first file reports it
    if (options.run.approve)
        std::filesystem::create_directories(plan.matrix.approved_folder, ignored);
    catchInterrupts();
    Progress progress;
    RunMatrixOptions run = options.run;
    run.cache_folder = options.cache.path();
    std::size_t begun = 0;
    run.begin = [&](const std::string& what) {
        progress.begin("[" + std::to_string(++begun) + "] " + what);
    };
    const Result<MatrixResults> results = runMatrix(plan, run);
    progress.wipe();
    if (!results) return report(results.diagnostics(), options.json);
    if (const Status written = writeAll(*results, run.out_folder); !written)
        return report(written.diagnostics(), options.json);
    if (options.json)
        printAsJson(resultsJson(*results));
    else
        printResults(*results, run.out_folder);
    if (results->interrupted)
        printMessage("interrupted: %s missing; run the same command with --resume to go on\n",
                     counted(plan.cells.size() - results->cells.size(), "cell").c_str());
    return exitCodeOf(*results);
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
    return runTests(options, *plan);
}

}  // namespace

void addTestCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand(
        "test", "Draw configs by a matrix of scenes, params, sizes and backends, and check each");
    auto options = std::make_shared<TestOptions>();
    RunMatrixOptions& run = options->run;
    run.version = CREVICE_VERSION;
    run.out_folder = "crevice_test";
    command->add_option("MATRIX", options->file, "A matrix file")
        ->type_name("FILE.json")
        ->required();
    addText(*command, "--out", run.out_folder, "FOLDER",
            "Folder for index.html, junit.xml, results.tap, results.json and pictures");
    addText(*command, "--filter", options->matrix.filter, "TEXT",
            "Only cells whose name contains this");
    addText(*command, "--shard", options->shard, "I/N", "Only the I-th of N parts of the cells");
    command->add_option("--jobs", run.jobs, "Processes that draw side by side")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    CLI::Option* resume = command->add_flag(
        "--resume", run.resume,
        "Do not draw again what passed before in the same --out, unless something of it changed");
    command
        ->add_flag("--approve", run.approve,
                   "Write the approved files that are missing or that their check fails; check "
                   "nothing else")
        ->excludes(resume);
    command->add_flag("--require-backends", run.require_backends,
                      "Fail cells whose backend this machine lacks, instead of skipping them");
    addCacheOptions(*command, options->cache);
    addCheckoutOption(*command, options->matrix.checkout);
    addRootOption(*command, options->matrix.roots);
    command->add_flag("--json", options->json, "Print the results as JSON");
    command->footer(
        "Exit code 5 where a check fails.\n"
        "Examples:\n"
        "  crevice test matrix.json --approve\n"
        "  crevice test matrix.json --jobs 4 --require-backends --out results");
    command->callback([options, &exit_code] { exit_code = test(*options); });
}

}  // namespace crevice
