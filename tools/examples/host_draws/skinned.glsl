// SPDX-License-Identifier: MIT
// The interface `vertex`: each vertex moves with a mixture of two bones, which the host holds in a
// uniform block. Copies stand side by side.
layout(location = 0) in vec3 rest_point;
layout(location = 1) in vec3 rest_normal;
layout(location = 3) in float weight;  // of the second bone; 0 where a mesh has no such array

layout(std140) uniform Bones {
    mat4 bones[2];
};

const vec3 kApart = vec3(1.0, 0.0, 0.0);

mat4 skin() { return bones[0] * (1.0 - weight) + bones[1] * weight; }
vec3 modelPoint() { return (skin() * vec4(rest_point, 1.0)).xyz + kApart * float(gl_InstanceID); }
vec3 modelNormal() { return mat3(skin()) * rest_normal; }
vec2 modelUv() { return vec2(0.0); }
