// SPDX-License-Identifier: MIT
// Contexts: several at once, switched back and forth.
#include "tests/support/gl_fixture.h"

namespace crevice {

namespace {

/// A context with a device and one pixel to clear.
struct Room {
    explicit Room(std::unique_ptr<Context> made)
        : context(std::move(made)),
          device(need(makeGlDevice(context->loader())))
    {
        pixel = need(device->createTexture({"pixel", Format::rgba8, {1, 1}}));
        framebuffer = need(device->createFramebuffer({"pixel", {pixel}, {}}));
    }

    ~Room()
    {
        (void)context->makeCurrent();
        device.reset();
    }

    void clear(float value)
    {
        need(context->makeCurrent());
        PassInfo pass = wholePass(framebuffer, {1, 1});
        pass.clear_color[0][0] = value;
        need(device->beginFrame());
        device->beginPass(pass);
        device->endPass();
        need(device->endFrame());
    }

    float read()
    {
        need(context->makeCurrent());
        return need(device->readTexture(pixel)).at(0, 0);
    }

    std::unique_ptr<Context> context;
    std::unique_ptr<Device> device;
    TextureId pixel;
    FramebufferId framebuffer;
};

void takeTurns(Room& first, Room& second)
{
    for (int turn = 0; turn < 3; ++turn) {
        first.clear(turn % 2 ? 1.0f : 0.0f);
        second.clear(turn % 2 ? 0.0f : 1.0f);
        CHECK(first.read() == (turn % 2 ? 1.0f : 0.0f));
        CHECK(second.read() == (turn % 2 ? 0.0f : 1.0f));
        CHECK(first.read() == (turn % 2 ? 1.0f : 0.0f));
    }
}

}  // namespace

TEST_CASE("EGL and OSMesa live in one process")
{
    Result<std::unique_ptr<Context>> egl = makeEglContext();
    Result<std::unique_ptr<Context>> osmesa = makeOsmesaContext();
    if (!egl || !osmesa) {
        WARN("one of the two is not there");
        return;
    }
    need((*egl)->makeCurrent());
    Room first(std::move(*egl));
    need((*osmesa)->makeCurrent());
    Room second(std::move(*osmesa));
    takeTurns(first, second);
}

}  // namespace crevice
