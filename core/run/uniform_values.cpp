// SPDX-License-Identifier: MIT
// Filling the value table from params, frames and draws.
#include "core/run/uniform_values.h"

#include "core/sampling/generators.h"

namespace crevice {
namespace {

// Clip space is 2 wide about 0, windows 1 from 0 on.
const glm::dmat4 kClipFromWindow(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1);

// From (uv, 1) to x and y of view space, at z = 1 of a perspective view, and anywhere along
// parallel rays; the third row is (0, 0, 1). Clip space gives x + s z of it, or x + s.
glm::dmat3 rayFromUv(const glm::dmat4& clip_from_view)
{
    const bool parallel = clip_from_view[2][3] == 0.0;
    const glm::dvec4 of_rest = clip_from_view[parallel ? 3 : 2];
    const double w = of_rest.w;  // 1, or -1 as z is
    const auto column = [w](const glm::dvec4& of, double last) {
        return glm::dvec3(of.x / w, of.y / w, last);
    };
    const glm::dmat3 clip_from_ray = {column(clip_from_view[0], 0), column(clip_from_view[1], 0),
                                      column(of_rest, 1)};
    const glm::dmat3 clip_from_uv(2, 0, 0, 0, 2, 0, -1, -1, 1);
    return glm::inverse(clip_from_ray) * clip_from_uv;
}

}  // namespace

std::size_t wordsOf(GlslType type, int count)
{
    constexpr std::size_t kWords[] = {1, 2, 3, 4, 1, 2, 3, 4, 1, 1, 9, 16, 1, 1, 1, 1};
    return kWords[static_cast<int>(type)] * count;  // in the order of GlslType
}

ValueTable::ValueTable(const Plan& plan) : plan_(plan)
{
    for (const FrameValueInfo& info : kFrameValues) add(info.type, info.count);
    draw_words_ = words_.size() - drawOffset();  // a draw's are the last
    for (const PlanParam& param : plan.params) add(param.type, 1);
    for (const GeneratorDesc& generated : plan.generated)
        add(GlslType::vec3, generatesTexture(generated.generator) ? 0 : generated.count);
    for (std::size_t i = 0; i < plan.boxes.size(); ++i) add(GlslType::mat4, 1);
    for (std::size_t i = 0; i < plan.params.size(); ++i)
        setParam(static_cast<int>(i), plan.params[i].initial.data());
    write(view_size, glm::vec2(plan.extent.width, plan.extent.height));
}

void ValueTable::add(GlslType type, int count)
{
    offsets_.push_back(words_.size());
    words_.resize(words_.size() + wordsOf(type, count));
}

std::size_t ValueTable::offsetOf(const PlanUniform& uniform) const
{
    std::size_t value = uniform.index;
    if (uniform.source == UniformSource::param) value += frame_value_count;
    if (uniform.source == UniformSource::box)
        value += frame_value_count + plan_.params.size() + plan_.generated.size();
    if (uniform.source == UniformSource::kernel) value += frame_value_count + plan_.params.size();
    return offsets_[value];
}

float ValueTable::param(int index) const
{
    float value = 0;
    std::memcpy(&value, data(offsets_[frame_value_count + index]), sizeof value);
    return value;
}

void ValueTable::setParam(int index, const float* values)
{
    const std::size_t value = frame_value_count + index;
    const GlslType type = plan_.params[index].type;
    if (type == GlslType::int_) return write(value, static_cast<std::int32_t>(*values));
    std::memcpy(&words_[offsets_[value]], values, wordsOf(type, 1) * sizeof *values);
}

void ValueTable::setKernel(std::size_t generated, const std::vector<glm::vec3>& offsets)
{
    const std::size_t value = frame_value_count + plan_.params.size() + generated;
    for (std::size_t i = 0; i < offsets.size(); ++i) write(value, offsets[i], static_cast<int>(i));
}

void ValueTable::setFrame(const Frame& frame, const CameraMatrices& camera)
{
    write(clip_from_view, glm::mat4(camera.clip_from_view));
    write(view_from_clip, glm::mat4(camera.view_from_clip));
    write(view_from_window, glm::mat4(camera.view_from_clip * kClipFromWindow));
    write(view_from_world, glm::mat4(camera.view_from_world));
    write(world_from_view, glm::mat4(camera.world_from_view));
    write(view_from_host, glm::mat3(camera.view_from_host));
    ray_from_uv_ = rayFromUv(camera.clip_from_view);
    write(ambient_light, isFinite(frame.ambient_light) ? frame.ambient_light : glm::vec3(0.0f));
    Light dark;
    dark.color = glm::vec3(0.0f);
    const int count = std::min(static_cast<int>(frame.lights.size()), kMaxLights);
    write(light_count, static_cast<std::int32_t>(count));
    for (int i = 0; i < count; ++i) {
        // One that is left out keeps its place, so that shaders made for the count of lights hold.
        const Light& light = isFinite(frame.lights[i]) ? frame.lights[i] : dark;
        write(light_position, lightInView(light, camera.view_from_world), i);
        write(light_color, light.color, i);
        write(light_attenuation, light.attenuation, i);
        write(light_cone, coneInView(light, camera.view_from_world), i);
    }
}

void ValueTable::setHistory(const FrameHistory& history, const CameraMatrices& camera)
{
    const glm::dmat4 view_from_view = history.camera.view_from_world * camera.world_from_view;
    write(history_valid, history.valid ? 1.0f : 0.0f);
    write(frame_index, static_cast<std::int32_t>(history.frame_index));
    write(previous_view_from_view, glm::mat4(view_from_view));
    write(previous_clip_from_view, glm::mat4(history.camera.clip_from_view * view_from_view));
}

void ValueTable::setViewport(Extent extent)
{
    const glm::dvec2 pixel(1.0 / extent.width, 1.0 / extent.height);
    write(viewport_size, glm::vec2(extent.width, extent.height));
    write(ray_from_pixel,
          glm::mat3(ray_from_uv_[0] * pixel.x, ray_from_uv_[1] * pixel.y, ray_from_uv_[2]));
}

void ValueTable::setBox(std::size_t box, const CameraMatrices& drawn, const CameraMatrices& camera)
{
    const std::size_t value =
        frame_value_count + plan_.params.size() + plan_.generated.size() + box;
    write(value, glm::mat4(glm::inverse(kClipFromWindow) * drawn.clip_from_view *
                           drawn.view_from_world * camera.world_from_view));
}

void ValueTable::setDraw(const glm::dmat4& view_from_mesh, const Material& material,
                         const CameraMatrices& camera, bool normals)
{
    write(clip_from_model, glm::mat4(camera.clip_from_view * view_from_mesh));
    write(view_from_model, glm::mat4(view_from_mesh));
    if (normals) write(view_normal_from_model, normalMatrix(view_from_mesh));
    write(base_color, material.base_color);
    write(alpha_cutoff, material.alpha_cutoff);
    write(specular, material.specular);
    write(shininess, material.shininess);
    write(material_ambient, std::clamp(material.ambient, 0.0f, 1.0f));
    write(normal_scale, material.normal_map ? material.normal_scale : 0.0f);
    write(occlusion_strength, material.occlusion_strength);
    write(metallic, material.metallic);
    write(roughness, material.roughness);
    write(reflectance, material.reflectance);
    write(emission, material.emission);
    write(unlit, material.unlit ? 1.0f : 0.0f);
}

void ValueTable::keepDraw(std::uint32_t* words) const
{
    std::copy_n(&words_[drawOffset()], draw_words_, words);
}

void ValueTable::takeDraw(const std::uint32_t* words)
{
    std::copy_n(words, draw_words_, &words_[drawOffset()]);
}

const float* DrawCall::matrix(std::string_view name) const
{
    const FrameValueInfo* value = findNamed(kFrameValues, name);
    if (!value || (value->type != GlslType::mat4 && value->type != GlslType::mat3)) return nullptr;
    return static_cast<const float*>(values.frameValue(value - kFrameValues));
}

}  // namespace crevice
