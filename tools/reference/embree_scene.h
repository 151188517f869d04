// SPDX-License-Identifier: MIT
// A scene as Embree sees it, and hits at the precision of doubles.
//
// Embree finds the triangles that a ray may hit, with 32-bit floats. The distance to the plane of
// each is computed again in doubles, from the mesh's vertices and the instance's matrix, and
// decides. So no ray has to start far off its surface: Embree's ray begins before it, and what lies
// behind the true origin does not count.
#pragma once

#include "tools/scene/scene.h"

#include <embree3/rtcore.h>

#include <memory>

namespace crevice {

/// A ray in world space.
struct TraceRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  ///< Of length 1.
    double limit = 1.0;    ///< Where it ends, scene units.
};

/// Where a ray met the scene. Both normals face the side that the ray came from.
struct TraceHit {
    glm::dvec3 position;          ///< Relative to EmbreeScene::center().
    glm::dvec3 normal;            ///< Interpolated, of length 1.
    glm::dvec3 geometric_normal;  ///< The triangle's, of length 1.
    double rounding;              ///< At most how far `position` is off the triangle's plane.
};

/// Eight rays from one point.
struct TraceBatch {
    alignas(32) int valid[8];  ///< -1 for a ray, 0 for none.
    glm::vec3 directions[8];   ///< Of length 1.
};

/// Owns Embree's device and scene. The scene it was built from must outlive it. Safe to read from
/// any number of threads.
class EmbreeScene {
public:
    /// Floats resolve best what lies near `eye`, a place in the world.
    ///
    /// Errors: CV6009 when Embree has no memory for it.
    static Result<std::unique_ptr<EmbreeScene>> build(const Scene& scene, const glm::dvec3& eye);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// The first hit of the ray; false when there is none.
    bool intersect(const TraceRay& ray, TraceHit& hit) const;

    /// How many rays meet nothing within `limit`; the origin is relative to center().
    int countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const;

    /// The place in the bounds that is closest to the eye: Embree's origin.
    const glm::dvec3& center() const { return center_; }

private:
    EmbreeScene(const Scene& scene, const glm::dvec3& eye);
    void addInstance(const SceneInstance& instance);

    struct Query;
    struct Body;

    const Scene& source_;
    glm::dvec3 center_;
    glm::dvec3 middle_;  // of the bounds, relative to center_
    double size_;        // half of their diagonal
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<std::unique_ptr<Body>> bodies_;  // one an instance
};

}  // namespace crevice
