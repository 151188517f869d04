// SPDX-License-Identifier: MIT
// Pictures of a host's: taken as they are, drawn into, or refused with the reason. That depth is
// the same wherever it lies, hosts in random states find.
#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

#include <limits>

using namespace crevice;

namespace {

constexpr Extent kExtent = {8, 6};
constexpr int kMax = std::numeric_limits<int>::max();

struct DepthFormat {
    Format format;
    GLenum internal;
};
constexpr DepthFormat kDepthFormats[] = {
    {Format::depth16, GL_DEPTH_COMPONENT16},  {Format::depth24, GL_DEPTH_COMPONENT24},
    {Format::depth24, GL_DEPTH24_STENCIL8},   {Format::depth32f, GL_DEPTH_COMPONENT32F},
    {Format::depth32f, GL_DEPTH32F_STENCIL8},
};

struct Pictures : GlFixture {
    /// Left bound.
    GLuint newTexture(GLenum internal, Extent extent = kExtent, GLsizei levels = 1)
    {
        const GLuint name = textures.emplace_back(GlTexture::make(gl)).name();
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexStorage2D(GL_TEXTURE_2D, levels, internal, extent.width, extent.height);
        return name;
    }

    /// Left bound.
    GLuint newFramebuffer(GLenum attachment, GLuint texture)
    {
        const GLuint name = framebuffers.emplace_back(GlFramebuffer::make(gl)).name();
        gl.BindFramebuffer(GL_FRAMEBUFFER, name);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
        return name;
    }

    /// "" where an output is drawn there, else why not.
    std::string refusal(const HostFramebuffer& target)
    {
        if (!shown) shown = texture(Format::rgba8);
        return reasonOf(device->present(shown, target).diagnostics());
    }

    /// "" where the picture is adopted, else why not.
    std::string refusal(const HostTexture& host)
    {
        return reasonOf(device->adoptTexture(host).diagnostics());
    }

    std::string reasonOf(const Diagnostics& found)
    {
        CHECK(gl.GetError() == GL_NO_ERROR);
        if (found.empty()) return "";
        REQUIRE(found.size() == 1);
        CHECK(found[0].code == Code::bad_input);
        CHECK(!found[0].help.empty());
        return found[0].message;
    }

    /// A step from 0.25 to 0.75 at column `x`.
    void checkStep(TextureId id, int x)
    {
        const Image image = read(id);
        for (int column = 0; column < image.extent.width; ++column) {
            INFO(column);
            CHECK(image.at(column, 1) == Approx(column < x ? 0.25f : 0.75f).margin(1e-4));
        }
    }

    /// A texture of one colour.
    TextureId plain(Format format, const std::vector<float>& color)
    {
        const TextureId id = texture(format);
        Image image({4, 4}, static_cast<int>(color.size()));
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = color[i % color.size()];
        need(device->writeTexture(id, image));
        return id;
    }

    /// All rectangles that leave a target of 8x6 pixels are refused, and those within are not.
    void checkRectangles(HostFramebuffer target)
    {
        constexpr HostFramebuffer kWithin[] = {{0, 0, 0, {8, 6}}, {0, 7, 5, {1, 1}}};
        constexpr HostFramebuffer kOutside[] = {
            {0, 0, 0, {9, 6}},    {0, 0, 0, {8, 7}},       {0, 8, 0, {1, 1}},
            {0, 0, 6, {1, 1}},    {0, -1, 0, {4, 4}},      {0, 0, -1, {4, 4}},
            {0, kMax, 0, {4, 4}}, {0, 1, 0, {kMax, 4}},    {0, 0, kMax, {4, 4}},
            {0, 0, 4, {4, kMax}}, {0, 0, 0, {kMax, kMax}}, {0, -kMax - 1, 0, {4, 4}},
            {0, 0, 0, {0, 4}},    {0, 0, 0, {4, 0}}};
        const auto refused = [&](const HostFramebuffer& rectangle) {
            target.x = rectangle.x;
            target.y = rectangle.y;
            target.extent = rectangle.extent;
            return !refusal(target).empty();
        };
        for (const HostFramebuffer& each : kWithin) CHECK_FALSE(refused(each));
        for (const HostFramebuffer& each : kOutside) {
            INFO(each.x << ", " << each.y << ": " << each.extent.width << "x"
                        << each.extent.height);
            CHECK(refused(each));
        }
    }

    TextureId shown;
    std::vector<GlTexture> textures;
    std::vector<GlFramebuffer> framebuffers;
};

}  // namespace

TEST_CASE_METHOD(Pictures, "Depth of every format is read, whole and in part")
{
    for (const DepthFormat& format : kDepthFormats) {
        INFO(formatInfo(format.format).name << " " << format.internal);
        const GLuint name = newTexture(format.internal);
        newFramebuffer(GL_DEPTH_ATTACHMENT, name);
        gl.Enable(GL_SCISSOR_TEST);
        for (const auto& [x, depth] : {std::pair(0, 0.25f), {3, 0.75f}}) {
            gl.Scissor(x, 0, kExtent.width, kExtent.height);
            gl.ClearBufferfv(GL_DEPTH, 0, &depth);
        }
        gl.Disable(GL_SCISSOR_TEST);
        HostTexture host{name, "depth", Format::none, kExtent};
        const TextureId found = need(device->adoptTexture(host));
        CHECK(device->info(found).format == format.format);
        checkStep(found, 3);
        host.part = true;
        host.x = 2;
        host.y = 1;
        host.extent = {3, 2};
        checkStep(need(device->adoptTexture(host)), 1);
    }
}

TEST_CASE_METHOD(Pictures, "What is not as it was said to be is refused with what it is")
{
    struct Case {
        GLuint name;
        Format format;
        Extent extent;
        const char* words;
    };
    const GLuint colour = newTexture(GL_RGBA8);
    const GLuint swizzled = newTexture(GL_RGBA8);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_BLUE);
    const bool asks = gl.GetTexLevelParameteriv && device->caps().version >= 310;
    const Case cases[] = {
        {colour, Format::depth24, kExtent, "for 'depth' holds"},
        {colour, Format::rgba8, asks ? Extent{96, 64} : Extent{},
         asks ? "8x6 pixels; it was said to have 96x64" : ""},
        {colour, Format::rgba8, {0, 6}, ""},
        {colour, Format::rgba16f, kExtent, ""},
        {colour, Format::none, kExtent, ""},
        {newTexture(GL_DEPTH_COMPONENT16), Format::depth24, kExtent, "depth of 16 bits"},
        {newTexture(GL_SRGB8_ALPHA8), Format::rgba8, kExtent, "sRGB"},
        {swizzled, Format::rgba8, kExtent, "GL_TEXTURE_SWIZZLE"},
        {0, Format::rgba8, kExtent, ""},
    };
    for (const Case& each : cases) {
        INFO(each.words);
        const std::string found = refusal({each.name, "depth", each.format, each.extent});
        CHECK_FALSE(found.empty());
        CHECK(found.find(each.words) != std::string::npos);
    }
    CHECK(refusal({colour, "colour", Format::rgba8, kExtent}).empty());
    HostTexture host{colour, "colour", Format::rgba8, {4, 4}};
    host.part = true;
    CHECK(refusal(host).empty());
    for (const int far : {asks ? 5 : kMax, kMax, kMax - 1, kMax - 4, -1, -kMax - 1}) {
        INFO(far);
        host.x = far;
        host.y = 0;
        CHECK(!refusal(host).empty());
        std::swap(host.x, host.y);
        CHECK(!refusal(host).empty());
    }
    host.kind = HostTexture::Kind::layer;
    CHECK(!refusal(host).empty());
}

TEST_CASE_METHOD(Pictures, "A picture of another size than was said is refused")
{
    if (device->caps().version < 310) return;  // cannot be asked for sizes
    for (const DepthFormat& format : kDepthFormats) {
        INFO(format.internal);
        const GLuint name = newTexture(format.internal);
        HostTexture framed{newFramebuffer(GL_DEPTH_ATTACHMENT, name), "depth", format.format};
        framed.kind = HostTexture::Kind::framebuffer;
        for (const Extent extent : {Extent{8, 6}, {7, 6}, {8, 5}, {9, 6}, {8, 7}, {6, 8}}) {
            INFO(extent.width << "x" << extent.height);
            framed.extent = extent;
            CHECK(refusal({name, "depth", format.format, extent}).empty() == (extent == kExtent));
            CHECK(refusal(framed).empty() == (extent == kExtent));
        }
    }
}

TEST_CASE_METHOD(Pictures, "A rectangle that leaves the host's target is refused")
{
    if (device->caps().version < 310) return;  // cannot be asked for sizes
    HostFramebuffer target;
    for (const GLenum internal : {GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F, GL_R8}) {
        INFO(internal);
        target.texture = newTexture(internal, {16, 12}, 2);
        target.level = 1;
        checkRectangles(target);
    }
    checkRectangles({newFramebuffer(GL_COLOR_ATTACHMENT0, newTexture(GL_RGBA8))});
    const GLenum none = GL_NONE;
    gl.DrawBuffers(1, &none);
    CHECK(refusal(HostFramebuffer{framebuffers.back().name(), 0, 0, {32, 32}}).empty());
    target = {0, 0, 0, kExtent};
    target.texture = newTexture(GL_DEPTH_COMPONENT24);
    CHECK(onlyCode(device->present(shown, target)) == Code::gl_error);
}

TEST_CASE_METHOD(Pictures,
                 "One channel is presented as grey, two as red and green, alpha is 1 but for four")
{
    const struct {
        Format format;
        std::vector<float> given, wanted;
        bool multiply = false;
    } cases[] = {{Format::r8, {0.2f}, {0.2f, 0.2f, 0.2f, 1}},
                 {Format::rg8, {0.2f, 0.4f}, {0.2f, 0.4f, 0, 1}},
                 {Format::rgba8, {1, 0.8f, 0.4f, 0.6f}, {1, 0.8f, 0.4f, 0.6f}},
                 {Format::r8, {0.5f}, {0.5f, 0.4f, 0.2f, 0.6f}, true}};  // with what is there
    HostFramebuffer target{0, 2, 1, {3, 4}};
    target.texture = newTexture(GL_RGBA8);
    const TextureId drawn =
        need(device->adoptTexture({target.texture, "", Format::rgba8, kExtent}));
    const Image before = read(drawn);
    for (const auto& each : cases) {
        INFO(formatInfo(each.format).name);
        target.multiply = each.multiply;
        need(device->present(plain(each.format, each.given), target));
        const Image found = read(drawn);
        for (int channel = 0; channel < 4; ++channel) {
            CHECK(found.at(2, 1, channel) == Approx(each.wanted[channel]).margin(0.003));
            CHECK(found.at(4, 4, channel) == found.at(2, 1, channel));
            for (const auto& [x, y] : {std::pair(1, 1), {5, 1}, {2, 0}, {2, 5}})
                CHECK(found.at(x, y, channel) == before.at(x, y, channel));
        }
    }
}
