// SPDX-License-Identifier: MIT
// One measured sample of a bench, which is a config in one view at one size: what was drawn, its
// error and its cost.
//
// Results are JSON Lines, one bench sample a line, appended as they are measured. A line's key is a
// hash over everything that decides its figures, so a run that was interrupted goes on where it
// stopped, and files from several machines merge by putting one after the other.
#pragma once

#include "tools/measure/motion/figures.h"

#include <crevice/diagnostic.h>
#include <crevice/image.h>

namespace crevice {

/// What several samples look at.
struct BenchView {
    std::shared_ptr<const Scene> scene;
    Bounds bounds;
    SceneCamera camera;
    Extent extent;

    Camera matrices() const;
};

/// Whether its figures say most about what to take (docs/which_config.md), so that it is measured
/// first. `reference`, which takes too long, is none.
bool isPresetConfig(std::string_view config);

/// Median and quartiles over the repeats, milliseconds.
struct TimeFigures {
    double median = 0;
    double q1 = 0;
    double q3 = 0;
};

struct PassTime {
    std::string name;
    TimeFigures ms;
};

/// Against the ray-traced ground truth; see tools/render/image/image_metrics.h.
struct ErrorFigures {
    double rmse = 0;
    double bias = 0;
    double p99 = 0;
    double pattern = 0;
    double rmse_fit = 0;
    double power_fit = 1;
    long long pixels = 0;
};

/// Whose error is measured, and whose passes are timed unless another output is asked for.
constexpr const char* kOcclusionOutput = "ao";

struct BenchSample {
    std::string key;      ///< 16 hex digits.
    std::string failure;  ///< Why there are no figures; empty when there are.

    std::string config;
    std::vector<std::string> overrides;  ///< As --set has them.
    std::vector<std::string> disable;    ///< Optimizations that are switched off.
    std::string family;  ///< Bench samples that differ only in `samples` share it: "learnopengl".
    std::string output = kOcclusionOutput;  ///< Whose passes are timed.
    std::string scene;
    std::string camera;
    Extent extent;
    double radius = 0;     ///< Scene units.
    int rays = 0;          ///< Per pixel of the ground truth.
    double radius_px = 0;  ///< On screen, at the median depth of what is seen.
    int samples = 0;       ///< Depth taps a pixel; 0 for a config without such a param.
    long long triangles = 0;

    std::string device;  ///< Renderer and driver.
    bool software = false;
    std::string version;  ///< Of crevice.

    ErrorFigures error;
    double error_without_ao = 0;  ///< The rmse that no ambient occlusion at all has here.

    MotionFigures motion;        ///< Without paths where it was not asked for.
    std::string motion_failure;  ///< Why it could not be measured; else empty.

    std::string clock;  ///< clockName of tools/measure/bench/times.h: "query", "cpu" or "wall".
    int repeats = 0;
    TimeFigures total;  ///< All passes, those that draw the scene's geometry too.
    /// The passes that draw no geometry: for `ao`, what it adds to a host that has a G-buffer.
    TimeFigures cost;
    /// The same and the draw passes that the occlusion alone needs
    /// (tools/show/plan/costs.h): back faces, further layers and, with forward
    /// lighting, depth. Zeros in earlier versions' lines.
    TimeFigures cost_with_geometry;
    std::vector<PassTime> passes;
    double ratio_learnopengl = 0;    ///< Cost over that of learnopengl, same run.
    double ratio_with_geometry = 0;  ///< cost_with_geometry over the cost of learnopengl, same run.

    double texture_bytes = 0;
    double bytes_read = 0;  ///< Estimated, a frame.
    double bytes_written = 0;

    /// Pictures beside the results file, relative to it; empty when none were kept.
    std::string ao_picture;
    std::string ground_truth_picture;
    std::string difference_picture;
    std::string folder;  ///< Of the results file; empty for the working folder. Not written.
};

/// One line, without the line feed.
std::string toJsonLine(const BenchSample& sample);

/// What was measured, the same in every run and on every device: config, overrides, scene, camera,
/// size, radius, rays, the output, unless that is `ao`, and what is switched off. A key says more:
/// it changes with a shader's text, a driver or a version.
std::string identityOf(const BenchSample& sample);

/// The same but for what is switched off, which may change no pixel: what two benches compare.
std::string questionOf(const BenchSample& sample);

/// " output=color" and " without cached" after a sample's name; nothing where `ao` is timed with
/// all optimizations.
std::string nameSuffix(const BenchSample& sample);

/// "bitmask samples=16": the config, what was set in it, but for the radius, which is part of the
/// question and not of the answer, and the suffix.
std::string sampleLabel(const BenchSample& sample);

/// "bitmask radius=0.5 samples=16, room, 960x540".
std::string sampleTitle(const BenchSample& sample);

/// Reads results files; a folder stands for the results.jsonl in it. Of two lines about one sample
/// on one device the later one holds, but a failure never hides figures of its own key. A line that
/// an interrupt cut short is left out with a warning. Pictures come back relative to the working
/// folder. A figure that was not finite makes its sample a failure.
///
/// Errors: CV7009 for a file that cannot be read or a line that is no sample.
Result<std::vector<BenchSample>> readBenchSamples(const std::vector<std::string>& paths);

}  // namespace crevice
