// SPDX-License-Identifier: MIT
// The names that a frame gives to GLSL and to conditions: the values of <crevice/frame.h> and the
// traits.
//
// Private to core, and the one list of each: decode knows the names by it, compile the types and
// defines, the value table the layout. findNamed looks them up.
#pragma once

#include <crevice/frame.h>

#include <algorithm>
#include <optional>

namespace crevice {

/// The frame's values, in the order of `kFrameValues`.
enum FrameValue : std::size_t {
    clip_from_view,
    view_from_clip,
    view_from_window,
    view_from_world,
    world_from_view,
    view_from_host,
    light_count,
    light_position,
    light_color,
    light_attenuation,
    light_cone,
    ambient_light,
    viewport_size,
    ray_from_pixel,
    history_valid,
    frame_index,
    previous_view_from_view,
    previous_clip_from_view,
    clip_from_model,
    view_from_model,
    view_normal_from_model,
    base_color,
    alpha_cutoff,
    specular,
    shininess,
    material_ambient,
    normal_scale,
    occlusion_strength,
    frame_value_count,
};

struct FrameValueInfo {
    const char* name;  ///< In GLSL.
    GlslType type;
    int count;                         ///< Elements; more than 1 is an array.
    std::optional<ImportType> import;  ///< Where it comes from; none for the pass itself.
};

extern const FrameValueInfo kFrameValues[frame_value_count];

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

extern const TraitInfo kTraits[12];

/// A texture that a material may have.
struct MaterialMapInfo {
    const char* name;  ///< Of the sampler in GLSL.
    TextureId Material::*texture;
};

extern const MaterialMapInfo kMaterialMaps[3];

}  // namespace crevice
