// SPDX-License-Identifier: MIT
// The renderer on a device that fails: an error, no leak, and what worked before works on.
#include <crevice/renderer.h>

#include "core/config/values.h"
#include "tests/support/catch.h"
#include "tests/support/failing_changes.h"
#include "tests/support/renderer_rig.h"

#include <algorithm>
#include <functional>

using namespace crevice;

namespace {

// Lets each object of `change` fail in turn, until one run of it meets no failure.
void failEachAttempt(Rig& rig, const std::function<Status()>& change)
{
    const std::string before = rig.draw();
    const TextureId ao = rig.renderer->output("ao");
    const int failures = failEachObject(rig.device, change, [&] {
        REQUIRE(rig.renderer->output("ao").value == ao.value);
        CHECK(rig.device.readTexture(ao).ok());
    });
    CHECK(failures > 5);
    CHECK(rig.device.misuse().empty());
    CHECK(rig.draw() != before);
}

}  // namespace

TEST_CASE("A renderer that fails at any object leaves none behind")
{
    Rig rig;
    const int live = rig.device.live();
    const int needed = rig.device.attempts();
    int failures = 0;
    for (int n = 1; n <= needed; ++n) {
        INFO("attempt " << n);
        rig.device.failAt(n);
        const auto none =
            Renderer::create(rig.device, rigDescription(), {{64, 32}}, traitsOf(rig.frame));
        rig.device.failAt(0);
        if (none.ok()) break;
        ++failures;
        CHECK(none.diagnostics().front().code == Code::out_of_memory);
        CHECK(rig.device.live() == live);
    }
    CHECK(failures == needed - 1);  // the mesh is the frame's, not the renderer's
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("A define that fails to apply leaves the old value, plan and pictures")
{
    Rig rig;
    failEachAttempt(rig, [&] {
        const Status status = rig.renderer->setParam("samples", 9.0f);
        const float value = findNamed(rig.renderer->description().params, "samples")->value[0];
        CHECK(value == (status.ok() ? 9.0f : 4.0f));
        return status;
    });
}

TEST_CASE("A feature that fails to apply leaves the old value, plan and pictures")
{
    Rig rig;
    failEachAttempt(rig, [&] {
        const Status status = rig.renderer->setFeature("soft", "false");
        CHECK(findNamed(rig.renderer->description().features, "soft")->value ==
              (status.ok() ? 0 : 1));
        return status;
    });
}

TEST_CASE("A size that fails to apply leaves the old size and pictures")
{
    Rig rig;
    failEachAttempt(rig, [&] {
        const Status status = rig.renderer->resize({30, 30});
        CHECK(rig.renderer->plan().extent.width == (status.ok() ? 30 : 64));
        return status;
    });
}

TEST_CASE("A frame that fails to be planned leaves the old plan and pictures")
{
    Rig rig;
    Frame other = rig.frame;
    other.lights.resize(3);
    failEachAttempt(rig, [&] {
        const Status status = rig.renderer->render(other);
        if (status.ok()) rig.frame = other;
        return status;
    });
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
    auto renderer = Renderer::create(device, description, {{8, 8}}, traitsOf({}));
    REQUIRE(renderer.ok());
    Frame frame;
    frame.textures = {
        {"depth", device.adoptTexture({1, "depth", Format::depth24, {8, 8}}).value()}};
    REQUIRE((*renderer)->render(frame).ok());
    const int live = device.live();
    const TextureId ao = (*renderer)->output("ao");

    frame.textures.clear();
    const Status same_traits = (*renderer)->render(frame);
    CHECK(codeOf(same_traits) == Code::missing_import);
    CHECK(same_traits.diagnostics().front().message ==
          "the frame has no texture for import 'depth'");
    CHECK(same_traits.diagnostics().front().pointer == "/imports/depth");
    frame.lights.resize(1);
    CHECK(codeOf((*renderer)->render(frame)) == Code::missing_import);
    CHECK(device.live() == live);
    CHECK((*renderer)->output("ao").value == ao.value);
    CHECK(device.readTexture(ao).ok());
    CHECK(device.misuse().empty());
}

namespace {

// The first error of a renderer on a device where every program has that uniform.
Code createWith(const UniformInfo& uniform)
{
    RecordingDevice device;
    device.forceUniform(uniform);
    const auto none = Renderer::create(device, rigDescription(), {{8, 8}}, {});
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
    return none.ok() ? Code::internal : none.diagnostics().front().code;
}

}  // namespace

TEST_CASE("An active uniform that the text does not declare is CV5003")
{
    CHECK(createWith({"hidden", GlslType::float_, 1, 0}) == Code::uniform_unbound);
    CHECK(createWith({"hidden", GlslType::sampler2d, 1, 0}) == Code::uniform_unbound);
}

TEST_CASE("An active uniform of another type than its value is CV5004")
{
    RecordingDevice device;
    device.forceUniform({"view_from_clip", GlslType::vec4, 1, 0});
    const auto none = Renderer::create(device, rigDescription(), {{8, 8}}, {});
    REQUIRE_FALSE(none.ok());
    const auto wrong_type = [](const Diagnostic& error) {
        return error.code == Code::uniform_type && error.pointer == "/shaders/occlusion";
    };
    CHECK(std::count_if(none.diagnostics().begin(), none.diagnostics().end(), wrong_type) == 1);
}

TEST_CASE("What the driver reports at the end of a frame reaches the caller, and frames go on")
{
    Rig rig;
    const std::string before = rig.draw();
    rig.device.failFrame();
    CHECK(codeOf(rig.renderer->render(rig.frame)) == Code::gl_error);
    CHECK(rig.draw() == before);
    CHECK(rig.device.misuse().empty());
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
    const auto lost = [](const Status& status) {
        return status.diagnostics().size() == 1 && codeOf(status) == Code::context_lost;
    };
    CHECK(lost(rig.renderer->render(rig.frame)));
    CHECK(lost(rig.renderer->renderTimed(rig.frame).diagnostics()));
    CHECK(lost(rig.renderer->resize({30, 30})));
    CHECK(lost(rig.renderer->setFeature("soft", "false")));
    CHECK(lost(rig.renderer->setParam("samples", 5.0f)));
    CHECK(lost(rig.renderer->reload(rigDescription(), {{64, 32}})));
    CHECK(lost(rig.device.readTexture(rig.renderer->output("ao")).diagnostics()));
    const Values kept = valuesOf(rig.renderer->description());
    CHECK(kept.params == valuesOf(description).params);
    CHECK(kept.features == valuesOf(description).features);
    rig.renderer.reset();
    CHECK(rig.device.live() == 1);
    CHECK(rig.device.misuse().empty());

    Rig other;
    other.renderer =
        std::move(*Renderer::create(other.device, description, {{64, 32}}, traitsOf(other.frame)));
    CHECK(other.draw() == before);
}
