// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/run.h"

#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/line_file.h"

#include <nlohmann/json.hpp>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

constexpr useconds_t kLookAgain_us = 20000;  // at processes, and for an interrupt

/// What times, or all else, of a cell.
struct Part {
    std::size_t cell;
    bool times;

    bool operator<(const Part& other) const
    {
        return std::pair(times, cell) < std::pair(other.times, other.cell);
    }
};

/// Results go through the file of lines alone, whichever process they are from.
class MatrixRunner {
public:
    MatrixRunner(const MatrixPlan& plan, const RunMatrixOptions& options, LineFile& lines)
        : plan_(plan),
          options_(options),
          lines_(lines),
          check_(cellChecker(plan, options))
    {
        for (const std::size_t cell : plan.cells)
            for (const std::size_t check : plan.matrix.cells[cell].checks)
                parts_[{cell, plan.matrix.checks[check].kind == CheckKind::time}] = {};
        for (auto& [part, result] : parts_)
            result = {part.cell, keyOf(plan, plan.matrix.cells[part.cell],
                                       options.version + (part.times ? " times" : "") +
                                           (options.approve ? " approve" : ""))};
    }

    Result<MatrixResults> run()
    {
        MatrixResults results{plan_.matrix};
        if (options_.resume) recall(true);
        std::vector<std::size_t> drawn, timed, open;
        for (const auto& [part, result] : parts_)
            if (result.checks.empty()) (part.times ? timed : drawn).push_back(part.cell);
        std::set_union(drawn.begin(), drawn.end(), timed.begin(), timed.end(),
                       std::back_inserter(open));
        results.kept = plan_.cells.size() - open.size();
        std::string crash;
        Status done = options_.jobs > 1 && drawn.size() > 1 ? drawSideBySide(drawn, crash)
                                                            : work(drawn, false);
        if (done) done = work(timed, true);
        if (!done) return done.diagnostics();
        recall(false);
        results.interrupted = interrupted();
        for (const std::size_t cell : plan_.cells) collect(cell, crash, results);
        return results;
    }

private:
    /// Reads the lines: those of earlier runs of which all passed, or those of this one.
    void recall(bool earlier)
    {
        std::map<std::string, CellResult*> open;
        for (auto& [part, result] : parts_)
            if (result.checks.empty()) open[result.key] = &result;
        std::size_t line = 0;
        readLines(lines_.path(), {"result of a cell", "crevice test"}, [&](nlohmann::json&& json) {
            if (++line <= lines_before_) return;
            CellResult result = cellResultFrom(json);
            const auto found = open.find(result.key);
            if (found == open.end()) return;
            const bool bad = anyOf(result.checks, [](const CheckResult& check) {
                return check.state == "failed" || check.state == "skipped";
            });
            found->second->checks.clear();
            if (!earlier || !bad) found->second->checks = std::move(result.checks);
        });
        lines_before_ = line;
    }

    /// Here, one after the other. Errors: CV7007.
    Status work(const std::vector<std::size_t>& cells, bool times, bool tell = true)
    {
        for (const std::size_t cell : cells) {
            if (interrupted()) break;
            if (tell) options_.begin(plan_.matrix.cells[cell].name);
            const auto checks = check_(cell, times);
            if (!checks) return checks.diagnostics();
            if (times && interrupted()) break;  // too few turns
            const CellResult result{cell, parts_.at({cell, times}).key, *checks};
            if (const Status kept = lines_.append(jsonLine(toJson(result))); !kept) return kept;
        }
        return {};
    }

    /// In copies of this process; `crash` says how one ended that did not do so by itself.
    Status drawSideBySide(const std::vector<std::size_t>& cells, std::string& crash)
    {
        const std::size_t jobs = std::min<std::size_t>(options_.jobs, cells.size());
        options_.begin(std::to_string(cells.size()) + " cells by " + std::to_string(jobs) +
                       " processes");
        std::vector<pid_t> processes;
        for (std::size_t job = 1; job <= jobs; ++job) {
            const pid_t process = fork();
            if (process == 0) {
                const Status done = work(shardOf(cells, job, jobs), false, false);
                _exit(report(done.diagnostics(), false));
            }
            if (process < 0) crash = std::string("no process can be started: ") + strerror(errno);
            if (process > 0) processes.push_back(process);
        }
        Status all;
        bool told = false;
        for (const pid_t process : processes) {
            int status = 0;
            while (waitpid(process, &status, WNOHANG) == 0) {
                if (interrupted() && !std::exchange(told, true))
                    for (const pid_t each : processes) kill(each, SIGTERM);
                usleep(kLookAgain_us);
            }
            if (WIFSIGNALED(status))
                crash = "a process was ended by signal " + std::to_string(WTERMSIG(status));
            else if (WEXITSTATUS(status) != 0)
                all = Diagnostic{Code::cannot_write, "a process could not write its results",
                                 "it said why; make room or name another --out"};
        }
        return all;
    }

    /// Both parts of a cell; what a crash left out fails.
    void collect(std::size_t cell, const std::string& crash, MatrixResults& results)
    {
        CellResult all{cell, {}};
        for (const bool times : {false, true}) {
            const auto part = parts_.find({cell, times});
            if (part == parts_.end()) continue;
            const std::vector<CheckResult>& checks = part->second.checks;
            all.checks.insert(all.checks.end(), checks.begin(), checks.end());
            if (!checks.empty() || options_.approve) continue;
            if (results.interrupted) return;
            for (const std::size_t i : plan_.matrix.cells[cell].checks)
                if ((plan_.matrix.checks[i].kind == CheckKind::time) == times)
                    all.checks.push_back({i, plan_.matrix.checks[i].title, "failed", crash});
        }
        std::sort(all.checks.begin(), all.checks.end(),
                  [](const CheckResult& a, const CheckResult& b) { return a.check < b.check; });
        if (!all.checks.empty()) results.cells.push_back(std::move(all));
    }

    const MatrixPlan& plan_;
    const RunMatrixOptions& options_;
    LineFile& lines_;
    const CheckCell check_;
    std::map<Part, CellResult> parts_;
    std::size_t lines_before_ = 0;
};

}  // namespace

Result<MatrixResults> runMatrix(const MatrixPlan& plan, const RunMatrixOptions& options)
{
    const std::string& folder = options.out_folder;
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
