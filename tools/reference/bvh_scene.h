// SPDX-License-Identifier: MIT
// The search for what rays hit, without threads: a tree of boxes.
//
// Triangles are met by the sides of a ray on which the edges lie, which triangles that share an
// edge agree on, so that no ray slips through between them.
//
// Sources
//   Davidovic, Engelhardt, Georgiev, Slusallek, Dachsbacher 2012, "3D Rasterization: A Bridge
//     between Rasterization and Ray Casting" - the edges.
//   Ize 2013, "Robust BVH Ray Traversal" - the boxes.
#pragma once

#include "tools/reference/ray_scene.h"

namespace crevice {

/// Triangles with a corner that is no number or above 1.8e18 in any direction are left out. Floats
/// resolve best what lies near `eye`, a place in the world. Takes about 80 bytes a triangle.
std::unique_ptr<RayScene> makeBvhScene(const Scene& scene, const glm::dvec3& eye);

}  // namespace crevice
