// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_target.h"

#include "backends/gl/failure.h"
#include "backends/gl/host/host_image.h"

namespace crevice {

namespace {

std::string nameOf(const HostFramebuffer& host)
{
    return host.texture != 0 ? "the host's texture " + std::to_string(host.texture)
                             : "the host's framebuffer " + std::to_string(host.name);
}

}  // namespace

Status checkRectangle(const HostFramebuffer& host)
{
    const auto [width, height] = host.extent;
    if (width <= 0 || height <= 0)
        return failure(Code::bad_input,
                       "the rectangle to draw into is " + sizeText(host.extent) + " pixels",
                       "give its extent, at least 1x1");
    if (isCountable(host.x, host.y, host.extent)) return {};
    return failure(Code::bad_input,
                   "the rectangle to draw into is " + sizeText(host.extent) + " pixels at (" +
                       std::to_string(host.x) + ", " + std::to_string(host.y) +
                       "), outside of every framebuffer",
                   "x and y count from 0, from the lower left; keep the rectangle within it");
}

GlFramebuffer bindHostTarget(const GlApi& gl, const HostFramebuffer& host)
{
    GlFramebuffer own;
    if (host.texture != 0) own = GlFramebuffer::make(gl);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, host.texture != 0 ? own.name() : host.name);
    if (host.texture != 0)
        gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                host.texture, host.level);
    return own;
}

Status checkHostTarget(const GlApi& gl, const HostFramebuffer& host)
{
    if (const GLenum complete = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
        complete != GL_FRAMEBUFFER_COMPLETE)
        return failure(Code::gl_error,
                       nameOf(host) + " cannot be drawn into: " + framebufferStatusName(complete),
                       "give it storage of a colour format that this device renders to");
    if (host.name == 0 && host.texture == 0) return {};
    GLint drawn = GL_NONE;
    gl.GetIntegerv(GL_DRAW_BUFFER0, &drawn);
    if (drawn == GL_NONE) return {};
    const Extent end = {host.x + host.extent.width, host.y + host.extent.height};
    const Extent size = askSize(gl, GL_DRAW_FRAMEBUFFER, static_cast<GLenum>(drawn));
    if (size.width == 0 || (size.width >= end.width && size.height >= end.height)) return {};
    return failure(Code::bad_input,
                   nameOf(host) + " has " + sizeText(size) +
                       " pixels, and the rectangle to draw into ends at " + sizeText(end),
                   "keep the rectangle within it");
}

}  // namespace crevice
