// SPDX-License-Identifier: MIT
// A bench: which samples are to be measured, how they are measured one after the other into a file,
// and what the console says of it.
//
// What the file has under a sample's key is not measured again. How a sample is measured is the
// caller's, as in tools/measure/bench/measure.h; no GL is needed here.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/bench/sample.h"
#include "tools/measure/line_file.h"

#include <set>

namespace CLI {
class App;
}

namespace crevice {

struct BenchOptions {
    std::vector<std::string> configs = {};  ///< Empty: every shipped config.
    std::vector<std::string> scenes = {};
    ImportOptions import = {};  ///< Of those that are files.
    std::vector<std::string> sizes = {"960x540"};
    std::vector<double> radii = {};           ///< Scene units; empty: each config's own.
    std::vector<int> samples = {};            ///< Empty: each config's own.
    std::vector<std::string> overrides = {};  ///< For every config, as --set has them.
    std::vector<std::string> roots = {};      ///< As LoadRequest has them.
    std::vector<std::string> disable = {};    ///< Optimizations, as CompileOptions has them.
    std::string camera = {};
    std::string output = kOcclusionOutput;  ///< The timed passes are those that it needs.
    int rays = 256;
    bool motion = false;       ///< Measure what changes along camera paths, too.
    std::string version = {};  ///< Of crevice; part of each key.
};

/// One sample that is to be measured.
struct BenchTask {
    BenchSample sample;    ///< What is known beforehand, or why it cannot be measured.
    std::size_t view = 0;  ///< Into BenchPlan::views; means nothing where there is a failure.
    std::string
        reference;  ///< Key of the ground truth, see tools/measure/reference/reference_cache.h.
    Description description = {};
};

struct BenchPlan {
    std::vector<BenchView> views;
    /// In an order in which neighbours share scene, size and ground truth; where no configs were
    /// named, the presets of all scenes come first.
    std::vector<BenchTask> tasks;
    Diagnostics diagnostics;  ///< Unusable scenes (errors), values that do not fit (warnings).
};

/// Crosses scenes, sizes, radii, configs and sample counts. What is asked for twice is one task.
/// The tasks of a scene that cannot be loaded have its error as their failure, so that reports know
/// of them.
///
/// Errors: CV4005 for a size.
Result<BenchPlan> planBench(const BenchOptions& options, const SourceSet& sources);

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

struct RunOptions {
    std::string time_budget;
    std::string out;  ///< A folder.
};

/// Adds --time-budget and --out.
void addRunOptions(CLI::App& app, RunOptions& options);

/// Seconds, of "90s", "5m", "1.5h" or plain seconds; 0 where the option was not given. Errors:
/// CV8001.
Result<double> timeBudgetOf(const RunOptions& options);

/// Measures all by `world.measure`, stops in good order on an interrupt, and says what came of it.
MeasureSummary measureOnConsole(const BenchPlan& plan, BenchFile& file, MeasureWorld world,
                                Progress& progress);

/// kExitBadInput where a sample failed; what could not be written and interrupts come first.
int exitCodeOf(const MeasureSummary& summary);

}  // namespace crevice
