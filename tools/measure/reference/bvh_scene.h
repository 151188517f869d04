// SPDX-License-Identifier: MIT
// A search of our own for what rays hit, which needs no library and no threads: a tree of boxes.
//
// Triangles are met as Embree's robust mode meets them: the sides of a ray on which the edges lie,
// which triangles that share an edge agree on, so that no ray slips through between them.
//
// Sources: Davidovic et al. 2012 - the edges; Ize 2013 - the boxes.
#pragma once

#include "tools/measure/reference/ray_scene.h"

namespace crevice {

/// Triangles with a corner that is no number or above 1.8e18 in any direction are left out, as
/// Embree leaves them out. Takes about 80 bytes a triangle.
std::unique_ptr<RayScene> makeBvhScene(const Scene& scene, const glm::dvec3& eye);

}  // namespace crevice
