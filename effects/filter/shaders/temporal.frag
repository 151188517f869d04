#version 300 es
// SPDX-License-Identifier: MIT
// The mean of the occlusion over frames: what each surface point had in the last frame is found where the
// camera then saw it, and the new value joins it.
//
//   surface              interface: points
//   ao                   this frame's occlusion; what is not in 0..1 is dropped
//   ao_filtered_history  the mean up to the last frame
//   ao_depth_history     where that was: rgb view depth, a the frames in the mean, over 255
//   ao_filtered          the mean; `ao` itself where there is no earlier frame
//   ao_depth             for the next frame
//
// Objects that move by themselves have no history where they arrive and leave none behind, as far as the depth test
// finds them; HISTORY_CLAMP clamps the rest to the range that this frame has around the pixel.
// [Nehab et al. 2007, "Accelerating Real-Time Shading with Reverse Reprojection Caching"]
// [Karis 2014, "High Quality Temporal Supersampling" - the clamp to the range of 3x3 pixels]
precision highp float;  // points and depths

#define SURFACE_WITHOUT_NORMAL
#include "common/view_space.glsl"
#include <surface>

uniform highp mat4 previous_view_from_view;
uniform highp mat4 previous_clip_from_view;
uniform highp float history_valid;
uniform highp float history_weight;
uniform highp float history_cut;
uniform highp float radius;
uniform mediump sampler2D ao;
uniform mediump sampler2D ao_filtered_history;
uniform highp sampler2D ao_depth_history;

in vec2 uv;
layout(location = 0) out float ao_filtered;
layout(location = 1) out vec4 ao_depth;

const float kMostFrames = 255.0;
const vec3 kDigits = vec3(1.0, 255.0, 65025.0);  // 24 bits of a number in three of 8

// View z to and from three digits. Finest near the camera: a thousandth of a radius at a hundred of them
// away, a tenth at a thousand, where a radius is less than a pixel. The curve, 1 / (1 + radii), is ours.
// [Pranckevicius 2009, "Encoding Floats to RGBA - the Final?" - the digits]
vec3 digitsOf(float z)
{
    float radii = z / max(radius, 1e-30);
    float far = 0.5 / (1.0 + abs(radii));
    vec3 digits = fract(min(radii > 0.0 ? 1.0 - far : far, 0.9999999) * kDigits);
    return digits - vec3(digits.yz / 255.0, 0.0);
}

float zOf(vec3 digits)
{
    float place = dot(digits, 1.0 / kDigits);
    float far = max(min(place, 1.0 - place), 1e-8);
    return sign(place - 0.5) * (0.5 / far - 1.0) * radius;
}

bool isVisibility(float value) { return value >= 0.0 && value <= 1.0; }  // false for NaN

// Where the last frame saw the point that this one sees at `uv`; false behind its camera. The way a point
// goes, and not where it comes from: so a still camera finds the same texel whatever the G-buffer's size.
bool previousUv(vec3 point, out vec2 before)
{
    vec4 clip = clip_from_view * vec4(point, 1.0);
    vec4 previous = previous_clip_from_view * vec4(point, 1.0);
    before = uv + 0.5 * (previous.xy / max(previous.w, kSmallestW) - clip.xy / max(clip.w, kSmallestW));
    return previous.w > 0.0;
}

// Mean and count of frames of the point; 0 frames where the last frame did not see it.
vec2 historyOf(vec3 point)
{
    vec2 before;
    if (history_valid == 0.0 || !previousUv(point, before)) return vec2(0.0);
    float z = (previous_view_from_view * vec4(point, 1.0)).z;
    ivec2 size = textureSize(ao_depth_history, 0);
    vec2 place = clamp(before, -1.0, 2.0) * vec2(size) - 0.5;
    ivec2 first = ivec2(floor(place));
    vec2 between = place - vec2(first);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        ivec2 at = first + step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
        vec2 share = mix(1.0 - between, between, vec2(step));
        vec4 was = texelFetch(ao_depth_history, at, 0);
        float weight = abs(zOf(was.rgb) - z) < history_cut * radius ? share.x * share.y : 0.0;
        sum += weight * vec3(texelFetch(ao_filtered_history, at, 0).r, was.a, 1.0);
    }
    // A sliver of a texel is no history: under 5 % of the bilinear weights, by choice.
    return sum.z > 0.05 ? sum.xy / sum.z * vec2(1.0, kMostFrames) : vec2(0.0);
}

// The least and the greatest value about the pixel.
vec2 rangeAround(float now)
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    vec2 range = vec2(now);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            float value = texture(ao, uv + vec2(x, y) * texel).r;
            if (isVisibility(value)) range = vec2(min(range.x, value), max(range.y, value));
        }
    return range;
}

void main()
{
    vec3 point;
    bool known = viewPosition(uv, point);
    vec2 history = known ? historyOf(point) : vec2(0.0);
    float frames = floor(history.y + 0.5);
    float now = texture(ao, uv).r;
    bool usable = isVisibility(now);
    if (!usable) now = frames > 0.0 ? history.x : 1.0;
#if HISTORY_CLAMP
    if (frames > 0.0 && usable) {
        vec2 range = rangeAround(now);
        history.x = clamp(history.x, range.x, range.y);
    }
#endif
    // At first each frame counts alike; then the mean is exponential, over 1 / (1 - history_weight) frames.
    float weight = min(frames / (frames + 1.0), history_weight);
    ao_filtered = frames > 0.0 ? mix(now, history.x, weight) : now;
    ao_depth = vec4(known ? digitsOf(point.z) : vec3(0.0),
                    known ? min(frames + (usable ? 1.0 : 0.0), kMostFrames) / kMostFrames : 0.0);
}
