// SPDX-License-Identifier: MIT
// Interface `surface`, from a host's distances and normals, whose view space may be turned.

#define HOST_SPACE
#include "geometry/shaders/linear_depth_normal.surface.glsl"
