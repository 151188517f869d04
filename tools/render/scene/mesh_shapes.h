// SPDX-License-Identifier: MIT
// Simple meshes with outward normals, for scenes that need no file.
#pragma once

#include <crevice/device.h>

#include <glm/vec3.hpp>

namespace crevice {

/// A rectangle with corners `origin`, `origin + right`, `origin + right + up` and `origin + up`; it
/// faces along cross(right, up).
MeshDesc makeQuad(const glm::vec3& origin, const glm::vec3& right, const glm::vec3& up);

/// A box between two corners, `low` below `high` in each direction; flat faces.
MeshDesc makeBox(const glm::vec3& low, const glm::vec3& high);

/// A sphere around the origin; `rings` from pole to pole, at least 2, and twice as many segments.
MeshDesc makeSphere(float radius, int rings);

/// One closed body of `count` steps that climb towards -z. It fills x in [-width / 2, width / 2],
/// y in [0, count * rise] and z in [-count * run, 0].
MeshDesc makeStairs(int count, float width, float rise, float run);

/// Adds `other` to `mesh`.
void append(MeshDesc& mesh, const MeshDesc& other);

}  // namespace crevice
