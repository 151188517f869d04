// SPDX-License-Identifier: MIT
#include "backends/gl/reads.h"

#include "backends/gl/formats.h"

#include <cstring>

namespace crevice {
namespace {

using Texel = std::array<float, 4>;

}  // namespace

void GlReads::make(GlApi& gl, GlState& state, Slot& slot)
{
    gl_ = &gl;
    slot.buffer = GlBuffer::make(gl);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.name());
    gl.BufferData(GL_PIXEL_PACK_BUFFER, sizeof(Texel), nullptr, GL_STREAM_READ);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (bits_.name() != 0) return;
    bits_ = GlTexture::make(gl);
    state.bindTexture(0, bits_.name(), 0);
    allocateTexture(gl, GL_RGBA32UI, {1, 1});
    framebuffer_ = GlFramebuffer::make(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, bits_.name(), 0);
}

Status GlReads::begin(GlApi& gl, GlState& state, const GlCopier& copier, int slot, GLuint texture,
                      GLuint nearest)
{
    Slot& used = slots_[slot];
    if (used.done) gl.DeleteSync(std::exchange(used.done, nullptr));
    if (used.buffer.name() == 0) make(gl, state, used);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    copier.fetchBits(gl, state, texture, nearest, {1, 1});
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, used.buffer.name());
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    used.done = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    Status status = takeErrors(gl, "beginRead");
    if (!status) forget();
    return status;
}

/// All reads, and the objects that may be broken.
void GlReads::forget()
{
    for (Slot& slot : slots_) {
        if (slot.done) gl_->DeleteSync(std::exchange(slot.done, nullptr));
        slot.buffer = {};
    }
    bits_ = {};
    framebuffer_ = {};
}

std::optional<Texel> GlReads::take(const GlApi& gl, int slot)
{
    Slot& used = slots_[slot];
    if (!used.done) return std::nullopt;
    const GLenum state = gl.ClientWaitSync(used.done, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return std::nullopt;
    gl.DeleteSync(std::exchange(used.done, nullptr));
    GLint bound = 0;
    gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bound);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, used.buffer.name());
    std::optional<Texel> texel;
    if (gl.GetBufferSubData) {
        gl.GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, sizeof(Texel), texel.emplace().data());
    } else if (const void* bits =
                   gl.MapBufferRange(GL_PIXEL_PACK_BUFFER, 0, sizeof(Texel), GL_MAP_READ_BIT)) {
        std::memcpy(texel.emplace().data(), bits, sizeof(Texel));
        gl.UnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(bound));
    return texel;
}

}  // namespace crevice
