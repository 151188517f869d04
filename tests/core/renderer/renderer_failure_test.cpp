// SPDX-License-Identifier: MIT
// The renderer on a device that fails: an error, no leak, and what worked before works on.
#include <crevice/renderer.h>

#include "core/config/values.h"
#include "tests/support/failing_changes.h"
#include "tests/support/renderer_rig.h"

#include <algorithm>
#include <tuple>

using namespace crevice;

TEST_CASE("A renderer that fails at any object leaves none behind")
{
    Rig rig;
    const int needed = rig.device.attempts();
    const auto create = [&]() -> Status {
        return Renderer::create(rig.device, rigDescription(), {{64, 32}}, traitsOf(rig.frame))
            .diagnostics();
    };
    CHECK(failEachObject(rig.device, create, [] {}) == needed - 1);  // the mesh is the frame's
}

TEST_CASE("A change that fails at any object leaves the old values, plan and pictures")
{
    constexpr std::pair<const char*, Status (*)(Rig&)> kChanges[] = {
        {"a define", [](Rig& rig) { return rig.renderer->setParam("samples", 9.0f); }},
        {"a feature", [](Rig& rig) { return rig.renderer->setFeature("soft", "false"); }},
        {"a size",
         [](Rig& rig) {
             return rig.renderer->resize({30, 30});
         }},
        {"a reload",
         [](Rig& rig) {
             return rig.renderer->reload(rigDescription(true), {{64, 32}});
         }},
        {"a frame of other traits",
         [](Rig& rig) {
             rig.frame.lights.resize(3);
             Status status = rig.renderer->render(rig.frame);
             if (!status) rig.frame.lights.resize(1);
             return status;
         }},
    };
    for (const auto& [what, make] : kChanges) {
        INFO(what);
        Rig rig;
        const std::string before = rig.draw();
        const TextureId ao = rig.renderer->output("ao");
        const Values values = valuesOf(rig.renderer->description());
        const auto unchanged = [&] {
            const Values now = valuesOf(rig.renderer->description());
            CHECK((now.params == values.params && now.features == values.features));
            CHECK(rig.renderer->plan().extent == Extent{64, 32});
            REQUIRE(rig.renderer->output("ao").value == ao.value);
            CHECK(rig.device.readTexture(ao).ok());
        };
        const int failures = failEachObject(
            rig.device, [&, make = make] { return make(rig); }, unchanged);
        CHECK(failures > 5);
        CHECK(rig.draw() != before);
    }
}

TEST_CASE("A frame of other traits that lacks an import leaves the old plan and pictures")
{
    const std::string config = R"({
      "format": 1, "name": "needy",
      "imports": {"depth": {"type": "texture"}},
      "targets": {"ao": {"format": ["r8"]}},
      "shaders": {"s": {"vertex": "v", "fragment": "f"}},
      "passes": {"p": {"shader": "s", "color": "ao"}},
      "outputs": {"ao": "ao"}})";
    const Description description =
        describe(config, {{"v", "#version 300 es\nvoid main() {}\n"},
                          {"f",
                           "#version 300 es\nuniform highp sampler2D depth;\n"
                           "layout(location = 0) out highp float ao;\n"}});
    RecordingDevice device;
    auto renderer = need(Renderer::create(device, description, {{8, 8}}, traitsOf({})));
    Frame frame;
    frame.textures = {
        {"depth", device.adoptTexture({1, "depth", Format::depth24, {8, 8}}).value()}};
    REQUIRE(renderer->render(frame).ok());
    const int live = device.live();
    const TextureId ao = renderer->output("ao");

    frame.textures.clear();
    const Status same_traits = renderer->render(frame);
    CHECK(codeOf(same_traits) == Code::missing_import);
    CHECK(same_traits.diagnostics().front().message ==
          "the frame has no texture for import 'depth'");
    CHECK(same_traits.diagnostics().front().pointer == "/imports/depth");
    frame.lights.resize(1);
    CHECK(codeOf(renderer->render(frame)) == Code::missing_import);
    CHECK(device.live() == live);
    CHECK(renderer->output("ao").value == ao.value);
    CHECK(device.readTexture(ao).ok());
    CHECK(device.misuse().empty());
}

TEST_CASE("An active uniform that the text does not declare, or of another type, is an error")
{
    const std::tuple<UniformInfo, Code, const char*> cases[] = {
        {{"hidden", GlslType::float_, 1, 0}, Code::uniform_unbound, ""},
        {{"hidden", GlslType::sampler2d, 1, 0}, Code::uniform_unbound, ""},
        {{"view_from_clip", GlslType::vec4, 1, 0}, Code::uniform_type, "/shaders/occlusion"}};
    for (const auto& [uniform, code, pointer] : cases) {
        INFO(uniform.name);
        RecordingDevice device;
        device.forceUniform(uniform);
        const auto none = Renderer::create(device, rigDescription(), {{8, 8}}, {});
        REQUIRE_FALSE(none.ok());
        CHECK((*pointer || none.diagnostics().front().code == code));
        const auto told = [&, code = code, pointer = pointer](const Diagnostic& error) {
            return error.code == code && error.pointer == pointer;
        };
        if (*pointer)
            CHECK(std::count_if(none.diagnostics().begin(), none.diagnostics().end(), told) == 1);
        CHECK(device.live() == 0);
        CHECK(device.misuse().empty());
    }
}

TEST_CASE(
    "A lost context is one error a call and changes nothing, and a new renderer draws the same")
{
    Rig rig;
    REQUIRE(rig.renderer->setParam("radius", 2.0f).ok());
    REQUIRE(rig.renderer->setParam("samples", 9.0f).ok());
    const std::string before = rig.draw();
    const Description description = rig.renderer->description();
    rig.device.loseContext();
    Renderer& renderer = *rig.renderer;
    for (const Status& status :
         {renderer.render(rig.frame), Status(renderer.renderTimed(rig.frame).diagnostics()),
          renderer.resize({30, 30}), renderer.setFeature("soft", "false"),
          renderer.setParam("samples", 5.0f), renderer.reload(rigDescription(), {{64, 32}}),
          Status(rig.device.readTexture(renderer.output("ao")).diagnostics())})
        CHECK(onlyCode(status) == Code::context_lost);
    const Values kept = valuesOf(rig.renderer->description());
    CHECK(kept.params == valuesOf(description).params);
    CHECK(kept.features == valuesOf(description).features);
    rig.renderer.reset();
    CHECK(rig.device.live() == 1);

    Rig other;
    other.use(description);
    CHECK(other.draw() == before);
}
