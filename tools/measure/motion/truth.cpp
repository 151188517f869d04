// SPDX-License-Identifier: MIT
#include "tools/measure/motion/truth.h"

#include "tools/measure/motion/flow.h"
#include "tools/measure/reference/reference_cache.h"

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
        TraceOptions options;
        options.radius = view_.radius;
        options.rays = kMotionRays;
        constexpr double kAll = std::size(kCameraPaths) * kMeasuredFrames;
        if (progress_) options.progress = [this](double done) { progress_((done_ + done) / kAll); };
        const Extent extent = view_.end.extent;
        Result<Image> truth =
            cachedReference(view_.scene, camera, extent, options, view_.cache_folder);
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

}  // namespace crevice
