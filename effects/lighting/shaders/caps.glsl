// SPDX-License-Identifier: MIT
// How open a highlight is, from the visibility alone or with the mean open direction.
//
//   [Lagarde, de Rousiers 2014 - from visibility]
//   [Jimenez et al. 2016 - cones]
//   [Oat, Sander 2007 - where two caps of a sphere overlap]

#include "common/angles.glsl"

// 1 at an open surface, 0 at a blocked one; between, sharp highlights see more of what is above them.
// `n_dot_v`, 0..1, is the cosine between normal and eye.
highp float glossOpen(highp float open, highp float n_dot_v, highp float exponent)
{
    highp float roughness = sqrt(2.0 / (exponent + 2.0));
    highp float curve = exp2(-16.0 * roughness - 1.0);
    return clamp(pow(max(n_dot_v + open, 1e-6), curve) - 1.0 + open, 0.0, 1.0);
}

// The share of the smaller of two caps, of those half angles, that lies in the other; axes `apart`, in radians.
highp float capOverlap(highp float a, highp float b, highp float apart)
{
    highp float inside = abs(a - b);
    return 1.0 - smoothstep(inside, max(a + b, inside + 1e-4), apart);
}

// The size of a cap over that of the hemisphere.
highp float capSize(highp float angle)
{
    return 1.0 - cos(angle);
}

// The part of a lobe about `mirrored` that falls into the cone of open directions about `bent`, over the
// part that falls into the open hemisphere about `normal`: an open surface gives 1.
highp float glossOpen(highp float open, highp vec3 bent, highp vec3 normal, highp vec3 mirrored,
                      highp float exponent)
{
    highp float lobe = angleOf(pow(0.01, 1.0 / exponent));
    highp float cone = angleOf(sqrt(1.0 - clamp(open, 0.0, 1.0)));
    highp float seen = capSize(min(cone, lobe)) *
                       capOverlap(cone, lobe, angleOf(clamp(dot(bent, mirrored), -1.0, 1.0)));
    highp float whole = capSize(lobe) *
                        capOverlap(1.5707963, lobe, angleOf(clamp(dot(normal, mirrored), -1.0, 1.0)));
    return clamp(seen / max(whole, 1e-6), 0.0, 1.0);
}
