// SPDX-License-Identifier: MIT
// Ray tracing in a worker of the page: a scene and a camera in, rows of visibility out.
#include "tools/measure/reference/pixel_tracer.h"
#include "tools/measure/reference/ray_scene.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/show/page/engine/answers.h"

#include <glm/matrix.hpp>

namespace crevice::page {
namespace {

struct Trace {
    std::optional<ProgressiveTrace> progress;  // of the tree
    std::unique_ptr<RayScene> tree;
    Scene scene;
    Bounds bounds;
    std::vector<float> row;
} trace;

/// Builds the tree for the camera's eye and begins anew. Errors: those of chooseCamera and
/// ProgressiveTrace::begin.
Status begin(const std::string& text, Extent extent, const TraceOptions& options)
{
    trace.progress.reset();
    const double aspect = double(extent.width) / extent.height;
    const Result<SceneCamera> chosen = chooseCamera(trace.scene, trace.bounds, text, aspect);
    if (!chosen) return chosen.diagnostics();
    const Camera camera = {chosen->view_from_world, clipFromView(*chosen, extent, trace.bounds)};
    if (!trace.tree)
        trace.tree = makeBvhScene(trace.scene, glm::inverse(camera.view_from_world)[3]);
    Result<ProgressiveTrace> progress =
        ProgressiveTrace::begin(*trace.tree, camera, extent, options);
    if (!progress) return progress.diagnostics();
    trace.progress.emplace(std::move(*progress));
    return {};
}

}  // namespace

/// Takes the scene, as sceneBytes has it.
EXPORT const char* page_trace_scene(const char* data, int size)
{
    trace.progress.reset();
    trace.tree.reset();
    Result<Scene> scene = sceneFromBytes({data, static_cast<std::size_t>(size)});
    if (!scene) return say(answer(scene));
    trace.bounds = scene->bounds();
    trace.scene = std::move(*scene);
    return say(answer(Status()));
}

/// Adds "passes".
EXPORT const char* page_trace_begin(const char* camera, int width, int height, double radius,
                                    int rays)
{
    Json json = answer(begin(camera, {width, height}, {radius, rays}));
    if (json["ok"]) json["passes"] = trace.progress->passes();
    return say(json);
}

/// Traces a pass of a row, counted from the bottom; gives the row's visibilities so far.
EXPORT const float* page_trace_row(int pass, int y)
{
    trace.progress->traceRow(pass, y);
    trace.row.resize(static_cast<std::size_t>(trace.progress->extent().width));
    trace.progress->readRow(y, trace.row.data());
    return trace.row.data();
}

}  // namespace crevice::page
