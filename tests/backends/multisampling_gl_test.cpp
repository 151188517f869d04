// SPDX-License-Identifier: MIT
// Multisampling, drawn for real: what resolves to a mean, what to one sample, and what stays.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <crevice/shipped.h>

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

const Extent kSize = {32, 32};

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
        PassInfo pass = wholePass(need(device->createFramebuffer(desc)), kSize, 3);
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
        return {read(red), read(sum), read(depth)};
    }

    ProgramId painted = program(
        "layout(location = 0) out vec4 red;\n"
        "layout(location = 1) out vec4 unread;\n"
        "layout(location = 2) out vec4 sum;\n"
        "void main() { red = vec4(1, 0, 0, 1); unread = red; sum = vec4(1); }",
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
};

int count(const Image& image, float least, float most)
{
    int found = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x)
            found += image.at(x, y) > least && image.at(x, y) < most ? 1 : 0;
    return found;
}

/// The least and most of the pixels around one, itself too, in a channel.
std::pair<float, float> around(const Image& image, int x, int y, int channel)
{
    std::pair<float, float> range(1e9f, -1e9f);
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.extent.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.extent.width - 1); ++u) {
            range.first = std::min(range.first, image.at(u, v, channel));
            range.second = std::max(range.second, image.at(u, v, channel));
        }
    return range;
}

/// The lit spheres by forward lighting; its occlusion is 1, so that edges are those of the mesh.
Image forward(const std::string& msaa)
{
    MemorySources mine;
    mine.add("configs/forward.json", R"({"format": 1, "extends": ["geometry/depth_normal",
        "ssao/sphere", "filter/none", "lighting/forward"], "params": {"intensity": {"default": 0}}})");
    const LayeredSources sources({&mine, &shippedSources()});
    SceneRig rig("spheres");
    return rig.draw(descriptionOf({"forward"}, {"msaa=" + msaa}, sources), rig.frame(), "color");
}

}  // namespace

TEST_CASE_METHOD(TriangleFixture,
                 "Colour resolves to the mean of samples, in each attachment apart")
{
    REQUIRE(device->caps().sample_counts[static_cast<int>(Format::rgba8)] & 1u << 3);
    const Pictures one = draw(1);
    const Pictures four = draw(4);
    CHECK(count(one.red, 0.01f, 0.99f) == 0);
    CHECK(count(four.red, 0.01f, 0.99f) > 20);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const float covered = four.red.at(x, y) * 4;
            CHECK(covered == Approx(std::round(covered)).margin(0.02));
            CHECK(four.red.at(x, y, 1) == 0.0f);
            CHECK(four.sum.at(x, y, 1) == Approx(four.red.at(x, y)).margin(0.004));
        }
}

TEST_CASE_METHOD(TriangleFixture,
                 "Depth resolves to one sample, never to a mean with the background")
{
    const Image one = draw(1).depth;
    const Image four = draw(4).depth;
    int seen = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            if (four.at(x, y) == 1.0f) continue;
            ++seen;
            const float z = 0.8f * (2.0f * (x + 0.5f) / kSize.width - 1.0f);  // the triangle's
            constexpr double kHalfPixel = 0.5 * 0.8 / 32;
            CHECK(four.at(x, y) == Approx(z * 0.5f + 0.5f).margin(kHalfPixel));
            if (one.at(x, y) < 1.0f)
                CHECK(four.at(x, y) == Approx(one.at(x, y)).margin(kHalfPixel));
        }
    CHECK(seen > 200);
}

TEST_CASE("Forward lighting with four samples smooths outlines and leaves the rest as it was")
{
    const Image one = forward("1");
    const Image four = forward("4");
    int inside = 0, edges = 0, smooth = 0;
    for (int y = 0; y < one.extent.height; ++y)
        for (int x = 0; x < one.extent.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto [least, most] = around(one, x, y, c);
                const float was = one.at(x, y, c), is = four.at(x, y, c);
                constexpr float kSlack = 0.03f;  // what lies between two pixels of a round object
                CHECK(is >= least - kSlack);
                CHECK(is <= most + kSlack);
                const bool edge = most - least > 0.05f;
                if (!edge) CHECK(is == Approx(was).margin(kSlack));
                (edge ? edges : inside) += 1;
                smooth += edge && std::abs(is - was) > kSlack ? 1 : 0;
            }
    CHECK(inside > edges);
    CHECK(smooth > edges / 10);
}
