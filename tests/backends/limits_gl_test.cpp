// SPDX-License-Identifier: MIT
// Real GL at the limits of what it takes: sizes, counts, uniforms.
#include <crevice/renderer.h>

#include "tests/backends/stage.h"
#include "tests/support/picture.h"
#include "tests/support/watched_gl.h"
#include "tools/render/device/forwarding_device.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {16, 9};

/// As small a device as it says to be.
class SmallerDevice : public ForwardingDevice {
public:
    SmallerDevice(Device& device, int fragment_uniform_vectors)
        : ForwardingDevice(device),
          caps_(device.caps())
    {
        caps_.max_fragment_uniform_vectors = fragment_uniform_vectors;
    }
    const DeviceCaps& caps() const override { return caps_; }

private:
    DeviceCaps caps_;
};

std::string arrayOf(int count)
{
    const std::string length = std::to_string(count);
    return "uniform vec4 many[" + length +
           "]; uniform int at; out vec4 color;\n"
           "void main() { color = many[at % " +
           length + "]; }";
}

}  // namespace

TEST_CASE("Textures of a size that cannot be are refused and leave no name")
{
    GlFixture fixture;
    WatchedGl gl(testContext().loader());
    auto device = need(makeGlDevice(gl.loader()));
    const int names = gl.names(), limit = device->caps().max_texture_size;
    for (const Extent extent : {Extent{0, 4}, Extent{4, 0}, Extent{-1, 4}, Extent{4, -2147483647},
                                Extent{limit + 1, 1}, Extent{1, 2147483647}}) {
        INFO(extent.width << "x" << extent.height);
        const auto none = device->createTexture({"none", Format::r8, extent});
        REQUIRE_FALSE(none.ok());
        CHECK(none.diagnostics().size() == 1);
        CHECK(gl.names() == names);
    }
    device->destroy(need(device->createTexture({"widest", Format::r8, {limit, 1}})));
}

TEST_CASE("A uniform array as long as the device's limit links, and a longer one is an error")
{
    GlFixture gl;
    const int limit = gl.device->caps().max_fragment_uniform_vectors;
    for (const int count : {limit - 1, limit, 4 * limit}) {
        INFO(count);
        const auto made = gl.device->createProgram(
            {"array", stage(kFullscreenVertex), stage(fragment(arrayOf(count)))});
        if (count < limit) REQUIRE(made.ok());
        if (count > limit) CHECK_FALSE(made.ok());
        if (!made) CHECK_FALSE(made.diagnostics().front().message.empty());
    }
}

TEST_CASE(
    "A config at the device's limit of uniforms draws, and past it is refused before GL sees it")
{
    GlFixture gl;
    const Description description = descriptionOf({"learnopengl"});
    int least = 1;  // vectors with which it can be planned
    const auto planned = [&](int vectors) {
        const SmallerDevice device(*gl.device, vectors);
        return compile(description, {}, device.caps(), {kExtent, {"ao"}, {}});
    };
    while (!planned(least).ok()) ++least;
    CHECK(least > 60);  // its kernel
    const Result<Plan> refused = planned(least - 1);
    REQUIRE(refused.diagnostics().size() == 1);
    CHECK(refused.diagnostics()[0].code == Code::too_many);

    SmallerDevice device(*gl.device, least);
    auto renderer = need(Renderer::create(device, description, {kExtent, {"ao"}, {}}, {}));
    need(renderer->render({}));
    CHECK(mean(need(device.readTexture(renderer->output("ao")))) == 1.0);
}

TEST_CASE("Shipped configs draw visibility with the least and the most of every count")
{
    GlFixture gl;
    Stage stage(*gl.device, kExtent);
    for (const Subject& subject : sampledSubjects()) {
        for (const bool most : {false, true}) {
            INFO(subject.config << " " << subject.variant << (most ? " most" : " least"));
            const auto renderer = stage.make(withCounts(descriptionOf(subject), most), {"ao"});
            need(renderer->render(stage.frame));
            CHECK(allVisibility(gl.read(renderer->output("ao"))));
        }
    }
}
