// SPDX-License-Identifier: MIT
// The renderer keeps its plan in step with params, features, size and scene.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>
#include <tuple>

using namespace crevice;

TEST_CASE("A frame runs the plan's passes in order, and nothing about it is wrong")
{
    Rig rig;
    const std::string log = rig.draw();
    std::vector<std::size_t> places;
    for (const char* pass : {"geometry 64x32", "occlusion 32x16", "filter 64x32", "lighting 64x32"})
        places.push_back(log.find("beginPass " + std::string(pass)));
    CHECK(std::is_sorted(places.begin(), places.end()));
    CHECK(places.back() != std::string::npos);
}

TEST_CASE("Outputs have textures with content, other names have none")
{
    Rig rig;
    rig.draw();
    CHECK(rig.device.readTexture(rig.renderer->output("ao"))->extent == Extent{64, 32});
    CHECK(rig.device.readTexture(rig.renderer->output("color"))->channels == 4);
    CHECK_FALSE(rig.renderer->output("normal"));
}

TEST_CASE("A uniform param is sent with the next frame and costs no object")
{
    Rig rig;
    rig.draw();
    CHECK(rig.device.lastUniform("radius") == std::vector<float>{0.5f});
    const int attempts = rig.device.attempts();
    REQUIRE(rig.renderer->setParam("radius", 2.0f).ok());
    REQUIRE(rig.renderer->setParam("taps", 7.0f).ok());
    const float tint[3] = {0.1f, 0.2f, 0.3f};
    REQUIRE(rig.renderer->setParam("tint", tint, 3).ok());
    rig.draw();
    CHECK(rig.device.lastUniform("radius") == std::vector<float>{2.0f});
    CHECK(rig.device.lastUniform("taps") == std::vector<float>{7.0f});
    CHECK(rig.device.lastUniform("tint") == std::vector<float>{0.1f, 0.2f, 0.3f});
    CHECK(rig.device.attempts() == attempts);
}

TEST_CASE("A param that cannot be set says why and keeps its value")
{
    Rig rig;
    Renderer& renderer = *rig.renderer;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::tuple<const char*, float, int, Code> cases[] = {
        {"radius", -0.5f, 1, Code::out_of_range},   {"radius", 101.0f, 1, Code::out_of_range},
        {"taps", 2.5f, 1, Code::out_of_range},      {"radius", std::nanf(""), 1, Code::not_finite},
        {"radius", kInfinity, 1, Code::not_finite}, {"radius", 1, 2, Code::bad_length},
        {"tint", 1, 2, Code::bad_length},           {"radious", 1, 1, Code::unknown_param}};
    for (const auto& [param, value, count, code] : cases) {
        INFO(param << ' ' << value);
        const float values[2] = {value, value};
        CHECK(codeOf(renderer.setParam(param, values, count)) == code);
    }
    CHECK(rig.value("radius") == 0.5f);
    CHECK(rig.value("taps") == 3.0f);

    const Diagnostic error = renderer.setParam("radius", -0.5f).diagnostics().front();
    CHECK(error.message == "radius -0.5 is outside [0.001, 100] scene units");
    CHECK(error.pointer == "/params/radius");
    CHECK(error.place.line > 0);
    CHECK(has(onlyError(renderer.setParam("radious", 1), Code::unknown_param).help, "radius"));
}

TEST_CASE("A param compiles the programs and makes the textures that depend on it, and no others")
{
    struct Case {
        const char* param;
        float value;
        const char* program;  ///< The only one that is compiled; "" for none.
        const char* texture;
    };
    for (const Case& each :
         {Case{"samples", 16, "occlusion", ""}, Case{"edge", 0.25f, "filter", ""},
          Case{"tile", 7, "", "'noise' rgba16f 7x7"},
          Case{"resolution", 0.25f, "", "'ao' r8 16x8"}}) {
        INFO(each.param);
        Rig rig;
        rig.draw();
        CHECK(rig.device.lastUniform("kernel").size() == 3 * 4);
        rig.device.clearLog();
        REQUIRE(rig.renderer->setParam(each.param, each.value).ok());
        const std::string program = each.program;
        CHECK(rig.logged("createProgram '" + program + "'") == !program.empty());
        CHECK(occurrences(rig.device.log(), "createProgram") == (program.empty() ? 0 : 1));
        CHECK(rig.logged("createTexture " + std::string(each.texture)));
        rig.draw();
        CHECK(rig.device.lastUniform("kernel").size() == 3u * (program == "occlusion" ? 16 : 4));
    }
}

TEST_CASE("At its no-op value a pass is left out, and comes back with another value")
{
    Rig rig;
    REQUIRE(rig.renderer->setParam("intensity", 0.0f).ok());
    rig.draw();
    CHECK_FALSE(rig.ranPass("occlusion"));
    CHECK(rig.ranPass("lighting"));
    REQUIRE(rig.renderer->setParam("intensity", 1.5f).ok());
    rig.draw();
    CHECK(rig.ranPass("occlusion"));
    CHECK(rig.device.lastUniform("intensity") == std::vector<float>{1.5f});

    const int attempts = rig.device.attempts();
    REQUIRE(rig.renderer->setParam("intensity", 2.0f).ok());
    CHECK(rig.device.attempts() == attempts);
}

TEST_CASE("A feature switches its pass off, and the bypass stands in")
{
    Rig rig;
    REQUIRE(rig.renderer->setFeature("soft", "false").ok());
    rig.draw();
    CHECK_FALSE(rig.ranPass("filter"));
    CHECK(rig.logged("setTexture smooth_ao unit"));
    CHECK(rig.device.readTexture(rig.renderer->output("ao"))->extent == Extent{32, 16});
}

TEST_CASE("A new size gives new textures, a size that cannot be leaves the old ones")
{
    Rig rig;
    rig.draw();
    REQUIRE(rig.renderer->resize({20, 11}).ok());
    CHECK(rig.renderer->plan().extent == Extent{20, 11});
    rig.draw();
    CHECK(rig.device.lastUniform("viewport_size") == std::vector<float>{20, 11});
    const TextureId before = rig.renderer->output("ao");

    CHECK(codeOf(rig.renderer->resize({0, 10})) == Code::bad_size);
    CHECK(codeOf(rig.renderer->resize({1 << 20, 10})) == Code::too_big_for_device);
    CHECK(rig.renderer->plan().extent == Extent{20, 11});
    CHECK(rig.renderer->output("ao").value == before.value);
    rig.draw();
}

TEST_CASE("A frame with other traits is planned again, once")
{
    Rig rig;
    rig.draw();
    const int attempts = rig.device.attempts();
    rig.frame.materials[0].specular = glm::vec3(1.0f);
    rig.draw();
    CHECK(rig.device.attempts() > attempts);
    const int after = rig.device.attempts();
    rig.draw();
    CHECK(rig.device.attempts() == after);
}

TEST_CASE("A camera whose range needs more bits has positions stored in wider formats")
{
    const SourceSet& sources = shippedSources();
    const Description description =
        need(decode(need(loadConfig(sources, {"learnopengl"})), sources));
    Frame frame;
    frame.camera.clip_from_view = glm::perspective(1.0f, 1.5f, 0.1f, 10.0f);
    RecordingDevice device;
    const auto renderer =
        need(Renderer::create(device, description, {{1920, 1080}}, traitsOf(frame)));
    const auto positions = [&] {
        REQUIRE(renderer->render(frame).ok());
        const Plan& plan = renderer->plan();
        return plan.textures[findNamed(plan.targets, "position")->texture].format;
    };
    CHECK(positions() == Format::rgba16f);
    frame.camera.clip_from_view = glm::perspective(1.0f, 1.5f, 0.1f, 10000.0f);
    CHECK(positions() == Format::rgba32f);
}

TEST_CASE("The warnings of a plan that a frame asks for come back with that frame alone")
{
    const Description description =
        describe(R"({"format": 1, "name": "dead_pass",
        "imports": {"scene": {"type": "draw_list"}},
        "targets": {"color": {"format": ["rgba8"]}, "shine": {"format": ["rgba8"]}},
        "shaders": {"plain": {"vertex": "v", "fragment": "f"}},
        "passes": {"lit": {"type": "fullscreen", "shader": "plain", "color": "color"},
                   "sheen": {"type": "fullscreen", "shader": "plain", "color": "shine",
                             "when": {"scene.specular": true}}},
        "outputs": {"color": "color"}})",
                 {{"v", "#version 300 es\nvoid main() {}\n"},
                  {"f", "#version 300 es\nprecision highp float;\nout vec4 value;\n"}});
    Rig rig;
    auto renderer = Renderer::create(rig.device, description, {{8, 8}}, traitsOf(rig.frame));
    REQUIRE(renderer.ok());
    CHECK(renderer.diagnostics().empty());
    CHECK((*renderer)->render(rig.frame).diagnostics().empty());
    rig.frame.materials[0].specular = glm::vec3(1.0f);
    const Status drawn = (*renderer)->render(rig.frame);
    CHECK(onlyWarning(drawn, Code::dead_pass).pointer == "/passes/sheen");
    CHECK((*renderer)->render(rig.frame).diagnostics().empty());
    rig.frame.materials[0].specular = glm::vec3(0.0f);
    CHECK((*renderer)->render(rig.frame).diagnostics().empty());
    rig.frame.materials[0].specular = glm::vec3(1.0f);
    onlyWarning((*renderer)->renderTimed(rig.frame), Code::dead_pass);
}

TEST_CASE("What a plan cannot be made of is no renderer")
{
    RecordingDevice device;
    onlyError(Renderer::create(device, rigDescription(), {{0, 0}}, {}), Code::bad_size);
    CHECK(device.attempts() == 0);
}
