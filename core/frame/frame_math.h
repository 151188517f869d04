// SPDX-License-Identifier: MIT
// What a frame's matrices become before a shader sees them. Products and inverses are made in
// double: a camera far from the origin would otherwise shake by the last bits of its position.
#pragma once

#include <crevice/frame.h>

#include <glm/mat3x3.hpp>

namespace crevice {

/// A camera's matrices and their inverses, in the view space of shaders: x points right and y up on
/// the picture, and the view looks along -z.
struct CameraMatrices {
    glm::dmat4 clip_from_view;
    glm::dmat4 view_from_clip;
    glm::dmat4 view_from_world;
    glm::dmat4 world_from_view;
    glm::dmat3 view_from_host = glm::dmat3(1.0);  ///< From the view space of the host.
};

/// Turns, flips and mirrors the host's view space into that of shaders; 1 where they are one.
glm::dmat3 uprightTurn(const Camera& camera);

/// `clip_from_view` of that space.
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

/// Whether front faces of an item come out as back faces: it, the view or the projection mirrors.
bool isMirrored(const DrawItem& item, const CameraMatrices& camera);

/// Whether it has no back of its own, so that no pass culls it.
bool isSheet(const DrawItem& item, const Material& material);

/// Whether nothing of the item shows in a view `wider` times as wide and high as the camera's.
/// Never true of one without bounds.
bool isOutside(const DrawItem& item, const CameraMatrices& camera, double wider);

/// A part of a view in shares of its width and height, from the lower left; empty where right <
/// left.
struct ViewArea {
    double left = 0, bottom = 0, right = 1, top = 1;
};

/// The part in which draws can show: those at which a `length` in scene units comes to a pixel of
/// a view of `extent`, or all where it is infinite. All of the view where that is not known,
/// without bounds say.
ViewArea areaOfDraws(const std::vector<DrawItem>& draws, const CameraMatrices& camera,
                     const Extent& extent, double length);

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

bool isFinite(const glm::mat4& matrix);
bool isFinite(const glm::dmat4& matrix);
bool isFinite(const glm::vec3& vector);
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
