// SPDX-License-Identifier: MIT
// What the GL device calls at both ends of a pass. No pixel shows it, and on a GPU with tile memory
// each call is a picture that is neither loaded nor stored.
#include <crevice/gl_device.h>

#include "tests/support/need.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

/// A framebuffer of two colours and depth on a driver that does nothing.
struct Drawn {
    explicit Drawn(int samples = 1)
    {
        gl.logPasses();
        const auto texture = [&](Format format, int count) {
            return need(device->createTexture({"texture", format, {4, 4}, count}));
        };
        FramebufferDesc desc{"framebuffer",
                             {texture(Format::rgba8, samples), texture(Format::rgba8, samples)},
                             texture(Format::depth24, samples)};
        if (samples > 1) {
            desc.resolve_color = {texture(Format::rgba8, 1), texture(Format::rgba8, 1)};
            desc.resolve_depth = texture(Format::depth24, 1);
        }
        pass.framebuffer = need(device->createFramebuffer(desc));
        pass.extent = {4, 4};
        pass.color_count = 2;
        pass.has_depth = true;
        pass.depth_load = LoadOp::load;
        pass.depth_store = StoreOp::store;
    }

    /// The calls of a frame of that pass.
    std::string calls()
    {
        gl.takePassLog();
        need(device->beginFrame());
        device->beginPass(pass);
        device->drawFullscreen();
        device->endPass();
        need(device->endFrame());
        return gl.takePassLog();
    }

    WatchedGl gl;
    std::unique_ptr<Device> device = need(makeGlDevice(gl.loader()));
    PassInfo pass;
};

}  // namespace

TEST_CASE("A pass that loads and stores everything clears and invalidates nothing")
{
    CHECK(Drawn().calls() == "draw");
}

TEST_CASE("A pass invalidates what it does not load before it draws, and clears what it clears")
{
    Drawn drawn;
    drawn.pass.color_load[0] = LoadOp::clear;
    drawn.pass.color_load[1] = LoadOp::discard;
    drawn.pass.depth_load = LoadOp::discard;
    CHECK(drawn.calls() == "invalidate color1 depth, clear color0, draw");
    drawn.pass.color_load[0] = LoadOp::load;
    drawn.pass.color_load[1] = LoadOp::clear;
    drawn.pass.depth_load = LoadOp::clear;
    CHECK(drawn.calls() == "clear color1, clear depth, draw");
}

TEST_CASE("A pass invalidates at its end what it does not store")
{
    Drawn drawn;
    drawn.pass.depth_store = StoreOp::discard;
    CHECK(drawn.calls() == "draw, invalidate depth");
    drawn.pass.color_store[1] = StoreOp::discard;
    CHECK(drawn.calls() == "draw, invalidate color1 depth");
    drawn.pass.color_store[0] = StoreOp::discard;
    drawn.pass.depth_store = StoreOp::store;
    CHECK(drawn.calls() == "draw, invalidate color0 color1");
}

TEST_CASE("Of several samples a pixel nothing is stored but what they resolve to")
{
    CHECK(Drawn(4).calls() == "draw, invalidate color0 color1 depth");
}
