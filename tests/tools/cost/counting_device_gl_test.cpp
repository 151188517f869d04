// SPDX-License-Identifier: MIT
// Fetches counted in frames that are drawn, against counts that are known.
#include "tests/support/gl_fixture.h"
#include "tests/support/need.h"
#include "tools/cli/config_options.h"
#include "tools/cost/counting_device.h"
#include "tools/cost/fetches.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <crevice/renderer.h>

using namespace crevice;

namespace {

constexpr Extent kSize = {96, 54};
constexpr double kPixels = 96.0 * 54.0;

SceneView viewOf(const char* scene)
{
    SceneOptions options;
    options.scene = scene;
    options.size = "96x54";
    return need(loadSceneView(options));
}

Description described(const char* config, std::vector<std::string> set = {})
{
    ConfigOptions options;
    options.config = config;
    options.overrides = std::move(set);
    return need(loadDescription(options, CheckoutSources("")));
}

}  // namespace

TEST_CASE("A box of four by four fetches sixteen times a pixel, and as often as its size says")
{
    const SceneView view = viewOf("room");
    const auto counted = need(countFetches(described("learnopengl"), view));
    CHECK(counted.at("filter") == 16 * kPixels);
    CHECK(counted.at("foreground") == kPixels);
    CHECK(counted.at("ssao") > 50 * kPixels);
    CHECK(counted.at("ssao") <= 66 * kPixels);
    const auto fewer = need(countFetches(described("learnopengl", {"samples=16"}), view));
    CHECK(fewer.at("ssao") < 0.3 * counted.at("ssao"));
    CHECK(fewer.at("ssao") > 0.2 * counted.at("ssao"));
}

TEST_CASE("Counting changes no picture, whatever the config reads")
{
    GlFixture gl;
    for (const char* config : {"mobile", "high", "gtao_temporal", "learnopengl"}) {
        INFO(config);
        const SceneView view = viewOf("spheres");
        const UploadedScene scene = need(UploadedScene::upload(*gl.device, view.scene));
        const Frame frame = makeFrame(scene, view.camera, kSize);
        CompileOptions options;
        options.extent = kSize;
        options.disable = {"cached"};
        std::vector<Image> pictures;
        for (const bool counting : {false, true}) {
            CountingDevice device(*gl.device);
            if (counting) device.startCounting();
            const auto renderer =
                need(Renderer::create(device, described(config), options, traitsOf(frame)));
            for (int i = 0; i < 3; ++i) REQUIRE(renderer->render(frame).ok());
            pictures.push_back(need(readOutput(device, *renderer, "ao")));
            CHECK(need(device.fetches()).empty() == !counting);
        }
        CHECK(pictures[0].pixels == pictures[1].pixels);
    }
}
