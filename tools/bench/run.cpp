// SPDX-License-Identifier: MIT
// A bench for the engine of tools/measure: its file, its lines, its words.
#include "tools/bench/bench.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <utility>

namespace crevice {
namespace {

std::string figuresText(const BenchPoint& point)
{
    return "rmse " + fixed(point.error.rmse, 4) + ", " + fixed(point.total.median, 2) + " ms, " +
           fixed(point.ratio_copy, 2) + " x floor";
}

}  // namespace

Result<BenchFile> openBench(const std::string& folder, const PlannedBench& planned)
{
    Result<LineFile> lines = LineFile::open(folder + "/results.jsonl");
    if (!lines) return lines.diagnostics();
    const Result<BenchResults> known = readBenchResults({lines->path()});
    if (!known) return known.diagnostics();
    BenchFile file{std::move(*lines), {}};
    for (const BenchPoint& point : known->points)
        if (point.failure.empty()) file.done.insert(point.key);
    const std::string line = toJsonLine(planned);
    const auto same = [&line](const PlannedBench& each) { return toJsonLine(each) == line; };
    if (std::any_of(known->planned.begin(), known->planned.end(), same)) return file;
    if (const Status written = file.lines.append(line); !written) return written.diagnostics();
    return file;
}

MeasureJob benchJob(const BenchPlan& plan, const std::string& device, std::set<std::string> done,
                    std::function<Result<BenchPoint>(const BenchTask&)> measure)
{
    MeasureJob job;
    job.done = std::move(done);
    for (const BenchTask& task : plan.tasks)
        job.tasks.push_back(
            {keyOnDevice(task.point.key, device), pointTitle(task.point), task.point.failure});
    const auto lineOf = [&plan, device](BenchPoint point, std::size_t task) {
        point.key = keyOnDevice(plan.tasks[task].point.key, device);
        point.device = device;
        return toJsonLine(point);
    };
    job.measure = [&plan, lineOf,
                   measure = std::move(measure)](std::size_t task) -> Result<Measured> {
        const Result<BenchPoint> point = measure(plan.tasks[task]);
        if (!point) return point.diagnostics();
        return {Measured{lineOf(*point, task), figuresText(*point)}, point.diagnostics()};
    };
    job.failure_line = [&plan, lineOf](std::size_t task, const std::string& failure) {
        BenchPoint point =
            plan.tasks[task].point;  // with its device, so that figures can take its place
        point.failure = failure;
        return lineOf(std::move(point), task);
    };
    return job;
}

}  // namespace crevice
