// SPDX-License-Identifier: MIT
// A plan that no config stands behind, on the recording device: what running needs is in the plan.
#include "core/run/execution.h"

#include <crevice/recording_device.h>

#include "tests/support/catch.h"

namespace crevice {
namespace {

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
    plan.textures = {{Format::r8, plan.extent, 1, {"ao"}}};
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

TEST_CASE("A plan made by hand runs, and its params change, where there is no config")
{
    RecordingDevice device;
    auto execution = Execution::create(device, handMade());
    REQUIRE(execution.ok());
    const Frame frame;
    REQUIRE((*execution)->setImports(frame).ok());
    REQUIRE((*execution)->run(frame).ok());
    CHECK(device.lastUniform("radius") == std::vector<float>{0.5f});
    CHECK(device.lastUniform("taps") == std::vector<float>{3});
    CHECK(device.lastUniform("offsets").size() == 6);
    CHECK(device.lastUniform("viewport_size") == std::vector<float>{16, 8});
    CHECK((*execution)->output("ao", 0));

    const float wider = 2, more = 5;
    (*execution)->setParam("radius", &wider);
    (*execution)->setParam("taps", &more);
    (*execution)->setParam("of another plan", &more);
    REQUIRE((*execution)->run(frame).ok());
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

}  // namespace crevice
