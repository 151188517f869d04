// SPDX-License-Identifier: MIT
// Ambient occlusion from bit masks as in ssao/shaders/bitmask.glsl, and from voxels of what the screen does not show.

#define VOXEL_RAYS
#include "ssao/bitmask/voxel_rays.glsl"
#include "ssao/shaders/bitmask.glsl"
