// SPDX-License-Identifier: MIT
// What occlusion does while the camera moves, in figures: `crevice bench --motion`.
//
// Each pixel's point, ray-traced, is projected into the next frame. What that frame has there is
// interpolated between the four texels about the place, and counts only where all of them lie on
// the point's own surface: no farther off its tangent plane than a pixel covers at the point. So
// edges, what comes into view and what goes out of it do not count, and a crease does. The ground
// truth is interpolated in the same way, so that what interpolation itself changes is in both.
#pragma once

#include "tools/measure/reference/tracer.h"

#include <crevice/image.h>

#include <map>
#include <string>

namespace crevice {

/// For each pixel of `from` its place in `to`, in texels from the centre of the first: two
/// channels, NaN where it does not count. `camera` is the one that saw `to`.
Image flowTo(const SurfaceMap& from, const SurfaceMap& to, const Camera& camera);

/// 1 for each pixel of `now` whose point lies within the picture `before` and is hidden there; else
/// 0. `camera` is the one that saw `before`.
Image uncoveredSince(const SurfaceMap& before, const Camera& camera, const SurfaceMap& now);

/// The change from one frame to the next at the same points, one channel; NaN where `flow` is.
Image changeAlong(const Image& flow, const Image& from, const Image& to);

/// Along one camera path; after its jump, of one that has one. A change is that of one surface
/// point from a frame to the next, less the ground truth's change at the same place.
struct ChangeFigures {
    double rms = 0;         ///< Of the changes.
    double p99 = 0;         ///< 99th percentile of the absolute change.
    double p999 = 0;        ///< 99.9th.
    double truth = 0;       ///< Rms of the ground truth's own change, from interpolation.
    double rmse = 0;        ///< Of the error while the camera moves.
    long long changes = 0;  ///< Points that count, over all pairs of frames.
};

/// Of surfaces that have come into view.
struct UncoveredFigures {
    int frames = 0;   ///< Drawn since, from 1.
    double rmse = 0;  ///< Of the error there.
};

/// All paths. Nothing where no motion was measured.
struct MotionFigures {
    std::map<std::string, ChangeFigures> paths;  ///< By tools/render/camera_path.h's name.
    /// Frames of a still camera after which no pixel changes any more; 0: not within 32.
    int settled_after = 0;
    std::vector<UncoveredFigures> uncovered;
    double uncovered_rest = 0;  ///< The error there after 32 frames of a still camera.
    long long uncovered_pixels = 0;
};

/// The ground truth of consecutive frames, and where each one's points are in the next; one less.
struct PathTruth {
    std::vector<Image> frames;
    std::vector<Image> flows;
};

/// Figures of drawn frames. Requires as many as the ground truth has, at least two.
ChangeFigures changeFigures(const std::vector<Image>& frames, const PathTruth& truth);

/// Rms of (frame - truth) where the truth is finite and the mask, if any, is above 0.
double errorOver(const Image& frame, const Image& truth, const Image* mask = nullptr);

/// After how many of the frames nothing changes; 0 where the last of them still does.
class Settling {
public:
    void add(const Image& frame);
    int frames() const { return changed_ < count_ || count_ == 1 ? changed_ : 0; }

private:
    Image last_;
    int count_ = 0;
    int changed_ = 0;  ///< The last frame that was another than the one before it.
};

struct MotionRow {
    std::string name;
    double rest = 0;  ///< The error of a still camera.
    MotionFigures motion;
};

/// In Markdown, a row each: the error at rest, the change along each path (rms, 99th and 99.9th
/// percentile), the error in a pan, the frames to settle, the error where surfaces were uncovered.
std::string motionTable(const std::vector<MotionRow>& rows);

}  // namespace crevice
