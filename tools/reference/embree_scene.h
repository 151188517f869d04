// SPDX-License-Identifier: MIT
// A scene as Embree sees it: world-space triangles, moved to the centre of their bounds so that
// 32-bit floats lose nothing far from the origin.
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
};

/// Owns Embree's device and scene. The scene it was built from must outlive it. Safe to read from
/// any number of threads.
class EmbreeScene {
public:
    /// Errors: CV6009 when Embree has no memory for it.
    static Result<std::unique_ptr<EmbreeScene>> build(const Scene& scene);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// The first hit of the ray; false when there is none.
    bool intersect(const TraceRay& ray, TraceHit& hit) const;

    /// How many of the rays whose `valid` is -1 meet nothing; origins relative to center().
    int countOpen(const int* valid, RTCRay8& rays) const;

    const glm::dvec3& center() const { return center_; }

    /// Half of the diagonal of the bounds.
    double size() const { return size_; }

private:
    explicit EmbreeScene(const Scene& scene);
    void addInstance(const SceneInstance& instance);
    TraceHit hitFrom(const RTCRayHit& ray_hit, const glm::dvec3& direction) const;

    struct Cutout;

    const Scene& source_;
    glm::dvec3 center_;
    double size_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<std::unique_ptr<Cutout>> cutouts_;
};

}  // namespace crevice
