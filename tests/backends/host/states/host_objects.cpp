// SPDX-License-Identifier: MIT
// The host's own objects: depth in every place that it may lie in, targets and a vertex buffer.
#include "tests/backends/host/states/host_life.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crevice {

namespace {

constexpr Extent kLarger = {40, 24};

}  // namespace

/// Steps of depth in what is bound for drawing.
void HostLife::paintDepth(int x, int y) const
{
    gl.Enable(GL_SCISSOR_TEST);
    for (int step = 0; step < 6; ++step) {
        const float depth = step == 5 ? 1.0f : 0.5f + 0.0625f * static_cast<float>(step * 3 % 5);
        gl.Scissor(x + 6 * step, y + 2 * step, kHostSize.width, kHostSize.height);
        gl.ClearBufferfv(GL_DEPTH, 0, &depth);
    }
    gl.Disable(GL_SCISSOR_TEST);
}

/// Gives the object what `host` says it is, and attaches it to the bound framebuffer.
void HostLife::allocateDepth(HostTexture& host, Extent extent)
{
    const GLenum point = GL_DEPTH_ATTACHMENT, internal = GL_DEPTH_COMPONENT32F;
    const auto [width, height] = extent;
    if (host.kind == HostTexture::Kind::renderbuffer) {
        renderbuffer_ = GlRenderbuffer::make(gl);
        host.name = renderbuffer_.name();
        gl.BindRenderbuffer(GL_RENDERBUFFER, host.name);
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, internal, width, height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, host.name);
        return;
    }
    const bool layer = host.kind == HostTexture::Kind::layer;
    const GLenum target = layer              ? GL_TEXTURE_2D_ARRAY
                          : host.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE
                                             : GL_TEXTURE_2D;
    host.name = textures_.emplace_back(target, GlTexture::make(gl)).second.name();
    gl.BindTexture(target, host.name);
    if (layer) {
        host.layer = 1;
        calls_("glTexImage3D", target, GLint(0), GLint(internal), width, height, GLsizei(2),
               GLint(0), GLenum(GL_DEPTH_COMPONENT), GLenum(GL_FLOAT),
               static_cast<const void*>(nullptr));
        gl.FramebufferTextureLayer(GL_FRAMEBUFFER, point, host.name, 0, host.layer);
    } else {
        if (host.samples > 1)
            calls_(info_.desktop ? "glTexImage2DMultisample" : "glTexStorage2DMultisample", target,
                   GLsizei(host.samples), internal, width, height, GLboolean(GL_TRUE));
        else
            gl.TexImage2D(target, 0, internal, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                          nullptr);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, target, host.name, 0);
    }
    gl.BindTexture(target, 0);
}

void HostLife::addDepth(HostTexture host)
{
    const GLenum none = GL_NONE;
    const GLuint into = framebuffers_.emplace_back(GlFramebuffer::make(gl)).name();
    gl.BindFramebuffer(GL_FRAMEBUFFER, into);
    gl.DrawBuffers(1, &none);
    gl.ReadBuffer(GL_NONE);
    host.format = Format::depth32f;
    host.extent = kHostSize;
    if (host.part && host.samples == 1) {
        host.x = 5;
        host.y = 3;
    }
    allocateDepth(host, host.x > 0 ? kLarger : kHostSize);
    if (host.kind == HostTexture::Kind::framebuffer) host.name = into;
    paintDepth(host.x, host.y);
    depths_.push_back(host);
}

void HostLife::makeDepths()
{
    for (const auto kind : {HostTexture::Kind::texture, HostTexture::Kind::layer,
                            HostTexture::Kind::renderbuffer, HostTexture::Kind::framebuffer}) {
        HostTexture host;
        host.kind = kind;
        addDepth(host);
    }
    HostTexture part;
    part.part = true;
    addDepth(part);
    if (!info_.desktop && info_.version < 310) return;
    part.samples = 4;  // last: one kind reads its samples, and the others a copy
    addDepth(part);
}

/// The second encodes what is drawn where the context does.
void HostLife::makeTargets()
{
    for (GLuint& shown : shown_) {
        shown = textures_.emplace_back(GL_TEXTURE_2D, GlTexture::make(gl)).second.name();
        gl.BindTexture(GL_TEXTURE_2D, shown);
        gl.TexImage2D(GL_TEXTURE_2D, 0, shown == shown_[0] ? GL_RGBA8 : GL_SRGB8_ALPHA8,
                      kHostSize.width, kHostSize.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        framebuffers_.push_back(GlFramebuffer::make(gl));
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().name());
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shown, 0);
        drawn_into_.push_back(framebuffers_.back().name());
    }
}

/// What a target holds, read by the host itself, under what it sets for it.
Image HostLife::readShown(int target) const
{
    for (const GLenum name : {0x0D00, 0x0D02, 0x0D03, 0x0D04, 0x8758, 0x93A4})
        gl.PixelStorei(name, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_into_[target]);
    std::vector<GLubyte> bytes(4 * kHostSize.width * kHostSize.height);
    gl.ReadPixels(0, 0, kHostSize.width, kHostSize.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    Image image(kHostSize, 4);
    image.pixels.assign(bytes.begin(), bytes.end());
    quiet(gl);
    return image;
}

void HostLife::makeBuffers()
{
    const std::vector<Vertex> data = step();
    vertices_ = GlBuffer::make(gl);
    array_ = GlVertexArray::make(gl);
    gl.BindVertexArray(array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.BufferData(GL_ARRAY_BUFFER, data.size() * sizeof(Vertex), data.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 3; ++i) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, i == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                               reinterpret_cast<const void*>(std::size_t(12 * i)));
    }
    gl.BindVertexArray(0);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace crevice
