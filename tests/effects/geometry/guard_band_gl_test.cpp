// SPDX-License-Identifier: MIT
// Views of any size within a guard band: their pixels are those of the picture without one.
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/device/forwarding_device.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

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

PictureRequest request(const View& view, const std::string& band, const char* camera)
{
    PictureRequest request;
    request.extent = view.extent;
    request.camera = camera;
    request.overrides = {"guard_band=" + band};
    return request;
}

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

/// A config of these modules.
Image drawn(const std::string& modules, PictureRequest request)
{
    MemorySources mine;
    mine.add("configs/banded.json", R"({"format": 1, "extends": [)" + modules + "]}");
    const LayeredSources sources({&mine, &shippedSources()});
    request.config = "banded";
    request.sources = &sources;
    return picture(request);
}

}  // namespace

TEST_CASE("A G-buffer with a guard band holds the view's pixels, and as many on either side")
{
    for (const View& view : kViews) {
        INFO(view.extent.width << 'x' << view.extent.height << " in " << view.band);
        for (const char* target : {"depth", "normal"}) {
            const auto stored = [&](const std::string& band) {
                PictureRequest wanted = request(view, band, kCut);
                wanted.config = "gtao";
                wanted.target = target;
                return picture(wanted);
            };
            const Image with = stored(view.band);
            const Image without = stored("1");
            CHECK(with.extent.width > without.extent.width);
            CHECK((with.extent.width - without.extent.width) % 2 == 0);
            CHECK((with.extent.height - without.extent.height) % 2 == 0);
            CHECK(shareOff(with, without, kDepthRounding) < kMostRounded);
        }
    }
}

TEST_CASE("Where nothing lies off the view a guard band changes no picture, in any geometry")
{
    struct Kind {
        const char* modules;
        const char* output;
        double most = kMostRounded;
    };
    const Kind kinds[] = {
        {R"("gtao")", "ao"},
        {R"("gtao")", "color"},
        {R"("bitmask_layers")", "ao"},
        {R"("hbao_plus")", "ao"},
        {R"("gtao", "geometry/depth_levels")", "ao", 0.01},  // every second texel, of either
        {R"("geometry/depth_only", "ssao/gtao", "filter/bilateral_normal")", "ao"},
        {R"("geometry/linear_depth_normal", "ssao/gtao", "filter/bilateral_normal")", "ao"},
        {R"("mobile")", "color", 0.005},  // normals rebuilt and rounded
        {R"("ssdo")", "color"},
        {R"("baked")", "ao"},
    };
    for (const Kind& kind : kinds)
        for (const View& view : kViews) {
            INFO(kind.modules << ' ' << kind.output << ' ' << view.extent.width << 'x'
                              << view.extent.height << " in " << view.band);
            const auto drawn_with = [&](const std::string& band) {
                PictureRequest wanted = request(view, band, kWhole);
                wanted.output = kind.output;
                wanted.overrides.push_back("radius=1");
                return drawn(kind.modules, wanted);
            };
            const Image with = drawn_with(view.band);
            const Image without = drawn_with("1");
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
    GlFixture gl;
    const Scene scene = need(loadScene("spheres"));
    const auto uploaded = need(UploadedScene::upload(*gl.device, scene));
    const Extent extent = {128, 72};
    const auto camera = need(chooseCamera(scene, uploaded.bounds(), kCut, 128.0 / 72.0));
    const Frame frame = makeFrame(uploaded, camera, extent);
    const auto occlusion = [&](int limit, const std::vector<std::string>& overrides) {
        SmallDevice device(*gl.device, limit);
        std::vector<std::string> all = {"radius=2"};  // wide, so that the band counts
        all.insert(all.end(), overrides.begin(), overrides.end());
        const Description config =
            need(decode(need(loadConfig(shippedSources(), {"high", {}, all})), shippedSources()));
        const auto renderer =
            need(Renderer::create(device, config, {extent, {"ao"}, {}}, traitsOf(frame)));
        CHECK(findNamed(renderer->plan().passes, "geometry")->extent.width <= limit);
        // Up to a pixel more on either side: borders are whole pixels, in both directions.
        CHECK(findNamed(renderer->plan().passes, "geometry")->frustum_scale <=
              limit / 128.0f + 2.0f / 72.0f);
        need(renderer->render(frame));
        return gl.read(renderer->output("ao"));
    };
    CHECK(meanChange(occlusion(150, {}), occlusion(2048, {"guard_band=1.171875"})) == 0.0);
    CHECK(meanChange(occlusion(128, {}), occlusion(2048, {"guard_band=1"})) == 0.0);
    CHECK(meanChange(occlusion(128, {}), occlusion(2048, {})) > 0.002);
}
