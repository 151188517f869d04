// SPDX-License-Identifier: MIT
// The drawing half of the GL device.
#include "backends/gl/device_class.h"
#include "backends/gl/failure.h"
#include "backends/gl/host/host_target.h"

namespace crevice {

namespace {

GLenum compareFunction(Compare compare)
{
    constexpr GLenum kFunctions[] = {GL_ALWAYS,  GL_LESS,   GL_LEQUAL,
                                     GL_GREATER, GL_GEQUAL, GL_EQUAL};  // in the order of Compare
    return kFunctions[static_cast<int>(compare)];
}

/// Invalidates the attachments whose contents are not needed: tile memory is then neither loaded
/// nor stored.
template <class Op>
void invalidate(const GlApi& gl, const PassInfo& pass, const Op* color, Op depth, Op discard)
{
    if (!gl.InvalidateFramebuffer) return;
    GLenum unwanted[kMaxColorAttachments + 1];
    GLsizei count = 0;
    for (int i = 0; i < pass.color_count; ++i)
        if (color[i] == discard) unwanted[count++] = GL_COLOR_ATTACHMENT0 + i;
    if (pass.has_depth && depth == discard) unwanted[count++] = GL_DEPTH_ATTACHMENT;
    if (count > 0) gl.InvalidateFramebuffer(GL_DRAW_FRAMEBUFFER, count, unwanted);
}

void clear(const GlApi& gl, const PassInfo& pass)
{
    for (int i = 0; i < pass.color_count; ++i)
        if (pass.color_load[i] == LoadOp::clear) gl.ClearBufferfv(GL_COLOR, i, pass.clear_color[i]);
    if (pass.has_depth && pass.depth_load == LoadOp::clear)
        gl.ClearBufferfv(GL_DEPTH, 0, &pass.clear_depth);
}

}  // namespace

GLuint GlDevice::sampler(const SamplerDesc& desc, Format format) const
{
    const Filter filter = canFilter(info_, format) ? desc.filter : Filter::nearest;
    return samplers_[static_cast<int>(filter)][static_cast<int>(desc.wrap)].name();
}

void GlDevice::noteErrors(const char* what, const char* label)
{
    if (!check_errors_ || tellsLoss(errors_)) return;
    const Status status = takeErrors(gl_, what, label);
    append(errors_, status.diagnostics());
}

void GlDevice::noteDeleted(GLuint name)
{
    noteErrors("pass", pass_.label);
    if (!errors_.empty()) return;
    errors_ = {failure(Code::bad_input,
                       "the host's texture " + std::to_string(name) + ", which pass '" +
                           pass_.label + "' reads, is deleted",
                       "hand over another one, by Effect::setTexture, before you delete it")};
}

void GlDevice::takeHostErrors()
{
    noticeReset(gl_);
    Diagnostics left = takeErrors(gl_, "what the host did before").diagnostics();
    if (left.empty() || tellsLoss(left)) return;
    left[0].severity = Severity::warning;
    left[0].help = "ask glGetError after your own calls to find which it was";
    host_errors_ = std::move(left);
}

Status GlDevice::beginFrame()
{
    if (check_errors_) {
        if (Status status = checkCurrent(); !status) return status;
        takeHostErrors();
    }
    if (Status status = state_.checkHost(); !status) return status;
    timing_.beginFrame(gl_);
    state_.enter();
    return {};
}

Status GlDevice::endFrame()
{
    state_.leave();
    noteErrors("endFrame");
    Diagnostics errors = std::exchange(host_errors_, {});
    append(errors, errors_);
    errors_.clear();
    return errors;
}

void GlDevice::beginPass(const PassInfo& pass)
{
    pass_ = pass;
    const FramebufferSlot& framebuffer = framebuffers_.at(pass.framebuffer.value);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.drawn.name());
    attachLayers(framebuffer);
    state_.unmask();
    invalidate(gl_, pass, pass.color_load, pass.depth_load, LoadOp::discard);
    clear(gl_, pass);
    setArea(pass);
}

void GlDevice::setArea(const PassInfo& pass)
{
    const auto [width, height] = pass.extent;
    setViewport(gl_, 0, 0, static_cast<float>(width), static_cast<float>(height));
    if (pass.at_depth >= 0.0f) setDepthRange(gl_, pass.at_depth, pass.at_depth);
    if (!pass.within_area) return;
    state_.setEnabled(GL_SCISSOR_TEST, true);
    setScissor(gl_, pass.area.x, pass.area.y, pass.area.extent.width, pass.area.extent.height);
}

void GlDevice::resolve(const FramebufferSlot& framebuffer)
{
    const auto blit = [&](GLbitfield what) {
        const auto [width, height] = pass_.extent;
        gl_.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
    };
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.resolved.name());
    for (int i = 0; i < pass_.color_count; ++i) {
        if (pass_.color_store[i] != StoreOp::store) continue;
        GLenum buffers[kMaxColorAttachments] = {};  // none
        buffers[i] = GL_COLOR_ATTACHMENT0 + i;
        gl_.ReadBuffer(buffers[i]);
        gl_.DrawBuffers(i + 1, buffers);
        blit(GL_COLOR_BUFFER_BIT);
        pass_.color_store[i] = StoreOp::discard;
    }
    if (pass_.has_depth && pass_.depth_store == StoreOp::store) blit(GL_DEPTH_BUFFER_BIT);
    pass_.depth_store = StoreOp::discard;
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.drawn.name());
}

void GlDevice::endPass()
{
    if (pass_.within_area) state_.setEnabled(GL_SCISSOR_TEST, false);
    if (pass_.at_depth >= 0.0f) setDepthRange(gl_, 0.0f, 1.0f);
    const FramebufferSlot& framebuffer = framebuffers_.at(pass_.framebuffer.value);
    if (framebuffer.resolved.name() != 0) resolve(framebuffer);
    invalidate(gl_, pass_, pass_.color_store, pass_.depth_store, StoreOp::discard);
    if (pass_.makes_mips) makeMips(framebuffer);
    noteErrors("pass", pass_.label);
}

void GlDevice::setProgram(ProgramId id, const StateDesc& state)
{
    gl_.UseProgram(programs_.at(id.value).program.name());
    // Depth is written only while the test is on, so `always` may not switch it off then.
    state_.setEnabled(GL_DEPTH_TEST, state.depth_test != Compare::always || state.depth_write);
    gl_.DepthFunc(compareFunction(state.depth_test));
    gl_.DepthMask(state.depth_write);
    state_.setEnabled(GL_CULL_FACE, state.cull != Cull::none);
    gl_.CullFace(state.cull == Cull::front ? GL_FRONT : GL_BACK);
    state_.setEnabled(GL_BLEND, state.blend != Blend::none);
    if (state.blend == Blend::none) return;
    gl_.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    constexpr GLenum kEquations[] = {GL_FUNC_ADD, GL_FUNC_ADD, GL_MIN, GL_MAX};  // by Blend
    gl_.BlendEquation(kEquations[static_cast<int>(state.blend)]);
}

void GlDevice::setTexture(int location, int unit, TextureId id, const SamplerDesc& desc)
{
    const TextureSlot& texture = textures_.at(id.value);
    // Asked before it is bound, which would make an empty texture of that name.
    const bool gone = check_errors_ && texture.adopted() && !gl_.IsTexture(texture.name);
    if (gone) noteDeleted(texture.name);
    state_.bindTexture(unit, gone ? 0 : texture.name, sampler(desc, texture.format),
                       texture.target());
    gl_.Uniform1i(location, unit);
}

void GlDevice::drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host)
{
    noteErrors("pass", pass_.label);
    GLint program = 0;
    gl_.GetIntegerv(GL_CURRENT_PROGRAM, &program);
    drawing(static_cast<std::uint32_t>(program), host);
    noteErrors("the host's own draw in pass", pass_.label);
    state_.neutralize();
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_.at(pass_.framebuffer.value).drawn.name());
    setArea(pass_);
}

void GlDevice::drawFullscreen() { copier_.drawTriangle(gl_); }

/// Has what is drawn multiply the colours that are there, and leave alpha.
void GlDevice::multiplyColors()
{
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
    gl_.BlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
}

Status GlDevice::present(TextureId id, const HostFramebuffer& host)
{
    if (Status status = check_errors_ ? checkCurrent() : Status(); !status) return status;
    if (Status status = checkReadable(*this, id); !status) return status;
    if (Status status = checkRectangle(host); !status) return status;
    const TextureSlot& texture = textures_.at(id.value);
    Scope scope(*this);
    if (Status status = state_.checkHost(); !status) return status;
    const GlFramebuffer own = bindHostTarget(gl_, host);
    if (Status status = check_errors_ ? checkHostTarget(gl_, host) : Status(); !status)
        return unlessLost(status, "present");
    setViewport(gl_, static_cast<float>(host.x), static_cast<float>(host.y),
                static_cast<float>(host.extent.width), static_cast<float>(host.extent.height));
    if (host.multiply) multiplyColors();
    copier_.copy(gl_, state_, texture.name, sampler({Filter::linear, Wrap::clamp}, texture.format),
                 formatInfo(texture.format).channels);
    return check_errors_ ? takeErrors(gl_, "present") : Status();
}

}  // namespace crevice
