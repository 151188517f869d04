// SPDX-License-Identifier: MIT
// What a frame's matrices become before a shader sees them. Products and inverses are made in
// double: a camera far from the origin would otherwise shake by the last bits of its position.
#pragma once

#include <crevice/frame.h>

#include <glm/mat3x3.hpp>

namespace crevice {

/// A camera's matrices and their inverses, in the view space of shaders: x points right and y up on
/// the picture, and the view looks along -z. Depth in clip space is twice that in the window,
/// less 1.
struct CameraMatrices {
    glm::dmat4 clip_from_view;
    glm::dmat4 view_from_clip;
    glm::dmat4 view_from_world;
    glm::dmat4 world_from_view;
    glm::dmat3 view_from_host = glm::dmat3(1.0);  ///< From the view space of the host.
};

/// Turns, flips and mirrors the host's view space into that of shaders; 1 where they are one.
glm::dmat3 uprightTurn(const Camera& camera);

/// `clip_from_view` of that space, with depth from -1 to 1.
glm::dmat4 uprightClip(const Camera& camera);

/// Frames are counted up to here and from 0 again, which keeps them exact in a mediump int.
constexpr int kFrameIndices = 1024;

/// What a frame knows of the one before.
struct FrameHistory {
    bool valid = false;   ///< There was one, drawn by this plan.
    int frame_index = 0;  ///< Of this frame, [0, kFrameIndices).
    CameraMatrices camera = {};
};

/// Requires that `checkFrame` had nothing against the camera.
CameraMatrices cameraMatrices(const Camera& camera);

/// All but where draws lie, which takes as long as culling does and is of use to plans alone.
SceneTraits steadyTraitsOf(const Frame& frame);

/// Turns normals as `matrix` turns the surface they stand on: proportional to the inverse
/// transpose, but also right for a matrix that flattens, which has none. Rotations keep lengths.
glm::mat3 normalMatrix(const glm::dmat4& matrix);

/// Whether it has no back of its own, so that no pass culls it.
bool isSheet(const DrawItem& item, const Material& material);

/// A sphere around what an item draws, in view space. Of one without bounds the radius is below 0.
struct ViewSphere {
    glm::dvec3 center = glm::dvec3(0.0);
    double radius = -1;
};

/// `view_from_model` is the product of the view's and the item's own.
ViewSphere boundsInView(const DrawItem& item, const glm::dmat4& view_from_model);

/// What a view `wider` times as wide and high as the camera's shows: the inner side of six planes.
struct ViewVolume {
    glm::dvec4 planes[6];
    double lengths[6];  ///< Of the planes' normals.
};

ViewVolume viewVolume(const CameraMatrices& camera, double wider);

/// Whether nothing of what is drawn shows. Never true of what has no bounds.
bool isOutside(const ViewSphere& sphere, const ViewVolume& volume);

/// Whether a length comes to a pixel at no point of a sphere: `reach` is `pixelReach` of it. Never
/// true of an infinite one, nor of what has no bounds.
bool isBelowPixel(const ViewSphere& sphere, const glm::dmat4& clip_from_view, double reach);

/// The distance at which a `length` in scene units is a pixel of a view of `extent`; of parallel
/// rays, pixels that it is at any.
double pixelReach(const glm::dmat4& clip_from_view, const Extent& extent, double length);

/// A part of a view in shares of its width and height, from the lower left; empty where right <
/// left.
struct ViewArea {
    double left = 0, bottom = 0, right = 1, top = 1;
};

constexpr ViewArea kNoArea = {1, 1, 0, 0};

/// The part in which a sphere can show: all where it reaches behind the camera.
ViewArea areaOf(const ViewSphere& sphere, const glm::dmat4& clip_from_view);

/// The least that holds both.
ViewArea united(const ViewArea& area, const ViewArea& other);

/// The pixels of a picture of the view that the area touches.
PixelArea pixelsOf(const ViewArea& area, const Extent& extent);

/// A light in view space: (x, y, z, 1) of a point, (x, y, z, 0) towards a directional one.
glm::vec4 lightInView(const Light& light, const glm::dmat4& view_from_world);

/// How a light's cone dims it, as (x, y, z, w) of <crevice/frame.h>; (0, 0, 0, 1) of all but spots.
glm::vec4 coneInView(const Light& light, const glm::dmat4& view_from_world);

/// CV6011.
Diagnostic badInput(std::string what, std::string help);

/// Whether it turns right hands into left ones.
bool mirrors(const glm::dmat4& columns);

/// What of a camera no shader could draw with. Errors: CV6011, which names the view.
Status checkCamera(const Camera& camera, std::size_t view);

/// What nothing of a frame can be drawn with: a camera that is not finite or has no inverse, views
/// of which not all are orthographic or reversed. Errors: CV6011.
Status checkFrame(const Frame& frame);

/// As floats, which is what shaders get.
bool isFinite(const glm::dmat4& matrix);
bool isFinite(const glm::dvec3& vector);
bool isFinite(const Material& material);
bool isFinite(const Light& light);

/// Whether an item asks for anything to be drawn.
bool drawsSomething(const DrawItem& item);

/// Whether an item can be drawn: the host draws it or it has indices of a mesh of the device, a
/// finite matrix and bounds, and a finite material whose maps are the device's.
bool isDrawable(const Frame& frame, const DrawItem& item, const Device& device);

/// A warning CV6011 for each of the draws and lights that a frame does without, and why; draws past
/// the eighth are only counted. Items of no indices are no draws.
Diagnostics warnElided(const Frame& frame, const Device& device);

}  // namespace crevice
