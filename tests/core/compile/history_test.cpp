// SPDX-License-Identifier: MIT
// Targets that keep what they held in the last frame: how they are planned, and how frames use
// them.
#include "core/frame/frame_math.h"
#include "tests/support/plan_rig.h"
#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

const char* const kKept = R"({"format": ["r8"], "history": true})";

float sent(const Rig& rig, const char* name) { return rig.device.lastUniform(name).at(0); }

bool same(const glm::mat4& a, const glm::mat4& b)
{
    for (int i = 0; i < 16; ++i)
        if (std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]) > 1e-5f) return false;
    return true;
}

}  // namespace

TEST_CASE("A history is read before its target is written, by the pass that writes it too")
{
    const Description self = describe(Sketch{
        {"mean: now mean_history -> mean", "first: -> now"}, {{"out", "mean"}}, {{"mean", kKept}}});
    CHECK(outcome(self) == "first, mean");
    const Plan plan = planOf(self);
    const PlanInput& input = plan.passes[1].inputs.at(1);
    CHECK(input.kind == InputKind::history);
    CHECK(plan.targets[input.index].name == "mean");
    checkEach({
        {"before its target is written",
         {{"early: late_history -> a", "late: a -> late"}, {{"out", "late"}}, {{"late", kKept}}},
         "early, late"},
        {"without a pass that writes its target",
         {{"a: x_history -> y"}, {{"out", "y"}}, {{"x", kKept}}},
         "CV2202 /passes/a"},
        {"of a target that keeps none",
         {{"a: x_history -> x"}, {{"out", "x"}}},
         "CV5003 /passes/a/shader"},
    });
}

TEST_CASE("A target with a history has two textures, which nothing else shares")
{
    const Plan plan = planOf(describe(Sketch{
        {"a: kept_history -> x", "b: x -> kept", "c: kept -> y", "d: y -> z", "e: z -> last"},
        {{"out", "last"}},
        {{"kept", kKept}}}));
    for (const PlanTexture& texture : plan.textures) {
        INFO(joined(texture.targets));
        const bool kept = texture.targets[0] == "kept" || texture.targets[0] == "kept_history";
        if (kept) CHECK(texture.targets.size() == 1);
    }
    const PlanTarget& kept = *findNamed(plan.targets, "kept");
    CHECK(kept.texture != kept.history_texture);
    CHECK(plan.textures[kept.history_texture].targets.front() == "kept_history");
    CHECK(attachmentOf(plan, "kept")->store == StoreOp::store);
    CHECK(toText(plan).find("kept_history from history kept") != std::string::npos);
    CHECK(toJson(plan).find("\"kind\": \"history\"") != std::string::npos);
}

TEST_CASE("A frame knows whether there was one before")
{
    Rig rig(true);
    rig.draw();
    CHECK(sent(rig, "history_valid") == 0.0f);
    rig.draw();
    CHECK(sent(rig, "history_valid") == 1.0f);
    CHECK(sent(rig, "frame_index") == 1.0f);
    rig.frame.camera_cut = true;
    rig.draw();
    CHECK(sent(rig, "history_valid") == 0.0f);
    rig.frame.camera_cut = false;
    rig.draw();
    CHECK(sent(rig, "history_valid") == 1.0f);
    REQUIRE(rig.renderer->resize({32, 32}).ok());
    rig.draw();
    CHECK(sent(rig, "history_valid") == 0.0f);
}

TEST_CASE("A frame knows where the camera was in the one before")
{
    Rig rig(true);
    rig.frame.camera.clip_from_view = glm::perspective(1.0f, 2.0f, 0.1f, 100.0f);
    rig.draw();
    CHECK(same(sentMatrix(rig, "previous_view_from_view"), glm::mat4(1.0f)));

    const Camera before = rig.frame.camera;
    rig.frame.camera.view_from_world =
        glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0));
    rig.frame.camera.clip_from_view = glm::perspective(0.5f, 2.0f, 0.1f, 100.0f);
    const glm::mat4 moved = before.view_from_world * glm::inverse(rig.frame.camera.view_from_world);
    rig.draw();
    CHECK(same(sentMatrix(rig, "previous_view_from_view"), moved));
    CHECK(same(sentMatrix(rig, "previous_clip_from_view"), before.clip_from_view * moved));

    rig.frame.camera_cut = true;
    rig.frame.camera.view_from_world = glm::mat4(1.0f);
    rig.draw();
    CHECK(same(sentMatrix(rig, "previous_view_from_view"), glm::mat4(1.0f)));
}

TEST_CASE("A camera that moves with the world's origin has not moved")
{
    Rig rig(true);
    rig.frame.camera.view_from_world =
        glm::lookAt(glm::dvec3(3e6, 2, 5), glm::dvec3(3e6, 1, 0), glm::dvec3(0, 1, 0));
    rig.draw();
    rig.frame.origin_shift = {3e6, -7, 0.5};
    rig.frame.camera.view_from_world =
        glm::translate(rig.frame.camera.view_from_world, rig.frame.origin_shift);
    rig.draw();
    CHECK(same(sentMatrix(rig, "previous_view_from_view"), glm::mat4(1.0f)));
    CHECK(sent(rig, "history_valid") == 1);

    rig.frame.origin_shift = {NAN, 0, 0};
    rig.draw();
    CHECK(sent(rig, "history_valid") == 0);
    CHECK(same(sentMatrix(rig, "previous_view_from_view"), glm::mat4(1.0f)));
}
