// SPDX-License-Identifier: MIT
// A scene as the ray tracer asks it: what a ray meets first, and how many rays meet nothing.
//
// Two searches answer: Embree's (embree_scene.cpp) and that of a tree of boxes (bvh_scene.cpp),
// which needs no library and no threads. What counts as a hit is the same code for both, in
// trace_bodies.h.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// A ray in world space.
struct TraceRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< Of length 1.
    double limit = 1.0;    ///< Where it ends, scene units.
};

/// Where a ray met the scene. Both normals face the side that the ray came from.
struct TraceHit {
    glm::dvec3 position;          ///< Relative to RayScene::center().
    glm::dvec3 normal;            ///< Interpolated, of length 1.
    glm::dvec3 geometric_normal;  ///< The triangle's, of length 1.
    double rounding;              ///< At most how far `position` is off the triangle's plane.
};

/// Eight rays from one point.
struct TraceBatch {
    alignas(32) int valid[8];  ///< -1 for a ray, 0 for none.
    glm::vec3 directions[8];   ///< Of length 1.
};

/// The scene it was built from must outlive it. Safe to read from any number of threads, and from
/// any camera.
class RayScene {
public:
    RayScene() = default;
    virtual ~RayScene() = default;
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// The first hit of the ray; false when there is none.
    virtual bool intersect(const TraceRay& ray, TraceHit& hit) const = 0;

    /// How many rays meet nothing within `limit`; the origin is relative to center().
    virtual int countOpen(const glm::dvec3& origin, const TraceBatch& batch,
                          double limit) const = 0;

    /// The place in the bounds that is closest to the eye: the origin of the search's floats.
    virtual const glm::dvec3& center() const = 0;
};

/// Embree's search where Embree was found at build, else the tree's. Floats resolve best what lies
/// near `eye`, a place in the world.
///
/// Errors: CV6009 when Embree has no memory for it.
Result<std::unique_ptr<RayScene>> makeRayScene(const Scene& scene, const glm::dvec3& eye);

/// The tree of boxes. Triangles with a corner that is no number or above 1.8e18 in any direction
/// are left out, as Embree leaves them out. Takes about 80 bytes a triangle.
std::unique_ptr<RayScene> makeBvhScene(const Scene& scene, const glm::dvec3& eye);

}  // namespace crevice
