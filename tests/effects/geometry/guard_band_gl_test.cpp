// SPDX-License-Identifier: MIT
// Views of any size within a guard band: their pixels are those of the picture without one.
// Pictures of a third of the view's size: their texels see pixels of it.
#include "tests/support/modules.h"
#include "tests/support/nightly.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/device/forwarding_device.h"

using namespace crevice;

namespace {

/// What share of pixels may differ, as a corner of the mesh is a rounding away and moves an edge;
/// of texels half a pixel off 0.01 to 0.8 differ.
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

/// The share of pixels that differ.
double shareOff(const Image& with, const Image& without)
{
    int off = 0;
    for (int y = 0; y < without.extent.height; ++y)
        for (int x = 0; x < without.extent.width; ++x) {
            bool same = true;
            for (int c = 0; c < without.channels; ++c)
                same = same && with.at(x, y, c) == without.at(x, y, c);
            off += !same;
        }
    return double(off) / (without.extent.width * without.extent.height);
}

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
        {{"bitmask_layers"}},
        {{"hbao_plus"}},
        {{"gtao", "geometry/depth_levels"}, "ao", 0.01},  // every second texel, of either
        {{"geometry/depth_only", "ssao/gtao", "filter/bilateral_normal"}},
        {{"geometry/linear_depth_normal", "ssao/gtao", "filter/bilateral_normal"}},
        {{"mobile"}, "color", 0.005},  // normals rebuilt and rounded
        {{"geometry/depth_normal", "ssao/gtao", "filter/bilateral_normal", "lighting/forward"},
         "color"},
        {{"ssdo"}, "color"},
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
            CHECK(shareOff(with, without) < kind.most);
        }
}

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

TEST_CASE(
    "What is drawn at a third of the view's size is of the pixels that are read of the full one")
{
    // With the nearest front faces as layer, front and back are one wherever the two are of one
    // place: a sheet, whose depth is within bounds (layers.frag).
    const GivenConfig config({"balanced"},
                             R"(, "passes": { "back_faces": { "state": { "cull": "back" } } },
                                              "outputs": { "layers": "source_layers" })");
    SceneRig rig("spheres");
    const auto off = [&](Extent extent, const char* scale) {
        rig.extent = extent;
        const Image layers =
            rig.draw(config.description({std::string("ao_scale=") + scale, "guard_band=1.4"}),
                     rig.frame(kCut), "layers");
        int seen = 0, apart = 0;
        for (int y = 0; y < layers.extent.height; ++y)
            for (int x = 0; x < layers.extent.width; ++x) {
                const float deep = layers.at(x, y, 0);
                seen += deep > 0;  // not in the background
                apart += deep > 0 && (deep < 0.019f || deep > 0.335f);
            }
        REQUIRE(seen > 300);
        return double(apart) / seen;
    };
    for (const Extent extent : {Extent{240, 135}, {241, 136}, {242, 137}, {250, 91}})
        for (const char* scale : {"1", "0.5", "0.3333", "0.25"}) {
            INFO(extent.width << 'x' << extent.height << ' ' << scale);
            CHECK(off(extent, scale) <
                  2 * kMostRounded);  // a texel's edges are rounded to 3 pixels'
        }
    CHECK(off({240, 135}, "0.4") > 0.1);  // which this test must see
}
