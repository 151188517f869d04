// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_image.h"

#include "backends/gl/formats.h"

#include <algorithm>

namespace crevice {

namespace {

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

GLint parameter(const GlApi& gl, GLenum target, GLenum point, GLenum what)
{
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(target, point, what, &value);
    return value;
}

/// Takes all errors, and gives the last of them.
GLenum lastError(const GlApi& gl)
{
    GLenum last = GL_NO_ERROR;
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR && last != GL_CONTEXT_LOST;
         error = gl.GetError())
        last = error;
    return last;
}

/// The format that holds just that; any where there is none.
Format formatOf(const GlHeld& held)
{
    for (const Wanted& wanted : kWanted)
        if (held.type == wanted.type && std::equal(held.bits, held.bits + 5, wanted.bits))
            return wanted.format;
    return Format::rgba8;
}

/// An image of a texture that is bound.
struct BoundImage {
    GLenum target;
    GLint level;
    GlHeld held;
};

/// What OpenGL ES 3.0, which cannot be asked for sizes, says of a write of nothing there.
GLenum writeNothing(const GlApi& gl, const BoundImage& image, GLint x, GLint y)
{
    const GlFormat& format = glFormat(formatOf(image.held));
    GLenum upload_format = format.upload_format, upload_type = format.upload_type;
    if (image.held.stencil > 0) {
        upload_format = GL_DEPTH_STENCIL;
        upload_type =
            image.held.type == GL_FLOAT ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV : GL_UNSIGNED_INT_24_8;
    }
    const GLuint nothing[2] = {};
    gl.TexSubImage2D(image.target, image.level, x, y, 0, 0, upload_format, upload_type, nothing);
    return lastError(gl);
}

GlReach compare(Extent size, Extent end, bool or_later)
{
    const bool reaches = size.width >= end.width && size.height >= end.height;
    return {size.width == 0 || (or_later ? reaches : size == end), size};
}

GlReach reachOf(const GlApi& gl, const BoundImage& image, Extent end, bool or_later)
{
    if (gl.GetTexLevelParameteriv) {
        Extent size;
        gl.GetTexLevelParameteriv(image.target, image.level, GL_TEXTURE_WIDTH, &size.width);
        gl.GetTexLevelParameteriv(image.target, image.level, GL_TEXTURE_HEIGHT, &size.height);
        return compare(size, end, or_later);
    }
    if (writeNothing(gl, image, 0, 0) != GL_NO_ERROR) return {};  // of layers and other formats
    const auto reaches = [&](GLint x, GLint y) {
        return writeNothing(gl, image, x, y) != GL_INVALID_VALUE;
    };
    const bool ends = or_later || (!reaches(end.width + 1, 0) && !reaches(0, end.height + 1));
    return {ends && reaches(end.width, end.height), {}};
}

/// Finds the target of a texture by binding it, and puts each binding back.
GlReach textureReach(const GlApi& gl, GLuint name, BoundImage image, Extent end, bool or_later)
{
    constexpr GLenum kTargets[][2] = {
        {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
        {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
        {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
    };
    (void)lastError(gl);
    for (const auto& [target, binding] : kTargets) {
        if (target == GL_TEXTURE_2D_MULTISAMPLE && !gl.GetTexLevelParameteriv) continue;
        GLint bound = 0;
        gl.GetIntegerv(binding, &bound);
        gl.BindTexture(target, name);
        const bool right = lastError(gl) == GL_NO_ERROR;
        image.target = target;
        const GlReach reach = right ? reachOf(gl, image, end, or_later) : GlReach();
        gl.BindTexture(target, static_cast<GLuint>(bound));
        if (right) return reach;
    }
    return {};
}

}  // namespace

bool GlHeld::fits(Format format) const
{
    const Wanted* wanted = std::begin(kWanted);
    while (wanted->format != format) ++wanted;
    bool enough = type == wanted->type;
    for (int i = 0; i < 5; ++i) enough = enough && bits[i] >= wanted->bits[i];
    return enough;
}

Format GlHeld::depthFormat() const
{
    if (type == GL_FLOAT) return Format::depth32f;
    return bits[4] == 16 ? Format::depth16 : Format::depth24;
}

bool GlHeld::empty() const
{
    return type == GL_NONE || std::all_of(bits, bits + 5, [](GLint count) { return count == 0; });
}

GlHeld readHeld(const GlApi& gl, GLenum target, GLenum point)
{
    const auto get = [&](GLenum what) { return parameter(gl, target, point, what); };
    GlHeld held;
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

std::string textOf(const GlHeld& held)
{
    const auto number = [&](int i) { return std::to_string(held.bits[i]); };
    const std::string type = held.type == GL_FLOAT ? "float"
                             : held.type == kUnorm ? "normalised"
                                                   : "integer or signed";
    if (held.bits[4] > 0) return "depth of " + number(4) + " bits, " + type;
    return "colour of " + number(0) + ", " + number(1) + ", " + number(2) + " and " + number(3) +
           " bits, " + (held.srgb ? "sRGB" : type);
}

bool isCountable(int x, int y, Extent extent)
{
    return x >= 0 && y >= 0 && x <= kLastPixel - extent.width && y <= kLastPixel - extent.height;
}

std::string sizeText(Extent extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

GlReach askReach(const GlApi& gl, GLenum target, GLenum point, Extent end, bool or_later)
{
    const GLint kind = parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (kind != GL_RENDERBUFFER && kind != GL_TEXTURE) return {};
    const auto name =
        static_cast<GLuint>(parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (kind == GL_TEXTURE) {
        const GLint level = parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
        const BoundImage image = {GL_NONE, level, readHeld(gl, target, point)};
        return textureReach(gl, name, image, end, or_later);
    }
    Extent size;
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.width);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.height);
    return compare(size, end, or_later);
}

}  // namespace crevice
