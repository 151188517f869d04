// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_image.h"

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
    {Format::rgb565, {5, 6, 5, 0, 0}, kUnorm},
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

/// Finds the target of a texture by binding it, and puts each binding back.
Extent textureSize(const GlApi& gl, GLuint name, GLint level)
{
    constexpr GLenum kTargets[][2] = {
        {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
        {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
        {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
    };
    Extent size;
    if (!gl.GetTexLevelParameteriv) return size;
    for (const auto& [target, binding] : kTargets) {
        GLint bound = 0;
        gl.GetIntegerv(binding, &bound);
        gl.BindTexture(target, name);
        const bool right = gl.GetError() == GL_NO_ERROR;
        if (right) {
            gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &size.width);
            gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_HEIGHT, &size.height);
        }
        gl.BindTexture(target, static_cast<GLuint>(bound));
        if (right) break;
    }
    return size;
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

Extent askSize(const GlApi& gl, GLenum target, GLenum point)
{
    const GLint kind = parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (kind != GL_RENDERBUFFER && kind != GL_TEXTURE) return {};
    const auto name =
        static_cast<GLuint>(parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (kind == GL_TEXTURE)
        return textureSize(gl, name,
                           parameter(gl, target, point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL));
    Extent size;
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size.width);
    gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size.height);
    return size;
}

}  // namespace crevice
