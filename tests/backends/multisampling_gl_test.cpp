// SPDX-License-Identifier: MIT
// Multisampling, drawn for real: what resolves to a mean, what to one sample, and what stays.
#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kSize = {32, 32};
constexpr int kSamples = 4;

/// A triangle across the picture, at a depth that rises to the right, in three attachments.
class TriangleFixture : public GlFixture {
public:
    struct Pictures {
        Image red, sum, depth;
    };

    Pictures draw(int samples)
    {
        const auto target = [&](Format format, int count) {
            return need(device->createTexture({"target", format, kSize, count}));
        };
        const TextureId red = target(Format::rgba8, 1);
        const TextureId sum = target(Format::rgb10_a2, 1);
        const TextureId depth = target(Format::depth24, 1);
        FramebufferDesc desc{"triangle", {red, {}, sum}, depth};
        if (samples > 1) {
            desc.resolve_color = std::exchange(
                desc.color,
                {target(Format::rgba8, samples), {}, target(Format::rgb10_a2, samples)});
            desc.resolve_depth = std::exchange(desc.depth, target(Format::depth24, samples));
        }
        draw(need(device->createFramebuffer(desc)), 3);
        return {read(red), read(sum), read(depth)};
    }

    void draw(FramebufferId into, int colors)
    {
        PassInfo pass = wholePass(into, kSize, colors);
        pass.has_depth = true;
        pass.depth_load = LoadOp::clear;
        pass.depth_store = StoreOp::store;
        pass.clear_depth = 1.0f;
        pass.color_store[1] = StoreOp::discard;
        StateDesc state;
        state.depth_test = Compare::less;
        state.depth_write = true;
        drawPass(pass, [&] {
            device->setProgram(painted, state);
            device->draw(triangle, 0, 3);
        });
    }

    /// A host's texture of several samples.
    TextureId samplesOf(Format format, GLenum internal)
    {
        const auto storage = reinterpret_cast<PFNGLTEXSTORAGE2DMULTISAMPLEPROC>(
            testContext().loader()("glTexStorage2DMultisample"));
        const GLuint name = names_.emplace_back(GlTexture::make(gl)).name();
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
        storage(GL_TEXTURE_2D_MULTISAMPLE, kSamples, internal, kSize.width, kSize.height, GL_TRUE);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
        return need(device->adoptTexture({name, "host", format, kSize, kSamples}));
    }

    /// An output of a config that draws no scene.
    Image run(const std::string& config, const std::vector<ImportedTexture>& textures,
              const std::string& output, const std::string& fragment = "")
    {
        MemorySources mine;
        mine.add("configs/host.json", config);
        mine.add("mine/show.frag", fragment);
        const LayeredSources sources({&mine, &shippedSources()});
        Frame frame;
        frame.textures = textures;
        const auto renderer = need(
            Renderer::create(*device, need(decode(need(loadConfig(sources, {"host"})), sources)),
                             {kSize, {output}, {}}, traitsOf(frame)));
        need(renderer->render(frame));
        return read(renderer->output(output));
    }

    /// One sample of each pixel of a texture.
    Image sample(const ImportedTexture& texture, int index)
    {
        const std::string config = R"({"format": 1, "imports": {")" + texture.name +
                                   R"(": {"type": "texture"}},
            "targets": {"shown": {"format": ["rgba32f"]}}, "shaders": {"show":
            {"vertex": "geometry/shaders/resolve.vert", "fragment": "mine/show.frag"}},
            "passes": {"show": {"shader": "show", "color": "shown"}}, "outputs": {"shown": "shown"}})";
        return run(config, {texture}, "shown",
                   "#version 310 es\nprecision highp float;\nuniform highp sampler2DMS " +
                       texture.name + ";\nout vec4 shown;\nvoid main() { shown = texelFetch(" +
                       texture.name + ", ivec2(gl_FragCoord.xy), " + std::to_string(index) +
                       "); }\n");
    }

    ProgramId painted = program(
        "layout(location = 0) out vec4 red;\n"
        "layout(location = 1) out vec4 unread;\n"
        "layout(location = 2) out vec4 sum;\n"
        "void main() { red = vec4(1, fract(16.0 * gl_FragCoord.z), 0, 1); unread = red;\n"
        "    sum = vec4(1); }",
        kMeshVertex);
    MeshId triangle = need(device->createMesh(slanted()));

private:
    static MeshDesc slanted()
    {
        MeshDesc mesh = square(0.0f);
        mesh.vertices.resize(3);
        const float corners[3][3] = {
            {-0.9f, -0.8f, -0.72f}, {0.9f, -0.5f, 0.72f}, {0.1f, 0.9f, 0.08f}};
        for (int i = 0; i < 3; ++i) std::copy_n(corners[i], 3, mesh.vertices[i].position);
        mesh.indices = {0, 1, 2};
        return mesh;
    }

    std::vector<GlTexture> names_;
};

}  // namespace

TEST_CASE_METHOD(TriangleFixture,
                 "Colour resolves to the mean of samples in each attachment, depth to one sample")
{
    REQUIRE(device->caps().sample_counts[static_cast<int>(Format::rgba8)] & 1u << 3);
    const Pictures one = draw(1);
    const Pictures four = draw(kSamples);
    int smooth = 0, seen = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const float covered = four.red.at(x, y) * 4;
            CHECK(covered == Approx(std::round(covered)).margin(0.02));
            CHECK(four.sum.at(x, y, 1) == Approx(four.red.at(x, y)).margin(0.004));
            CHECK((one.red.at(x, y) == 0.0f || one.red.at(x, y) == 1.0f));
            smooth += covered > 0.5f && covered < 3.5f ? 1 : 0;
            if (four.depth.at(x, y) == 1.0f) continue;
            ++seen;
            const float z = 0.8f * (2.0f * (x + 0.5f) / kSize.width - 1.0f);  // the triangle's
            constexpr double kHalfPixel = 0.5 * 0.8 / 32;
            CHECK(four.depth.at(x, y) == Approx(z * 0.5f + 0.5f).margin(kHalfPixel));
        }
    CHECK(smooth > 20);
    CHECK(seen > 200);
}

TEST_CASE_METHOD(TriangleFixture,
                 "Of a host's samples the middle one by depth is taken, and the normal of that one")
{
    if (device->caps().version < 310) {
        WARN("not tested: " << device->caps().name << " has no OpenGL ES 3.1");
        return;
    }
    const ImportedTexture depths = {"depth_samples",
                                    samplesOf(Format::depth24, GL_DEPTH_COMPONENT24)};
    const ImportedTexture normals = {"normal_samples", samplesOf(Format::rgb10_a2, GL_RGB10_A2)};
    draw(framebuffer({normals.texture}, depths.texture), 1);
    const std::string resolving = R"({"format": 1, "extends":
        ["geometry/host_depth_normal_msaa", "ssao/hemisphere", "filter/bilateral_normal"],
        "outputs": {"depth": "depth", "normal": "normal"}})";
    const Image depth = run(resolving, {depths, normals}, "depth");
    const Image normal = run(resolving, {depths, normals}, "normal");
    std::vector<Image> depth_samples, normal_samples;
    for (int i = 0; i < kSamples; ++i) {
        depth_samples.push_back(sample(depths, i));
        normal_samples.push_back(sample(normals, i));
    }
    int mixed = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            std::vector<float> sorted;
            for (const Image& each : depth_samples) sorted.push_back(each.at(x, y));
            std::sort(sorted.begin(), sorted.end());
            REQUIRE(depth.at(x, y) == Approx(sorted[1]).margin(1e-7));
            bool same = false;
            for (int i = 0; i < kSamples; ++i)
                same = same || (depth_samples[i].at(x, y) == sorted[1] &&
                                normal_samples[i].at(x, y) == normal.at(x, y) &&
                                normal_samples[i].at(x, y, 1) == normal.at(x, y, 1));
            REQUIRE(same);
            mixed += sorted[3] - sorted[0] > 0.001f ? 1 : 0;
        }
    CHECK(mixed > 50);
}
