// SPDX-License-Identifier: MIT
// Interface `surface`, from a host's depth and normals, whose view space may be turned.

#define HOST_SPACE
#include "geometry/shaders/depth_normal.surface.glsl"
