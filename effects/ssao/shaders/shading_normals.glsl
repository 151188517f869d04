// SPDX-License-Identifier: MIT
// Whether a surface has normals besides its planes: a switch of geometry modules that store them.
#ifndef SHADING_NORMALS
#define SHADING_NORMALS 0
#endif
