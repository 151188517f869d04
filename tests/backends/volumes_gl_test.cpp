// SPDX-License-Identifier: MIT
// Volumes, mips and what blends by the smaller or larger, drawn for real.
#include "tests/support/gl_fixture.h"

#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kSize = {4, 4};
constexpr int kDepth = 4;
constexpr float kStep = 1.0f / 200;

/// A volume whose layer i holds (i + 1) / 8, drawn two layers at once.
struct Volume : GlFixture {
    TextureId volume = need(device->createTexture({"volume", Format::r8, kSize, 1, kDepth, true}));
    FramebufferId layers = need(device->createFramebuffer({"layers", {volume, volume}}));
    ProgramId filled = program(
        "uniform float value;\nlayout(location = 0) out float even;\n"
        "layout(location = 1) out float odd;\n"
        "void main() { even = value; odd = value + 0.125; }\n");
    ProgramId shown = program(
        "uniform highp sampler3D volume;\nuniform float at, level;\nin vec2 uv;\n"
        "layout(location = 0) out float seen;\n"
        "void main() { seen = textureLod(volume, vec3(0.5, 0.5, at), level).r; }\n");

    void fill(float plus = 0, Blend blend = Blend::none)
    {
        for (int layer = 0; layer < kDepth; layer += 2) {
            PassInfo pass = wholePass(layers, kSize, 2);
            pass.first_layer = layer;
            pass.makes_mips = layer + 2 == kDepth;
            if (blend != Blend::none) pass.color_load[0] = pass.color_load[1] = LoadOp::load;
            const float value = static_cast<float>(layer + 1) / 8 + plus;
            drawPass(pass, [&] {
                device->setProgram(filled, {Compare::always, false, Cull::none, blend});
                device->setUniform(location(filled, "value"), GlslType::float_, 1, &value);
                device->drawFullscreen();
            });
        }
    }

    float seen(float at, float level = 0, Filter filter = Filter::trilinear)
    {
        const TextureId picture = texture(Format::r8);
        drawPass(wholePass(framebuffer({picture}), {4, 4}), [&] {
            device->setProgram(shown, {});
            device->setTexture(location(shown, "volume"), 0, volume, {filter, Wrap::clamp});
            device->setUniform(location(shown, "at"), GlslType::float_, 1, &at);
            device->setUniform(location(shown, "level"), GlslType::float_, 1, &level);
            device->drawFullscreen();
        });
        return read(picture).at(1, 1, 0);
    }
};

}  // namespace

TEST_CASE("A volume is drawn layer by layer, and read between layers and between mips")
{
    Volume volume;
    volume.fill();
    for (int layer = 0; layer < kDepth; ++layer)
        CHECK(std::abs(volume.seen((layer + 0.5f) / kDepth) - (layer + 1) / 8.0f) < kStep);
    CHECK(std::abs(volume.seen(0.5f) - 2.5f / 8) < kStep);  // between the second and the third
    CHECK(std::abs(volume.seen(0.5f, 0, Filter::nearest) - 3.0f / 8) < kStep);
    CHECK(std::abs(volume.seen(0.25f, 1) - 1.5f / 8) < kStep);
    CHECK(std::abs(volume.seen(0.1f, 2) - 2.5f / 8) < kStep);
    CHECK(std::abs(volume.seen(0.25f, 1.5f) - 2.0f / 8) < kStep);
    CHECK(volume.device->info(volume.volume).depth == kDepth);
}

TEST_CASE("Blending keeps the larger or the smaller")
{
    Volume volume;
    volume.fill();
    volume.fill(0.25f, Blend::max);
    CHECK(std::abs(volume.seen(0.125f) - 3.0f / 8) < kStep);
    volume.fill(0.0f, Blend::max);
    CHECK(std::abs(volume.seen(0.125f) - 3.0f / 8) < kStep);
    volume.fill(0.0f, Blend::min);
    CHECK(std::abs(volume.seen(0.125f) - 1.0f / 8) < kStep);
}

TEST_CASE("What the host has bound as GL_TEXTURE_3D is bound again")
{
    Volume volume;
    GLuint own = 0;
    volume.gl.GenTextures(1, &own);
    volume.gl.ActiveTexture(GL_TEXTURE0);
    volume.gl.BindTexture(GL_TEXTURE_3D, own);
    volume.fill();
    volume.seen(0.5f);
    GLint bound = 0;
    volume.gl.GetIntegerv(GL_TEXTURE_BINDING_3D, &bound);
    CHECK(bound == static_cast<GLint>(own));
    volume.gl.DeleteTextures(1, &own);
}

TEST_CASE("A volume is no picture to read, and has its own limit")
{
    Volume volume;
    CHECK(onlyError(volume.device->readTexture(volume.volume), Code::bad_input).help ==
          "draw a layer of it into a picture");
    const int limit = volume.device->caps().max_volume_size;
    CHECK(limit >= 256);
    const TextureDesc deep{"deep", Format::r8, {1, 1}, 1, limit + 1};
    onlyError(volume.device->createTexture(deep), Code::too_big_for_device);
}
