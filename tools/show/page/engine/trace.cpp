// SPDX-License-Identifier: MIT
// Ray tracing in a worker, and its exports.
#include "tools/show/page/engine/trace.h"

#include "tools/measure/reference/bvh_scene.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/show/page/engine/answers.h"

#include <glm/matrix.hpp>

namespace crevice::page {
namespace {

Trace trace;
std::vector<float> row;

}  // namespace

Status Trace::setScene(std::string_view bytes)
{
    progress_.reset();
    tree_.reset();
    Result<Scene> scene = sceneFromBytes(bytes);
    if (!scene) return scene.diagnostics();
    scene_ = std::move(*scene);
    bounds_ = scene_.bounds();
    return {};
}

Status Trace::begin(const std::string& text, Extent extent, const TraceOptions& options)
{
    progress_.reset();
    const double aspect = double(extent.width) / extent.height;
    const Result<SceneCamera> chosen = chooseCamera(scene_, bounds_, text, aspect);
    if (!chosen) return chosen.diagnostics();
    Camera camera;
    camera.view_from_world = chosen->view_from_world;
    camera.clip_from_view = clipFromView(*chosen, extent, bounds_);
    if (!tree_) tree_ = makeBvhScene(scene_, glm::inverse(camera.view_from_world)[3]);
    Result<ProgressiveTrace> progress = ProgressiveTrace::begin(*tree_, camera, extent, options);
    if (!progress) return progress.diagnostics();
    progress_.emplace(std::move(*progress));
    return {};
}

EXPORT const char* page_trace_scene(const char* data, int size)
{
    return say(answer(trace.setScene({data, static_cast<std::size_t>(size)})));
}

/// Adds "passes".
EXPORT const char* page_trace_begin(const char* camera, int width, int height, double radius,
                                    int rays)
{
    TraceOptions options;
    options.radius = radius;
    options.rays = rays;
    Json json = answer(trace.begin(camera, {width, height}, options));
    if (json["ok"]) json["passes"] = trace.progress().passes();
    return say(json);
}

/// Traces a pass of a row, counted from the bottom; gives the row's visibilities so far.
EXPORT const float* page_trace_row(int pass, int y)
{
    trace.progress().traceRow(pass, y);
    row.resize(static_cast<std::size_t>(trace.progress().extent().width));
    trace.progress().readRow(y, row.data());
    return row.data();
}

}  // namespace crevice::page
