// SPDX-License-Identifier: MIT
// Views of any size within a guard band: their pixels are those of the picture without one.
#include "tests/support/modules.h"
#include "tests/support/nightly.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/device/forwarding_device.h"

#include <cmath>

using namespace crevice;

namespace {

/// By how much depth may differ, as a corner of the mesh is a rounding away: a few steps of 24
/// bits.
constexpr float kDepthRounding = 1e-6f;
/// What share of pixels that rounding may move over an edge; of texels half a pixel off 0.01 to 0.8
/// differ.
constexpr double kMostRounded = 0.002;

/// Views and bands of which the first alone is a whole number of pixels on either side.
struct View {
    Extent extent;
    const char* band;
};

const View kViews[] = {{{160, 90}, "1.4"},  {{128, 72}, "1.4"}, {{97, 53}, "1.2"},
                       {{111, 62}, "1.35"}, {{75, 64}, "2"},    {{64, 33}, "1.01"}};

const char* const kCut = "eye=0.6,0.9,2.2;at=0,0.3,0;fov=50";  // the picture's edges cut the scene
const char* const kWhole = "eye=0,4,12;at=0,0,0;fov=30";       // all of the scene is in the picture

/// The share of pixels that differ by more than `limit` from those in the middle of `with`.
double shareOff(const Image& with, const Image& without, float limit)
{
    const int left = (with.extent.width - without.extent.width) / 2;
    const int below = (with.extent.height - without.extent.height) / 2;
    int off = 0;
    for (int y = 0; y < without.extent.height; ++y)
        for (int x = 0; x < without.extent.width; ++x)
            for (int c = 0; c < without.channels; ++c)
                if (!(std::abs(with.at(x + left, y + below, c) - without.at(x, y, c)) <= limit)) {
                    ++off;
                    break;
                }
    return double(off) / (without.extent.width * without.extent.height);
}

}  // namespace

TEST_CASE("A G-buffer with a guard band holds the view's pixels, and as many on either side")
{
    SceneRig rig("spheres");
    for (const View& view : kViews) {
        INFO(view.extent.width << 'x' << view.extent.height << " in " << view.band);
        rig.extent = view.extent;
        const GivenConfig config({"gtao"},
                                 R"(, "outputs": {"depth": "depth", "normal": "normal"})");
        for (const char* target : {"depth", "normal"}) {
            const auto stored = [&](const std::string& band) {
                return rig.draw(config.description({"guard_band=" + band}), rig.frame(kCut),
                                target);
            };
            const Image with = stored(view.band), without = stored("1");
            CHECK(with.extent.width > without.extent.width);
            CHECK((with.extent.width - without.extent.width) % 2 == 0);
            CHECK((with.extent.height - without.extent.height) % 2 == 0);
            CHECK(shareOff(with, without, kDepthRounding) < kMostRounded);
        }
    }
}

TEST_CASE("Where nothing lies off the view a guard band changes no picture, in any geometry")
{
    using Names = std::vector<std::string>;
    struct Kind {
        Names modules;
        const char* output = "ao";
        double most = kMostRounded;
    };
    const Kind kinds[] = {
        {{"gtao"}},
        {{"gtao"}, "color"},
        {{"bitmask_layers"}},
        {{"hbao_plus"}},
        {{"gtao", "geometry/depth_levels"}, "ao", 0.01},  // every second texel, of either
        {{"geometry/depth_only", "ssao/gtao", "filter/bilateral_normal"}},
        {{"geometry/linear_depth_normal", "ssao/gtao", "filter/bilateral_normal"}},
        {{"mobile"}, "color", 0.005},  // normals rebuilt and rounded
        {{"geometry/depth_normal", "ssao/gtao", "filter/bilateral_normal", "lighting/forward"},
         "color"},
        {{"ssdo"}, "color"},
        {{"baked"}},
    };
    SceneRig rig("spheres");
    std::size_t turn = 0;
    for (const Kind& kind : kinds)
        for (const View& view : kViews) {
            if (!nightly() && turn++ % 5 > 0) continue;  // each kind in one or two of the views
            INFO(kind.modules.front() << ' ' << kind.output << ' ' << view.extent.width << 'x'
                                      << view.extent.height << " in " << view.band);
            rig.extent = view.extent;
            const auto drawn_with = [&](const std::string& band) {
                const Names overrides = {"guard_band=" + band, "radius=1"};
                return rig.draw(GivenConfig(kind.modules).description(overrides), rig.frame(kWhole),
                                kind.output);
            };
            const Image with = drawn_with(view.band), without = drawn_with("1");
            REQUIRE(with.extent == without.extent);
            CHECK(shareOff(with, without, 0.0f) < kind.most);
        }
}

namespace {

/// A device whose textures end at a size.
class SmallDevice : public ForwardingDevice {
public:
    SmallDevice(Device& device, int limit) : ForwardingDevice(device), caps_(device.caps())
    {
        caps_.max_texture_size = limit;
    }
    const DeviceCaps& caps() const override { return caps_; }

private:
    DeviceCaps caps_;
};

}  // namespace

TEST_CASE("On a device of small textures the guard band is what they hold, in plan and shaders")
{
    SceneRig rig("spheres");
    const Frame frame = rig.frame(kCut);
    const auto occlusion = [&](int limit, std::vector<std::string> overrides) {
        SmallDevice device(*rig.device, limit);
        overrides.push_back("radius=2");  // wide, so that the band counts
        const auto renderer = need(Renderer::create(device, descriptionOf({"high"}, overrides),
                                                    {rig.extent, {"ao"}, {}}, traitsOf(frame)));
        CHECK(findNamed(renderer->plan().passes, "geometry")->extent.width <= limit);
        // Up to a pixel more on either side: borders are whole pixels, in both directions.
        CHECK(findNamed(renderer->plan().passes, "geometry")->frustum_scale <=
              limit / 128.0f + 2.0f / 72.0f);
        need(renderer->render(frame));
        return rig.read(renderer->output("ao"));
    };
    CHECK(meanChange(occlusion(150, {}), occlusion(2048, {"guard_band=1.171875"})) == 0.0);
    CHECK(meanChange(occlusion(128, {}), occlusion(2048, {"guard_band=1"})) == 0.0);
    CHECK(meanChange(occlusion(128, {}), occlusion(2048, {})) > 0.002);
}
