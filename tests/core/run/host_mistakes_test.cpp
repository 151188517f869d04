// SPDX-License-Identifier: MIT
// Hosts that hand in what is not there or not finite, or that call without their context.
#include <crevice/renderer.h>

#include "core/config/values.h"
#include "tests/support/need.h"
#include "tests/support/renderer_rig.h"

#include <limits>

using namespace crevice;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kPoison = 12345;

int count(const std::string& text, const std::string& part)
{
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// The one warning of a frame that is drawn, and what was drawn of it.
struct Drawn {
    explicit Drawn(Rig& rig)
    {
        rig.device.clearLog();
        const Status status = rig.renderer->render(rig.frame);
        INFO(toText(status.diagnostics()));
        REQUIRE(status.ok());
        REQUIRE(status.diagnostics().size() == 1);
        warning = status.diagnostics()[0];
        CHECK(warning.code == Code::bad_input);
        CHECK_FALSE(warning.help.empty());
        CHECK(rig.device.misuse().empty());
        draws = count(rig.device.log(), "draw mesh");
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

Code onlyCode(const Status& status)
{
    return status.diagnostics().size() == 1 ? status.diagnostics()[0].code : Code::internal;
}

}  // namespace

TEST_CASE(
    "A draw that cannot be drawn is left out with a warning, and is back as soon as it is mended")
{
    Scene scene;
    Rig& rig = scene.rig;
    const DrawItem item = scene.item();
    const Material material = scene.material();
    std::string why;
    SECTION("null mesh")
    {
        scene.item().mesh = {};
        why = "it has no mesh";
    }
    SECTION("unknown mesh")
    {
        scene.item().mesh = {kPoison};
        why = "mesh 12345 is none of this device";
    }
    SECTION("a mesh that was destroyed")
    {
        scene.item().mesh =
            rig.device.createMesh({"gone", std::vector<Vertex>(3), {0, 1, 2}}).value();
        rig.device.destroy(scene.item().mesh);
        why = "is none of this device";
    }
    SECTION("a texture as mesh")
    {
        scene.item().mesh = {rig.renderer->output("ao").value};
        why = "is none of this device";
    }
    SECTION("indices past the mesh's")
    {
        scene.item().count = 7;
        why = "has fewer indices than it draws";
    }
    SECTION("first index past the mesh's")
    {
        scene.item().first = 0xffffffff;
        why = "has fewer indices than it draws";
    }
    SECTION("matrix")
    {
        scene.item().world_from_model[1][2] = kNan;
        why = "its matrix is not finite";
    }
    SECTION("huge matrix")
    {
        scene.item().world_from_model[3][0] = 1e300;
        why = "its matrix is not finite";
    }
    SECTION("center")
    {
        scene.item().bounds_center.y = kNan;
        why = "its bounds are not finite";
    }
    SECTION("radius")
    {
        scene.item().bounds_radius = kNan;
        why = "its bounds are not finite";
    }
    SECTION("no such material")
    {
        scene.item().material = GENERATE(2, -1, 2147483647);
        why = "and the frame has 2 materials";
    }
    SECTION("material")
    {
        float* const numbers[] = {
            &scene.material().base_color.w, &scene.material().specular.y,
            &scene.material().shininess,    &scene.material().alpha_cutoff,
            &scene.material().normal_scale, &scene.material().occlusion_strength,
            &scene.material().ambient};
        *numbers[GENERATE(range(0, 7))] = kNan;
        why = "material 1 is not finite";
    }
    SECTION("unknown map")
    {
        scene.material().base_color_map = {kPoison};
        why = "material 1 has texture 12345 as base_color_map, which is none of this device";
    }
    SECTION("a map of samples")
    {
        const HostTexture host{7, "samples", Format::rgba8, {4, 4}, 4};
        scene.material().normal_map = need(rig.device.adoptTexture(host));
        why = "as normal_map, which has several samples a pixel";
    }
    INFO(why);
    for (int frame = 0; frame < 2; ++frame) {
        rig.frame.lights[0].position.x += 1;
        const Drawn drawn(rig);
        CHECK(drawn.warning.message.find("draw 1 is left out: ") == 0);
        CHECK(drawn.warning.message.find(why) != std::string::npos);
        CHECK(drawn.draws == (frame == 0 ? 1 : 0));  // nothing of the geometry changed since
    }
    scene.item() = item;
    scene.material() = material;
    rig.draw();
    CHECK(count(rig.device.log(), "draw mesh") == 2);
    rig.draw();
    CHECK(count(rig.device.log(), "draw mesh") == 0);
}

TEST_CASE("A renderer's first frame may have a draw that cannot be drawn")
{
    Rig rig;
    rig.frame.draws[0].mesh = {kPoison};
    const Drawn drawn(rig);
    CHECK(drawn.draws == 0);
    CHECK(rig.ranPass("geometry"));
    CHECK(rig.ranPass("lighting"));
}

TEST_CASE("Many draws that cannot be drawn are few warnings and a count")
{
    Rig rig;
    rig.frame.draws.resize(1000, rig.frame.draws[0]);
    for (std::size_t i = 1; i < 1000; ++i) rig.frame.draws[i].world_from_model[0][0] = kNan;
    const Status status = rig.renderer->render(rig.frame);
    REQUIRE(status.ok());
    REQUIRE(status.diagnostics().size() == 8);
    CHECK(status.diagnostics()[7].notes.at(0).text == "991 more draws are left out");
    CHECK(count(rig.device.log(), "draw mesh") == 1);
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
    Rig rig;
    rig.draw();
    std::string what;
    SECTION("position")
    {
        rig.frame.lights[0].position.y = kNan;
        what = "light 0";
    }
    SECTION("color")
    {
        rig.frame.lights[0].color.y = kNan;
        what = "light 0";
    }
    SECTION("attenuation")
    {
        rig.frame.lights[0].attenuation.z = kNan;
        what = "light 0";
    }
    SECTION("cone")
    {
        rig.frame.lights[0].inner_angle_rad = kNan;
        what = "light 0";
    }
    SECTION("ambient")
    {
        rig.frame.ambient_light.z = kNan;
        what = "ambient_light";
    }
    const Drawn drawn(rig);
    CHECK(drawn.warning.message == what + " is left out: it is not finite");
    CHECK(rig.device.lastUniform("light_count") == std::vector<float>{1});
    for (const char* name : {"light_position", "light_color", "light_attenuation", "ambient_light"})
        for (const float value : rig.device.lastUniform(name)) CHECK(std::isfinite(value));
    const std::string dark = what == "light 0" ? "light_color" : "ambient_light";
    CHECK(rig.device.lastUniform(dark)[0] == 0);
    rig.frame.lights[0] = {};
    rig.frame.ambient_light = glm::vec3(1.0f);
    rig.draw();
    CHECK(rig.device.lastUniform("light_color")[0] == 1);
    CHECK(rig.device.lastUniform("ambient_light")[0] == 1);
}

TEST_CASE("Timed frames leave out the same")
{
    Scene scene;
    scene.item().mesh = {kPoison};
    const auto times = scene.rig.renderer->renderTimed(scene.rig.frame);
    REQUIRE(times.ok());
    CHECK(onlyCode(times.diagnostics()) == Code::bad_input);
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
    CHECK(rig.device.misuse().empty());
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
    CHECK(rig.device.misuse().empty());
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
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("A device knows its objects, and what is none of them")
{
    Rig rig;
    CHECK(rig.device.info(rig.mesh).exists);
    CHECK(rig.device.info(rig.mesh).index_count == 6);
    CHECK_FALSE(rig.device.info(TextureId{rig.mesh.value}).exists);
    CHECK_FALSE(rig.device.info(MeshId{}).exists);
    CHECK_FALSE(rig.device.info(MeshId{kPoison}).exists);
    const TextureId adopted = need(rig.device.adoptTexture({77, "host", Format::r8, {4, 4}}));
    CHECK(rig.device.nativeName(adopted) == 77);
    CHECK(rig.device.nativeName(rig.renderer->output("ao")) != 0);
    CHECK(rig.device.nativeName({}) == 0);
    CHECK(rig.device.nativeName({kPoison}) == 0);
    rig.device.destroy(adopted);
    CHECK(rig.device.nativeName(adopted) == 0);
}
