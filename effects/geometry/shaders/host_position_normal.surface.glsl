// SPDX-License-Identifier: MIT
// Interface `surface`, from a host's positions and normals, whose view space may be turned.

#define HOST_SPACE
#include "geometry/shaders/position_normal.surface.glsl"
