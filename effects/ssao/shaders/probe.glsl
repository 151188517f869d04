// SPDX-License-Identifier: MIT
// The uv at which a probe is compared with what the camera sees.
//
//   GUARDS   on: probes behind the camera and off the screen are not compared. Off: they are, as most tutorials have
//            it, with what lies at the edge of the texture or on its other side:
//   OUTSIDE  clamp, or repeat. Read where GUARDS is off.

#include "common/view_space.glsl"

// False where the probe says nothing, either way.
bool uvOfProbe(highp vec3 probe, out highp vec2 at)
{
#if GUARDS
    return uvFromView(probe, at);
#else
    highp vec4 clip = clip_from_view * vec4(probe, 1.0);
    at = clip.xy / (abs(clip.w) < kSmallestW ? kSmallestW : clip.w) * 0.5 + 0.5;
#if OUTSIDE == OUTSIDE_REPEAT
    at = fract(at);
#else
    at = clamp(at, 0.0, 1.0);
#endif
    return true;
#endif
}
