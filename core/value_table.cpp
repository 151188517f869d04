// SPDX-License-Identifier: MIT
// Filling the value table from params, frames and draws.
#include "core/value_table.h"

#include "core/generators.h"

#include <algorithm>

namespace crevice {
namespace {

// Values of core/frame.h; each is its own index in the table.
enum FrameValue : std::size_t {
    clip_from_view, view_from_clip, view_from_world, world_from_view, light_count, light_position,
    light_color, light_attenuation, ambient_light, viewport_size, clip_from_model, view_from_model,
    view_normal_from_model, base_color, alpha_cutoff, specular, shininess,
};

struct FrameValueInfo {
    const char* name;
    GlslType type;
    int words;
    int count;
    bool per_draw;
};

constexpr FrameValueInfo kFrameValues[] = {
    {"clip_from_view", GlslType::mat4, 16, 1, false},
    {"view_from_clip", GlslType::mat4, 16, 1, false},
    {"view_from_world", GlslType::mat4, 16, 1, false},
    {"world_from_view", GlslType::mat4, 16, 1, false},
    {"light_count", GlslType::int_, 1, 1, false},
    {"light_position", GlslType::vec4, 4, kMaxLights, false},
    {"light_color", GlslType::vec3, 3, kMaxLights, false},
    {"light_attenuation", GlslType::vec3, 3, kMaxLights, false},
    {"ambient_light", GlslType::vec3, 3, 1, false},
    {"viewport_size", GlslType::vec2, 2, 1, false},
    {"clip_from_model", GlslType::mat4, 16, 1, true},
    {"view_from_model", GlslType::mat4, 16, 1, true},
    {"view_normal_from_model", GlslType::mat3, 9, 1, true},
    {"base_color", GlslType::vec4, 4, 1, true},
    {"alpha_cutoff", GlslType::float_, 1, 1, true},
    {"specular", GlslType::vec3, 3, 1, true},
    {"shininess", GlslType::float_, 1, 1, true},
};

GlslType glslTypeOf(ParamType type)
{
    switch (type) {
    case ParamType::int_: return GlslType::int_;
    case ParamType::vec2: return GlslType::vec2;
    case ParamType::vec3: return GlslType::vec3;
    case ParamType::vec4: return GlslType::vec4;
    case ParamType::float_: break;
    }
    return GlslType::float_;
}

}  // namespace

ValueTable::ValueTable(const std::vector<ParamDesc>& params)
{
    for (const FrameValueInfo& info : kFrameValues)
        add(info.name, info.type, info.words, info.count, info.per_draw);
    for (const ParamDesc& param : params) {
        add(param.name, glslTypeOf(param.type), componentCount(param.type), 1, false);
        setParam(param);
    }
}

std::size_t ValueTable::add(std::string name, GlslType type, int words, int count, bool per_draw)
{
    values_.push_back({std::move(name), type, count, per_draw, words_.size()});
    words_.resize(words_.size() + static_cast<std::size_t>(words) * count);
    return values_.size() - 1;
}

Status ValueTable::addKernel(const GeneratedDesc& kernel)
{
    const bool hemisphere = kernel.generator == "hemisphere_kernel";
    Result<std::vector<glm::vec3>> offsets =
        makeKernel(hemisphere, kernel.count, kernel.distribution, kernel.seed);
    if (!offsets) {
        Diagnostics errors = offsets.diagnostics();
        for (Diagnostic& error : errors) {
            error.place = kernel.place;
            error.pointer = kernel.pointer;
        }
        return errors;
    }
    const std::size_t value = add(kernel.name, GlslType::vec3, 3, kernel.count, false);
    for (int i = 0; i < kernel.count; ++i) write(value, (*offsets)[i], i);
    return {};
}

const Value* ValueTable::find(std::string_view name) const
{
    for (const Value& value : values_)
        if (value.name == name) return &value;
    return nullptr;
}

void ValueTable::setParam(const ParamDesc& param)
{
    const auto value = static_cast<std::size_t>(find(param.name) - values_.data());
    if (param.type == ParamType::int_)
        return write(value, static_cast<std::int32_t>(param.value[0]));
    for (int i = 0; i < componentCount(param.type); ++i) write(value, param.value[i], i);
}

void ValueTable::setFrame(const Frame& frame, const CameraMatrices& camera)
{
    write(clip_from_view, glm::mat4(camera.clip_from_view));
    write(view_from_clip, glm::mat4(camera.view_from_clip));
    write(view_from_world, glm::mat4(camera.view_from_world));
    write(world_from_view, glm::mat4(camera.world_from_view));
    write(ambient_light, frame.ambient_light);
    const int count = std::min(static_cast<int>(frame.lights.size()), kMaxLights);
    write(light_count, static_cast<std::int32_t>(count));
    for (int i = 0; i < count; ++i) {
        write(light_position, lightInView(frame.lights[i], camera.view_from_world), i);
        write(light_color, frame.lights[i].color, i);
        write(light_attenuation, frame.lights[i].attenuation, i);
    }
}

void ValueTable::setViewport(Extent extent)
{
    write(viewport_size, glm::vec2(extent.width, extent.height));
}

void ValueTable::setDraw(const DrawItem& item, const Material& material,
                         const CameraMatrices& camera)
{
    const glm::dmat4 to_view = camera.view_from_world * glm::dmat4(item.world_from_model);
    write(clip_from_model, glm::mat4(camera.clip_from_view * to_view));
    write(view_from_model, glm::mat4(to_view));
    write(view_normal_from_model, normalMatrix(to_view));
    write(base_color, material.base_color);
    write(alpha_cutoff, material.alpha_cutoff);
    write(specular, material.specular);
    write(shininess, material.shininess);
}

}  // namespace crevice
