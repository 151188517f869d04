// SPDX-License-Identifier: MIT
#include "backends/gl/formats.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

namespace crevice {

namespace {

const GlFormat kFormats[] = {
    {Format::r8, GL_R8, GL_RED, GL_UNSIGNED_BYTE},
    {Format::rg8, GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
    {Format::rgb565, GL_RGB565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
    {Format::rgba8, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {Format::rgb10_a2, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
    {Format::r16f, GL_R16F, GL_RED, GL_FLOAT},
    {Format::rg16f, GL_RG16F, GL_RG, GL_FLOAT},
    {Format::rgba16f, GL_RGBA16F, GL_RGBA, GL_FLOAT},
    {Format::r32f, GL_R32F, GL_RED, GL_FLOAT},
    {Format::rg32f, GL_RG32F, GL_RG, GL_FLOAT},
    {Format::rgba32f, GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {Format::r11g11b10f, GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT},
    {Format::depth16, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
    {Format::depth24, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {Format::depth32f, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
};

/// Those that the device alone asks for.
constexpr GlFormat kOtherFormats[] = {
    {Format::none, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
    {Format::none, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
    {Format::none, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV},
};

const GlFormat& formatOfInternal(GLenum internal)
{
    for (const GlFormat& each : kFormats)
        if (each.internal == internal) return each;
    for (const GlFormat& each : kOtherFormats)
        if (each.internal == internal) return each;
    return glFormat(Format::depth32f);  // GL_DEPTH_COMPONENT32, of desktop OpenGL
}

using Pixel = std::array<float, 4>;

/// `value` in steps of 1 / (2^bits - 1).
std::uint32_t toUnorm(float value, int bits)
{
    const double most = std::ldexp(1.0, bits) - 1.0;
    if (!(value > 0.0f)) return 0;  // NaN too
    if (value >= 1.0f) return static_cast<std::uint32_t>(most);
    return static_cast<std::uint32_t>(value * most + 0.5);
}

Pixel pixelAt(const Image& image, std::size_t index)
{
    Pixel pixel = {0, 0, 0, 1};
    for (int c = 0; c < image.channels && c < 4; ++c)
        pixel[c] = image.pixels[index * image.channels + c];
    return pixel;
}

template <class T>
void append(std::vector<std::uint8_t>& bytes, T value)
{
    std::uint8_t raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.insert(bytes.end(), raw, raw + sizeof(T));
}

void appendPixel(std::vector<std::uint8_t>& bytes, const Pixel& p, GLenum type, int channels)
{
    if (type == GL_UNSIGNED_INT_2_10_10_10_REV) {
        append(bytes, toUnorm(p[3], 2) << 30 | toUnorm(p[2], 10) << 20 | toUnorm(p[1], 10) << 10 |
                          toUnorm(p[0], 10));
        return;
    }
    if (type == GL_UNSIGNED_SHORT_5_6_5)
        return append(bytes, static_cast<std::uint16_t>(toUnorm(p[0], 5) << 11 |
                                                        toUnorm(p[1], 6) << 5 | toUnorm(p[2], 5)));
    for (int c = 0; c < channels; ++c) {
        if (type == GL_UNSIGNED_BYTE) append(bytes, static_cast<std::uint8_t>(toUnorm(p[c], 8)));
        if (type == GL_UNSIGNED_SHORT) append(bytes, static_cast<std::uint16_t>(toUnorm(p[c], 16)));
        if (type == GL_FLOAT) append(bytes, p[c]);
        if (type == GL_UNSIGNED_INT) {  // 24 bits, widened so that the driver keeps them
            const std::uint32_t depth = toUnorm(p[c], 24);
            append(bytes, depth << 8 | depth >> 16);
        }
    }
}

}  // namespace

const GlFormat& glFormat(Format format)
{
    assert(format != Format::none);
    return kFormats[static_cast<int>(format) - 1];
}

void allocateTexture(const GlApi& gl, GLenum internal, Extent extent, int depth, int levels)
{
    const GLenum target = depth > 0 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(target, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.TexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
    if (gl.TexStorage2D && depth == 0) {
        gl.TexStorage2D(target, levels, internal, extent.width, extent.height);
        return;
    }
    const GlFormat& format = formatOfInternal(internal);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (int level = 0; level < levels; ++level) {
        const auto edge = [level](int texels) { return std::max(texels >> level, 1); };
        const auto of_level = static_cast<GLint>(internal);
        if (depth > 0)
            gl.TexImage3D(target, level, of_level, edge(extent.width), edge(extent.height),
                          edge(depth), 0, format.upload_format, format.upload_type, nullptr);
        else
            gl.TexImage2D(target, level, of_level, edge(extent.width), edge(extent.height), 0,
                          format.upload_format, format.upload_type, nullptr);
    }
}

std::vector<std::uint8_t> packPixels(const Image& image, Format format)
{
    const int channels = formatInfo(format).channels;
    const GLenum type = glFormat(format).upload_type;
    const std::size_t count = static_cast<std::size_t>(image.extent.width) * image.extent.height;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(count * channels * sizeof(float));
    for (std::size_t i = 0; i < count; ++i) appendPixel(bytes, pixelAt(image, i), type, channels);
    return bytes;
}

}  // namespace crevice
