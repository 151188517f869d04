// SPDX-License-Identifier: MIT
// The loop over a bench's points, and the file that they go to.
#include "tools/bench/bench.h"

#include "tools/cli/output.h"

#include "core/base/numbers.h"

#include <cmath>
#include <utility>

namespace crevice {
namespace {

std::string timeText(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string((whole + 59) / 60) + " min";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

class Loop {
public:
    Loop(const std::vector<BenchTask>& tasks, ResultFile& file, const BenchWorld& world)
        : file_(file), world_(world), start_(world.seconds())
    {
        for (const BenchTask& task : tasks) {
            if (file.has(keyOnDevice(task.point.key, world.device))) ++summary_.kept;
            else todo_.push_back(&task);
        }
    }

    BenchSummary run()
    {
        std::size_t next = 0;
        while (next < todo_.size() && !mustStop() && measureOne(*todo_[next], next)) ++next;
        for (; next < todo_.size(); ++next)
            summary_.missing.push_back(pointTitle(todo_[next]->point));
        return std::move(summary_);
    }

private:
    double elapsed() const { return world_.seconds() - start_; }

    bool mustStop()
    {
        summary_.interrupted = world_.interrupted();
        const bool spent = world_.time_budget_s > 0 && elapsed() >= world_.time_budget_s;
        return summary_.interrupted || spent;
    }

    /// False when the run must end before this point has a line.
    bool measureOne(const BenchTask& task, std::size_t index)
    {
        BenchPoint point = task.point;
        if (point.failure.empty()) {
            Result<BenchPoint> measured = world_.measure(task);
            summary_.interrupted = world_.interrupted();
            if (summary_.interrupted) return false;
            if (!measured && firstError(measured.diagnostics()).code == Code::cannot_write) {
                Diagnostic error = firstError(measured.diagnostics());
                error.help = LineFile::wayOut();
                summary_.written = error;
                return false;
            }
            warn(measured.diagnostics());
            if (measured) point = std::move(*measured);
            else point.failure = failureText(measured.diagnostics());
        }
        point.key = keyOnDevice(task.point.key, world_.device);
        point.device = world_.device;  // a failure's too, so that figures can take its place
        summary_.written = file_.append(point);
        if (!summary_.written) return false;
        if (point.failure.empty()) ++summary_.measured;
        else summary_.failures.push_back(pointTitle(point) + ": " + point.failure);
        tell(point, index + 1);
        return true;
    }

    /// Once each.
    void warn(const Diagnostics& diagnostics)
    {
        for (const Diagnostic& each : diagnostics) {
            if (each.severity != Severity::warning) continue;
            std::string text = toText(each);
            text.pop_back();  // say() ends the line
            if (warnings_.insert(text).second) world_.say(text);
        }
    }

    void tell(const BenchPoint& point, std::size_t done) const
    {
        std::string line = "[" + std::to_string(done) + "/" + std::to_string(todo_.size()) + "] " +
                           pointTitle(point) + ": ";
        if (point.failure.empty()) {
            line += "rmse " + fixed(point.error.rmse, 4) + ", " + fixed(point.total.median, 2) +
                    " ms, " + fixed(point.ratio_floor, 2) + " x floor";
        } else {
            line += "failed: " + point.failure;
        }
        const std::size_t left = todo_.size() - done;
        if (left > 0)
            line += "; about " +
                    timeText(elapsed() / static_cast<double>(done) * static_cast<double>(left)) +
                    " left";
        world_.say(line);
    }

    ResultFile& file_;
    const BenchWorld& world_;
    const double start_;
    std::vector<const BenchTask*> todo_;
    std::set<std::string> warnings_;
    BenchSummary summary_;
};

}  // namespace

Result<ResultFile> ResultFile::open(const std::string& folder)
{
    Result<LineFile> lines = LineFile::open(folder + "/results.jsonl");
    if (!lines) return lines.diagnostics();
    const Result<BenchResults> known = readBenchResults({lines->path()});
    if (!known) return known.diagnostics();
    ResultFile results(std::move(*lines));
    for (const BenchPoint& point : known->points)
        if (point.failure.empty()) results.done_.insert(point.key);
    for (const PlannedBench& planned : known->planned) results.plans_.insert(toJsonLine(planned));
    return results;
}

Status ResultFile::plan(const PlannedBench& planned)
{
    const std::string line = toJsonLine(planned);
    return plans_.insert(line).second ? lines_.append(line) : Status();
}

Status ResultFile::append(const BenchPoint& point)
{
    Status written = lines_.append(toJsonLine(point));
    if (written && point.failure.empty()) done_.insert(point.key);
    return written;
}

BenchSummary runBench(const std::vector<BenchTask>& tasks, ResultFile& file,
                      const BenchWorld& world)
{
    return Loop(tasks, file, world).run();
}

}  // namespace crevice
