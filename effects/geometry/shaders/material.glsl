// SPDX-License-Identifier: MIT
// What a geometry pass asks of the mesh's material and vertex normals.

uniform vec4 base_color;
uniform vec3 specular;
#if SCENE_MATERIAL_AMBIENT
uniform float material_ambient;
#endif
#if SCENE_TEXTURED
uniform mediump sampler2D base_color_map;
#endif
#if SCENE_ALPHA_TESTED
uniform float alpha_cutoff;
#endif
#if SCENE_NORMAL_MAPPED
uniform mediump sampler2D normal_map;
uniform float normal_scale;
#endif
#if SCENE_BAKED_OCCLUSION
uniform mediump sampler2D occlusion_map;
uniform float occlusion_strength;
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

// How much it hides of what lies behind.
float materialAlpha(vec2 at)
{
    float alpha = base_color.a;
#if SCENE_TEXTURED
    alpha *= texture(base_color_map, at).a;
#endif
    return clamp(alpha, 0.0, 1.0);
}

// The unit normal of the triangle, on the side that the camera sees.
highp vec3 planeOf(highp vec3 at)
{
    highp vec3 across = dFdx(at);
    highp vec3 up = dFdy(at);
    highp vec3 plane = cross(across / max(length(across), 1e-30), up / max(length(up), 1e-30));
    highp float size = max(abs(plane.x), max(abs(plane.y), abs(plane.z)));
    if (!(size > 0.0)) return vec3(0.0, 0.0, 1.0);
    // Of a pixel at a horizon the neighbour may be extrapolated to behind the camera, which turns the product.
#if CAMERA_ORTHOGRAPHIC
    bool turned = plane.z < 0.0;
#else
    bool turned = dot(plane, at) > 0.0;
#endif
    return normalize(turned ? -plane / size : plane / size);
}

// The unit normal on the side that the camera sees. The triangle's plane, planeOf, decides which side that is, so
// meshes with either winding, and seen from behind, are right; it also stands in where the vertex normal has no length.
highp vec3 seenNormal(highp vec3 plane, highp vec3 vertex_normal)
{
    highp float size = max(abs(vertex_normal.x), max(abs(vertex_normal.y), abs(vertex_normal.z)));
    highp vec3 n = size > 0.0 ? normalize(vertex_normal / size) : plane;
    return dot(n, plane) < 0.0 ? -n : n;
}

#if SCENE_NORMAL_MAPPED
// Columns: where the texture's u and v grow along the surface, both over the longer one, and n. Needs no
// tangents in the mesh. [Mikkelsen 2010; Schueler 2013]
highp mat3 textureFrame(highp vec3 at, highp vec2 map_uv, highp vec3 n)
{
    highp vec3 across = dFdx(at);
    highp vec3 up = dFdy(at);
    highp vec2 uv_across = dFdx(map_uv);
    highp vec2 uv_up = dFdy(map_uv);
    // Lengths alone, so that scenes of any scale stay within floats.
    highp float size = max(max(length(across), length(up)), 1e-30);
    highp float uv_size = max(max(length(uv_across), length(uv_up)), 1e-30);
    highp vec3 by_across = cross(up / size, n);
    highp vec3 by_up = cross(n, across / size);
    highp vec3 u = (by_across * uv_across.x + by_up * uv_up.x) / uv_size;
    highp vec3 v = (by_across * uv_across.y + by_up * uv_up.y) / uv_size;
    highp float longer = sqrt(max(max(dot(u, u), dot(v, v)), 1e-30));
    return mat3(u / longer, v / longer, n);
}
#endif

// As seenNormal, tilted by the material's normal map where both that and `map_uv` are numbers.
highp vec3 materialNormal(highp vec3 at, highp vec3 plane, highp vec3 vertex_normal, highp vec2 map_uv)
{
    highp vec3 n = seenNormal(plane, vertex_normal);
#if SCENE_NORMAL_MAPPED
    highp vec3 tilt = texture(normal_map, map_uv).xyz * 2.0 - 1.0;
    highp vec3 tilted = textureFrame(at, map_uv, n) * vec3(tilt.xy * normal_scale, max(tilt.z, 1e-3));
    highp float size = dot(tilted, tilted);
    if (size > 0.0 && size < 1e30) n = tilted * inversesqrt(size);
#endif
    return n;
}

// The material's baked visibility, 1 open.
mediump float materialOpen(highp vec2 map_uv)
{
#if SCENE_BAKED_OCCLUSION
    return 1.0 + occlusion_strength * (texture(occlusion_map, map_uv).r - 1.0);
#else
    return 1.0;
#endif
}
