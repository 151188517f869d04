// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_texture.h"

#include "backends/gl/failure.h"
#include "backends/gl/formats.h"

#include <algorithm>
#include <vector>

namespace crevice {

namespace {

constexpr GLenum kDepthComponent32 = 0x81A7;  // desktop OpenGL alone

/// What an image holds: bits of red, green, blue, alpha and depth, and what kind of numbers.
struct Held {
    GLint bits[5] = {};
    GLint stencil = 0;
    GLint type = GL_NONE;
    bool srgb = false;
};

constexpr GLint kUnorm = GL_UNSIGNED_NORMALIZED;

struct Wanted {
    Format format;
    GLint bits[5];
    GLint type;
};

constexpr Wanted kWanted[] = {
    {Format::r8, {8, 0, 0, 0, 0}, kUnorm},
    {Format::rg8, {8, 8, 0, 0, 0}, kUnorm},
    {Format::rgba8, {8, 8, 8, 8, 0}, kUnorm},
    {Format::rgb10_a2, {10, 10, 10, 2, 0}, kUnorm},
    {Format::r16f, {16, 0, 0, 0, 0}, GL_FLOAT},
    {Format::rg16f, {16, 16, 0, 0, 0}, GL_FLOAT},
    {Format::rgba16f, {16, 16, 16, 16, 0}, GL_FLOAT},
    {Format::r32f, {32, 0, 0, 0, 0}, GL_FLOAT},
    {Format::rg32f, {32, 32, 0, 0, 0}, GL_FLOAT},
    {Format::rgba32f, {32, 32, 32, 32, 0}, GL_FLOAT},
    {Format::r11g11b10f, {11, 11, 10, 0, 0}, GL_FLOAT},
    {Format::depth16, {0, 0, 0, 0, 16}, kUnorm},
    {Format::depth24, {0, 0, 0, 0, 24}, kUnorm},
    {Format::depth32f, {0, 0, 0, 0, 32}, GL_FLOAT},
};

bool isDepth(const HostTexture& host)
{
    return formatInfo(host.format).format_class == FormatClass::depth;
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

std::string sizeText(Extent extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

std::string textOf(const Held& held)
{
    const auto number = [&](int i) { return std::to_string(held.bits[i]); };
    const std::string type = held.type == GL_FLOAT ? "float"
                             : held.type == kUnorm ? "normalised"
                                                   : "integer or signed";
    if (held.bits[4] > 0) return "depth of " + number(4) + " bits, " + type;
    return "colour of " + number(0) + ", " + number(1) + ", " + number(2) + " and " + number(3) +
           " bits, " + (held.srgb ? "sRGB" : type);
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
        "say what it is by HostTexture::kind, layer and samples");
}

/// What the bound read framebuffer holds; a type of GL_NONE where there is nothing.
Held readHeld(const GlApi& gl, const HostTexture& host)
{
    const bool is_default = host.kind == HostTexture::Kind::framebuffer && host.name == 0;
    const GLenum point = !isDepth(host) ? GL_COLOR_ATTACHMENT0
                         : is_default   ? GL_DEPTH
                                        : GL_DEPTH_ATTACHMENT;
    const auto get = [&](GLenum what) {
        GLint value = 0;
        gl.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, point, what, &value);
        return value;
    };
    Held held;
    if (get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return held;
    constexpr GLenum kSizes[] = {
        GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
        GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE,
        GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE};
    for (int i = 0; i < 5; ++i) held.bits[i] = get(kSizes[i]);
    held.stencil = get(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    held.type = get(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
    held.srgb = get(GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB;
    return held;
}

/// Drivers may hold more bits than were asked for.
Status checkHeld(const HostTexture& host, const Held& held)
{
    const Wanted* wanted = std::begin(kWanted);
    while (wanted->format != host.format) ++wanted;
    if (held.type == GL_NONE || *std::max_element(held.bits, held.bits + 5) == 0)
        return misfit(host,
                      "holds nothing of the kind of " + std::string(formatInfo(host.format).name),
                      "give it storage, and say its format by HostTexture::format");
    bool fits = held.type == wanted->type && !held.srgb;
    for (int i = 0; i < 5; ++i) fits = fits && held.bits[i] >= wanted->bits[i];
    if (fits) return {};
    return misfit(host,
                  "holds " + textOf(held) + "; it was said to be " + formatInfo(host.format).name,
                  "say its format by HostTexture::format, or hand over another");
}

/// Whether OpenGL ES 3.0, which cannot be asked for sizes, takes writes of nothing there.
bool reaches(GlApi& gl, const Held& held, const HostTexture& host, GLint x, GLint y)
{
    const GlFormat& format = glFormat(host.format);
    GLenum upload_format = format.upload_format, upload_type = format.upload_type;
    if (held.stencil > 0) {
        upload_format = GL_DEPTH_STENCIL;
        upload_type =
            held.type == GL_FLOAT ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8;
    }
    const GLuint nothing[2] = {};
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, 0, 0, upload_format, upload_type, nothing);
    bool reached = true;
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR && error != GL_CONTEXT_LOST;
         error = gl.GetError())
        reached = reached && error != GL_INVALID_VALUE;
    return reached;
}

Status wrongSize(const HostTexture& host, const std::string& has)
{
    const std::string end = sizeText({host.x + host.extent.width, host.y + host.extent.height});
    return misfit(host,
                  has + (host.part ? ", and the picture in it is said to end at " + end
                                   : "; it was said to have " + sizeText(host.extent)),
                  host.part ? "keep the picture within it"
                            : "say its size by HostTexture::extent; of a part, set part, x and y");
}

Status checkExtent(const HostTexture& host, Extent found)
{
    if (found.width == 0) return {};  // not known
    const bool fits = host.part ? host.x + host.extent.width <= found.width &&
                                      host.y + host.extent.height <= found.height
                                : found == host.extent;
    return fits ? Status() : wrongSize(host, "has " + sizeText(found) + " pixels");
}

/// Of the texture that is bound to `target` of the active unit.
Status checkBoundSize(GlApi& gl, const HostTexture& host, const Held& held, GLenum target)
{
    if (gl.GetTexLevelParameteriv) {
        Extent found;
        gl.GetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &found.width);
        gl.GetTexLevelParameteriv(target, 0, GL_TEXTURE_HEIGHT, &found.height);
        return checkExtent(host, found);
    }
    if (target != GL_TEXTURE_2D) return {};
    const GLint right = host.x + host.extent.width, top = host.y + host.extent.height;
    const bool fits = reaches(gl, held, host, right, top) &&
                      (host.part || (!reaches(gl, held, host, right + 1, 0) &&
                                     !reaches(gl, held, host, 0, top + 1)));
    return fits ? Status() : wrongSize(host, "has another size");
}

/// Leaves the unit's binding of arrays as it was.
Status checkArraySize(GlApi& gl, const HostTexture& host, const Held& held)
{
    GLint bound = 0;
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &bound);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, host.name);
    const Status status = checkBoundSize(gl, host, held, GL_TEXTURE_2D_ARRAY);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(bound));
    return status;
}

Status checkSize(GlApi& gl, GlState& state, const HostTexture& host, const Held& held)
{
    const GLenum target = host.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    Extent found;
    switch (host.kind) {
    case HostTexture::Kind::texture:
        state.bindTexture(0, host.name, 0, target);
        return checkBoundSize(gl, host, held, target);
    case HostTexture::Kind::layer: return checkArraySize(gl, host, held);
    case HostTexture::Kind::renderbuffer:
        gl.BindRenderbuffer(GL_RENDERBUFFER, host.name);
        gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &found.width);
        gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &found.height);
        return checkExtent(host, found);
    case HostTexture::Kind::framebuffer: break;  // not known of the default one
    }
    return {};
}

/// What a texture reads as, beside what it holds.
Status checkReading(const GlApi& gl, const HostTexture& host)
{
    const GLenum target = host.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
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
std::vector<GLenum> copyFormats(const HostTexture& host, const Held& held)
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
    if (host.format == Format::none || host.extent.width < 1 || host.extent.height < 1)
        return misfit(host, "has no format or size", "set HostTexture::format and extent");
    if (host.kind == HostTexture::Kind::framebuffer && !isDepth(host))
        return misfit(host, "is asked for colour", "hand over the texture that it draws into");
    if (host.samples < 1)
        return misfit(host, "has " + std::to_string(host.samples) + " samples a pixel",
                      "set HostTexture::samples to 1 or more");
    if (host.copied() && (host.x < 0 || host.y < 0 || host.layer < 0))
        return misfit(host, "is asked for a part below 0", "x, y and layer count from 0");
    return {};
}

}  // namespace

Status checkHostTexture(GlApi& gl, GlState& state, const HostTexture& host)
{
    if (Status status = checkKind(host); !status) return status;
    const auto framebuffer = GlFramebuffer::make(gl);
    if (Status status = attachForReading(gl, host, framebuffer.name()); !status) return status;
    const Held held = readHeld(gl, host);
    (void)gl.GetError();  // of what an attachment that is none cannot be asked
    if (Status status = checkHeld(host, held); !status) return status;
    if (Status status = checkSize(gl, state, host, held); !status) return status;
    return host.kind == HostTexture::Kind::texture ? checkReading(gl, host) : Status();
}

Result<GlHostCopy> GlHostCopy::make(GlApi& gl, GlState& state, const HostTexture& host)
{
    if (Status status = checkHostTexture(gl, state, host); !status) return status.diagnostics();
    GlHostCopy copy;
    copy.host_ = host;
    copy.from_ = GlFramebuffer::make(gl);
    copy.into_ = GlFramebuffer::make(gl);
    if (Status status = attachForReading(gl, host, copy.from_.name()); !status)
        return status.diagnostics();
    if (const GLenum complete = gl.CheckFramebufferStatus(GL_READ_FRAMEBUFFER);
        complete != GL_FRAMEBUFFER_COMPLETE)
        return Diagnostics{misfit(host,
                                  std::string("cannot be read: ") + framebufferStatusName(complete),
                                  "give it storage, and name a layer that it has")};
    Status status;
    for (const GLenum internal : copyFormats(host, readHeld(gl, host))) {
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
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, into_.name());
    gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, GL_TEXTURE_2D, texture_.name(), 0);
    gl.DrawBuffers(1, &buffer);
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
