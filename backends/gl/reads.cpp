// SPDX-License-Identifier: MIT
#include "backends/gl/reads.h"

#include "backends/gl/formats.h"

#include <cstring>

namespace crevice {

using Texel = std::array<float, 4>;

void GlReads::make(const GlApi& gl, GlState& state, GlRead& read)
{
    read.buffer = GlBuffer::make(gl);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, read.buffer.name());
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

Status GlReads::begin(GlApi& gl, GlState& state, const GlCopier& copier, GlRead& read,
                      GLuint texture, GLuint nearest)
{
    read.done.reset();
    if (read.buffer.name() == 0) make(gl, state, read);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    copier.fetchBits(gl, state, texture, nearest, {1, 1});
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, read.buffer.name());
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    read.done = GlFence(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0), {&gl});
    Status status = takeErrors(gl, "beginRead");
    if (status) return status;
    read = {};  // what may be broken is made again
    bits_ = {};
    framebuffer_ = {};
    return status;
}

std::optional<Texel> GlReads::take(const GlApi& gl, GlRead& read)
{
    if (!read.done) return std::nullopt;
    const GLenum state = gl.ClientWaitSync(read.done.get(), GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return std::nullopt;
    read.done.reset();
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, read.buffer.name());
    std::optional<Texel> texel;
    if (gl.GetBufferSubData) {
        gl.GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, sizeof(Texel), texel.emplace().data());
    } else if (const void* bits =
                   gl.MapBufferRange(GL_PIXEL_PACK_BUFFER, 0, sizeof(Texel), GL_MAP_READ_BIT)) {
        std::memcpy(texel.emplace().data(), bits, sizeof(Texel));
        gl.UnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return texel;
}

}  // namespace crevice
