// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_texture.h"

#include "backends/gl/failure.h"
#include "backends/gl/formats.h"
#include "backends/gl/host/host_image.h"

#include <algorithm>
#include <vector>

namespace crevice {

namespace {

constexpr GLenum kDepthComponent32 = 0x81A7;  // desktop OpenGL alone

bool isDepth(const HostTexture& host)
{
    return host.format == Format::none ||
           formatInfo(host.format).format_class == FormatClass::depth;
}

std::string nameOf(const HostTexture& host)
{
    constexpr const char* kKinds[] = {"texture", "array texture", "renderbuffer", "framebuffer"};
    return "the host's " + std::string(kKinds[static_cast<int>(host.kind)]) + " " +
           std::to_string(host.name) + " for '" + host.label + "'";
}

Diagnostic misfit(const HostTexture& host, const std::string& what, const char* help)
{
    return failure(Code::bad_input, nameOf(host) + " " + what, help);
}

/// Attaches the host's image for reading. Errors: CV6011 where it has no such image.
Status attachForReading(GlApi& gl, const HostTexture& host, GLuint framebuffer)
{
    const GLenum point = isDepth(host) ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
    if (host.kind == HostTexture::Kind::framebuffer) {
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, host.name);
        return {};
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    const GLenum target = host.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    switch (host.kind) {
    case HostTexture::Kind::texture:
        gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, point, target, host.name, 0);
        break;
    case HostTexture::Kind::layer:
        gl.FramebufferTextureLayer(GL_READ_FRAMEBUFFER, point, host.name, 0, host.layer);
        break;
    default:
        gl.FramebufferRenderbuffer(GL_READ_FRAMEBUFFER, point, GL_RENDERBUFFER, host.name);
        break;
    }
    gl.ReadBuffer(isDepth(host) ? GL_NONE : GL_COLOR_ATTACHMENT0);
    if (gl.GetError() == GL_NO_ERROR) return {};
    constexpr const char* kWhat[] = {"is no GL_TEXTURE_2D",
                                     "is no GL_TEXTURE_2D_ARRAY, or has no such layer",
                                     "is none of this context", ""};
    return misfit(
        host,
        host.samples > 1 ? "is no GL_TEXTURE_2D_MULTISAMPLE" : kWhat[static_cast<int>(host.kind)],
        "say what it is: its kind, layer and samples");
}

bool isDefault(const HostTexture& host)
{
    return host.kind == HostTexture::Kind::framebuffer && host.name == 0;
}

/// Where the host's image is attached in the bound read framebuffer.
GLenum pointOf(const HostTexture& host)
{
    if (!isDepth(host)) return GL_COLOR_ATTACHMENT0;
    return isDefault(host) ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
}

Status checkHeld(const HostTexture& host, const GlHeld& held)
{
    if (held.empty())
        return misfit(host,
                      "holds nothing of the kind of " + std::string(formatInfo(host.format).name),
                      "give it storage, and say its format");
    // Who made the default framebuffer asked for no bits in particular, and finer steps are better.
    const bool as_said = !isDefault(host) || held.depthFormat() == host.format;
    if (held.fits(host.format) && !held.srgb && as_said) return {};
    return misfit(host,
                  "holds " + textOf(held) + "; it was said to be " + formatInfo(host.format).name,
                  "say that, or for depth no format, or hand over another");
}

/// Of the image that is attached to the bound read framebuffer.
Status checkSize(const GlApi& gl, const HostTexture& host)
{
    const Extent end =
        host.part ? Extent{host.x + host.extent.width, host.y + host.extent.height} : host.extent;
    const Extent size = askSize(gl, GL_READ_FRAMEBUFFER, pointOf(host));
    const bool reaches = size.width >= end.width && size.height >= end.height;
    if (size.width == 0 || (host.part ? reaches : size == end)) return {};
    return misfit(
        host,
        "has " + sizeText(size) + " pixels" +
            (host.part ? ", and the picture in it is said to end at " : "; it was said to have ") +
            sizeText(end),
        host.part ? "keep the picture within it"
                  : "say its own width and height; of a part, set part, x and y");
}

/// What a texture reads as, beside what it holds.
Status checkReading(const GlApi& gl, GlState& state, const HostTexture& host)
{
    const GLenum target = host.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    state.bindTexture(0, host.name, 0, target);
    const auto get = [&](GLenum what) {
        GLint value = 0;
        gl.GetTexParameteriv(target, what, &value);
        return value;
    };
    constexpr GLint kIdentity[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    for (int i = 0; i < formatInfo(host.format).channels; ++i)
        if (const GLint read = get(GL_TEXTURE_SWIZZLE_R + i); read != 0 && read != kIdentity[i])
            return misfit(host, "swaps its channels (GL_TEXTURE_SWIZZLE)", "set them to their own");
    (void)gl.GetError();  // of WebGL, which swaps none and knows no such name
    if (get(GL_TEXTURE_BASE_LEVEL) != 0)
        return misfit(host, "begins at another level than 0", "set GL_TEXTURE_BASE_LEVEL to 0");
    const bool reads_stencil = gl.GetTexLevelParameteriv && isDepth(host) &&
                               get(GL_DEPTH_STENCIL_TEXTURE_MODE) == GL_STENCIL_INDEX;
    if (reads_stencil)
        return misfit(host, "reads as stencil",
                      "set its GL_DEPTH_STENCIL_TEXTURE_MODE to GL_DEPTH_COMPONENT");
    return {};
}

/// Formats that a copy of the depth may need, the likeliest first: GL copies depth between images
/// of the same format alone, and not every driver tells of a stencil beside it.
std::vector<GLenum> copyFormats(const HostTexture& host, const GlHeld& held)
{
    if (!isDepth(host)) return {glFormat(host.format).internal};
    if (held.type == GL_FLOAT && held.stencil > 0)
        return {GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT32F};
    if (held.type == GL_FLOAT) return {GL_DEPTH_COMPONENT32F, GL_DEPTH32F_STENCIL8};
    if (held.bits[4] == 16) return {GL_DEPTH_COMPONENT16};
    if (held.bits[4] == 32) return {kDepthComponent32};
    if (held.stencil > 0) return {GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24};
    return {GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8};
}

Status checkKind(const HostTexture& host)
{
    if (host.extent.width < 1 || host.extent.height < 1)
        return misfit(host, "has no size", "say its width and height");
    if (host.kind == HostTexture::Kind::framebuffer && !isDepth(host))
        return misfit(host, "is asked for colour", "hand over the texture that it draws into");
    const bool placed = host.copied();
    if (!isCountable(placed ? host.x : 0, placed ? host.y : 0, host.extent))
        return misfit(host, "is asked for pixels below 0 or past " + std::to_string(kLastPixel),
                      "x and y count from 0; keep the picture within it");
    return {};
}

}  // namespace

Status checkHostTexture(GlApi& gl, GlState& state, HostTexture& host)
{
    if (Status status = checkKind(host); !status) return status;
    const auto framebuffer = GlFramebuffer::make(gl);
    if (Status status = attachForReading(gl, host, framebuffer.name()); !status) return status;
    const GlHeld held = readHeld(gl, GL_READ_FRAMEBUFFER, pointOf(host));
    (void)gl.GetError();  // of what an attachment that is none cannot be asked
    if (host.format == Format::none) host.format = held.depthFormat();
    if (Status status = checkHeld(host, held); !status) return status;
    if (Status status = checkSize(gl, host); !status) return status;
    return host.kind == HostTexture::Kind::texture ? checkReading(gl, state, host) : Status();
}

Result<GlHostCopy> GlHostCopy::make(GlApi& gl, GlState& state, HostTexture& host)
{
    if (Status status = checkHostTexture(gl, state, host); !status) return status.diagnostics();
    GlHostCopy copy;
    copy.host_ = host;
    copy.from_ = GlFramebuffer::make(gl);
    copy.into_ = GlFramebuffer::make(gl);
    // Desktop OpenGL before 4.1 wants what is drawn into to be there, even of what is only read.
    const GLenum none = GL_NONE;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, copy.from_.name());
    gl.DrawBuffers(1, &none);
    if (Status status = attachForReading(gl, host, copy.from_.name()); !status)
        return status.diagnostics();
    if (const GLenum complete = gl.CheckFramebufferStatus(GL_READ_FRAMEBUFFER);
        complete != GL_FRAMEBUFFER_COMPLETE)
        return Diagnostics{misfit(host,
                                  std::string("cannot be read: ") + framebufferStatusName(complete),
                                  "give it storage, and name a layer that it has")};
    Status status;
    for (const GLenum internal :
         copyFormats(host, readHeld(gl, GL_READ_FRAMEBUFFER, pointOf(host)))) {
        status = copy.allocate(gl, state, internal);
        if (status) status = copy.update(gl);
        if (status) return copy;
    }
    return status.diagnostics();
}

Status GlHostCopy::allocate(GlApi& gl, GlState& state, GLenum internal)
{
    texture_ = GlTexture::make(gl);
    state.bindTexture(0, texture_.name(), 0);
    allocateTexture(gl, internal, host_.extent);
    const GLenum point = isDepth(host_) ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
    const GLenum buffer = isDepth(host_) ? GL_NONE : GL_COLOR_ATTACHMENT0;
    gl.BindFramebuffer(GL_FRAMEBUFFER, into_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture_.name(), 0);
    gl.DrawBuffers(1, &buffer);
    gl.ReadBuffer(buffer);
    return takeErrors(gl, "adoptTexture", host_.label.c_str());
}

Status GlHostCopy::update(GlApi& gl) const
{
    if (Status status = attachForReading(gl, host_, from_.name()); !status) return status;
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, into_.name());
    const GLint x = host_.part ? host_.x : 0, y = host_.part ? host_.y : 0;
    const auto [width, height] = host_.extent;
    gl.BlitFramebuffer(x, y, x + width, y + height, 0, 0, width, height,
                       isDepth(host_) ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return takeErrors(gl, "the copy of the host's", host_.label.c_str());
}

}  // namespace crevice
