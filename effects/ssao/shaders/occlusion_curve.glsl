// SPDX-License-Identifier: MIT
// From the occluded share of the samples to the visibility that is stored. The power is the authors' usual last
// step [Chapman 2013; Strugar, McCalla 2021]; with 1 nothing is fitted.

uniform highp float intensity;
uniform highp float power;

// 1 open .. 0 blocked; `occlusion` in 0..1.
highp float visibilityOf(highp float occlusion)
{
    return pow(clamp(1.0 - intensity * occlusion, 0.0, 1.0), power);
}
