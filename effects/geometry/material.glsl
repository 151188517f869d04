// SPDX-License-Identifier: MIT
// What a geometry pass asks of the mesh's material and vertex normals.

uniform vec4 base_color;
uniform vec3 specular;
#if SCENE_TEXTURED
uniform mediump sampler2D base_color_map;
#endif
#if SCENE_ALPHA_TESTED
uniform float alpha_cutoff;
#endif

// Linear colour and, in alpha, the strength of the highlight. Discards what the alpha test cuts away.
vec4 materialAlbedo(vec2 at)
{
    vec4 color = base_color;
#if SCENE_TEXTURED
    color *= texture(base_color_map, at);
#endif
#if SCENE_ALPHA_TESTED
    if (color.a < alpha_cutoff) discard;
#endif
    return vec4(color.rgb, max(specular.r, max(specular.g, specular.b)));
}

// The unit normal on the side that the camera sees. The triangle's own plane decides which side that
// is, so meshes with either winding, and seen from behind, are right; it also stands in where the
// vertex normal has no length.
highp vec3 seenNormal(highp vec3 at, highp vec3 vertex_normal)
{
    highp vec3 across = dFdx(at);
    highp vec3 up = dFdy(at);
    highp vec3 plane = cross(across / max(length(across), 1e-30), up / max(length(up), 1e-30));
    if (dot(plane, plane) == 0.0) plane = vec3(0.0, 0.0, 1.0);
    highp float size = max(abs(vertex_normal.x), max(abs(vertex_normal.y), abs(vertex_normal.z)));
    highp vec3 n = size > 0.0 ? normalize(vertex_normal / size) : normalize(plane);
    return dot(n, plane) < 0.0 ? -n : n;
}
