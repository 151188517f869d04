// SPDX-License-Identifier: MIT
// What built-in scenes are put together from. Lengths are metres.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// How deep a resting body is sunk: no light leaks below it, and no eye sees it.
constexpr float kSunk = 0.002f;

/// Returns the index of the new material.
int addMaterial(Scene& scene, const char* name, const glm::vec3& color, float specular = 0.0f,
                float shininess = 16.0f);

void addObject(Scene& scene, const char* name, MeshDesc mesh, int material,
               const glm::mat4& world_from_model = glm::mat4(1.0f));

/// Moved to a spot on the floor, where it rests, and turned about the vertical.
glm::mat4 standing(float x, float z, float turn_degrees);

/// A box that stands on the middle of its base.
MeshDesc makeBlock(float width, float height, float depth);

void addCamera(Scene& scene, const char* name, const glm::vec3& eye, const glm::vec3& at);

/// Ambient light, a point light at that place and a weaker sky.
void addLights(Scene& scene, const glm::vec3& light);

/// The street: what rooms and spheres lack, and what screen-space occlusion errs most on. Thin
/// things that hide others and gaps that nobody sees into: rails on sleepers, stacked slabs,
/// railings, poles, stairs, cars above the road, and leaves, which are open meshes. The same
/// triangles on every platform; metres.
Scene makeStreetScene();

}  // namespace crevice
