// SPDX-License-Identifier: MIT
// The loop over tasks.
#include "tools/measure/run.h"

#include "core/base/content_hash.h"

#include <algorithm>
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

class Run {
public:
    Run(const MeasureJob& job, LineFile& file, const MeasureWorld& world)
        : job_(job),
          file_(file),
          world_(world),
          start_(world.seconds())
    {
        for (std::size_t task = 0; task < job.tasks.size(); ++task) {
            if (job.done.count(job.tasks[task].key) > 0)
                ++summary_.kept;
            else
                todo_.push_back(task);
        }
    }

    MeasureSummary run()
    {
        std::size_t next = 0;
        while (next < todo_.size() && !mustStop() && measureOne(next)) ++next;
        for (; next < todo_.size(); ++next)
            summary_.missing.push_back(job_.tasks[todo_[next]].title);
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

    /// False when the run must end before this task has its lines.
    bool measureOne(std::size_t place)
    {
        const MeasureTask& task = job_.tasks[todo_[place]];
        if (!task.failure.empty()) return fail(place, task.failure);
        world_.begin(task.title);
        const Result<Measured> measured = job_.measure(todo_[place]);
        summary_.interrupted = world_.interrupted();
        if (summary_.interrupted) return false;
        warn(measured.diagnostics());
        if (measured) {
            if (!write(measured->lines)) return false;
            ++summary_.measured;
            printProgress(place, measured->outcome);
            return true;
        }
        Diagnostic error = firstError(measured.diagnostics());
        if (error.code != Code::cannot_write) return fail(place, failureText({error}));
        error.help = LineFile::wayOut();
        summary_.written = error;
        return false;
    }

    bool fail(std::size_t place, const std::string& failure)
    {
        if (job_.failure_line && !write(job_.failure_line(todo_[place], failure))) return false;
        summary_.failures.push_back(job_.tasks[todo_[place]].title + ": " + failure);
        printProgress(place, "failed: " + failure);
        return true;
    }

    bool write(const std::string& lines)
    {
        if (!lines.empty()) summary_.written = file_.append(lines);
        return summary_.written.ok();
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

    void printProgress(std::size_t place, const std::string& outcome) const
    {
        const std::size_t done = place + 1;
        const std::size_t left = todo_.size() - done;
        std::string line = "[" + std::to_string(done) + "/" + std::to_string(todo_.size()) + "] " +
                           job_.tasks[todo_[place]].title + ": " + outcome;
        const double each = elapsed() / static_cast<double>(done);
        if (left > 0) line += "; about " + timeText(each * static_cast<double>(left)) + " left";
        world_.say(line);
    }

    const MeasureJob& job_;
    LineFile& file_;
    const MeasureWorld& world_;
    const double start_;
    std::vector<std::size_t> todo_;
    std::set<std::string> warnings_;
    MeasureSummary summary_;
};

}  // namespace

MeasureSummary measureAll(const MeasureJob& job, LineFile& file, const MeasureWorld& world)
{
    return Run(job, file, world).run();
}

std::string keyOnDevice(const std::string& task_key, const std::string& device)
{
    ContentHash hash;
    hash.addText(task_key);
    hash.addText(device);
    return hash.hex();
}

const Diagnostic& firstError(const Diagnostics& diagnostics)
{
    const auto isError = [](const Diagnostic& each) { return each.severity == Severity::error; };
    return *std::find_if(diagnostics.begin(), diagnostics.end(), isError);
}

std::string failureText(const Diagnostics& diagnostics)
{
    const Diagnostic& error = firstError(diagnostics);
    const std::string place = placeName(error.place);
    return (place.empty() ? "" : place + ": ") + codeName(error.code) + ": " + error.message;
}

}  // namespace crevice
