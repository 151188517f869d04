// SPDX-License-Identifier: MIT
// What the estimators that march over the screen share: the pixel's slices, where their taps lie, and what taps see.
//
//   source_depth   view depth as a share, with the guard band; 0 in the background
//   source_normal  normal in view space, and in alpha how far off its plane the surface may come out
//   source_plane   with SHADING_NORMALS: the normal of that plane
//
// Taps lie on a straight line of texels, which a slice through the view ray is on the screen. Lengths of what a tap
// sees are in radii. What lives from tap to tap is a few numbers: a phone's core has 32 registers for full speed. Loops
// ask at the end of their bodies too: llvmpipe, which runs eight pixels side by side, would run them once more for none.

#include "common/host_picture.glsl"
#include "common/pixel_noise.glsl"
#include "common/pixel_ray.glsl"
#include "common/tolerance.glsl"
#include "common/uneven_step.glsl"
#include "ssao/shaders/shading_normals.glsl"

uniform highp sampler2D source_depth;
#ifndef MARCH_FROM_VIEW
uniform mediump sampler2D source_normal;
#if SHADING_NORMALS
uniform mediump sampler2D source_plane;
#endif
#endif
uniform highp float bias;
uniform highp vec2 viewport_size;

const highp float kPi = 3.14159265;

// The picture that is marched, whose pixels those below are: the view, a tile of it (hbao_plus.frag), or for pixels of
// the view a smaller one (march_missing.frag).
#ifdef MARCH_FROM_VIEW
highp ivec2 sourceSize() { return textureSize(MARCH_FROM_VIEW, 0); }
highp vec2 marchedSize() { return vec2(sourceSize()); }
highp vec2 stride() { return viewport_size / marchedSize(); }  // from one of its pixels to the next, in the view's
#else
highp ivec2 sourceSize() { return ivec2(viewport_size); }
#ifndef MARCH_IN_TILES
highp vec2 marchedSize() { return viewport_size; }
highp vec2 stride() { return vec2(1.0); }
#endif
#endif
#ifndef MARCH_IN_TILES
highp vec2 inView(highp vec2 pixel) { return pixel * stride(); }
highp ivec2 marchedTexel(highp vec2 pixel) { return ivec2(pixel); }  // without the guard band
#endif

#ifdef MARCH_FROM_VIEW
const int kSlices = SLICES + 1;
#else
const int kSlices = SLICES;
#endif

// One pixel and its surface. Lengths in radii.
struct March {
    highp vec3 point;        // view space, lifted off its own surface
    highp float radius;      // what lengths are counted in, in scene units: the radius, or four screens
    highp float unit;        // of the shares of depth
    highp vec2 pixel;        // its middle
    highp ivec2 band;        // the guard band's texels on either side
    mediump vec3 normal;     // weighs light
    mediump vec3 plane;      // normal of the surface's plane
    mediump float nearness;  // one over the camera's distance
    mediump vec2 noise;      // 0..1: turns the slices, shifts the taps
};

// The point at view depth `z` behind a pixel; lengths in radii.
highp vec3 pointOn(March march, highp vec2 pixel, highp float z)
{
    pixel = inView(pixel);
    highp vec2 ray = (ray_from_pixel * vec3(pixel, 1.0)).xy;
#if CAMERA_ORTHOGRAPHIC
    return vec3(ray / march.radius, z);
#else
    return vec3(ray * z, z);
#endif
}

// How far from the middle a sphere of one radius ends for the eye, measured across the view ray: at the distance d
// 1 / sqrt(1 - 1 / d^2), and at most sqrt(5), since an eye within the sphere sees no end. That bound is ours.
highp float seenReach(highp vec3 point)
{
#if CAMERA_ORTHOGRAPHIC
    return 1.0;
#else
    return inversesqrt(max(1.0 - 1.0 / max(dot(point, point), 1e-30), 0.2));
#endif
}

// The direction to the camera, unit. Computed where it is read: kept, it takes registers from tap to tap.
mediump vec3 toCamera(highp vec2 pixel) { return normalize(rayThrough(inView(pixel))); }

// A normal that leans away from the camera is bent until the cosine to it is this.
const mediump float kLeastFacing = 0.05;

// From a surface's `share` of depth, its normals of light and of its plane, and how far off that it may come out.
void marchOf(highp vec2 pixel, highp float share, mediump vec3 normal, mediump vec3 plane, mediump float stored_tolerance,
             out March march)
{
    march.band = (textureSize(source_depth, 0) - sourceSize()) / 2;
    march.normal = normal;
    march.plane = plane;
    highp float z = zOfShare(share, depthUnit());
    highp vec2 shown = usedRadius() / abs(vec2(ray_from_pixel[0].x, ray_from_pixel[1].y));
#if !CAMERA_ORTHOGRAPHIC
    shown /= max(abs(z), 1e-30);
#endif
    // Taps lie within the screen: of a wider radius four screens, so that they are not too near for 16 bits.
    highp float screens = max(shown.x / viewport_size.x, shown.y / viewport_size.y);
    highp float wider = max(0.25 * screens, 1.0);
    march.radius = usedRadius() / wider;
    march.unit = depthUnit() / march.radius;
    highp vec3 point = pointOn(march, pixel, z / march.radius);
#if CAMERA_ORTHOGRAPHIC
    march.nearness = 0.0;
#else
    march.nearness = inversesqrt(dot(point, point));
#endif
    // Of a radius wider than the screen the screen's share.
    highp float lift = bias * wider / max(screens, 1.0);
#if SHADING_NORMALS
    mediump vec3 camera = toCamera(pixel);
    march.normal = normalize(march.normal + camera * max(kLeastFacing - dot(march.normal, camera), 0.0));
#endif
    highp float facing = abs(dot(march.plane, rayThrough(inView(pixel))));
    highp float rounding = shareStep(share) / march.radius * facing;
    highp float tolerance = stored_tolerance > 0.0 ? toleranceOf(stored_tolerance) * wider : 0.0;  // the least is no more
    march.point = point + march.plane * max(lift, max(rounding, tolerance));
    march.pixel = pixel;
#ifdef MARCH_FROM_VIEW
    march.noise = vec2(0.5);  // no filter smooths it
#else
    march.noise = pixelNoise(hostPixel(inView(pixel), viewport_size));
#endif
}

#ifndef MARCH_FROM_VIEW
// False in the background.
bool marchFrom(highp vec2 pixel, out March march)
{
    highp ivec2 texel = marchedTexel(pixel) + (textureSize(source_depth, 0) - sourceSize()) / 2;
    highp float stored = texelFetch(source_depth, texel, 0).r;
    mediump vec4 normal = texelFetch(source_normal, texel, 0);
    mediump vec3 plane = normal.xyz;
#if SHADING_NORMALS
    plane = texelFetch(source_plane, texel, 0).xyz;
#endif
    marchOf(pixel, max(stored, kFarthestShare), normalize(normal.xyz * 2.0 - 1.0), normalize(plane * 2.0 - 1.0),
            normal.a, march);
    return stored > 0.0;
}
#endif

// One side of a slice through the hemisphere. Within the slice lengths have x along the surface's plane, y over it.
struct Side {
    mediump vec3 along;   // unit, perpendicular to the direction to the camera
    mediump vec3 x;       // axis of what lies within the slice; its y, along the plane's normal, is 0 in the plane
    mediump float height; // y of a point one radius over the plane
    mediump vec2 towards; // the camera, within the slice
    mediump vec2 lean;    // cosine and sine of the angle from the level that the normal has up to the plane
    mediump float cos_n;  // cosine of the angle between the view ray and the normal's projection onto the slice
    mediump float sin_n;  // its sine, positive where the normal leans towards this side
    mediump float projected_length;  // of the unit normal, projected onto the slice
    mediump float below;  // the light below the plane
    mediump float whole;  // the light of all of it, over the plane
    highp vec2 step;     // from tap to tap where they lie evenly, in pixels
    highp vec2 first;    // where the first of those lies
    highp float pixel;   // one, of all steps
    bool cut;            // the screen or its guard band ends before the radius does
};

// From over the plane to over the normal's level.
mediump vec2 overLevel(Side side, mediump vec2 at)
{
#if SHADING_NORMALS
    return vec2(at.x * side.lean.x - at.y * side.lean.y, at.y * side.lean.x + at.x * side.lean.y);
#else
    return at;
#endif
}

// The light from the normal's level up to where the cosine of the angle over it is `c`: of the angle less its sine times
// its cosine a polynomial that is right at both ends, and to within 0.005 between. Ours.
mediump float lightUpTo(mediump float cos_n, mediump float sin_n, mediump float c)
{
    mediump float square = c * c;
    mediump float across = 0.7853982 - c * (0.9853982 - square * (0.0917877 + square * 0.1082123));
    return cos_n * (0.5 - 0.5 * square) + sin_n * across;
}

// Of a direction: over the plane, and on this side of the camera, beyond which only texels beside the line are.
bool isOver(Side side, mediump vec2 to) { return to.y > 0.0 && to.x >= min(side.towards.x, 0.0); }

// The light below what stands `at`; below what lies under the plane as much as below that.
mediump float lightUnder(Side side, mediump vec2 at)
{
    at *= inversesqrt(max(dot(at, at), 1e-5));
    mediump vec2 over = isOver(side, at) ? overLevel(side, at) : side.lean;
    return lightUpTo(side.cos_n, side.sin_n, over.y > 0.0 ? over.x : 1.0);
}

// How many `way`s from `at`, within the radius, one leaves it: t of |at + t way| = 1. 0 or more.
mediump float leaving(mediump vec2 at, mediump vec2 way)
{
    mediump float a = max(dot(way, way), 1e-4);
    mediump float b = dot(at, way);
    return max((sqrt(max(b * b - a * (dot(at, at) - 1.0), 0.0)) - b) / a, 0.0);
}

// Slices lie evenly over half a turn about the view ray, not on the screen: towards the edge of a wide view
// the two differ by a third. Taps lie from the pixel to somewhat beyond the radius, so that the surface is seen to leave
// it, and at most up to the edge; the first is a pixel away, at least. Ours.
// [Jimenez et al. 2016: lines 5 to 15 of algorithm 1, which turns about the view axis]
Side sideOf(March march, int i)
{
    // Evenly over a turn.
    mediump float angle = kPi / float(kSlices) * (march.noise.x + float(i));
    mediump vec2 turn = vec2(cos(angle), sin(angle));
    Side side;
    mediump vec3 camera = toCamera(march.pixel);
    mediump vec3 to_camera = hostFromPicture(camera);
    mediump vec3 right = normalize(vec3(max(to_camera.z, 1e-3), 0.0, -to_camera.x));
    mediump vec3 along = pictureFromHost(turn.x * right + turn.y * cross(to_camera, right));
    mediump vec2 projected = vec2(dot(march.normal, camera), dot(march.normal, along));
    mediump float inverse_length = inversesqrt(max(dot(projected, projected), 1e-3));
    side.along = along;
    side.cos_n = projected.x * inverse_length;
    side.sin_n = projected.y * inverse_length;
    side.projected_length = 1.0 / inverse_length;
    side.lean = vec2(1.0, 0.0);
    side.towards = vec2(-side.sin_n, side.cos_n);
    side.height = inverse_length;
#if SHADING_NORMALS
    mediump vec2 plane = vec2(dot(march.plane, camera), dot(march.plane, along));
    mediump float inverse_plane = inversesqrt(max(dot(plane, plane), 1e-3));
    plane *= inverse_plane;
    side.lean = vec2(dot(projected, plane), projected.y * plane.x - projected.x * plane.y);
    side.lean *= inverse_length;
    side.towards = vec2(-plane.y, plane.x);
    side.height = inverse_plane;
#endif
    side.x = side.towards.y * along + side.towards.x * camera;
    side.below = side.lean.y > 0.0 ? lightUpTo(side.cos_n, side.sin_n, side.lean.x) : 0.0;
    side.whole = max(lightUpTo(side.cos_n, side.sin_n, -side.sin_n) - side.below, 1e-2);
    highp vec3 way = seenReach(march.point) * along;
#if !CAMERA_ORTHOGRAPHIC
    highp vec2 ray = march.point.xy / march.point.z;
    way.xy = (way.xy - ray * way.z) / min(march.point.z + way.z, 0.05 * march.point.z);
#endif
    highp vec2 pixels = way.xy / (stride() * vec2(ray_from_pixel[0].x, ray_from_pixel[1].y));
#if CAMERA_ORTHOGRAPHIC
    pixels *= march.radius;
#endif
    highp vec2 band = vec2(march.band);
    highp vec2 room = mix(march.pixel, marchedSize() - march.pixel, step(0.0, pixels)) + band - 0.5;
    room /= max(abs(pixels), 1e-6);
    highp float edge = min(room.x, room.y);
    side.step = pixels * min(1.0 / (float(STEPS) - 0.6), edge / float(STEPS));
    side.cut = edge < 1.0;
    highp float least = inversesqrt(max(dot(side.step, side.step), 1e-12));
    side.pixel = least / float(STEPS);
    least = min(least, max(edge * (float(STEPS) - 0.6), float(STEPS)) - float(STEPS - 1));  // the last within the edge
    side.first = march.pixel + side.step * max(march.noise.y, least);
    return side;
}

// How far along all steps a tap lies, 0..1: of more than three, closer near the pixel, where what is small blocks much;
// none on another's texel. [Strugar, McCalla 2021 - with a power]
highp float placeOf(March march, Side side, int i)
{
    highp float even = (float(i) + march.noise.y) / float(STEPS);
    highp float closer = min(0.4 + 1.8 / float(STEPS), 1.0);
    return min(max(even * mix(closer, 1.0, even), side.pixel * float(i + 1)), 1.0);
}

// The texel that a tap reads that lies a `way` from the pixel. Far off only every fourth row is read, the next towards
// the middle of the picture: a quarter of the memory, which caches hold. At 1920x1080 on a CPU, radius 10 in the room,
// the pass takes 204 ms in balanced, with all rows 289; rmse changes by 1 % or less. Pixels marched for themselves are
// too few for that.
highp vec2 texelOf(March march, highp vec2 way)
{
    highp vec2 texel = floor(march.pixel + way);
#ifndef MARCH_FROM_VIEW
    const highp float kFarPixels = 64.0;
    highp float middle = floor(0.5 * marchedSize().y);
    if (max(abs(way.x), abs(way.y)) > kFarPixels) texel.y = middle + 4.0 * trunc(0.25 * (texel.y - middle));
#endif
#ifdef MARCH_IN_TILES
    texel = clamp(texel, vec2(0.0), marchedSize() - 1.0);  // beyond the edge lies another tile
#endif
    return texel;
}

// In radii. Squares of it are within 16 bits.
const highp float kFar = 40.0;

// What the tap that reads `texel` sees, from the point. Far off it is nearer than it is, within what 16 bits hold.
mediump vec3 offsetAt(March march, highp vec2 texel)
{
    highp float share = texelFetch(source_depth, marchedTexel(texel) + march.band, 0).r;
    highp float z = clamp(zOfShare(share, march.unit), march.point.z - kFar, march.point.z + kFar);
    return pointOn(march, texel + 0.5, z) - march.point;
}

// Within the slice, turned into it about the normal: texels lie beside the line.
mediump vec2 withinSlice(March march, Side side, mediump vec3 offset)
{
    mediump float y = clamp(dot(offset, march.plane) * side.height, -kFar, kFar);
    mediump float x = sqrt(max(dot(offset, offset) - y * y, 0.0));
    return vec2(dot(offset, side.x) < 0.0 ? -x : x, y);
}

// How much of the hidden space between two neighbouring taps counts as filled: the wider the gap, the likelier it is
// open. `gap` is in units of one that is filled by half. Ours.
mediump float filledShare(mediump float gap)
{
    return 1.0 / (1.0 + gap * gap);
}

// 1 where the radius is two pixels or more across the view, 0 where it is below one: no tap is nearer, and there is
// nothing to see. Ours; XeGTAO fades as well, from ten pixels on.
mediump float radiusFade(March march)
{
    highp vec2 size = abs(vec2(ray_from_pixel[0].x, ray_from_pixel[1].y));
    highp float pixel = min(size.x, size.y);
#ifdef MARCH_FROM_VIEW
    pixel *= stride().x;
#endif
#if CAMERA_ORTHOGRAPHIC
    highp float shown = march.radius / max(pixel, 1e-30);
#else
    highp float shown = 1.0 / max(pixel * abs(march.point.z), 1e-30);
#endif
    return clamp(shown - 1.0, 0.0, 1.0);
}
