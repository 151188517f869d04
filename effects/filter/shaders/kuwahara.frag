#version 300 es
// SPDX-License-Identifier: MIT
// The mean of the quietest of four windows that meet in the pixel.
//
//   ao           what is filtered
//   ao_filtered  that mean
//
// Beside an edge in the occlusion the quietest window is the one that does not reach across it, so that
// shadows stay crisp without any geometry. Windows of BLUR_RADIUS + 1 pixels a side: with 4 of them noise
// that repeats every four pixels leaves no trace in their means.
// [Kuwahara et al. 1976, "Processing of RI-angiocardiographic images"] - the four windows
precision highp float;  // a small variance is the difference of large sums

uniform mediump sampler2D ao;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// Variance and mean of the window that reaches from the pixel in that direction.
vec2 windowTowards(vec2 texel)
{
    const float share = 1.0 / float((BLUR_RADIUS + 1) * (BLUR_RADIUS + 1));
    vec2 sum = vec2(0.0);
    for (int y = 0; y <= BLUR_RADIUS; ++y)
        for (int x = 0; x <= BLUR_RADIUS; ++x) {
            float value = texture(ao, uv + vec2(x, y) * texel).r;
            sum += vec2(value * value, value);
        }
    vec2 means = sum * share;
    return vec2(means.x - means.y * means.y, means.y);
}

vec2 quieter(vec2 a, vec2 b)
{
    return b.x < a.x ? b : a;
}

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    vec2 left = quieter(windowTowards(-texel), windowTowards(vec2(-texel.x, texel.y)));
    vec2 right = quieter(windowTowards(vec2(texel.x, -texel.y)), windowTowards(texel));
    ao_filtered = quieter(left, right).y;
}
