// SPDX-License-Identifier: MIT
// The interface `voxels`: how much of the space about a point surfaces fill.

#include "common/depth_share.glsl"

uniform mediump sampler3D near_voxels;
uniform highp mat4 near_box;  // from view space to [0, 1] along each edge
#if FAR_BOXES
uniform mediump sampler3D middle_voxels;
uniform mediump sampler3D far_voxels;
uniform highp mat4 middle_box;
uniform highp mat4 far_box;
#endif
uniform highp float extent;

const int kBoxes = 1 + 2 * FAR_BOXES;

const highp float kOffCentre = 1.0 / 16.0;  // of an edge: half a step, by which a box may be off the camera
const highp float kFade = 1.0 / 8.0;        // of the way to a border, over which boxes fade into each other

// One of the boxes. Its matrix is read where it is needed: kept, it takes half of a phone's registers.
struct Voxels {
    int box;
    highp float size;  // of a voxel, in scene units
};

highp mat4 boxFromView(int box)
{
#if FAR_BOXES
    if (box > 0) return box == 1 ? middle_box : far_box;
#endif
    return near_box;
}

// The largest part of a place off the middle of a box.
highp float offMiddle(highp vec3 off)
{
    off = abs(off);
    return max(off.x, max(off.y, off.z));
}

// The smallest box that has all within the radius of a point, or the largest where it has the point; false where none
// has. Within kFade of a border `noise`, in 0..1, decides. What counts is how far the point is from the camera, so that
// nothing changes when a box moves on.
bool findVoxels(highp vec3 point, mediump float noise, out Voxels voxels)
{
    for (int box = 0; box < kBoxes; ++box) {
        highp mat4 from_view = boxFromView(box);
        highp float edge = 1.0 / length(from_view[0].xyz);
        voxels = Voxels(box, edge / float(RESOLUTION));
        highp float off = offMiddle((from_view * vec4(point, 1.0)).xyz - 0.5);
        // A smaller one than was asked for has all that there is.
        if (edge < 0.99 * extent * usedRadius() * exp2(float(box)) && off < 0.5) return true;
        highp float from_camera = offMiddle(mat3(from_view) * point) + kOffCentre;
        highp float needed = box < kBoxes - 1 ? usedRadius() / edge : 0.0;
        if (max(off, from_camera) * (1.0 + kFade * noise) + needed < 0.5) return true;
    }
    return false;
}

// What share of the voxels about a place in a box surfaces fill, as seen along each edge, over 2^level voxels each
// way. Nothing is known outside of the box.
mediump vec3 fillingAt(Voxels voxels, highp vec3 place, highp float level)
{
    if (offMiddle(place - 0.5) > 0.5) return vec3(0.0);
#if FAR_BOXES
    if (voxels.box == 1) return textureLod(middle_voxels, place, level).rgb;
    if (voxels.box == 2) return textureLod(far_voxels, place, level).rgb;
#endif
    return textureLod(near_voxels, place, level).rgb;
}

const highp float kApart = 1.5;  // voxels from a surface on in which it fills nothing, filtered linearly
const highp float kOwn = 1.2;    // more than a plane's mean, since voxels of a leaning one lie unevenly

// What a surface fills itself, along each edge, of voxels that it lies in.
mediump vec3 ownFilling(Voxels voxels, mediump vec3 plane)
{
    return kOwn * abs(normalize(mat3(boxFromView(voxels.box)) * plane));
}

// What others fill of voxels of `width` at `place_over` of those over the surface.
mediump vec3 withoutOwn(mediump vec3 filled, mediump vec3 own, mediump float width, mediump float voxels_over)
{
    return max(filled - own / width * clamp(kApart - voxels_over, 0.0, 1.0), 0.0);
}
