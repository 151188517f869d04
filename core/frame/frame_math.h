// SPDX-License-Identifier: MIT
// What a frame's matrices become before a shader sees them. Products and inverses are made in
// double: a camera far from the origin would otherwise shake by the last bits of its position.
//
// And the names that a frame gives to GLSL and to conditions: the values of <crevice/frame.h>, and
// traits. The one list of each: decode knows the names by it, compile the types and defines, the
// value table the layout. findNamed looks them up.
#pragma once

#include <crevice/frame.h>

#include "core/base/text.h"

#include <glm/mat3x3.hpp>

#include <limits>

namespace crevice {

/// A camera's matrices and their inverses, in the view space of shaders: x points right and y up on
/// the picture, and the view looks along -z. Depth in clip space is 2 * window depth - 1.
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
/// `known`: traits of a frame with the same draws and materials, which are not looked at then.
SceneTraits steadyTraitsOf(const Frame& frame, const SceneTraits* known = nullptr);

/// Turns normals as `matrix` turns the surface they stand on: proportional to the inverse
/// transpose, but also right for a matrix that flattens, which has none. Rotations keep lengths.
glm::mat3 normalMatrix(const glm::dmat4& matrix);

/// Whether it has no back of its own, so that no pass culls it.
bool isSheet(const DrawItem& item, const Material& material);

/// The view of a cube with that middle, in world space, and edges along the world's axes: clip
/// space is [-1, 1] along each.
CameraMatrices boxMatrices(const glm::dvec3& center, double edge);

/// The middle of a box that follows the point `at` in world space by whole steps.
glm::dvec3 snappedTo(const glm::dvec3& at, double step);

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

/// The distance at which a `length` is a pixel of a view of `extent`; of parallel rays its pixels.
double pixelReach(const glm::dmat4& clip_from_view, const Extent& extent, double length);

/// A part of a view in shares of its size, from the lower left; empty where right < left.
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

// The frame's values: their names in GLSL, types, elements, of which more than 1 are an array, and
// imports that they come from; none for the pass itself.
#define CREVICE_FRAME_VALUES(VALUE) \
    VALUE(clip_from_view, mat4, 1, ImportType::camera) \
    VALUE(view_from_clip, mat4, 1, ImportType::camera) \
    VALUE(view_from_window, mat4, 1, ImportType::camera) \
    VALUE(view_from_world, mat4, 1, ImportType::camera) \
    VALUE(world_from_view, mat4, 1, ImportType::camera) \
    VALUE(view_from_host, mat3, 1, ImportType::camera) \
    VALUE(light_count, int_, 1, ImportType::lights) \
    VALUE(light_position, vec4, kMaxLights, ImportType::lights) \
    VALUE(light_color, vec3, kMaxLights, ImportType::lights) \
    VALUE(light_attenuation, vec3, kMaxLights, ImportType::lights) \
    VALUE(light_cone, vec4, kMaxLights, ImportType::lights) \
    VALUE(ambient_light, vec3, 1, ImportType::lights) \
    VALUE(view_size, vec2, 1, std::nullopt) \
    VALUE(viewport_size, vec2, 1, std::nullopt) \
    VALUE(first_layer, int_, 1, std::nullopt) \
    VALUE(ray_from_pixel, mat3, 1, ImportType::camera) \
    VALUE(history_valid, float_, 1, std::nullopt) \
    VALUE(frame_index, int_, 1, std::nullopt) \
    VALUE(previous_view_from_view, mat4, 1, ImportType::camera) \
    VALUE(previous_clip_from_view, mat4, 1, ImportType::camera) \
    VALUE(clip_from_model, mat4, 1, ImportType::draw_list) \
    VALUE(view_from_model, mat4, 1, ImportType::draw_list) \
    VALUE(view_normal_from_model, mat3, 1, ImportType::draw_list) \
    VALUE(base_color, vec4, 1, ImportType::draw_list) \
    VALUE(alpha_cutoff, float_, 1, ImportType::draw_list) \
    VALUE(specular, vec3, 1, ImportType::draw_list) \
    VALUE(shininess, float_, 1, ImportType::draw_list) \
    VALUE(material_ambient, float_, 1, ImportType::draw_list) \
    VALUE(normal_scale, float_, 1, ImportType::draw_list) \
    VALUE(occlusion_strength, float_, 1, ImportType::draw_list) \
    VALUE(metallic, float_, 1, ImportType::draw_list) \
    VALUE(roughness, float_, 1, ImportType::draw_list) \
    VALUE(reflectance, float_, 1, ImportType::draw_list) \
    VALUE(emission, vec3, 1, ImportType::draw_list) \
    VALUE(unlit, float_, 1, ImportType::draw_list)

enum FrameValue : std::size_t {
#define CREVICE_NAME(name, ...) name,
    CREVICE_FRAME_VALUES(CREVICE_NAME)
#undef CREVICE_NAME
        frame_value_count,
};

struct FrameValueInfo {
    const char* name;  ///< In GLSL.
    GlslType type;
    int count;                         ///< Elements; more than 1 is an array.
    std::optional<ImportType> import;  ///< Where it comes from; none for the pass itself.
};

/// By FrameValue.
inline constexpr FrameValueInfo kFrameValues[] = {
#define CREVICE_INFO(name, type, count, from) {#name, GlslType::type, count, from},
    CREVICE_FRAME_VALUES(CREVICE_INFO)
#undef CREVICE_INFO
};

/// A fact about the scene that conditions and shaders may depend on: a flag, or a count of at most
/// `most`, of which true means at least one.
struct TraitInfo {
    const char* name;    ///< In conditions.
    const char* define;  ///< In GLSL, where it is `value`.
    bool SceneTraits::*flag = nullptr;
    int SceneTraits::*count = nullptr;
    int most = 1;

    int value(const SceneTraits& traits) const
    {
        return flag ? traits.*flag : std::min(traits.*count, most);
    }
};

inline constexpr TraitInfo kTraits[] = {
    {"scene.lights", "SCENE_LIGHTS", nullptr, &SceneTraits::lights, kMaxLights},
    {"scene.alpha_tested", "SCENE_ALPHA_TESTED", &SceneTraits::alpha_tested},
    {"scene.specular", "SCENE_SPECULAR", &SceneTraits::specular},
    {"scene.textured", "SCENE_TEXTURED", &SceneTraits::textured},
    {"camera.orthographic", "CAMERA_ORTHOGRAPHIC", &SceneTraits::orthographic},
    {"camera.turned", "CAMERA_TURNED", &SceneTraits::turned},
    {"camera.reversed_depth", "CAMERA_REVERSED_DEPTH", &SceneTraits::reversed_depth},
    {"camera.views", "CAMERA_VIEWS", nullptr, &SceneTraits::views, std::numeric_limits<int>::max()},
    {"scene.normal_mapped", "SCENE_NORMAL_MAPPED", &SceneTraits::normal_mapped},
    {"scene.baked_occlusion", "SCENE_BAKED_OCCLUSION", &SceneTraits::baked_occlusion},
    {"scene.material_ambient", "SCENE_MATERIAL_AMBIENT", &SceneTraits::material_ambient},
    {"scene.blended", "SCENE_BLENDED", &SceneTraits::blended},
    {"scene.metal_mapped", "SCENE_METAL_MAPPED", &SceneTraits::metal_mapped},
    {"scene.emission_mapped", "SCENE_EMISSION_MAPPED", &SceneTraits::emission_mapped},
};

/// A texture that a material may have.
struct MaterialMapInfo {
    const char* name;  ///< Of the sampler in GLSL.
    TextureId Material::*texture;
};

inline constexpr MaterialMapInfo kMaterialMaps[] = {
    {"base_color_map", &Material::base_color_map},
    {"normal_map", &Material::normal_map},
    {"occlusion_map", &Material::occlusion_map},
    {"metallic_roughness_map", &Material::metallic_roughness_map},
    {"emission_map", &Material::emission_map},
};

}  // namespace crevice
