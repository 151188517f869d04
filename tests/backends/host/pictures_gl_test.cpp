// SPDX-License-Identifier: MIT
// Pictures of a host's in every object that it may keep them in: taken as they are, copied, or
// refused with the reason.
#include "tests/backends/host/host_pictures.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {6, 4};
constexpr GLint kLayers = 3;

struct DepthFormat {
    Format format;
    GLenum internal, upload, type;
};
constexpr DepthFormat kDepthFormats[] = {
    {Format::depth16, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
    {Format::depth24, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {Format::depth24, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
    {Format::depth32f, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    {Format::depth32f, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV},
};

struct Pictures : HostPictures {
    /// Depth of the framebuffer that is bound: 0.25 left of `x`, and 0.75 from there.
    void fill(int x, Extent extent)
    {
        gl.Enable(GL_SCISSOR_TEST);
        const float left = 0.25f, right = 0.75f;
        gl.Scissor(0, 0, extent.width, extent.height);
        gl.ClearBufferfv(GL_DEPTH, 0, &left);
        gl.Scissor(x, 0, extent.width, extent.height);
        gl.ClearBufferfv(GL_DEPTH, 0, &right);
        gl.Disable(GL_SCISSOR_TEST);
    }

    GLuint depthTexture(const DepthFormat& format, Extent extent)
    {
        const GLuint made = newTexture(format.internal, extent);
        newFramebuffer();
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, made, 0);
        fill(3, extent);
        return made;
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
};

/// A function that the library has no need of.
template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(testContext().loader()(name));
}

}  // namespace

TEST_CASE_METHOD(Pictures, "Depth of every format is read, whole and in part")
{
    for (const DepthFormat& format : kDepthFormats) {
        INFO(formatInfo(format.format).name << " " << format.internal);
        const GLuint name = depthTexture(format, kExtent);
        HostTexture host{name, "depth", format.format, kExtent};
        checkStep(need(device->adoptTexture(host)), 3);
        host.format = Format::none;
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

TEST_CASE_METHOD(Pictures, "A layer of an array is copied, and again when it is refreshed")
{
    const auto storage = find<PFNGLTEXSTORAGE3DPROC>("glTexStorage3D");
    for (const DepthFormat& format : kDepthFormats) {
        INFO(format.internal);
        auto array = GlTexture::make(gl);
        gl.BindTexture(GL_TEXTURE_2D_ARRAY, array.name());
        storage(GL_TEXTURE_2D_ARRAY, 1, format.internal, kExtent.width, kExtent.height, kLayers);
        const GLuint into = newFramebuffer();
        const auto draw = [&](int layer, int x) {
            gl.BindFramebuffer(GL_FRAMEBUFFER, into);
            gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, array.name(), 0, layer);
            fill(x, kExtent);
        };
        draw(1, 1);
        draw(2, 2);
        HostTexture host{array.name(), "depth", format.format, kExtent};
        CHECK(refusal(host).find("is no GL_TEXTURE_2D") != std::string::npos);
        host.kind = HostTexture::Kind::layer;
        host.layer = 2;
        const TextureId copy = need(device->adoptTexture(host));
        checkStep(copy, 2);
        draw(2, 4);
        checkStep(copy, 2);
        need(device->refresh(copy));
        checkStep(copy, 4);
        if (gl.GetTexLevelParameteriv) {
            host.extent.width += 1;
            CHECK(refusal(host).find("has 6x4 pixels") != std::string::npos);
            HostTexture drawn{into, "depth", format.format, host.extent};
            drawn.kind = HostTexture::Kind::framebuffer;
            CHECK(refusal(drawn).find("has 6x4 pixels") != std::string::npos);
            host.extent = kExtent;
        }
        host.layer = kLayers;
        CHECK(!refusal(host).empty());
        CHECK(gl.GetError() == GL_NO_ERROR);
    }
}

TEST_CASE_METHOD(Pictures, "A renderbuffer's depth is copied, and so is a framebuffer's")
{
    for (const int samples : {0, 4}) {
        for (const DepthFormat& format : kDepthFormats) {
            INFO(format.internal << ", samples " << samples);
            const GLuint buffer = newRenderbuffer(format.internal, kExtent, samples);
            const GLuint into = newFramebuffer();
            gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                       buffer);
            fill(2, kExtent);
            HostTexture host{buffer, "depth", format.format, kExtent};
            host.kind = HostTexture::Kind::renderbuffer;
            checkStep(need(device->adoptTexture(host)), 2);
            host.kind = HostTexture::Kind::framebuffer;
            host.name = into;
            checkStep(need(device->adoptTexture(host)), 2);
        }
    }
}

TEST_CASE_METHOD(Pictures,
                 "Several samples of a texture are read as they are, or resolved by a copy")
{
    const auto storage = find<PFNGLTEXSTORAGE2DMULTISAMPLEPROC>("glTexStorage2DMultisample");
    if (!storage || device->caps().version < 310) return;
    auto several = GlTexture::make(gl);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, several.name());
    storage(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_DEPTH_COMPONENT24, kExtent.width, kExtent.height,
            GL_TRUE);
    newFramebuffer();
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE,
                            several.name(), 0);
    fill(2, kExtent);
    HostTexture host{several.name(), "depth", Format::depth24, kExtent, 4};
    CHECK(device->info(need(device->adoptTexture(host))).samples == 4);
    host.part = true;
    checkStep(need(device->adoptTexture(host)), 2);
    host.x = 1;
    CHECK(refusal(host).find("has 6x4 pixels") != std::string::npos);
    host.part = false;
    host.samples = 1;
    CHECK(refusal(host).find("is no GL_TEXTURE_2D") != std::string::npos);
}

TEST_CASE_METHOD(Pictures, "What is not as it was said to be is refused with what it is")
{
    const GLuint colour = newTexture(GL_RGBA8, {32, 32});
    HostTexture host{colour, "depth", Format::depth24, {96, 64}};
    CHECK(refusal(host).find("for 'depth' holds") != std::string::npos);
    host.format = Format::rgba8;
    CHECK(!refusal(host).empty());
    if (gl.GetTexLevelParameteriv && device->caps().version >= 310)
        CHECK(refusal(host).find("has 32x32 pixels; it was said to have 96x64") !=
              std::string::npos);
    host.extent = {32, 32};
    CHECK(refusal(host).empty());
    for (const Extent other : {Extent{31, 32}, Extent{32, 33}, Extent{0, 32}}) {
        host.extent = other;
        CHECK(!refusal(host).empty());
    }
    host.extent = {32, 32};
    for (const Format other : {Format::rgba16f, Format::rgb10_a2, Format::depth16, Format::none}) {
        host.format = other;
        CHECK(!refusal(host).empty());
    }
    host = {depthTexture(kDepthFormats[0], kExtent), "depth", Format::depth24, kExtent};
    CHECK(refusal(host).find("depth of 16 bits") != std::string::npos);
    host = {newTexture(GL_SRGB8_ALPHA8, kExtent), "normal", Format::rgba8, kExtent};
    CHECK(refusal(host).find("sRGB") != std::string::npos);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);

    host = {newTexture(GL_RGBA8, kExtent), "normal", Format::rgba8, kExtent};
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_BLUE);
    CHECK(refusal(host).find("GL_TEXTURE_SWIZZLE") != std::string::npos);

    host = {0, "depth", Format::depth24, kExtent};
    host.kind = HostTexture::Kind::renderbuffer;
    CHECK(!refusal(host).empty());
    host = {depthTexture(kDepthFormats[1], kExtent), "depth", Format::depth24, {5, 4}};
    host.part = true;
    host.x = 2;
    CHECK(!refusal(host).empty());
    host.x = -1;
    CHECK(!refusal(host).empty());
}

TEST_CASE("OpenGL ES 3.0, which cannot be asked for sizes, refuses other ones too")
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    GlFixture fixture(options);
    if (fixture.device->caps().version != 300) return;
    for (const DepthFormat& format : kDepthFormats) {
        INFO(format.internal);
        auto made = GlTexture::make(fixture.gl);
        fixture.gl.BindTexture(GL_TEXTURE_2D, made.name());
        fixture.gl.TexStorage2D(GL_TEXTURE_2D, 1, format.internal, 6, 4);
        for (const Extent extent :
             {Extent{6, 4}, Extent{5, 4}, Extent{6, 3}, Extent{7, 4}, Extent{6, 5}, Extent{4, 6}}) {
            INFO(extent.width << "x" << extent.height);
            const auto adopted =
                fixture.device->adoptTexture({made.name(), "depth", format.format, extent});
            CHECK(adopted.ok() == (extent == Extent{6, 4}));
        }
    }
}

TEST_CASE_METHOD(Pictures,
                 "An output is drawn into a part of a host's texture or framebuffer, at any size")
{
    const GLuint into = newTexture(GL_RGBA8, {8, 8});
    const float black[] = {0, 0, 0, 1};
    const GLuint framebuffer = newFramebuffer();
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, into, 0);
    const TextureId source = texture(Format::rgba8, {4, 4});
    Image image({4, 4}, 4, 1.0f);
    for (int i = 0; i < 8; ++i) image.pixels[i * 4] = 0.0f;  // the lower half has no red
    need(device->writeTexture(source, image));
    HostFramebuffer target{framebuffer, 3, 2, {2, 2}};
    for (const GLuint name : {0u, into}) {
        target.texture = name;
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.ClearBufferfv(GL_COLOR, 0, black);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        need(device->present(source, target));
        const Image drawn = read(need(device->adoptTexture({into, "host", Format::rgba8, {8, 8}})));
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                CHECK(drawn.at(x, y, 0) == (x >= 3 && x < 5 && y == 3 ? 1.0f : 0.0f));
    }
    target.texture = depthTexture(kDepthFormats[1], kExtent);
    const Status refused = device->present(source, target);
    REQUIRE(!refused);
    CHECK(refused.diagnostics()[0].message.find("cannot be drawn into") != std::string::npos);
}
