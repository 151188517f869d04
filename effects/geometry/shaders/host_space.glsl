// SPDX-License-Identifier: MIT
// What a surface of the host's textures, which defines HOST_SPACE, stores in the host's own view space.

#include "common/host_picture.glsl"

#if defined(HOST_SPACE) && CAMERA_TURNED
highp vec3 viewFromHost(highp vec3 vector) { return view_from_host * vector; }
#else
highp vec3 viewFromHost(highp vec3 vector) { return vector; }
#endif
