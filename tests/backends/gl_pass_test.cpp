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

TEST_CASE("A pass clears and invalidates what it does not load, and what it does not store")
{
    constexpr LoadOp kLoad = LoadOp::load, kClear = LoadOp::clear, kDrop = LoadOp::discard;
    constexpr StoreOp kStore = StoreOp::store, kLose = StoreOp::discard;
    const struct {
        LoadOp load[3];  ///< Of both colours, and depth.
        StoreOp store[3];
        const char* calls;
    } cases[] = {
        {{kLoad, kLoad, kLoad}, {kStore, kStore, kStore}, "draw"},
        {{kClear, kDrop, kDrop},
         {kStore, kStore, kStore},
         "invalidate color1 depth, clear color0, draw"},
        {{kLoad, kClear, kClear}, {kStore, kStore, kStore}, "clear color1, clear depth, draw"},
        {{kLoad, kLoad, kLoad}, {kStore, kStore, kLose}, "draw, invalidate depth"},
        {{kLoad, kLoad, kLoad}, {kStore, kLose, kLose}, "draw, invalidate color1 depth"},
        {{kLoad, kLoad, kLoad}, {kLose, kLose, kStore}, "draw, invalidate color0 color1"},
    };
    Drawn drawn;
    for (const auto& each : cases) {
        std::copy_n(each.load, 2, drawn.pass.color_load);
        std::copy_n(each.store, 2, drawn.pass.color_store);
        drawn.pass.depth_load = each.load[2];
        drawn.pass.depth_store = each.store[2];
        CHECK(drawn.calls() == each.calls);
    }
}

TEST_CASE("Of several samples a pixel nothing is stored but what they resolve to")
{
    CHECK(Drawn(4).calls() == "draw, invalidate color0 color1 depth");
}
