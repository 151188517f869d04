#version 300 es
// SPDX-License-Identifier: MIT
// The median of 3x3 pixels: takes out single outliers and keeps steps.
//
//   ao           what is filtered
//   ao_filtered  the median, mixed with what was there
//
// The columns are sorted; then the median is that of the greatest of the three least, the median of
// the three middle ones and the least of the three greatest. [Smith 1996]
precision mediump float;  // 8-bit values are compared and never summed

uniform mediump sampler2D ao;
uniform mediump float median_strength;

in highp vec2 uv;
layout(location = 0) out float ao_filtered;

// Sorts a, b, c in each component.
void sort(inout vec3 a, inout vec3 b, inout vec3 c)
{
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    a = min(low, c);
    b = max(low, min(high, c));
    c = max(high, c);
}

float medianOf(vec3 v)
{
    return max(min(v.x, v.y), min(max(v.x, v.y), v.z));
}

vec3 rowAt(highp vec2 at, highp vec2 x)
{
    return vec3(texture(ao, at - x).r, texture(ao, at).r, texture(ao, at + x).r);
}

void main()
{
    highp vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    highp vec2 x = vec2(texel.x, 0.0);
    highp vec2 y = vec2(0.0, texel.y);
    vec3 least = rowAt(uv - y, x);
    vec3 middle = rowAt(uv, x);
    vec3 greatest = rowAt(uv + y, x);
    float here = middle.y;
    sort(least, middle, greatest);
    float median = medianOf(vec3(max(max(least.x, least.y), least.z), medianOf(middle),
                                 min(min(greatest.x, greatest.y), greatest.z)));
    ao_filtered = mix(here, median, median_strength);
}
