// SPDX-License-Identifier: MIT
// The interface `vertex`: a vertex of a mesh in model space. A host that skins or instances gives
// another file, with attributes of its own at locations 3 and up.

layout(location = 0) in vec3 model_point;
layout(location = 1) in vec3 model_normal;
layout(location = 2) in vec2 model_uv;

vec3 modelPoint() { return model_point; }
vec3 modelNormal() { return model_normal; }
vec2 modelUv() { return model_uv; }
