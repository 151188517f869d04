// SPDX-License-Identifier: MIT
// A bench: which points are to be measured, and the loop that measures them.
//
// Planning needs no GL, so that each machine of a cluster finds the same list and takes its share.
// What measures a point is in tools/bench/measure.h.
#pragma once

#include "tools/bench/sample.h"
#include "tools/cli/config_options.h"
#include "tools/measure/line_file.h"
#include "tools/scene/scene.h"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace crevice {

/// The `index`th of `count` shares, from 1.
struct Shard {
    int index = 1;
    int count = 1;
};

/// Reads "3/8". Errors: CV8001.
Result<Shard> parseShard(const std::string& text);

/// Reads "90s", "5m", "1.5h" or plain seconds, above 0. Returns seconds. Errors: CV8001.
Result<double> parseDuration(const std::string& text);

struct BenchOptions {
    std::vector<std::string> configs = {};  ///< Empty: every shipped config.
    std::vector<std::string> scenes = {};
    ImportOptions import = {};  ///< Of those that are files.
    std::vector<std::string> sizes = {"960x540"};
    std::vector<double> radii = {};  ///< Scene units; empty: each config's own.
    std::vector<int> samples = {};   ///< Empty: each config's own.
    std::vector<std::string> overrides = {};  ///< For every config, as --set has them.
    std::vector<std::string> roots = {};      ///< As LoadRequest has them.
    std::string camera = {};
    int rays = 256;
    Shard shard = {};
    std::string version = {};  ///< Of crevice; part of each key.
};

/// What several points look at.
struct BenchView {
    std::shared_ptr<const Scene> scene;
    Bounds bounds;
    SceneCamera camera;
    Extent extent;

    Camera matrices() const;
};

/// One point that is to be measured.
struct BenchTask {
    BenchPoint point;         ///< What is known beforehand, or why it cannot be measured.
    std::size_t view = 0;     ///< Into BenchPlan::views; means nothing where there is a failure.
    std::string reference;    ///< Key of the truth, see tools/reference/reference_cache.h.
    Description description = {};
};

struct BenchPlan {
    std::vector<BenchView> views;
    std::vector<BenchTask> tasks;  ///< In an order in which neighbours share scene, size and truth; where
                                   ///< no configs were named, the presets of all scenes come first.
    PlannedBench planned;          ///< All shards' points; the device is the runner's to fill in.
    Diagnostics diagnostics;       ///< Unusable scenes (errors), values that do not fit (warnings).
};

/// Crosses scenes, sizes, radii, configs and sample counts, and takes the shard's share: a task's key,
/// which names no device, decides whose it is. What is asked for twice is one task. The tasks of a
/// scene that cannot be loaded have its error as their failure, so that reports know of them.
///
/// Errors: CV4005 for a size.
Result<BenchPlan> planBench(const BenchOptions& options, const SourceSet& sources);

/// "learnopengl samples=16, room, 960x540, radius 0.5".
std::string pointTitle(const BenchPoint& point);

/// The first that is an error; `diagnostics` has one.
const Diagnostic& firstError(const Diagnostics& diagnostics);

/// "my.frag:12:3: CV5001: the message": the first error, as a point's failure has it.
std::string failureText(const Diagnostics& diagnostics);

/// The key of a point on a device, from the task's.
std::string keyOnDevice(const std::string& task_key, const std::string& device);

/// FOLDER/results.jsonl, grown line by line.
class ResultFile {
public:
    /// Reads what it holds. Keeps others out until it is destroyed.
    ///
    /// Errors: those of LineFile::open and readBenchPoints.
    static Result<ResultFile> open(const std::string& folder);

    /// Adds what is to be measured, unless the file says just that. Errors: those of LineFile::append.
    Status plan(const PlannedBench& planned);

    /// True when there are figures under that key; a failure is worth another try.
    bool has(const std::string& key) const { return done_.count(key) > 0; }

    /// Errors: those of LineFile::append.
    Status append(const BenchPoint& point);

private:
    explicit ResultFile(LineFile lines) : lines_(std::move(lines)) {}

    LineFile lines_;
    std::set<std::string> done_;
    std::set<std::string> plans_;  // lines
};

/// The world around the loop; tests put in their own.
struct BenchWorld {
    /// The point with its figures. CV7007 ends the run, any other error becomes the point's
    /// failure; a warning is said once.
    std::function<Result<BenchPoint>(const BenchTask&)> measure;
    std::function<double()> seconds;    ///< A clock.
    std::function<bool()> interrupted;  ///< A point that was under way is then dropped.
    std::function<void(const std::string& line)> say;
    std::string device;
    double time_budget_s = 0;  ///< No point is begun after it; 0: no limit.
};

struct BenchSummary {
    int measured = 0;
    int kept = 0;  ///< Had figures from an earlier run.
    std::vector<std::string> failures;  ///< Title and reason.
    std::vector<std::string> missing;   ///< Titles of points that nobody began.
    bool interrupted = false;
    Status written;
};

/// Measures every task that has no figures yet and adds it to the file.
BenchSummary runBench(const std::vector<BenchTask>& tasks, ResultFile& file,
                      const BenchWorld& world);

}  // namespace crevice
