// SPDX-License-Identifier: MIT
// The ground truth that screen-space occlusion is measured against, ray-traced.
//
// One primary ray goes through each pixel's centre; the shading normal is the interpolated vertex
// normal. From there `rays` cosine-weighted directions are probed (Hammersley points, rotated per
// pixel); of those that point over the geometric surface, one that hits anything within `radius` is
// occluded. Surfaces occlude from both sides, and are shaded on the side that is seen. Alpha-tested
// holes are not seen and let rays through.
//
// Distances are computed in doubles, so any radius will do, and any place in the world that an
// instance's matrix says; vertices are as exact as their 32-bit floats.
//
// Sources: Pharr et al. 2023 - Malley's method; Cranley, Patterson 1976; Duff et al. 2017.
#pragma once

#include "tools/measure/reference/ray_scene.h"

#include <functional>

namespace CLI {
class App;
}

namespace crevice {

/// Changes whenever the picture may: a part of the key of cached references.
constexpr int kTracerVersion = 3;

constexpr int kMaxTraceRays = 1 << 20;

struct TraceOptions {
    double radius = 0.5;  ///< How far an occluder may be, scene units, >= 0; 0 gives 1.
    int rays = 256;       ///< Rays a pixel, [1, kMaxTraceRays]. Time grows in step with it.
    int threads = 0;      ///< 0 takes one a processor. The picture does not depend on it.
    std::function<void(double done)> progress = {};  ///< Called on the caller's thread, [0, 1].
};

/// Ambient visibility, 1 open to 0 blocked, one channel; pixels that see no surface are NaN. Any
/// invertible `clip_from_view` will do. The same input gives the same picture.
///
/// Errors: CV4001 for options outside their ranges, CV4005 for an empty extent, CV6009 for a scene
/// that memory cannot hold, CV6011 for a projection that has no inverse.
Result<Image> traceAmbientOcclusion(const Scene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options);

/// The same of a scene that is ready to be searched.
Result<Image> traceAmbientOcclusion(const RayScene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options);

/// What the centre of a pixel sees.
struct SurfacePoint {
    glm::dvec3 position;  ///< In the world.
    glm::dvec3 normal;    ///< The triangle's, towards the eye, of length 1.
    bool seen = false;    ///< False where there is no surface: the others then mean nothing.
};

/// Rows from the bottom up, as an image's.
struct SurfaceMap {
    Extent extent;
    std::vector<SurfacePoint> points;

    const SurfacePoint& at(int x, int y) const
    {
        return points[static_cast<std::size_t>(y) * extent.width + x];
    }
};

/// The surfaces that `traceAmbientOcclusion` shades. Errors: the same.
Result<SurfaceMap> traceSurfaces(const Scene& scene, const Camera& camera, Extent extent);
Result<SurfaceMap> traceSurfaces(const RayScene& scene, const Camera& camera, Extent extent);

struct CacheOptions {
    std::string folder;  ///< --cache; empty for the usual one.
    bool off = false;    ///< --no-cache

    /// Where references are kept: --cache, $XDG_CACHE_HOME/crevice or ~/.cache/crevice. Empty for
    /// nowhere.
    std::string path() const;
};

/// $XDG_CACHE_HOME/crevice or ~/.cache/crevice; empty where neither variable is set.
std::string usualCacheFolder();

/// Adds --cache and --no-cache.
void addCacheOptions(CLI::App& app, CacheOptions& options);

/// A hash over the scene's triangles and cut-outs, the camera's matrices, the size, the radius, the
/// number of rays and the tracer's version: 16 hex digits.
std::string referenceKey(const Scene& scene, const Camera& camera, Extent extent,
                         const TraceOptions& options);

/// The picture of `traceAmbientOcclusion`, from the folder where it is there; otherwise it is
/// traced and kept there, with a checksum behind the PFM. A file that was changed and a folder that
/// cannot be written are warnings. An empty name: no folder.
///
/// Errors: CV7008 when the camera sees no surface, and those of `traceAmbientOcclusion`.
Result<Image> cachedReference(const Scene& scene, const Camera& camera, Extent extent,
                              const TraceOptions& options, const std::string& cache_folder);

}  // namespace crevice
