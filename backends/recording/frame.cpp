// SPDX-License-Identifier: MIT
// The recording device inside a frame: what is drawn in which order, and with which content.
#include <crevice/recording_device.h>

#include "core/run/uniform_values.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace crevice {

Status RecordingDevice::beginFrame()
{
    if (Status status = checkContext("the frame"); !status) return status;
    if (in_frame_) blame("beginFrame inside a frame");
    in_frame_ = true;
    timers_begun_ = 0;
    record(Call::begin_frame);
    return {};
}

Status RecordingDevice::endFrame()
{
    if (!in_frame_ || in_pass_) blame("endFrame without beginFrame, or inside a pass");
    if (in_timer_) blame("endFrame while a timer runs");
    in_frame_ = false;
    record(Call::end_frame);
    if (lost_) return Diagnostic{Code::context_lost, "the context is lost"};
    if (!std::exchange(frame_fails_, false)) return {};
    return Diagnostic{Code::gl_error, "the frame failed, as it was asked to"};
}

/// Whether a pass to that framebuffer draws into the texture or resolves into it.
bool RecordingDevice::uses(const FramebufferDesc& desc, std::uint32_t texture)
{
    const auto is = [&](TextureId id) { return id.value == texture; };
    const auto any = [&](const std::vector<TextureId>& all) {
        return std::any_of(all.begin(), all.end(), is);
    };
    return is(desc.depth) || is(desc.resolve_depth) || any(desc.color) || any(desc.resolve_color);
}

void RecordingDevice::loadAttachment(TextureId id, LoadOp load, StoreOp store)
{
    Object* texture = id ? find(id, "beginPass") : nullptr;
    if (!texture) return;
    const Extent extent = texture->texture.extent;
    const bool scratch = formatInfo(texture->texture.format).format_class == FormatClass::depth &&
                         load == LoadOp::clear && store == StoreOp::discard &&
                         extent.width >= pass_.extent.width && extent.height >= pass_.extent.height;
    if (extent != pass_.extent && !scratch)
        blame("pass '" + std::string(pass_.label) + "' has another size than texture '" +
              texture->label + "'");
    if (load == LoadOp::load && !texture->defined)
        blame("pass '" + std::string(pass_.label) + "' loads texture '" + texture->label +
              "', with undefined content");
    if (load == LoadOp::clear) texture->defined = true;
    if (load == LoadOp::discard) texture->defined = false;
}

void RecordingDevice::beginPass(const PassInfo& pass)
{
    auto name = pass_labels_.find(std::string_view(pass.label));
    if (name == pass_labels_.end()) name = pass_labels_.emplace(pass.label).first;
    pass_ = pass;
    pass_.label = name->c_str();
    record(Call::begin_pass, pass.framebuffer.value, {static_cast<std::uint32_t>(passes_.size())});
    passes_.push_back(pass_);

    if (!in_frame_ || in_pass_) blame("beginPass outside a frame, or inside a pass");
    const Object* framebuffer = find(pass.framebuffer, "beginPass");
    if (!framebuffer) return;
    in_pass_ = true;
    drawn_ = false;
    program_ = 0;
    const FramebufferDesc& desc = framebuffer->framebuffer;
    if (pass.color_count != static_cast<int>(desc.color.size()) ||
        pass.has_depth != static_cast<bool>(desc.depth))
        blame("pass '" + std::string(pass.label) + "' has other attachments than its framebuffer");
    const int count = std::min(pass.color_count, static_cast<int>(desc.color.size()));
    for (int i = 0; i < count; ++i) {
        loadAttachment(desc.color[i], pass.color_load[i], pass.color_store[i]);
        const int layer = pass.first_layer + layerOf(desc.color, i);
        const Object* texture = desc.color[i] ? objectOf(desc.color[i].value) : nullptr;
        if (texture && texture->texture.depth > 0 && layer >= texture->texture.depth)
            blame("pass '" + std::string(pass.label) + "' draws past the last layer of texture '" +
                  texture->label + "'");
    }
    loadAttachment(desc.depth, pass.depth_load, pass.depth_store);
}

void RecordingDevice::endPass()
{
    record(Call::end_pass);
    if (!in_pass_) return blame("endPass outside a pass");
    in_pass_ = false;
    const FramebufferDesc& desc = objects_.at(pass_.framebuffer.value).framebuffer;
    const auto storeAttachment = [&](TextureId id, TextureId resolved, StoreOp store) {
        if (!id) return;
        Object& texture = objects_.at(id.value);
        const bool stored = store == StoreOp::store && (texture.defined || drawn_);
        texture.defined = stored && texture.texture.samples == 1;
        if (resolved)
            objects_.at(resolved.value).defined = stored;
        else if (stored && texture.texture.samples > 1)
            blame("the samples of texture '" + texture.label + "' are stored, not resolved");
    };
    for (std::size_t i = 0; i < desc.color.size(); ++i) {
        const bool resolves = i < desc.resolve_color.size();
        storeAttachment(desc.color[i], resolves ? desc.resolve_color[i] : TextureId{},
                        pass_.color_store[i]);
    }
    storeAttachment(desc.depth, desc.resolve_depth, pass_.depth_store);
}

void RecordingDevice::setProgram(ProgramId id, const StateDesc& state)
{
    record(Call::set_program, id.value,
           {static_cast<std::uint32_t>(state.depth_test), state.depth_write ? 1u : 0u,
            static_cast<std::uint32_t>(state.cull), static_cast<std::uint32_t>(state.blend)});
    if (!in_pass_) blame("setProgram outside a pass");
    Object* program = find(id, "setProgram");
    program_ = program ? id.value : 0;
    if (!program) return;
    for (std::size_t i = 0; i < program->uniforms.size(); ++i)
        if (isSampler(program->uniforms[i].type)) program->uniform_set[i] = false;
}

/// The index of the running program's uniform at that location, or -1.
int RecordingDevice::uniformAt(int location, const char* caller)
{
    if (program_ == 0) {
        blame(std::string(caller) + " without a program");
        return -1;
    }
    const Object& program = objects_.at(program_);
    for (std::size_t i = 0; i < program.uniforms.size(); ++i)
        if (program.uniforms[i].location == location) return static_cast<int>(i);
    blame(std::string(caller) + " at a location that program '" + program.label +
          "' does not have");
    return -1;
}

void RecordingDevice::setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler)
{
    record(Call::set_texture, id.value,
           {static_cast<std::uint32_t>(location), static_cast<std::uint32_t>(unit),
            static_cast<std::uint32_t>(sampler.filter), static_cast<std::uint32_t>(sampler.wrap)});
    const int index = uniformAt(location, "setTexture");
    const Object* texture = find(id, "setTexture");
    if (index < 0 || !texture) return;
    Object& program = objects_.at(program_);
    const UniformInfo& uniform = program.uniforms[index];
    program.uniform_set[index] = true;
    const auto blameSampler = [&](const std::string& what) {
        blame("sampler '" + uniform.name + "' of program '" + program.label + "' " + what);
    };
    if (!isSampler(uniform.type)) blameSampler("is not a sampler");
    if (unit < 0 || unit >= caps_.max_texture_units) blameSampler("gets a unit that is not there");
    if (!texture->defined)
        blameSampler("reads texture '" + texture->label + "', with undefined content");
    if ((texture->texture.depth > 0) != (uniform.type == GlslType::sampler3d))
        blameSampler("and texture '" + texture->label + "' are a picture and a volume");
    if (sampler.filter == Filter::trilinear && !texture->texture.mips)
        blameSampler("reads texture '" + texture->label + "' between mips, which it has none of");
    if ((texture->texture.samples > 1) != (uniform.type == GlslType::sampler2d_ms))
        blameSampler("reads texture '" + texture->label + "', which has another count of samples");
    if (in_pass_ && uses(objects_.at(pass_.framebuffer.value).framebuffer, id.value))
        blameSampler("reads texture '" + texture->label + "', which the pass draws into");
}

void RecordingDevice::setUniform(int location, GlslType type, int count, const void* data)
{
    const std::size_t size = wordsOf(type, std::max(count, 0));
    record(Call::set_uniform, 0,
           {static_cast<std::uint32_t>(location), static_cast<std::uint32_t>(type),
            static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(size)});
    words_.resize(words_.size() + size);
    if (size) std::memcpy(words_.data() + words_.size() - size, data, size * sizeof(words_[0]));

    const int index = uniformAt(location, "setUniform");
    if (index < 0) return;
    Object& program = objects_.at(program_);
    const UniformInfo& uniform = program.uniforms[index];
    program.uniform_set[index] = true;
    if (uniform.type != type || count < 1 || count > uniform.count)
        blame("uniform '" + uniform.name + "' of program '" + program.label +
              "' gets another type or more values than it has");
}

void RecordingDevice::checkDraw(const char* caller)
{
    drawn_ = true;
    if (!in_pass_ || program_ == 0)
        return blame(std::string(caller) + " outside a pass, or without a program");
    const Object& program = objects_.at(program_);
    for (std::size_t i = 0; i < program.uniforms.size(); ++i)
        if (!program.uniform_set[i])
            blame("uniform '" + program.uniforms[i].name + "' of program '" + program.label +
                  "' was never set");
}

void RecordingDevice::draw(MeshId id, std::uint32_t first, std::uint32_t count)
{
    record(Call::draw, id.value, {first, count});
    const Object* mesh = find(id, "draw");
    if (mesh && std::uint64_t{first} + count > mesh->index_count + 3 * mesh->sheets.size())
        blame("mesh '" + mesh->label + "' is drawn past its last index");
    checkDraw("draw");
}

void RecordingDevice::drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host)
{
    record(Call::draw_by_host);
    checkDraw("drawByHost");
    const std::uint32_t program = program_;
    drawing(program, host);
    program_ = 0;  // which is to be set again
}

void RecordingDevice::drawFullscreen()
{
    record(Call::draw_fullscreen);
    checkDraw("drawFullscreen");
}

Status RecordingDevice::present(TextureId id, const HostFramebuffer& host)
{
    if (Status status = checkContext("the host's framebuffer"); !status) return status;
    record(Call::present, id.value,
           {host.name, static_cast<std::uint32_t>(host.x), static_cast<std::uint32_t>(host.y),
            static_cast<std::uint32_t>(host.extent.width),
            static_cast<std::uint32_t>(host.extent.height), host.multiply});
    if (in_pass_) blame("present inside a pass");
    const Object* texture = find(id, "present");
    if (texture && !texture->defined)
        blame("texture '" + texture->label + "' is presented, with undefined content");
    return checkReadable(*this, id);
}

void RecordingDevice::finish() { record(Call::finish); }

TimerId RecordingDevice::createTimer()
{
    return {caps_.timers ? add({ObjectId::Kind::timer, ""}, Call::create_timer) : 0};
}

void RecordingDevice::beginTimer(TimerId id)
{
    record(Call::begin_timer);
    if (!in_frame_ || in_timer_) blame("beginTimer outside a frame, or while a timer runs");
    Object* timer = find(id, "beginTimer");
    if (!timer) return;
    timer->time_ms = timers_ms_[std::min(timers_begun_++, timers_ms_.size() - 1)];
    in_timer_ = true;
}

void RecordingDevice::endTimer()
{
    record(Call::end_timer);
    if (!std::exchange(in_timer_, false)) blame("endTimer without beginTimer");
}

bool RecordingDevice::timerReady(TimerId id)
{
    return !results_held_ || !objects_.at(id.value).time_ms;
}

double RecordingDevice::readTimer(TimerId id)
{
    record(Call::read_timer);
    if (in_frame_) blame("readTimer inside a frame");
    if (results_held_) blame("readTimer waits");
    const Object* timer = find(id, "readTimer");
    return timer ? timer->time_ms.value_or(-1) : -1;
}

}  // namespace crevice
