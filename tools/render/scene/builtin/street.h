// SPDX-License-Identifier: MIT
// The street: what rooms and spheres lack, and what screen-space occlusion errs most on.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// Thin things that hide others and gaps that nobody sees into: rails on sleepers, stacked slabs,
/// railings, poles, stairs, cars above the road, and leaves, which are open meshes. The same
/// triangles on every platform; metres.
Scene makeStreetScene();

}  // namespace crevice
