// SPDX-License-Identifier: MIT
// A bench for the engine of tools/measure: its file, its lines, its words.
#include "tools/measure/bench/bench.h"

#include "core/base/numbers.h"

#include <utility>

namespace crevice {
namespace {

std::string figuresText(const BenchSample& sample)
{
    const std::string text = "rmse " + fixed(sample.error.rmse, 4) + ", " +
                             fixed(sample.total.median, 2) + " ms, " + fixed(sample.ratio_copy, 2) +
                             " x copy";
    return sample.motion_failure.empty() ? text : text + ", no motion: " + sample.motion_failure;
}

}  // namespace

Result<BenchFile> openBench(const std::string& folder)
{
    Result<LineFile> lines = LineFile::open(folder + "/results.jsonl");
    if (!lines) return lines.diagnostics();
    const Result<std::vector<BenchSample>> known = readBenchSamples({lines->path()});
    if (!known) return known.diagnostics();
    BenchFile file{std::move(*lines), {}};
    for (const BenchSample& sample : *known)
        if (sample.failure.empty()) file.done.insert(sample.key);
    return file;
}

MeasureJob benchJob(const BenchPlan& plan, const std::string& device, std::set<std::string> done,
                    std::function<Result<BenchSample>(const BenchTask&)> measure)
{
    MeasureJob job;
    job.done = std::move(done);
    for (const BenchTask& task : plan.tasks)
        job.tasks.push_back(
            {keyOnDevice(task.sample.key, device), sampleTitle(task.sample), task.sample.failure});
    const auto lineOf = [&plan, device](BenchSample sample, std::size_t task) {
        sample.key = keyOnDevice(plan.tasks[task].sample.key, device);
        sample.device = device;
        return toJsonLine(sample);
    };
    job.measure = [&plan, lineOf,
                   measure = std::move(measure)](std::size_t task) -> Result<Measured> {
        const Result<BenchSample> sample = measure(plan.tasks[task]);
        if (!sample) return sample.diagnostics();
        return {Measured{lineOf(*sample, task), figuresText(*sample)}, sample.diagnostics()};
    };
    job.failure_line = [&plan, lineOf](std::size_t task, const std::string& failure) {
        BenchSample sample =
            plan.tasks[task].sample;  // with its device, so that figures can take its place
        sample.failure = failure;
        return lineOf(std::move(sample), task);
    };
    return job;
}

}  // namespace crevice
