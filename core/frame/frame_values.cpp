// SPDX-License-Identifier: MIT
#include "core/frame/frame_values.h"

#include <limits>

namespace crevice {
namespace {

constexpr auto kCamera = ImportType::camera;
constexpr auto kDrawList = ImportType::draw_list;
constexpr auto kLights = ImportType::lights;

}  // namespace

const FrameValueInfo kFrameValues[frame_value_count] = {
    {"clip_from_view", GlslType::mat4, 1, kCamera},
    {"view_from_clip", GlslType::mat4, 1, kCamera},
    {"view_from_window", GlslType::mat4, 1, kCamera},
    {"view_from_world", GlslType::mat4, 1, kCamera},
    {"world_from_view", GlslType::mat4, 1, kCamera},
    {"view_from_host", GlslType::mat3, 1, kCamera},
    {"light_count", GlslType::int_, 1, kLights},
    {"light_position", GlslType::vec4, kMaxLights, kLights},
    {"light_color", GlslType::vec3, kMaxLights, kLights},
    {"light_attenuation", GlslType::vec3, kMaxLights, kLights},
    {"light_cone", GlslType::vec4, kMaxLights, kLights},
    {"ambient_light", GlslType::vec3, 1, kLights},
    {"viewport_size", GlslType::vec2, 1, std::nullopt},
    {"ray_from_pixel", GlslType::mat3, 1, kCamera},
    {"history_valid", GlslType::float_, 1, std::nullopt},
    {"frame_index", GlslType::int_, 1, std::nullopt},
    {"previous_view_from_view", GlslType::mat4, 1, kCamera},
    {"previous_clip_from_view", GlslType::mat4, 1, kCamera},
    {"clip_from_model", GlslType::mat4, 1, kDrawList},
    {"view_from_model", GlslType::mat4, 1, kDrawList},
    {"view_normal_from_model", GlslType::mat3, 1, kDrawList},
    {"base_color", GlslType::vec4, 1, kDrawList},
    {"alpha_cutoff", GlslType::float_, 1, kDrawList},
    {"specular", GlslType::vec3, 1, kDrawList},
    {"shininess", GlslType::float_, 1, kDrawList},
    {"material_ambient", GlslType::float_, 1, kDrawList},
    {"normal_scale", GlslType::float_, 1, kDrawList},
    {"occlusion_strength", GlslType::float_, 1, kDrawList},
};

const TraitInfo kTraits[12] = {
    {"scene.lights", "SCENE_LIGHTS", nullptr, &SceneTraits::lights, kMaxLights},
    {"scene.alpha_tested", "SCENE_ALPHA_TESTED", &SceneTraits::alpha_tested},
    {"scene.sheets", "SCENE_SHEETS", &SceneTraits::sheets},
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

const MaterialMapInfo kMaterialMaps[3] = {
    {"base_color_map", &Material::base_color_map},
    {"normal_map", &Material::normal_map},
    {"occlusion_map", &Material::occlusion_map},
};

}  // namespace crevice
