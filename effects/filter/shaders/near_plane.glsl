// SPDX-License-Identifier: MIT
// How much a neighbour counts: less the farther it lies off the pixel's tangent plane, both by itself and as a slope,
// so that neither a step nor an edge is smoothed over. A plane is filtered alike however it lies to the camera.
//
// What is across an edge lies on a slope about half as steep as the normals turn, and at full size needs no normal of
// its own: those of neighbours cost half as much again and err more, by 0.3 to 11 %. Both weights fall in a straight line,
// which is ours.
//
//   surface  interface: point and normal in view space
//
// [Tomasi, Manduchi 1998, "Bilateral Filtering for Gray and Color Images"]

#define WIDEST_NORMAL 1
#include <surface>

uniform highp float radius;
uniform highp float depth_cut;
uniform highp float slope_cut;

// A pixel's point, its tangent plane, and what that is to its neighbours.
struct Here {
    highp vec3 point;
    highp vec3 normal;
    highp float per_length;  // one over the distance at which nothing counts
    highp float whole;       // weight of what lies in the plane
    highp float step;        // that its own surface may be off by, as it is stored
};

// False in the background, where nothing is to be filtered.
bool hereAt(highp vec2 at, highp vec3 normal, out Here here)
{
    bool known = viewPosition(at, here.point);
    here.normal = normal;
    highp float cut = depth_cut * radius;
    here.per_length = 1.0 / max(cut, 1e-30);
    here.whole = cut * here.per_length;
    here.step = 4.0 * depthTolerance(here.point, here.normal, 0.0);  // either point and, rebuilt from such, the normal
    return known;
}

// How far a neighbour lies off the plane, by itself and as a slope, in cuts: at 1 and more it does not count. The
// background is very far off.
highp float cutsOf(highp vec2 at, Here here)
{
    highp vec3 point;
    bool known = viewPosition(at, point);
    highp vec3 way = point - here.point;
    highp float off = abs(dot(way, here.normal));
    highp float slope = max(off - here.step, 0.0) * inversesqrt(max(dot(way, way), 1e-30));
    const highp float kFarOff = 1e4;  // whose square a float holds
    return known ? min(off * here.per_length + slope / slope_cut, kFarOff) : kFarOff;
}

// 0..1; 0 in the background.
highp float nearnessOf(highp vec2 at, Here here)
{
    return clamp(here.whole - cutsOf(at, here), 0.0, 1.0);
}
