// SPDX-License-Identifier: MIT
// The facade in a host's context: the host's own depth goes in, an AO texture comes out.
#include <crevice/effect.h>

#include "tests/support/gl_fixture.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};

const char* const kHostDepth = R"({ "format": 1, "name": "ao",
    "extends": ["geometry/host_depth", "ssao/gtao", "filter/bilateral_normal"] })";

/// The depth of a floor that meets a wall, as a host's texture.
struct HostDepth : GlFixture {
    /// As it is drawn under a depth range.
    explicit HostDepth(const DepthRange& of = {})
    {
        std::vector<float> depth;
        for (int y = 0; y < kExtent.height; ++y)
            depth.insert(depth.end(), kExtent.width,
                         glm::mix(of.near_depth, of.far_depth, windowDepth(y)));
        name = depthTexture(gl, kExtent, depth);
    }
    ~HostDepth() { gl.DeleteTextures(1, &name); }

    /// The floor lies 1 below the camera, and the wall 4 away.
    float windowDepth(int row) const
    {
        const float slope = ((row + 0.5f) / kExtent.height * 2 - 1) * std::tan(glm::radians(30.0f));
        const float distance = slope < -0.25f ? -1 / slope : 4.0f;
        const glm::vec4 clip = projection * glm::vec4(0, 0, -distance, 1);
        return clip.z / clip.w * 0.5f + 0.5f;
    }

    /// An effect that has drawn the host's depth once.
    Effect drawn() const
    {
        Effect effect = need(Effect::create(*device, kHostDepth, kExtent));
        effect.setProjection(glm::value_ptr(projection));
        need(effect.setTexture("depth", name, Format::depth32f, kExtent));
        need(effect.setParam("radius", 1));
        need(effect.render());
        return effect;
    }

    glm::mat4 projection = glm::perspective(glm::radians(60.0f), 16.0f / 9.0f, 0.1f, 100.0f);
    GLuint name = 0;
};

float maxDifference(const Image& a, const Image& b)
{
    float most = 0;
    REQUIRE(a.pixels.size() == b.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
    return most;
}

}  // namespace

TEST_CASE("A host's depth gives an AO texture that is darker in the corner than on the wall")
{
    HostDepth host;
    Effect effect = host.drawn();
    const Image ao = host.read(effect.output("ao"));
    CHECK(ao.extent == kExtent);
    const int corner =
        static_cast<int>((1 - 0.25f / std::tan(glm::radians(30.0f))) / 2 * kExtent.height);
    CHECK(ao.at(32, corner) < 0.85f);
    CHECK(ao.at(32, kExtent.height - 2) > 0.95f);
    CHECK(host.gl.IsTexture(effect.nativeName("ao")));
}

TEST_CASE("Under any depth range of the host the same AO comes out, and the range is put back")
{
    const Image plain = [] {
        HostDepth host;
        return host.read(host.drawn().output("ao"));
    }();
    for (const DepthRange range :
         {DepthRange{0, 0.5f}, {0.25f, 0.75f}, {1, 0}, {0, 0.125f}, {0.5f, 0}}) {
        INFO(range.near_depth << " " << range.far_depth);
        HostDepth host(range);
        host.gl.DepthRangef(range.near_depth, range.far_depth);
        Effect effect = host.drawn();
        CHECK(maxDifference(host.read(effect.output("ao")), plain) < 0.01f);
        CHECK(host.device->depthRange() == range);
        host.gl.DepthRangef(0, 1);
        effect.setDepthRange(range);  // as it was when the depth was drawn
        need(effect.render());
        CHECK(maxDifference(host.read(effect.output("ao")), plain) < 0.01f);
    }
}

TEST_CASE("A texture that the host deleted is an error with its name, until there is another")
{
    HostDepth host;
    Effect effect = host.drawn();
    const GLuint gone = host.name;
    host.gl.DeleteTextures(1, &host.name);
    for (int frame = 0; frame < 2; ++frame) {
        CHECK_THAT(
            onlyError(effect.render(), Code::bad_input).message,
            Catch::Contains("texture " + std::to_string(gone)) && Catch::Contains("deleted"));
        CHECK_FALSE(host.gl.IsTexture(gone));
    }
    host.name =
        depthTexture(host.gl, kExtent, std::vector<float>(kExtent.width * kExtent.height, 1.0f));
    need(effect.setTexture("depth", host.name, Format::depth32f, kExtent));
    need(effect.render());
}

TEST_CASE("An effect follows what the host draws into its depth")
{
    HostDepth host;
    Effect effect = host.drawn();
    const Image before = host.read(effect.output("ao"));
    const std::vector<float> background(kExtent.width * kExtent.height, 1.0f);
    host.gl.BindTexture(GL_TEXTURE_2D, host.name);
    host.gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kExtent.width, kExtent.height, GL_DEPTH_COMPONENT,
                          GL_FLOAT, background.data());
    need(effect.render());
    const Image after = host.read(effect.output("ao"));
    CHECK(after.pixels != before.pixels);
    CHECK(after.at(32, 10) == 1.0f);
}

TEST_CASE("AO goes into a host's texture of half the size, as means of four pixels")
{
    HostDepth host;
    Effect effect = host.drawn();
    const Image ao = host.read(effect.output("ao"));
    const TextureId into = host.texture(Format::r8, {kExtent.width / 2, kExtent.height / 2});
    HostFramebuffer target;
    target.texture = host.device->nativeName(into);
    target.extent = {kExtent.width / 2, kExtent.height / 2};
    need(effect.present("ao", target));
    const Image half = host.read(into);
    for (int y = 0; y < half.extent.height; ++y) {
        float sum = 0;
        for (int i = 0; i < 4; ++i) sum += ao.at(32 + i % 2, 2 * y + i / 2);
        CHECK(half.at(16, y) == Approx(sum / 4).margin(1.5 / 255));
    }
}
