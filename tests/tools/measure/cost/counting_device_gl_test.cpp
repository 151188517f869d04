// SPDX-License-Identifier: MIT
// Fetches counted in frames that are drawn, against counts that are known.
#include "tests/support/gl_fixture.h"
#include "tools/commands/cli/config_options.h"
#include "tools/measure/cost/counting_device.h"
#include "tools/measure/cost/loops.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"
#include "tools/show/plan/planning.h"

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

TEST_CASE("Fetches are counted as often as loops run, in pixels that the mask lets through")
{
    // The taps, the pixel's own depth and normal, and its depth once more by what rebuilds points.
    constexpr double kAround = 3;
    const auto filled = need(countFrame(described("learnopengl"), viewOf("corner")));
    CHECK(filled.at("foreground").fetches == kPixels);
    CHECK(filled.at("filter").fetches == 9 * kPixels);
    CHECK(filled.at("ssao").fetches == (64 + kAround) * kPixels);
    const auto fewer = need(countFrame(described("learnopengl", {"samples=16"}), viewOf("corner")));
    CHECK(fewer.at("ssao").fetches == (16 + kAround) * kPixels);
    CHECK(filled.at("ssao").runs == std::vector<double>{64});
    CHECK(fewer.at("ssao").runs == std::vector<double>{16});
    CHECK(filled.at("filter").runs == std::vector<double>{3, 3});
    CHECK(filled.at("ssao").pixels == kPixels);
    const auto masked = need(countFrame(described("learnopengl"), viewOf("spheres")));
    CHECK(masked.at("ssao").fetches < 0.9 * filled.at("ssao").fetches);
    CHECK(masked.at("ssao").fetches > 0.5 * filled.at("ssao").fetches);
    CHECK(masked.at("ssao").fetches == (64 + kAround) * masked.at("ssao").pixels);
    CHECK(masked.at("ssao").runs == std::vector<double>{64});
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
            CHECK(need(device.counts()).empty() == !counting);
        }
        CHECK(pictures[0].pixels == pictures[1].pixels);
    }
}

TEST_CASE("Shaders compile with their loops' bodies once and twice instead")
{
    GlFixture gl;
    int loops = 0;
    for (const char* config : {"mobile", "balanced", "gtao_temporal", "learnopengl"}) {
        const Plan plan = need(
            compile(described(config), usualTraits(), gl.device->caps(), {kSize, {}, {"cached"}}));
        for (const PlanProgram& program : plan.programs) {
            const std::vector<GlslLoop> all = loopsOf(program.fragment.text);
            for (int twice = -1; twice < static_cast<int>(all.size()); ++twice, ++loops) {
                INFO(config << " " << program.label << " " << twice);
                GlslStage fragment = program.fragment;
                fragment.text = withoutLoops(fragment.text, all, twice);
                CHECK(loopsOf(fragment.text).empty());
                need(gl.device->createProgram({"", program.vertex, fragment}));
            }
        }
    }
    CHECK(loops > 20);
}
