// SPDX-License-Identifier: MIT
// Outputs in a host's own framebuffers and textures: what is drawn there, and what is refused.
#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

struct Targets : GlFixture {
    GLuint colorTexture(GLenum internal, Extent extent, GLsizei levels = 1)
    {
        auto made = GlTexture::make(gl);
        gl.BindTexture(GL_TEXTURE_2D, made.name());
        gl.TexStorage2D(GL_TEXTURE_2D, levels, internal, extent.width, extent.height);
        return textures.emplace_back(std::move(made)).name();
    }

    std::vector<GlTexture> textures;
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
    const GLuint into = colorTexture(GL_RGBA8, {4, 4});
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
