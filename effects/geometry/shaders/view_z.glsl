// SPDX-License-Identifier: MIT
// The interface `surface`'s viewZAt, by the viewPosition that was declared before this.

// View depth that stands for the background: behind everything.
const highp float kBackgroundZ = -1e30;

// View-space z of the texel at uv; kBackgroundZ in the background.
highp float viewZAt(highp vec2 at)
{
    highp vec3 point;
    return viewPosition(at, point) ? point.z : kBackgroundZ;
}
