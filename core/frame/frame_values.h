// SPDX-License-Identifier: MIT
// The names that a frame gives to GLSL and to conditions: the values of <crevice/frame.h> and the
// traits.
//
// Private to core, and the one list of each: decode knows the names by it, compile the types and
// defines, the value table the layout. findNamed looks them up.
#pragma once

#include <crevice/frame.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace crevice {

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
    VALUE(viewport_size, vec2, 1, std::nullopt) \
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
    VALUE(occlusion_strength, float_, 1, ImportType::draw_list)

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
    void set(SceneTraits& traits, int value) const
    {
        if (flag)
            traits.*flag = value != 0;
        else
            traits.*count = value;
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
};

}  // namespace crevice
