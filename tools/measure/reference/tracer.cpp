// SPDX-License-Identifier: MIT
// Whole pictures by rays, on all processors.
#include "tools/measure/reference/tracer.h"

#include "tools/measure/reference/pixel_tracer.h"

#include <glm/matrix.hpp>

#include <atomic>
#include <thread>

namespace crevice {
namespace {

// Rows are dealt out one by one; each pixel depends on nothing but itself.
void traceRows(ProgressiveTrace& trace, std::atomic<int>& next_row,
               const std::function<void(double)>& progress)
{
    const int height = trace.extent().height;
    for (int y = next_row++; y < height; y = next_row++) {
        trace.traceRow(0, y);
        if (progress) progress(static_cast<double>(y + 1) / height);
    }
}

glm::dvec3 eyeOf(const Camera& camera) { return glm::inverse(camera.view_from_world)[3]; }

}  // namespace

Result<Image> traceAmbientOcclusion(const RayScene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options)
{
    Result<ProgressiveTrace> begun = ProgressiveTrace::begin(scene, camera, extent, options, 1);
    if (!begun) return begun.diagnostics();
    ProgressiveTrace& trace = *begun;
    std::atomic<int> next_row = 0;
    const unsigned wanted =
        options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    std::vector<std::thread> helpers;
    for (unsigned k = 1; k < wanted; ++k)
        helpers.emplace_back([&] { traceRows(trace, next_row, {}); });
    traceRows(trace, next_row, options.progress);
    for (std::thread& helper : helpers) helper.join();
    return trace.image();
}

Result<Image> traceAmbientOcclusion(const Scene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options)
{
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    const auto built = makeRayScene(scene, eyeOf(camera));
    if (!built) return built.diagnostics();
    return traceAmbientOcclusion(**built, camera, extent, options);
}

Result<SurfaceMap> traceSurfaces(const RayScene& scene, const Camera& camera, Extent extent)
{
    const TraceOptions options;
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    const PixelTracer tracer(scene, camera, extent, options, 1);
    SurfaceMap map{extent, {}};
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            TraceHit hit;
            SurfacePoint point;
            if (tracer.surface(x, y, hit))
                point = {hit.position + scene.center(), hit.geometric_normal, true};
            map.points.push_back(point);
        }
    }
    return map;
}

Result<SurfaceMap> traceSurfaces(const Scene& scene, const Camera& camera, Extent extent)
{
    if (const Status status = checkTrace(camera, extent, {}); !status) return status.diagnostics();
    const auto built = makeRayScene(scene, eyeOf(camera));
    if (!built) return built.diagnostics();
    return traceSurfaces(**built, camera, extent);
}

}  // namespace crevice
