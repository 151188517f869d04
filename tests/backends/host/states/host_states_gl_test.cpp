// SPDX-License-Identifier: MIT
// Hosts in random states live with crevice from first to last: after each step they find their
// state as it was, and they get the pictures of a fresh context, wherever their depth lies.
// CREVICE_HOST_STATES is how many.
#include "tests/backends/host/states/host_life.h"

#include <cstdlib>

namespace crevice {

namespace {

constexpr int kDrawn = 1;  // a kind that draws the scene, into several samples too
constexpr std::uint32_t kSeeds = 6;

using Images = std::vector<Image>;

/// By kind, each from a fresh context when it is first asked for.
class FreshPictures {
public:
    const Images& operator[](int kind)
    {
        if (Images& found = by_kind_[kind]; !found.empty()) return found;
        const auto fresh = need(makeContext(testBackend()));
        HostLife life(*fresh);
        return by_kind_[kind] = life.live(kind, [](const char*) {});
    }

private:
    std::map<int, Images> by_kind_;
};

void comparePictures(const Images& got, const Images& wanted)
{
    REQUIRE(got.size() == wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        INFO("picture " << i);
        CHECK((got[i].pixels == wanted[i].pixels));
    }
}

}  // namespace

TEST_CASE("Hosts get the same pictures from depth wherever it lies")
{
    FreshPictures fresh;
    const auto own = need(makeContext(testBackend()));
    const HostLife life(*own);
    for (int place = 1; place < life.places(); ++place) {
        INFO("place " << place);
        comparePictures(fresh[place * HostLife::kConfigs], fresh[0]);
    }
}

TEST_CASE("Hosts in random states keep them, and get the pictures of a fresh context")
{
    const char* const many = std::getenv("CREVICE_HOST_STATES");
    const int count = many ? std::atoi(many) : 16;
    FreshPictures wanted;
    const auto own = need(makeContext(testBackend()));
    HostLife life(*own);
    RandomHost host(life.gl, own->loader());
    life.watch(host);
    for (int seed = 0; seed < count; ++seed) {
        // Steps of 7 come by every kind in the end, and by all depths and configs in the first few.
        const int kind = (7 * seed + life.kinds() - 1) % life.kinds();
        INFO("state " << seed << ", kind " << kind);
        host.randomize(static_cast<std::uint32_t>(seed));
        const Snapshot before = host.snapshot();
        const auto after = [&](const char* step) {
            INFO("after " << step);
            CHECK(difference(before, host.snapshot()) == "");
        };
        const Images pictures = life.live(kind, after);
        comparePictures(pictures, wanted[kind]);
        need(own->makeCurrent());
    }
}

TEST_CASE("Hosts that want no restoring get the pictures of a fresh context all the same")
{
    const Images wanted = FreshPictures()[kDrawn];
    GlDeviceOptions options;
    options.restore_state = false;
    options.check_errors = false;
    const auto own = need(makeContext(testBackend()));
    HostLife life(*own, options);
    RandomHost host(life.gl, own->loader());
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        host.randomize(seed);
        GLboolean feedback = GL_FALSE;  // nothing pauses it then, and drawing is refused
        life.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &feedback);
        if (!feedback) comparePictures(life.live(kDrawn, [](const char*) {}), wanted);
    }
}

}  // namespace crevice
