// SPDX-License-Identifier: MIT
// Outputs in a host's own framebuffers and textures: what is drawn there, and what is refused.
#include "tests/backends/host/host_pictures.h"

#include <limits>

using namespace crevice;

namespace {

constexpr int kMax = std::numeric_limits<int>::max();

GlDeviceOptions bare()
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    return options;
}

struct Targets : HostPictures {
    using HostPictures::HostPictures;

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
};

}  // namespace

TEST_CASE_METHOD(Targets, "One channel is presented as grey, two as red and green, alpha is 1")
{
    constexpr struct {
        Format format;
        float wanted[4];
    } kCases[] = {{Format::r8, {0.2f, 0.2f, 0.2f, 1}},
                  {Format::rg8, {0.2f, 0.4f, 0, 1}},
                  {Format::rgba8, {0.2f, 0.4f, 0.6f, 0.8f}},
                  {Format::r8, {0.2f, 0.2f, 0.2f, 1}}};
    const GLuint into = newTexture(GL_RGBA8, {4, 4});
    const TextureId drawn = need(device->adoptTexture({into, "host", Format::rgba8, {4, 4}}));
    for (const auto& each : kCases) {
        INFO(formatInfo(each.format).name);
        const TextureId source = texture(each.format);
        Image image({4, 4}, 4);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = 0.2f * static_cast<float>(i % 4 + 1);
        need(device->writeTexture(source, image));
        HostFramebuffer target;
        target.texture = into;
        target.extent = {4, 4};
        need(device->present(source, target));
        const Image found = read(drawn);
        for (int channel = 0; channel < 4; ++channel)
            CHECK(found.at(1, 2, channel) == Approx(each.wanted[channel]).margin(1e-4));
    }
}

TEST_CASE_METHOD(Targets, "What is presented may multiply what is there, and then leaves its alpha")
{
    const GLuint into = newTexture(GL_RGBA8, {4, 4});
    const TextureId drawn = need(device->adoptTexture({into, "host", Format::rgba8, {4, 4}}));
    const TextureId ao = texture(Format::r8);
    const auto fill = [&](TextureId id, const std::vector<float>& color) {
        Image image({4, 4}, static_cast<int>(color.size()));
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = color[i % color.size()];
        need(device->writeTexture(id, image));
    };
    const TextureId picture = texture(Format::rgba8);
    fill(picture, {1.0f, 0.8f, 0.4f, 0.6f});
    fill(ao, {0.5f});
    HostFramebuffer target;
    target.texture = into;
    target.extent = {4, 4};
    need(device->present(picture, target));
    target.extent = {2, 4};
    target.multiply = true;
    need(device->present(ao, target));
    target.multiply = false;
    target.x = 2;
    target.extent = {1, 4};
    need(device->present(ao, target));
    constexpr float kWanted[3][4] = {
        {0.5f, 0.4f, 0.2f, 0.6f}, {0.5f, 0.5f, 0.5f, 1.0f}, {1.0f, 0.8f, 0.4f, 0.6f}};
    const Image found = read(drawn);
    for (int column = 1; column < 4; ++column)
        for (int channel = 0; channel < 4; ++channel)
            CHECK(found.at(column, 2, channel) ==
                  Approx(kWanted[column - 1][channel]).margin(0.003));
}

TEST_CASE("A rectangle that leaves the host's target is refused, on OpenGL ES 3.0 too")
{
    Targets host(GENERATE(GlDeviceOptions(), bare()));
    const GlApi& gl = host.gl;
    HostFramebuffer target;
    for (const GLenum internal : {GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F, GL_R8}) {
        INFO(internal);
        target.texture = host.newTexture(internal, {16, 12}, 2);
        target.level = 1;
        host.checkRectangles(target);
    }
    const GLuint framebuffer = host.newFramebuffer();
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            host.newTexture(GL_RGBA8, {16, 16}), 0);
    const GLenum none = GL_NONE, first = GL_COLOR_ATTACHMENT0;
    gl.DrawBuffers(1, &none);
    target = {framebuffer, 0, 0, {32, 32}};
    CHECK(host.refusal(target).empty());  // nothing is drawn
    gl.DrawBuffers(1, &first);
    CHECK(!host.refusal(target).empty());
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               host.newRenderbuffer(GL_RGBA8, {8, 6}));
    host.checkRectangles(target);
    target.extent = {9, 6};
    CHECK(host.refusal(target).find("has 8x6 pixels, and the rectangle to draw into ends at 9x6") !=
          std::string::npos);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_CASE("A framebuffer's depth of another size than was said is refused")
{
    Targets host(GENERATE(GlDeviceOptions(), bare()));
    const GlApi& gl = host.gl;
    const GLuint framebuffer = host.newFramebuffer();
    HostTexture depth{framebuffer, "depth", Format::depth24, {8, 6}};
    depth.kind = HostTexture::Kind::framebuffer;
    const auto check = [&] {
        depth.part = false;
        depth.extent = {8, 6};
        CHECK(host.refusal(depth).empty());
        depth.extent = {9, 6};
        CHECK(host.refusal(depth).find("it was said to have 9x6") != std::string::npos);
        depth.extent = {8, 5};
        CHECK(!host.refusal(depth).empty());
        depth.part = true;
        CHECK(host.refusal(depth).empty());
        depth.extent = {8, 7};
        CHECK(host.refusal(depth).find("is said to end at 8x7") != std::string::npos);
    };
    for (const GLenum internal : {GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8}) {
        INFO(internal);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                                host.newTexture(internal, {8, 6}), 0);
        check();
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   host.newRenderbuffer(internal, {8, 6}));
        check();
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_CASE_METHOD(Targets, "A part of a host's picture that ends where no int counts is refused")
{
    HostTexture host{newTexture(GL_RGBA8, {8, 6}), "colour", Format::rgba8, {4, 4}};
    host.part = true;
    CHECK(refusal(host).empty());
    for (const int far : {kMax, kMax - 1, kMax - 4, -1, -kMax - 1}) {
        INFO(far);
        host.x = far;
        CHECK(!refusal(host).empty());
        host.x = 0;
        host.y = far;
        CHECK(!refusal(host).empty());
        host.y = 0;
    }
    host.x = 1;
    host.extent = {kMax, 4};
    CHECK(!refusal(host).empty());
    host.part = false;
    CHECK(!refusal(host).empty());
}
