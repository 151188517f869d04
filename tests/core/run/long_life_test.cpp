// SPDX-License-Identifier: MIT
// A renderer that lives long: ten thousand resizes, reloads, swaps and settings later nothing has
// grown.
#include <crevice/gl_device.h>

#include "tests/support/allocations.h"
#include "tests/support/need.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

constexpr int kChanges = 10000;

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

/// Changes from `first` to `end`; `after` each.
template <class After>
bool goOn(RestlessHost& host, int first, int end, After after)
{
    bool ok = true;
    for (int n = first; n < end; ++n) {
        ok = host.go(n) && ok;
        after();
    }
    return ok;
}

}  // namespace

TEST_CASE("Ten thousand changes later no object, no memory and no misuse is more than before")
{
    RecordingDevice device;
    {
        RestlessHost host(device);
        const auto forget = [&] { device.clearLog(); };
        bool ok = goOn(host, 0, 2 * kPeriod, forget);
        const int live = device.live();
        const long bytes = allocatedBytes();
        ok = goOn(host, 2 * kPeriod, kChanges / kPeriod * kPeriod + 2 * kPeriod, forget) && ok;
        const long grown = allocatedBytes() - bytes;
        CHECK(ok);
        CHECK(grown < kRoundingBytes);
        CHECK(device.live() == live);
    }
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
}

TEST_CASE("Ten thousand changes later a GL device has no more names, ids and memory than before")
{
    WatchedGl gl;
    {
        auto device = need(makeGlDevice(gl.loader()));
        RestlessHost host(*device);
        bool ok = goOn(host, 0, 2 * kPeriod, [] {});
        const int names = gl.names();
        const long bytes = allocatedBytes();
        ok = goOn(host, 2 * kPeriod, kChanges / kPeriod * kPeriod + 2 * kPeriod, [] {}) && ok;
        const long grown = allocatedBytes() - bytes;
        const TextureId next = need(device->createTexture({"next", Format::r8, {1, 1}}));
        device->destroy(next);
        CHECK(ok);
        CHECK(grown < kRoundingBytes);
        CHECK(gl.names() == names);
        CHECK(next.value < 100);
    }
    CHECK(gl.names() == 0);
}
