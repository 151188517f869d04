// SPDX-License-Identifier: MIT
// The instances of a scene as a search for hits sees them, and the distances that decide.
//
// A search finds the triangles that a ray may hit, with 32-bit floats. The distance to the plane of
// each is computed again in doubles, from the mesh's vertices and the instance's matrix, and
// decides. So no ray has to start far off its surface: the ray that is searched begins before it,
// and what lies behind the true origin does not count. Alpha-tested holes do not count either.
#pragma once

#include "tools/measure/reference/ray_scene.h"

#include <limits>

namespace crevice {

/// A triangle that a ray hits.
struct TraceCandidate {
    double distance = std::numeric_limits<double>::infinity();  ///< In lengths of the direction.
    unsigned instance = 0, triangle = 0;
    double u = 0.0, v = 0.0;  ///< Weights of its second and third corner.

    bool found() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// A triangle's plane, seen from a point.
struct TracePlane {
    glm::dvec3 across;  ///< Along the normal, of any length.
    double offset;      ///< From the point to the plane, in lengths of `across`, squared.

    /// Along a ray from the point, in lengths of `direction`; no number for a ray in the plane.
    double distance(const glm::dvec3& direction) const
    {
        return offset / glm::dot(direction, across);
    }
};

/// One instance. Places are relative to TraceBodies::center().
class TraceBody {
public:
    TraceBody(const Scene& scene, const SceneInstance& instance, const glm::dvec3& center);

    std::size_t triangles() const { return mesh_.indices.size() / 3; }
    const MeshDesc& mesh() const { return mesh_; }
    glm::dvec3 place(const Vertex& vertex) const;
    TracePlane plane(unsigned triangle, const glm::dvec3& from) const;
    bool hole(unsigned triangle, double u, double v) const;
    TraceHit hitAt(const TraceRay& ray, const TraceCandidate& found) const;

private:
    const Vertex& vertex(unsigned triangle, int corner) const
    {
        return mesh_.vertices[mesh_.indices[3 * static_cast<std::size_t>(triangle) + corner]];
    }

    const MeshDesc& mesh_;
    const SceneMaterial& material_;
    const Image* texture_;  // of its alpha; null for none
    glm::dmat4 from_model_;
};

/// What is searched of a ray, in floats: from before its origin to behind its end.
struct SearchRay {
    glm::vec3 origin;
    glm::vec3 direction;
    double begin;  ///< From the ray's origin to `origin`, mostly below 0.
    float end;     ///< From `origin`.
};

/// All instances of a scene.
class TraceBodies {
public:
    TraceBodies(const Scene& scene, const glm::dvec3& eye);

    const glm::dvec3& center() const { return center_; }
    const std::vector<TraceBody>& all() const { return bodies_; }

    /// `ray` is relative to center(). It is searched from where it enters the sphere around the
    /// bounds, since floats are coarse far away.
    SearchRay searched(const TraceRay& ray) const;

    /// From a place within the bounds.
    SearchRay searched(const glm::dvec3& origin, const glm::vec3& direction, double limit) const;

    /// Where the search for a hit before `distance` may end, from `ray.origin`.
    float endOf(const SearchRay& ray, double distance) const;

private:
    glm::dvec3 center_;
    glm::dvec3 middle_;  // of the bounds, relative to center_
    double size_;        // half of their diagonal
    std::vector<TraceBody> bodies_;
};

/// Decides about the triangles that a search finds for rays from one point.
class TraceQuery {
public:
    /// The nearest hit goes to `nearest`; null where any hit will do.
    TraceQuery(const TraceBodies& bodies, const glm::dvec3& origin, double limit,
               TraceCandidate* nearest)
        : bodies_(bodies),
          origin_(origin),
          limit_(limit),
          nearest_(nearest)
    {
    }

    /// Whether the ray hits this triangle within the limit, and not a hole of it. `found.distance`
    /// is computed here.
    bool hits(TraceCandidate found, const glm::dvec3& direction);

    bool wantsNearest() const { return nearest_ != nullptr; }

private:
    const TracePlane& plane(unsigned instance, unsigned triangle);

    // Most rays from a point meet the same few planes, first of all the one it lies in.
    struct Known {
        unsigned instance = ~0u, triangle = ~0u;
        TracePlane plane;
    };
    static constexpr unsigned kKnown = 4;

    const TraceBodies& bodies_;
    const glm::dvec3 origin_;
    const double limit_;
    TraceCandidate* const nearest_;
    Known known_[kKnown];
};

}  // namespace crevice
