// SPDX-License-Identifier: MIT
// The host's own multisampled depth and normals: of each pixel one sample, whole.
#include "tests/support/picture.h"

#include "tests/backends/stage.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

constexpr int kSamples = 4;

const char* const kHostVertex = R"(#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_model;
uniform mat3 normal_from_model;
out vec3 facing;
void main()
{
    facing = normal_from_model * direction;
    gl_Position = clip_from_model * vec4(position, 1.0);
}
)";

const char* const kHostFragment = R"(in vec3 facing;
out vec4 normal;
void main() { normal = vec4(normalize(gl_FrontFacing ? facing : -facing) * 0.5 + 0.5, 1.0); })";

Description describeText(const std::string& config, const std::string& fragment = "")
{
    MemorySources mine;
    mine.add("configs/host.json", config);
    mine.add("mine/show.frag", fragment);
    const LayeredSources sources({&mine, &shippedSources()});
    return need(decode(need(loadConfig(sources, {"host"})), sources));
}

bool readsSamples()
{
    const GlFixture gl;
    if (gl.device->caps().version >= 310) return true;
    WARN("not tested: " << gl.device->caps().name << " has no OpenGL ES 3.1");
    return false;
}

/// Shows one sample of each pixel of a texture.
Description showingSample(const std::string& texture, int sample)
{
    return describeText(R"({"format": 1, "imports": {")" + texture + R"(": {"type": "texture"}},
        "targets": {"shown": {"format": ["rgba32f"]}},
        "shaders": {"show": {"vertex": "geometry/shaders/resolve.vert", "fragment": "mine/show.frag"}},
        "passes": {"show": {"shader": "show", "color": "shown"}}, "outputs": {"shown": "shown"}})",
                        "#version 310 es\nprecision highp float;\nuniform highp sampler2DMS " +
                            texture + ";\nout vec4 shown;\nvoid main() { shown = texelFetch(" +
                            texture + ", ivec2(gl_FragCoord.xy), " + std::to_string(sample) +
                            "); }\n");
}

glm::vec3 normalAt(const Image& image, int x, int y)
{
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// The share of pixels that differ by more than `limit`.
double shareApart(const Image& a, const Image& b, float limit)
{
    int apart = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        apart += std::abs(a.pixels[i] - b.pixels[i]) > limit ? 1 : 0;
    return double(apart) / double(a.pixels.size());
}

/// A host that draws the scene itself, once with one sample a pixel and once with several.
class Host : public GlFixture {
public:
    struct Drawn {
        TextureId depth, normal;
    };

    explicit Host(const std::string& name = "spheres") : stage(*device, {128, 72}, name)
    {
        one = draw(texture(Format::depth24, stage.extent), texture(Format::rgb10_a2, stage.extent));
        several = draw(multisampled(Format::depth24, GL_DEPTH_COMPONENT24),
                       multisampled(Format::rgb10_a2, GL_RGB10_A2));
    }

    ~Host() { gl.DeleteTextures(static_cast<GLsizei>(names_.size()), names_.data()); }

    /// An output of a config that draws no scene.
    Image run(const Description& description, const std::vector<ImportedTexture>& textures,
              const std::string& output)
    {
        Frame bare;
        bare.camera = stage.frame.camera;
        bare.textures = textures;
        const auto renderer = need(
            Renderer::create(*device, description, {stage.extent, {output}, {}}, traitsOf(bare)));
        need(renderer->render(bare));
        return read(renderer->output(output));
    }

    std::vector<ImportedTexture> samples() const
    {
        return {{"depth_samples", several.depth}, {"normal_samples", several.normal}};
    }

    Stage stage;
    Drawn one, several;

private:
    TextureId multisampled(Format format, GLenum internal)
    {
        const auto storage = reinterpret_cast<PFNGLTEXSTORAGE2DMULTISAMPLEPROC>(
            testContext().loader()("glTexStorage2DMultisample"));
        REQUIRE(storage);
        gl.GenTextures(1, &names_.emplace_back());
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, names_.back());
        storage(GL_TEXTURE_2D_MULTISAMPLE, kSamples, internal, stage.extent.width,
                stage.extent.height, GL_TRUE);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
        return need(device->adoptTexture({names_.back(), "host", format, stage.extent, kSamples}));
    }

    Drawn draw(TextureId depth, TextureId normal)
    {
        const ProgramId paint = program(kHostFragment, kHostVertex);
        PassInfo pass = wholePass(framebuffer({normal}, depth), stage.extent);
        pass.has_depth = true;
        pass.depth_load = LoadOp::clear;
        pass.depth_store = StoreOp::store;
        StateDesc state;
        state.depth_test = Compare::less;
        state.depth_write = true;
        drawPass(pass, [&] {
            device->setProgram(paint, state);
            for (const DrawItem& item : stage.frame.draws) {
                const glm::mat4 view = stage.frame.camera.view_from_world * item.world_from_model;
                const glm::mat4 clip = stage.frame.camera.clip_from_view * view;
                const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(view)));
                device->setUniform(location(paint, "clip_from_model"), GlslType::mat4, 1,
                                   glm::value_ptr(clip));
                device->setUniform(location(paint, "normal_from_model"), GlslType::mat3, 1,
                                   glm::value_ptr(normals));
                device->draw(item.mesh, item.first, item.count);
            }
        });
        return {depth, normal};
    }

    std::vector<GLuint> names_;
};

}  // namespace

TEST_CASE("Of a multisampled pixel the middle sample by depth is taken, and the normal of that one")
{
    if (!readsSamples()) return;
    Host host;
    const std::vector<ImportedTexture> textures = host.samples();
    const Description resolving = describeText(R"({"format": 1,
        "extends": ["geometry/host_depth_normal_msaa", "ssao/hemisphere", "filter/bilateral_normal"],
        "outputs": {"depth": "depth", "normal": "normal"}})");
    const Image depth = host.run(resolving, textures, "depth");
    const Image normal = host.run(resolving, textures, "normal");
    std::vector<Image> depths, normals;
    for (int i = 0; i < kSamples; ++i) {
        depths.push_back(host.run(showingSample("depth_samples", i), textures, "shown"));
        normals.push_back(host.run(showingSample("normal_samples", i), textures, "shown"));
    }
    int mixed = 0;
    for (int y = 0; y < depth.extent.height; ++y)
        for (int x = 0; x < depth.extent.width; ++x) {
            std::vector<float> sorted;
            for (const Image& each : depths) sorted.push_back(each.at(x, y));
            std::sort(sorted.begin(), sorted.end());
            REQUIRE(depth.at(x, y) == Approx(sorted[1]).margin(1e-7));
            const auto same = [&](int i) {
                return depths[i].at(x, y) == sorted[1] &&
                       normalAt(normals[i], x, y) == normalAt(normal, x, y);
            };
            REQUIRE((same(0) || same(1) || same(2) || same(3)));
            mixed += sorted[3] - sorted[0] > 0.001f ? 1 : 0;
        }
    CHECK(mixed > 50);
}

TEST_CASE(
    "Multisampled depth gives the occlusion of depth with one sample, outlines and faces alike")
{
    if (!readsSamples()) return;
    const char* const scene = GENERATE("spheres", "corner");
    Host host(scene);
    const auto occlusion = [&](const std::string& geometry,
                               const std::vector<ImportedTexture>& textures) {
        return host.run(describeText(R"({"format": 1, "extends": ["geometry/)" + geometry +
                                     R"(", "ssao/gtao", "filter/bilateral_normal"],
            "params": {"radius": {"default": 1}}})"),
                        textures, "ao");
    };
    for (const std::string geometry : {"host_depth", "host_depth_normal"}) {
        INFO(scene << ' ' << geometry);
        const Image one =
            occlusion(geometry, {{"depth", host.one.depth}, {"normal", host.one.normal}});
        const Image several = occlusion(geometry + "_msaa", host.samples());
        CHECK(meanChange(several, one) < 0.003);
        CHECK(shareApart(several, one, 0.1f) < 0.003);
    }
}
