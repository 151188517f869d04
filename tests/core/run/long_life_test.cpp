// SPDX-License-Identifier: MIT
// A renderer that lives long: thousands of resizes, reloads, swaps and settings later nothing has
// grown.
#include <crevice/gl_device.h>

#include "tests/core/run/allocations.h"
#include "tests/support/nightly.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

/// What rounding may come to, and a leak at every period may not.
constexpr long kRoundingBytes = 512;

/// As many as bring a renderer back to where it was; kMaxIdlePrograms are kept by then.
constexpr int kPeriod = 240;

/// A host that changes something before each frame.
class RestlessHost {
public:
    explicit RestlessHost(Device& device) : device_(device)
    {
        mesh_ = need(device.createMesh({"mesh", std::vector<Vertex>(3), {0, 1, 2}}));
        frame_.draws = {{mesh_, 0, 3, glm::dmat4(1.0), 0}};
        frame_.materials.resize(1);
        renderer_ = need(Renderer::create(device, plain_, {{64, 32}}, traitsOf(frame_)));
    }
    ~RestlessHost()
    {
        renderer_.reset();
        device_.destroy(mesh_);
    }

    /// The n-th change and the frame after it.
    bool go(int n)
    {
        const bool changed = change(n);
        return renderer_->render(frame_).ok() && changed;
    }

private:
    bool change(int n)
    {
        const int turn = n / 6;
        switch (n % 6) {
        case 0: return renderer_->resize({20 + turn % 5, 30}).ok();
        case 1: return renderer_->reload(turn % 2 ? plain_ : remembering_, options()).ok();
        case 2: return renderer_->setFeature("soft", turn % 2 ? "true" : "false").ok();
        case 3: return renderer_->setParam("samples", 1.0f + turn % 40).ok();
        case 4: frame_.lights.resize(turn % 4); return true;
        default:
            return renderer_->setParam("radius", 0.5f + turn % 10).ok() &&
                   !renderer_->setParam("radius", -1.0f).ok();
        }
    }

    CompileOptions options() const { return {renderer_->plan().extent}; }

    Device& device_;
    const Description plain_ = rigDescription(), remembering_ = rigDescription(true);
    MeshId mesh_;
    Frame frame_;
    std::unique_ptr<Renderer> renderer_;
};

/// Each change of two periods, and of as many more as there are at night, over which neither memory
/// nor what `count` tells may grow.
template <class Count, class After>
void checkLongLife(Device& device, Count count, After after)
{
    const int more = kPeriod * (nightly() ? 41 : 8);
    RestlessHost host(device);
    bool ok = true;
    const auto go = [&](int first, int end) {
        for (int n = first; n < end; ++n) {
            ok = host.go(n) && ok;
            after();
        }
    };
    go(0, 2 * kPeriod);
    const int objects = count();
    const long bytes = allocatedBytes();
    go(2 * kPeriod, 2 * kPeriod + more);
    const long grown = allocatedBytes() - bytes;
    CHECK(ok);
    CHECK(grown < kRoundingBytes);
    CHECK(count() == objects);
}

}  // namespace

TEST_CASE("Thousands of changes later no object, no memory and no misuse is more than before")
{
    RecordingDevice device;
    checkLongLife(
        device, [&] { return device.live(); }, [&] { device.clearLog(); });
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
}

TEST_CASE("Thousands of changes later a GL device has no more names, ids and memory than before")
{
    WatchedGl gl;
    {
        auto device = need(makeGlDevice(gl.loader()));
        const auto objects = [&] {
            const TextureId next = need(device->createTexture({"next", Format::r8, {1, 1}}));
            device->destroy(next);
            CHECK(next.value < 100);
            return gl.names();
        };
        checkLongLife(*device, objects, [] {});
    }
    CHECK(gl.names() == 0);
}
