// SPDX-License-Identifier: MIT
// Hosts that hand in what is not there or not finite, or that call without their context.
// A plan that no config stands behind, on the recording device: what running needs is in the plan.
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "core/config/values.h"
#include "core/run/execution.h"
#include "tests/support/catch.h"
#include "tests/support/renderer_rig.h"

#include <functional>
#include <limits>

using namespace crevice;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kPoison = 12345;

/// The one warning of a frame that is drawn, and what was drawn of it.
struct Drawn {
    explicit Drawn(Rig& rig)
    {
        rig.device.clearLog();
        warning = onlyWarning(rig.renderer->render(rig.frame), Code::bad_input);
        CHECK_FALSE(warning.help.empty());
        draws = occurrences(rig.device.log(), "draw mesh");
    }

    Diagnostic warning;
    int draws = 0;
};

/// With a second draw, of a material of its own, in which mistakes are made.
struct Scene {
    Scene()
    {
        rig.frame.draws.push_back(rig.frame.draws[0]);
        rig.frame.draws[1].material = 1;
        rig.frame.materials.resize(2);
        rig.draw();
    }

    DrawItem& item() { return rig.frame.draws[1]; }
    Material& material() { return rig.frame.materials[1]; }

    Rig rig;
};

/// What a host may get wrong about a draw, and what is said of it.
struct Mistake {
    const char* why;
    std::function<void(Scene&)> make;
};

std::vector<Mistake> mistakes()
{
    std::vector<Mistake> all = {
        {"it has no mesh", [](Scene& scene) { scene.item().mesh = {}; }},
        {"mesh 12345 is none of this device", [](Scene& scene) { scene.item().mesh = {kPoison}; }},
        {"is none of this device",  // any more
         [](Scene& scene) {
             Device& device = scene.rig.device;
             const MeshDesc gone = {"gone", std::vector<Vertex>(3), {0, 1, 2}};
             scene.item().mesh = need(device.createMesh(gone));
             device.destroy(scene.item().mesh);
         }},
        {"is none of this device",  // but a texture
         [](Scene& scene) { scene.item().mesh = {scene.rig.renderer->output("ao").value}; }},
        {"has fewer indices than it draws", [](Scene& scene) { scene.item().count = 7; }},
        {"has fewer indices than it draws", [](Scene& scene) { scene.item().first = 0xffffffff; }},
        {"its matrix is not finite",
         [](Scene& scene) { scene.item().world_from_model[1][2] = kNan; }},
        {"its matrix is not finite",
         [](Scene& scene) { scene.item().world_from_model[3][0] = 1e300; }},
        {"its bounds are not finite", [](Scene& scene) { scene.item().bounds_center.y = kNan; }},
        {"its bounds are not finite", [](Scene& scene) { scene.item().bounds_radius = kNan; }},
        {"material 1 is not finite", [](Scene& scene) { scene.material().base_color.w = kNan; }},
        {"material 1 is not finite", [](Scene& scene) { scene.material().specular.y = kNan; }},
        {"material 1 has texture 12345 as base_color_map, which is none of this device",
         [](Scene& scene) { scene.material().base_color_map = {kPoison}; }},
        {"as normal_map, which has several samples a pixel",
         [](Scene& scene) {
             const HostTexture host{7, "samples", Format::rgba8, {4, 4}, 4};
             scene.material().normal_map = need(scene.rig.device.adoptTexture(host));
         }},
    };
    for (const int none : {2, -1, 2147483647})
        all.push_back({"and the frame has 2 materials",
                       [none](Scene& scene) { scene.item().material = none; }});
    for (float Material::*number :
         {&Material::shininess, &Material::alpha_cutoff, &Material::normal_scale,
          &Material::occlusion_strength, &Material::ambient})
        all.push_back({"material 1 is not finite",
                       [number](Scene& scene) { scene.material().*number = kNan; }});
    return all;
}

GlslStage stageWith(std::vector<GlslUniform> uniforms)
{
    GlslStage stage;
    stage.text = "#version 300 es\nvoid main() {}\n";
    stage.uniforms = std::move(uniforms);
    return stage;
}

// One fullscreen pass that draws "ao" from a param, a kernel and the size of its target.
Plan handMade()
{
    Plan plan;
    plan.config = "by hand";
    plan.extent = {16, 8};
    plan.params = {{"radius", GlslType::float_, {0.5f}}, {"taps", GlslType::int_, {3}}};
    plan.generated.resize(1);
    plan.generated[0].name = "offsets";
    plan.generated[0].generator = "sphere_kernel";
    plan.generated[0].count = 2;
    plan.textures = {{Format::r8, plan.extent, 1, 0, false, {"ao"}}};
    plan.targets = {{"ao", 0, 0, 0, 1}};
    PlanProgram program;
    program.key = "0123456789abcdef";
    program.label = "occlusion";
    program.vertex = stageWith({});
    program.fragment = stageWith({{"radius", GlslType::float_, 1, false, {}},
                                  {"taps", GlslType::int_, 1, false, {}},
                                  {"offsets", GlslType::vec3, 2, true, {}},
                                  {"viewport_size", GlslType::vec2, 1, false, {}}});
    plan.programs = {program};
    PlanPass pass;
    pass.name = "occlusion";
    pass.program = 0;
    pass.extent = plan.extent;
    pass.color.resize(1);
    pass.color[0].target = 0;
    pass.color[0].name = "ao";
    pass.uniforms = {{"radius", GlslType::float_, 1, UniformSource::param, 0},
                     {"taps", GlslType::int_, 1, UniformSource::param, 1},
                     {"offsets", GlslType::vec3, 2, UniformSource::kernel, 0},
                     {"viewport_size", GlslType::vec2, 1, UniformSource::frame, viewport_size}};
    plan.passes = {pass};
    plan.outputs = {{"ao", 0}};
    return plan;
}

}  // namespace

TEST_CASE(
    "A draw that cannot be drawn is left out with a warning, and is back as soon as it is mended")
{
    for (const Mistake& mistake : mistakes()) {
        INFO(mistake.why);
        Scene scene;
        Rig& rig = scene.rig;
        const DrawItem item = scene.item();
        const Material material = scene.material();
        mistake.make(scene);
        for (int frame = 0; frame < 2; ++frame) {
            rig.frame.lights[0].position.x += 1;
            const Drawn drawn(rig);
            CHECK(drawn.warning.message.find("draw 1 is left out: ") == 0);
            CHECK(drawn.warning.message.find(mistake.why) != std::string::npos);
            CHECK(drawn.draws == (frame == 0 ? 1 : 0));  // nothing of the geometry changed since
        }
        scene.item() = item;
        scene.material() = material;
        rig.draw();
        CHECK(occurrences(rig.device.log(), "draw mesh") == 2);
        rig.draw();
        CHECK(occurrences(rig.device.log(), "draw mesh") == 0);
    }
}

TEST_CASE("A strict renderer draws no frame of which something would be left out")
{
    Rig rig;
    CompileOptions options = {{64, 32}};
    options.strict = true;
    REQUIRE(rig.renderer->reload(rig.renderer->description(), options).ok());
    rig.draw();
    rig.frame.draws.push_back(rig.frame.draws[0]);
    rig.frame.draws[1].world_from_model[0][0] = kNan;
    rig.frame.lights[0].color.y = kNan;
    rig.device.clearLog();
    const Status status = rig.renderer->render(rig.frame);
    CHECK_FALSE(status.ok());
    REQUIRE(status.diagnostics().size() == 2);
    CHECK(status.diagnostics()[0].message ==
          "the frame cannot be drawn whole: draw 1 is left out: its matrix is not finite");
    CHECK(rig.device.log().empty());
    rig.frame.draws[1] = rig.frame.draws[0];
    rig.frame.lights[0].color.y = 1;
    CHECK(rig.renderer->render(rig.frame).ok());
}

TEST_CASE("A light that is not finite is left out with a warning, and the picture goes on")
{
    float* (*const numbers[])(Frame&) = {
        [](Frame& frame) { return &frame.lights[0].color.y; },
        [](Frame& frame) { return &frame.lights[0].attenuation.z; },
        [](Frame& frame) { return &frame.lights[0].inner_angle_rad; },
        [](Frame& frame) { return &frame.ambient_light.z; },
        [](Frame&) -> float* { return nullptr; },  // the position
    };
    for (const auto number : numbers) {
        Rig rig;
        rig.draw();
        float* const bad = number(rig.frame);
        if (bad) *bad = kNan;
        if (!bad) rig.frame.lights[0].position.y = kNan;
        const bool ambient = bad == &rig.frame.ambient_light.z;
        const Drawn drawn(rig);
        CHECK(drawn.warning.message == std::string(ambient ? "ambient_light" : "light 0") +
                                           " is left out: it is not finite");
        CHECK(rig.device.lastUniform("light_count") == std::vector<float>{1});
        for (const char* name :
             {"light_position", "light_color", "light_attenuation", "ambient_light"})
            for (const float value : rig.device.lastUniform(name)) CHECK(std::isfinite(value));
        CHECK(rig.device.lastUniform(ambient ? "ambient_light" : "light_color")[0] == 0);
        rig.frame.lights[0] = {};
        rig.frame.ambient_light = glm::vec3(1.0f);
        rig.draw();
        CHECK(rig.device.lastUniform("light_color")[0] == 1);
        CHECK(rig.device.lastUniform("ambient_light")[0] == 1);
    }
}

TEST_CASE("A frame's texture that the device does not have is refused, and the last picture stays")
{
    Rig rig;
    rig.draw();
    const TextureId gone = need(rig.device.createTexture({"gone", Format::rgba8, {4, 4}}));
    rig.device.destroy(gone);
    const TextureId wrong[] = {TextureId{kPoison}, gone, TextureId{rig.mesh.value}};
    rig.frame.textures = {{"decal", wrong[GENERATE(0, 1, 2)]}};
    rig.device.clearLog();
    const Status status = rig.renderer->render(rig.frame);
    CHECK(onlyCode(status) == Code::bad_input);
    CHECK(status.diagnostics()[0].message.find("the frame's texture 'decal' is texture ") == 0);
    CHECK(status.diagnostics()[0].pointer == "/imports/decal");
    CHECK(rig.device.log().empty());
    rig.frame.textures.clear();
    rig.draw();
}

TEST_CASE("A frame without the device's context is an error, and counts as not drawn")
{
    Rig rig(GENERATE(false, true));
    const bool first = GENERATE(false, true);
    if (!first) rig.draw();
    const TextureId shown = rig.renderer->output("ao");
    rig.frame.draws[0].world_from_model[3][0] = 1;
    rig.frame.lights[0].position.x = 5;
    rig.device.clearLog();
    rig.device.setCurrent(false);
    for (int i = 0; i < 3; ++i) {
        CHECK(onlyCode(rig.renderer->render(rig.frame)) == Code::gl_version);
        CHECK(onlyCode(rig.renderer->renderTimed(rig.frame).diagnostics()) == Code::gl_version);
    }
    CHECK(rig.device.log().find("beginPass") == std::string::npos);
    CHECK(rig.renderer->output("ao").value == shown.value);
    rig.device.setCurrent(true);
    rig.draw();
    for (const char* pass : {"geometry", "occlusion", "filter", "lighting"})
        CHECK(rig.ranPass(pass));
    CHECK(rig.device.lastUniform("view_from_model")[12] == 1);
}

TEST_CASE("Without the device's context a renderer is neither made nor changed")
{
    Rig rig;
    rig.draw();
    const Values before = valuesOf(rig.renderer->description());
    rig.device.setCurrent(false);
    CHECK(onlyCode(Renderer::create(rig.device, rigDescription(), {{64, 32}}, traitsOf(rig.frame))
                       .diagnostics()) == Code::gl_version);
    CHECK(onlyCode(rig.renderer->resize({30, 30})) == Code::gl_version);
    CHECK(onlyCode(rig.renderer->setFeature("soft", "false")) == Code::gl_version);
    CHECK(onlyCode(rig.renderer->setParam("samples", 5.0f)) == Code::gl_version);
    CHECK(onlyCode(rig.renderer->reload(rigDescription(), {{64, 32}})) == Code::gl_version);
    rig.frame.lights.resize(3);  // a frame of other traits
    CHECK(onlyCode(rig.renderer->render(rig.frame)) == Code::gl_version);
    rig.device.setCurrent(true);
    CHECK(valuesOf(rig.renderer->description()).params == before.params);
    CHECK(valuesOf(rig.renderer->description()).features == before.features);
    rig.draw();
}

TEST_CASE("A plan made by hand runs, and its params change, where there is no config")
{
    RecordingDevice device;
    auto execution = need(Execution::create(device, handMade()));
    const Frame frame;
    REQUIRE(execution->setImports(frame).ok());
    REQUIRE(execution->run(frame).ok());
    CHECK(device.lastUniform("radius") == std::vector<float>{0.5f});
    CHECK(device.lastUniform("taps") == std::vector<float>{3});
    CHECK(device.lastUniform("offsets").size() == 6);
    CHECK(device.lastUniform("viewport_size") == std::vector<float>{16, 8});
    CHECK(execution->output("ao", 0));

    const float wider = 2, more = 5;
    execution->setParam("radius", &wider);
    execution->setParam("taps", &more);
    execution->setParam("of another plan", &more);
    REQUIRE(execution->run(frame).ok());
    CHECK(device.lastUniform("radius") == std::vector<float>{2});
    CHECK(device.lastUniform("taps") == std::vector<float>{5});
    CHECK(device.misuse().empty());
}

TEST_CASE("A plan that binds nothing to a uniform, or a value of another type, is refused")
{
    Plan plan = handMade();
    plan.passes[0].uniforms[0].type = GlslType::vec2;
    plan.passes[0].uniforms.pop_back();
    RecordingDevice device;
    const auto none = Execution::create(device, std::move(plan));
    REQUIRE(none.diagnostics().size() == 2);
    CHECK(none.diagnostics()[0].code == Code::uniform_type);
    CHECK(none.diagnostics()[1].code == Code::uniform_unbound);
    CHECK(device.live() == 0);
}
