// SPDX-License-Identifier: MIT
// How much a neighbour counts: less the farther it lies off the pixel's tangent plane and, with FILTER_NORMALS,
// the more its normal turns. A plane is filtered alike however it lies to the camera.
// [Tomasi, Manduchi 1998, "Bilateral Filtering for Gray and Color Images"]

#define WIDEST_NORMAL 1
#include <surface>

uniform highp float radius;
uniform highp float depth_cut;
#if FILTER_NORMALS
uniform highp float normal_cut;
#endif

// A pixel's point, and its tangent plane and normal divided by the cuts.
struct Here {
    highp vec3 point;
    highp vec3 plane;
#if FILTER_NORMALS
    highp vec3 normal;
#endif
    highp float whole;  // weight of what lies in the plane, less that of a parallel normal
};

// False in the background, where nothing is to be filtered.
bool hereAt(highp vec2 at, out Here here)
{
    bool known = pointAt(at, here.point);
    highp vec3 normal_here = normalAt(at);
    highp float cut = depth_cut * radius;
    highp float per_length = 1.0 / max(cut, 1e-30);
    here.plane = normal_here * per_length;
    here.whole = cut * per_length;
#if FILTER_NORMALS
    here.normal = normal_here / normal_cut;
    here.whole -= 1.0 / normal_cut;
#endif
    return known;
}

// 0..1; 0 in the background.
highp float nearnessOf(highp vec2 at, Here here)
{
    highp vec3 point;
    bool known = pointAt(at, point);
    highp float off = abs(dot(point - here.point, here.plane));
    highp float weight = here.whole - off;
#if FILTER_NORMALS
    weight += dot(normalAt(at), here.normal);
#endif
    return known ? clamp(weight, 0.0, 1.0) : 0.0;
}
