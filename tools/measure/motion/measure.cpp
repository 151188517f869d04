// SPDX-License-Identifier: MIT
#include "tools/measure/motion/measure.h"

#include "core/base/text.h"
#include "tools/measure/motion/figures.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/read_output.h"

#include <cmath>

namespace crevice {
namespace {

/// One frame, as rays see it.
struct Traced {
    Camera camera;
    SurfaceMap surfaces;
    Image truth;
};

class PathTracer {
public:
    PathTracer(const MotionView& view, const std::function<void(double)>& progress)
        : view_(view),
          progress_(progress)
    {
    }

    Result<Traced> trace(const Camera& camera)
    {
        TraceOptions options = {view_.radius, view_.rays};
        constexpr double kAll = std::size(kCameraPaths) * kMeasuredFrames;
        if (progress_) options.progress = [this](double done) { progress_((done_ + done) / kAll); };
        const Extent extent = view_.end.extent;
        Result<Image> truth = view_.rays > 0 ? cachedReference(view_.scene, camera, extent, options,
                                                               view_.cache_folder)
                                             : Image(extent, 1, 1.0f);
        if (!truth) return truth.diagnostics();
        Result<SurfaceMap> surfaces = traceSurfaces(view_.scene, camera, extent);
        if (!surfaces) return surfaces.diagnostics();
        ++done_;
        return {Traced{camera, std::move(*surfaces), std::move(*truth)}, truth.diagnostics()};
    }

private:
    const MotionView& view_;
    const std::function<void(double)>& progress_;
    int done_ = 0;
};

bool same(const Camera& a, const Camera& b)
{
    return a.view_from_world == b.view_from_world && a.clip_from_view == b.clip_from_view;
}

/// The measured frames before the last, which is `end`.
Status tracePath(const MotionView& view, const CameraPath& path, const Traced& end,
                 PathTracer& tracer, PathTruth& truth)
{
    const int first = kMotionFrames - kMeasuredFrames;
    Result<Traced> before = Traced();
    for (int frame = first; frame < kMotionFrames; ++frame) {
        const Camera camera = view.camera(path, frame);
        Result<Traced> now = same(camera, end.camera) ? Result<Traced>(end) : tracer.trace(camera);
        if (!now) return now.diagnostics();
        if (frame > first)
            truth.flows.push_back(flowTo(before->surfaces, now->surfaces, now->camera));
        truth.frames.push_back(now->truth);
        before = std::move(now);
    }
    return {};
}

const char* const kOcclusion = "ao";

/// Frames since a surface was uncovered after which its error is measured.
constexpr int kUncoveredFor[] = {1, 2, 4, 8, kFramesAfterJump};

bool isFinite(const Image& image)
{
    return allOf(image.pixels, [](float value) { return std::isfinite(value); });
}

class MotionMeter {
public:
    MotionMeter(const MotionStage& stage, const MotionView& view, const MotionTruth& truth)
        : stage_(stage),
          view_(view),
          truth_(truth),
          remembers_(remembers(stage.renderer.plan()))
    {
    }

    /// Draws a frame of a path, the first one after a cut.
    Result<Image> draw(const CameraPath& path, int frame, bool first)
    {
        stage_.frame.camera = view_.camera(path, frame);
        stage_.frame.camera_cut = first;
        const Result<Frame> hosted = stage_.host.frameOf(stage_.frame);
        if (!hosted) return hosted.diagnostics();
        if (const Status drawn = stage_.renderer.render(*hosted); !drawn)
            return drawn.diagnostics();
        Result<Image> image = readOutput(stage_.device, stage_.renderer, kOcclusion);
        if (image && !isFinite(*image))
            return Diagnostic{Code::not_finite,
                              "the occlusion is not a number somewhere in frame " +
                                  std::to_string(frame) + " of the path '" + path.name + "'"};
        return image;
    }

    Status measurePath(const CameraPath& path)
    {
        const bool is_still = std::string(path.name) == kCameraPaths[0].name;
        const int measured = kMotionFrames - kMeasuredFrames;
        const int first = remembers_ || is_still ? 0 : measured;
        std::vector<Image> frames;
        Settling settling;
        for (int frame = first; frame < kMotionFrames; ++frame) {
            Result<Image> image = draw(path, frame, frame == first);
            if (!image) return image.diagnostics();
            if (is_still) settling.add(*image);
            if (frame >= measured) frames.push_back(std::move(*image));
        }
        figures.paths[path.name] = changeFigures(frames, truth_.paths.at(path.name));
        if (is_still) {
            figures.settled_after = settling.frames();
            rest_ = frames.back();
        }
        return {};
    }

    /// Requires that the still path was measured.
    Status measureUncovered(const CameraPath& path)
    {
        const Image& mask = truth_.uncovered;
        figures.uncovered_pixels = std::count(mask.pixels.begin(), mask.pixels.end(), 1.0f);
        figures.uncovered_rest = errorOver(rest_, truth_.rest, &mask);
        std::vector<Image> frames;
        for (int frame = 0; frame < kMotionFrames; ++frame) {
            Result<Image> image = draw(path, frame, frame == 0);
            if (!image) return image.diagnostics();
            const int since = frame + 1 - (kMotionFrames - kFramesAfterJump);
            if (std::count(std::begin(kUncoveredFor), std::end(kUncoveredFor), since) > 0)
                figures.uncovered.push_back({since, errorOver(*image, truth_.rest, &mask)});
            if (since >= 1 && since <= kMeasuredFrames) frames.push_back(std::move(*image));
        }
        // The camera has stopped: the truth is that of a still one.
        figures.paths[path.name] = changeFigures(frames, truth_.paths.at(kCameraPaths[0].name));
        return {};
    }

    MotionFigures figures;

private:
    MotionStage stage_;
    const MotionView& view_;
    const MotionTruth& truth_;
    const bool remembers_;
    Image rest_;  ///< Drawn, after kMotionFrames.
};

}  // namespace

Camera MotionView::camera(const CameraPath& path, int frame) const
{
    const SceneCamera at = cameraAt(path, end, frame, kMotionFrames);
    return {at.view_from_world, clipFromView(at, end.extent, bounds)};
}

Result<MotionTruth> traceMotion(const MotionView& view, const std::function<bool()>& interrupted,
                                const std::function<void(double done)>& progress)
{
    PathTracer tracer(view, progress);
    const Result<Traced> end = tracer.trace(view.camera(kCameraPaths[0], kMotionFrames - 1));
    if (!end) return end.diagnostics();
    MotionTruth truth;
    truth.rest = end->truth;
    for (const CameraPath& path : kCameraPaths) {
        if (interrupted()) break;
        if (!view.paths.empty() && !contains(view.paths, path.name)) continue;
        if (path.aside_px != 0.0) {
            const Camera aside = view.camera(path, 0);
            const Result<SurfaceMap> before = traceSurfaces(view.scene, aside, view.end.extent);
            if (!before) return before.diagnostics();
            truth.uncovered = uncoveredSince(*before, aside, end->surfaces);
        } else if (const Status traced =
                       tracePath(view, path, *end, tracer, truth.paths[path.name]);
                   !traced) {
            return traced.diagnostics();
        }
    }
    return {std::move(truth), end.diagnostics()};
}

Result<MotionFigures> measureMotion(const MotionStage& stage, const MotionView& view,
                                    const MotionTruth& truth,
                                    const std::function<bool()>& interrupted)
{
    MotionMeter meter(stage, view, truth);
    for (const CameraPath& path : kCameraPaths) {
        if (interrupted()) break;
        if (!view.paths.empty() && !contains(view.paths, path.name)) continue;
        const Status measured =
            path.aside_px != 0.0 ? meter.measureUncovered(path) : meter.measurePath(path);
        if (!measured) return measured.diagnostics();
    }
    return std::move(meter.figures);
}

}  // namespace crevice
