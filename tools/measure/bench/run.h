// SPDX-License-Identifier: MIT
// A bench at work: its samples measured one after the other into a file.
//
// What the file has under a sample's key is not measured again. How a sample is measured is the
// caller's; no GL is needed here.
#pragma once

#include "tools/measure/bench/bench.h"
#include "tools/measure/line_file.h"

#include <set>

namespace crevice {

/// The results file of a bench, with the keys of what it has figures of.
struct BenchFile {
    LineFile lines;
    std::set<std::string> done;
};

/// FOLDER/results.jsonl. Errors: those of LineFile and readBenchSamples.
Result<BenchFile> openBench(const std::string& folder);

/// The world around a run; tests put in their own.
struct MeasureWorld {
    std::string device;  ///< Its name.
    /// CV7007 ends the run, any other error becomes the sample's failure; a warning is said once.
    std::function<Result<BenchSample>(const BenchTask& task)> measure;
    std::function<double()> seconds;    ///< A clock.
    std::function<bool()> interrupted;  ///< A sample that was under way is then dropped.
    std::function<void(const std::string& title)> begin;  ///< A sample.
    std::function<void(const std::string& line)> say;
    double time_budget_s = 0;  ///< No sample is begun after it; 0: no limit.
};

struct MeasureSummary {
    int measured = 0;
    int kept = 0;                       ///< The file had figures of them.
    std::vector<std::string> failures;  ///< Title and reason.
    std::vector<std::string> missing;   ///< Titles of samples that nobody began.
    bool interrupted = false;
    Status written;
};

/// Measures every sample of the plan that the file has no figures of, and adds its line, or that of
/// its failure, to the file.
MeasureSummary measureAll(const BenchPlan& plan, BenchFile& file, const MeasureWorld& world);

/// The key of a sample on a device.
std::string keyOnDevice(const std::string& key, const std::string& device);

}  // namespace crevice
