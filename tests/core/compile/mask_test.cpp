// SPDX-License-Identifier: MIT
// Passes that are drawn where a mask says, or within the bounds of draws.
// Targets that keep what they held in the last frame: how they are planned, and how frames use
// them.
#include "tests/support/plan_rig.h"

#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

// draw -> mask -> ao, where ao is drawn where the mask says.
Sketch masked(const std::string& mask_keys = "", const std::string& ao_keys = "")
{
    return {
        {R"(geometry: -> normal | "type": "draw", "frustum_scale": 1)",
         R"(mask: normal -> | "depth": "mask", "state": {"depth_write": true})" + mask_keys,
         R"(ao: normal -> ao | "mask": "mask", "clear": {"ao": 1})" + ao_keys, "light: ao -> lit"},
        {{"color", "lit"}},
        {{"mask", R"({"format": ["depth16"], "semantic": "mask", "size": {"of": "ao"}})"}},
        R"("imports": {"scene": {"type": "draw_list"}},
               "features": {"soft": {"type": "bool", "default": false}})"};
}

Sketch with(Sketch sketch, const std::string& target, const std::string& json)
{
    sketch.targets[target] = json;
    return sketch;
}

const char* const kKept = R"({"format": ["r8"], "history": true})";

float sent(const Rig& rig, const char* name) { return rig.device.lastUniform(name).at(0); }

bool same(const glm::mat4& a, const glm::mat4& b)
{
    for (int i = 0; i < 16; ++i)
        if (std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]) > 1e-5f) return false;
    return true;
}

}  // namespace

TEST_CASE("A masked pass is tested against its mask, and cleared to what is elsewhere")
{
    const Plan plan = planOf(describe(masked()));
    CHECK(passNames(plan) == "geometry, mask, ao, light");
    const PlanPass& ao = plan.passes[2];
    REQUIRE(ao.has_depth);
    CHECK(ao.depth.name == "mask");
    CHECK(ao.depth.load == LoadOp::load);
    CHECK(ao.depth.store == StoreOp::store);
    CHECK_FALSE(ao.state.depth_write);
    CHECK(ao.color[0].load == LoadOp::clear);
    CHECK(ao.color[0].clear[0] == 1.0f);
    const PlanTarget& mask = plan.targets[ao.depth.target];
    CHECK(mask.first_pass == 1);
    CHECK(mask.last_pass == 2);
}

TEST_CASE("A pass is drawn whole where its mask is left out, off, constant or does not fit")
{
    const auto drawnWhole = [](const Plan& plan) {
        return passNames(plan) == "geometry, ao, light" && !plan.passes[1].has_depth &&
               plan.passes[1].color[0].load == LoadOp::discard && plan.passes[1].inputs.size() == 1;
    };
    CHECK(drawnWhole(planOf(describe(masked()), {}, keeping("depth_mask"))));
    const Sketch off = masked(R"(, "when": {"soft": true})");
    const Sketch smaller =
        with(masked(), "mask", R"({"format": ["depth16"], "size": {"scale": 0.5}})");
    const Sketch finer = with(masked(), "mask", R"({"format": ["depth16"], "samples": 4})");
    for (const Sketch& sketch : {off, smaller, finer}) CHECK(drawnWhole(planOf(describe(sketch))));

    Sketch constant = masked(R"(, "no_op": {"fill": {"at": 0, "gives": {"mask": 1}}})");
    constant.extra += R"(, "params": {"fill": {"default": 0}})";
    const Plan plan = planOf(describe(constant));
    CHECK(passNames(plan) == "geometry, ao, light");
    CHECK_FALSE(plan.passes[1].has_depth);
    CHECK(plan.passes[1].inputs.size() == 1);
}

TEST_CASE("A pass that draws over another one keeps what it does not draw, and readers get both")
{
    Sketch sketch = masked();
    sketch.passes[2] = R"(rest: normal -> ao | "over": "ao", "mask": "mask")";
    sketch.passes.push_back(R"(ao: normal -> ao | "when": {"soft": true},
                              "bypass": {"ao": "normal"})");
    sketch.targets["ao"] = sketch.targets["normal"] = R"({"format": ["rgba8"]})";
    CHECK(passNames(planOf(describe(sketch))) == "geometry, light");
    sketch.extra.replace(sketch.extra.find("false"), 5, "true");
    for (const CompileOptions& options : {sized(), keeping("depth_mask"), keeping("all")}) {
        const Plan plan = planOf(describe(sketch), {}, options);
        CHECK(passNames(plan) == "geometry, mask, ao, rest, light");
        CHECK(plan.passes[3].over == 2);
        CHECK(isMasked(plan.passes[3]));
        CHECK(plan.passes[3].color[0].load == LoadOp::load);
        CHECK(plan.passes[3].color[0].target == plan.passes[2].color[0].target);
        CHECK(plan.passes[2].color[0].store == StoreOp::store);
    }
}

TEST_CASE("A constant stands in for a pass and for what draws over it, or for neither")
{
    const auto names = [](const char* rest) {
        return passNames(planOf(
            describe({{"a: -> x", R"(b: x -> y | "no_op": {"fill": {"at": 0, "gives": {"y": 1}}})",
                       std::string("c: x -> y | \"over\": \"b\"") + rest, "d: y -> z"},
                      {{"out", "z"}},
                      {},
                      R"("params": {"fill": {"default": 0}})"})));
    };
    CHECK(names("") == "a, b, c, d");
    CHECK(names(R"(, "no_op": {"fill": {"at": 0, "gives": {"y": 1}}})") == "d");
}

TEST_CASE("A bounded pass is drawn within the bounds of draws where all it reads comes from them")
{
    const auto bounded = [](const Sketch& sketch, const CompileOptions& options = sized()) {
        const Plan plan = planOf(describe(sketch), {}, options);
        const PlanPass* pass = findNamed(plan.passes, "ao");
        CHECK((pass->color[0].load == LoadOp::clear || contains(options.disable, "all")));
        return pass->scissor;
    };
    const Sketch sketch = masked("", R"(, "scissor": true)");
    CHECK(bounded(sketch));
    CHECK_FALSE(bounded(sketch, keeping("scissor")));
    CHECK_FALSE(bounded(sketch, keeping("all")));
    CHECK_FALSE(bounded(masked()));

    Sketch moved = sketch;  // a vertex shader may put vertices anywhere
    moved.passes[0] = R"(geometry: -> normal | "type": "draw")";
    CHECK_FALSE(bounded(moved));
    Sketch remembering = with(sketch, "ao", R"({"format": ["r8"], "history": true})");
    remembering.passes[2] =  // which has what was drawn elsewhere in the last frame
        R"(ao: normal ao_history -> ao | "mask": "mask", "clear": {"ao": 1}, "scissor": true)";
    CHECK_FALSE(bounded(remembering));
    Sketch hosts = sketch;
    hosts.passes[0] = "geometry: host -> normal";
    hosts.extra = R"("imports": {"host": {"type": "texture"}},
                     "features": {"soft": {"type": "bool", "default": false}})";
    CHECK_FALSE(bounded(hosts));
}

TEST_CASE("A long chain of passes that each read twice what is before is planned at once")
{
    Sketch sketch;
    sketch.passes = {R"(pass_0: -> t_0 | "type": "draw", "frustum_scale": 1)"};
    for (int i = 1; i < 40; ++i) {
        const std::string now = std::to_string(i), before = "t_" + std::to_string(i - 1);
        sketch.passes.push_back("pass_" + now + ": " + before + " again -> t_" + now +
                                R"( | "scissor": true, "clear": {"t_)" + now +
                                R"(": 0}, "inputs": {"again": ")" + before + "\"}");
    }
    sketch.outputs = {{"out", "t_39"}};
    sketch.extra = R"("imports": {"scene": {"type": "draw_list"}})";
    CHECK(planOf(describe(sketch)).passes.back().scissor);
}

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
