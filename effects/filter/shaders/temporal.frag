#version 300 es
// SPDX-License-Identifier: MIT
// The mean of the occlusion over frames: what each surface point had in the last frame is found where the
// camera then saw it, and the new value joins it.
//
//   surface              interface: points
//   ao                   this frame's occlusion; what is not in 0..1 is dropped. With PACKED in gba the digits of its
//                        share of depth, marked or not, in place of the surface
//   ao_filtered_history  the mean up to the last frame
//   ao_depth_history     where that was: rgb the digits of its share of depth, a the frames in the mean, over 255
//   ao_cycle_history     the pixel's `ao` when a cycle of noise last began
//   velocity             with HOST_VELOCITY: how far on the screen what a pixel sees has come since the last frame, in uv
//   ao_filtered          the mean; `ao` itself where there is no earlier frame
//   ao_depth, ao_cycle   for the next frame
//
// Under a still camera the mean stands still once it has all its frames, until the same noise gives another occlusion:
// then something has changed. Ours. Elsewhere HISTORY_CLAMP keeps the mean near what this frame has around the pixel.
// Figures are of balanced_temporal in the room, radius 1, 256x144.
// [Nehab et al. 2007; Salvi 2016 - the clamp by mean and deviation]
precision highp float;  // points and depths
precision highp int;

#define SURFACE_WITHOUT_NORMAL
#include "common/noise_cycle.glsl"
#include "common/view_space.glsl"
#include "common/depth_share.glsl"
#ifndef PACKED
#include <surface>
#endif

uniform highp mat4 previous_view_from_view;
uniform highp mat4 previous_clip_from_view;
uniform highp float history_valid;
uniform highp float history_frames;
uniform highp float history_cut;
uniform highp int frame_index;
uniform highp sampler2D ao;
uniform mediump sampler2D ao_filtered_history;
uniform highp sampler2D ao_depth_history;
uniform mediump sampler2D ao_cycle_history;
#if HOST_VELOCITY
uniform highp sampler2D velocity;
#endif

in vec2 uv;
layout(location = 0) out float ao_filtered;
layout(location = 1) out vec4 ao_depth;
layout(location = 2) out float ao_cycle;

const float kMostFrames = 255.0;

// Half the width of the clamp, in deviations: 1 takes noise for change and has an rmse of 0.0526, 1.5 one of 0.0514, 2
// one of 0.0510; no clamp has 0.0508, and ghosts.
const float kClampWidth = 2.0;

// More than an 8-bit step apart, two values of the same noise differ.
const float kSameNoise = 1.5 / 255.0;

bool isVisibility(float value) { return value >= 0.0 && value <= 1.0; }  // false for NaN

// Where the last frame saw the point that this one sees at `uv`; false behind its camera. The way a point goes, and not
// where it comes from: so a still camera finds the same texel whatever the G-buffer's size. Along the view a point that
// moves by itself is taken to stand still: history_cut allows for that.
bool previousUv(vec3 point, out vec2 before)
{
#if HOST_VELOCITY
    before = uv - texelFetch(velocity, texelAt(uv, vec2(textureSize(velocity, 0))), 0).xy;
    return true;
#else
    vec4 clip = clip_from_view * vec4(point, 1.0);
    vec4 previous = previous_clip_from_view * vec4(point, 1.0);
    before = uv + 0.5 * (previous.xy / max(previous.w, kSmallestW) - clip.xy / max(clip.w, kSmallestW));
    return previous.w > 0.0;
#endif
}

// Mean and count of frames of the point; 0 frames where the last frame did not see it. `slope` is how far the
// view depth changes by a pixel: a neighbour in a plane that leans is the same surface. That test is ours: without it
// the cut had to be 0.5, and floor that comes into view kept ghosts. Beyond twice the cut a slope is an edge: rmse of
// uncovered floor after four frames 0.115, with four times the cut 0.116, without a slope 0.113 (480x270), where a pan
// over a leaning floor then loses its history.
vec2 historyOf(vec3 point, float slope, out bool still)
{
    vec2 before;
    still = false;
    if (history_valid == 0.0 || !previousUv(point, before)) return vec2(0.0);
    float z = (previous_view_from_view * vec4(point, 1.0)).z;
    float apart = history_cut * radius + min(slope, 2.0 * history_cut * radius);
    ivec2 size = textureSize(ao_depth_history, 0);
    // To a 256th of a texel, so that a still camera's rounding does not blur.
    vec2 place = floor(clamp(before, -1.0, 2.0) * vec2(size) * 256.0 + 0.5) / 256.0 - 0.5;
    still = all(lessThan(abs(before - uv) * vec2(size), vec2(1.0 / 512.0)));
    ivec2 first = ivec2(floor(place));
    vec2 between = place - vec2(first);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        ivec2 at = first + step;
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
        vec2 share = mix(1.0 - between, between, vec2(step));
        vec4 was = texelFetch(ao_depth_history, at, 0);
        float weight = abs(zOfShare(max(shareOfDigits(was.rgb), kFarthestShare), depthUnit()) - z) < apart ? share.x * share.y : 0.0;
        sum += weight * vec3(texelFetch(ao_filtered_history, at, 0).r, was.a, 1.0);
    }
    // A sliver of a texel is no history: under 5 % of the bilinear weights, by choice.
    return sum.z > 0.05 ? sum.xy / sum.z * vec2(1.0, kMostFrames) : vec2(0.0);
}

// The mean of 5x5 pixels, of which the middle and the corners are taken, and kClampWidth deviations. All of 3x3 pixels
// are alike once filtered, and changes from frame to frame rise by 4 to 13 %; nine of 5x5 do no better than five.
vec2 rangeAround(float now)
{
    vec2 texel = 2.0 / vec2(textureSize(ao, 0));
    vec3 sum = vec3(now, now * now, 1.0);
    for (int i = 0; i < 4; ++i) {
        float value = texture(ao, uv + (vec2(i & 1, i >> 1) * 2.0 - 1.0) * texel).r;
        if (isVisibility(value)) sum += vec3(value, value * value, 1.0);
    }
    sum /= sum.z;
    return vec2(sum.x, kClampWidth * sqrt(max(sum.y - sum.x * sum.x, 0.0)));
}

// And the digits of its share of depth.
bool pointHere(out vec3 point, out vec3 digits)
{
#ifdef PACKED
    digits = texelFetch(ao, ivec2(gl_FragCoord.xy), 0).gba;
    float share = shareOfDigits(digits);
    point = viewFromDepth(uv, zOfShare(max(share, kFarthestShare), depthUnit()));
    return share > 0.0;
#else
    bool known = viewPosition(uv, point);
    digits = known ? digitsOfShare(shareOfZ(point.z, depthUnit())) : vec3(0.0);
    return known;
#endif
}

void main()
{
    vec3 point;
    vec3 digits;
    bool known = pointHere(point, digits);
    bool still = false;
    float slope = fwidth(known ? point.z : 0.0);
    vec2 history = known ? historyOf(point, slope, still) : vec2(0.0);
    float frames = floor(history.y + 0.5);
    float now = texture(ao, uv).r;
    bool usable = isVisibility(now);
    if (!usable) now = frames > 0.0 ? history.x : 1.0;
    float cycle = texelFetch(ao_cycle_history, ivec2(gl_FragCoord.xy), 0).r;
    bool begins = frame_index % kNoiseCycle == 0;
    bool settled = still && frames >= max(history_frames, float(kNoiseCycle));
    if (settled && begins && abs(now - cycle) > kSameNoise) {
        settled = false;
        frames = 1.0;
    }
#if HISTORY_CLAMP
    if (frames > 0.0 && usable && !settled) {
        vec2 range = rangeAround(now);
        history.x = clamp(history.x, range.x - range.y, range.x + range.y);
    }
#endif
    // At first each frame counts alike; then the mean is exponential.
    float earlier = min(frames, history_frames - 1.0);
    float weight = settled ? 1.0 : earlier / (earlier + 1.0);
    ao_filtered = frames > 0.0 ? mix(now, history.x, weight) : now;
    float counted = min(frames + (usable ? 1.0 : 0.0), history_frames);
    ao_depth = vec4(digits, known ? counted / kMostFrames : 0.0);
    // What a moving camera has gathered is no mean to stand still: nothing is like its noise.
    ao_cycle = still ? (begins ? now : cycle) : 1.0 - step(0.5, now);
}
