// SPDX-License-Identifier: MIT
// A bench: which samples are to be measured.
//
// Planning needs no GL. What measures a sample is in tools/measure/bench/measure.h.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/bench/sample.h"
#include "tools/render/scene/scene.h"

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

/// What several samples look at.
struct BenchView {
    std::shared_ptr<const Scene> scene;
    Bounds bounds;
    SceneCamera camera;
    Extent extent;

    Camera matrices() const;
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

}  // namespace crevice
