// SPDX-License-Identifier: MIT
// What a surface of the host's textures, which defines HOST_SPACE, stores in the host's own view space.

#if defined(HOST_SPACE) && CAMERA_TURNED
uniform highp mat3 view_from_host;

highp vec3 viewFromHost(highp vec3 vector) { return view_from_host * vector; }
#else
highp vec3 viewFromHost(highp vec3 vector) { return vector; }
#endif
