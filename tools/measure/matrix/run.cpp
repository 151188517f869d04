// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/run.h"

#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/matrix/jobs.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

class MatrixRunner {
public:
    MatrixRunner(const MatrixPlan& plan, const RunMatrixOptions& options, LineFile& lines)
        : plan_(plan),
          options_(options),
          lines_(lines),
          checker_(plan, options.check)
    {
    }

    /// What earlier runs say of cells that are as they were.
    void recall()
    {
        std::map<std::string, CellResult> known;
        readLines(lines_.path(), {"result of a cell", "crevice test"}, [&](nlohmann::json&& line) {
            CellResult result = cellResultFrom(line);
            known[result.key] = std::move(result);
        });
        for (auto& [cell, result] : open_) {
            const auto found = known.find(result.key);
            if (found == known.end() || found->second.is("failed") || found->second.is("skipped"))
                continue;
            result.checks = found->second.checks;
            done_.insert(cell);
        }
        run_.kept = static_cast<int>(done_.size());
    }

    Result<MatrixRun> run()
    {
        for (const std::size_t cell : plan_.cells)
            open_[cell] = {cell, options_.check.approve
                                     ? ""
                                     : keyOf(plan_, plan_.matrix.cells[cell], options_.version)};
        if (options_.resume) recall();
        const std::vector<std::size_t> drawn = cellsWith(false), timed = cellsWith(true);
        drawAll(drawn);
        for (const std::size_t cell : timed) checkHere(cell, true);
        run_.interrupted = interrupted();
        if (!failure_.empty()) return failure_;
        for (auto& [cell, result] : open_)
            if (done_.count(cell) > 0 && !result.checks.empty())
                run_.cells.push_back(std::move(result));
        return std::move(run_);
    }

private:
    /// Those that are not known and have checks that time, or others. A cell without any is done.
    std::vector<std::size_t> cellsWith(bool times) const
    {
        std::vector<std::size_t> found;
        for (const std::size_t cell : plan_.cells)
            if (done_.count(cell) == 0 && has(cell, times)) found.push_back(cell);
        return found;
    }

    bool has(std::size_t cell, bool times) const
    {
        return anyOf(plan_.matrix.cells[cell].checks, [&](std::size_t check) {
            return (plan_.matrix.checks[check].kind == CheckKind::time) == times;
        });
    }

    void drawAll(const std::vector<std::size_t>& cells)
    {
        const int jobs = std::min<int>(options_.jobs, static_cast<int>(cells.size()));
        if (jobs < 2) {
            for (const std::size_t cell : cells) checkHere(cell, false);
            return;
        }
        options_.begin(std::to_string(cells.size()) + " cells by " + std::to_string(jobs) +
                       " processes");
        const auto work = [&](int job, const SendLine& send) {
            CellChecker checker(plan_, options_.check);
            const auto [begin, end] = shardOf(cells.size(), job + 1, jobs);
            for (std::size_t i = begin; i < end && !interrupted(); ++i) {
                const auto checks = checker.check(cells[i], false);
                if (!checks) return send(nlohmann::json(failureText(checks.diagnostics())).dump());
                send(jsonLine(toJson(CellResult{cells[i], {}, *checks})));
            }
        };
        const auto take = [&](const std::string& line) {
            const nlohmann::json json = nlohmann::json::parse(line);
            if (json.is_string()) return fail({Code::cannot_write, json.get<std::string>()});
            CellResult result = cellResultFrom(json);
            add(result.cell, std::move(result.checks), false);
        };
        const std::vector<std::string> ends = runJobs(jobs, work, take);
        if (interrupted() || !failure_.empty() || ends.empty()) return;
        for (const std::size_t cell : cells)
            if (open_[cell].checks.empty()) failAll(cell, ends[0]);
    }

    void failAll(std::size_t cell, const std::string& why)
    {
        std::vector<CheckResult> checks;
        for (const std::size_t check : plan_.matrix.cells[cell].checks)
            if (plan_.matrix.checks[check].kind != CheckKind::time)
                checks.push_back({check, plan_.matrix.checks[check].title(), "failed", why});
        add(cell, std::move(checks), false);
    }

    void checkHere(std::size_t cell, bool times)
    {
        if (interrupted() || !failure_.empty()) return;
        options_.begin(plan_.matrix.cells[cell].name);
        Result<std::vector<CheckResult>> checks = checker_.check(cell, times);
        if (!checks) return fail(firstError(checks.diagnostics()));
        if (times && interrupted()) return;  // too few turns
        add(cell, std::move(*checks), times);
    }

    /// The cell's line is written when nothing of it is missing.
    void add(std::size_t cell, std::vector<CheckResult> checks, bool times)
    {
        std::vector<CheckResult>& all = open_[cell].checks;
        all.insert(all.end(), checks.begin(), checks.end());
        std::sort(all.begin(), all.end(),
                  [](const CheckResult& a, const CheckResult& b) { return a.check < b.check; });
        if (!times && has(cell, true)) return;
        done_.insert(cell);
        const Status written = lines_.append(jsonLine(toJson(open_[cell])));
        if (!written) fail(firstError(written.diagnostics()));
    }

    void fail(const Diagnostic& error) { failure_.push_back(error); }

    const MatrixPlan& plan_;
    const RunMatrixOptions& options_;
    LineFile& lines_;
    CellChecker checker_;
    std::map<std::size_t, CellResult> open_;
    std::set<std::size_t> done_;
    Diagnostics failure_;
    MatrixRun run_;
};

}  // namespace

Result<MatrixRun> runMatrix(const MatrixPlan& plan, const RunMatrixOptions& options)
{
    const std::string& folder = options.check.out_folder;
    Result<LineFile> lines = LineFile::open(folder + "/cells.jsonl");
    if (!lines) return lines.diagnostics();
    std::error_code error;
    if (!options.resume && fs::file_size(lines->path(), error) > 0) {
        fs::resize_file(lines->path(), 0, error);
        fs::remove_all(folder + "/pictures", error);  // of that run
    }
    fs::create_directories(folder + "/pictures", error);
    return MatrixRunner(plan, options, *lines).run();
}

}  // namespace crevice
