// SPDX-License-Identifier: MIT
// Embree's search for what rays hit.
#pragma once

#include "tools/measure/reference/ray_scene.h"

namespace crevice {

/// Errors: CV6009 when Embree has no memory for the scene.
Result<std::unique_ptr<RayScene>> makeEmbreeScene(const Scene& scene, const glm::dvec3& eye);

}  // namespace crevice
