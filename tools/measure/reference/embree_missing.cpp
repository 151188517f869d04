// SPDX-License-Identifier: MIT
// Stands in for Embree where it was not found.
#include "tools/measure/reference/ray_scene.h"

namespace crevice {

Result<std::unique_ptr<RayScene>> makeRayScene(const Scene& scene, const glm::dvec3& eye)
{
    return makeBvhScene(scene, eye);
}

}  // namespace crevice
