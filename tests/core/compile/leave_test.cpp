// SPDX-License-Identifier: MIT
// What a plan leaves out: conditions with bypasses, no-ops, attachments nobody reads.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

// ssao -> filter -> light, with a filter that can be switched off.
Sketch filtered(const std::string& filter_keys, const std::string& extra = "")
{
    return {{"ssao: -> ao", "filter: ao -> smooth |" + filter_keys, "light: smooth -> lit"},
            {{"ao", "smooth"}, {"color", "lit"}},
            {},
            extra};
}

const char* const kSoft = R"("features": {"soft": {"type": "bool", "default": false}})";

// A chain whose first pass is known at intensity 0 and whose second is known at blur 0.
Sketch withNoOps(const std::string& intensity, const std::string& blur)
{
    return {{R"(ssao: -> ao | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})",
             R"(filter: ao -> smooth | "no_op": {"blur": {"at": 0, "gives": {"smooth": "ao"}}})",
             "light: smooth -> lit"},
            {{"ao", "smooth"}, {"color", "lit"}},
            {},
            R"("params": {"intensity": {"default": )" + intensity +
                R"(}, "blur": {"type": "int", "default": )" + blur + "}}"};
}

CompileOptions keeping(const std::string& optimization)
{
    CompileOptions options = sized();
    options.disable = {optimization};
    return options;
}

}  // namespace

TEST_CASE("A pass whose condition fails is left out, and its bypass stands in for it")
{
    const Plan plan =
        planOf(describe(filtered(R"("when": {"soft": true}, "bypass": {"smooth": "ao"})", kSoft)));
    CHECK(passNames(plan) == "ssao, light");
    REQUIRE(plan.passes[1].inputs.size() == 1);
    CHECK(plan.targets[plan.passes[1].inputs[0].index].name == "ao");
    CHECK(plan.targets[plan.outputs[0].target].name == "ao");
    const Elided* left = elided(plan, "pass filter");
    REQUIRE(left);
    CHECK(left->optimization == "condition");
    CHECK(left->reason == "it needs soft true, and soft is false");
}

TEST_CASE("A pass that no output needs is left out with a warning, unless that was asked for")
{
    const Description description = describe(Sketch{{"a: -> x", "b: -> y"}, {{"out", "x"}}});
    const Result<Plan> plan = tryCompile(description);
    REQUIRE(plan.ok());
    CHECK(passNames(*plan) == "a");
    REQUIRE(plan.diagnostics().size() == 1);
    CHECK(plan.diagnostics()[0].code == Code::dead_pass);
    CHECK(plan.diagnostics()[0].severity == Severity::warning);
    CHECK(plan.diagnostics()[0].pointer == "/passes/b");

    CompileOptions one = sized();
    one.outputs = {"out"};
    CHECK(compile(description, {}, ampleCaps(), one).diagnostics().empty());
}

TEST_CASE("A condition is meaning: no option switches it off")
{
    const Description description =
        describe(filtered(R"("when": {"soft": true}, "bypass": {"smooth": "ao"})", kSoft));
    CHECK(passNames(planOf(description, {}, keeping("all"))) == "ssao, light");
}

TEST_CASE("Bypasses are followed through one another")
{
    const Plan plan = planOf(describe(
        Sketch{{"a: -> x", R"(b: x -> y | "when": {"soft": true}, "bypass": {"y": "x"})",
                R"(c: y -> z | "when": {"soft": true}, "bypass": {"z": "y"})", "d: z -> w"},
               {{"out", "w"}},
               {},
               kSoft}));
    CHECK(passNames(plan) == "a, d");
    CHECK(plan.targets[plan.passes[1].inputs[0].index].name == "x");
}

TEST_CASE("Reading what an inactive pass would have written is an error that names it and why")
{
    const Diagnostic error = onlyError(describe(filtered(R"("when": {"soft": true})", kSoft)));
    CHECK(error.code == Code::never_written);
    CHECK(error.pointer == "/passes/light");
    CHECK(error.message.find("'filter'") != error.message.npos);
    CHECK(error.message.find("soft is false") != error.message.npos);
    REQUIRE(error.notes.size() == 2);
    CHECK(textAt(error.notes[0].place) == "\"filter\"");
    CHECK(textAt(error.notes[1].place) == "\"soft\"");
}

TEST_CASE("Bypasses that lead round in a circle stand in for nothing")
{
    const Diagnostic error = onlyError(describe(
        Sketch{{R"(b: z -> y | "when": {"soft": true}, "bypass": {"y": "z"})",
                R"(c: y -> z | "when": {"soft": true}, "bypass": {"z": "y"})", "d: z -> w"},
               {{"out", "w"}},
               {},
               kSoft}));
    CHECK(error.code == Code::never_written);
}

TEST_CASE("Two passes may write one target when their conditions exclude each other")
{
    const std::string feature =
        R"("features": {"method": {"type": "enum", "values": ["near", "far", "off"],
                                   "default": "far"}})";
    const Plan plan = planOf(
        describe(Sketch{{R"(near: -> ao | "when": {"method": "near"})",
                         R"(far: -> ao | "when": {"method": ["far", "off"]})", "light: ao -> lit"},
                        {{"out", "lit"}},
                        {},
                        feature}));
    CHECK(passNames(plan) == "far, light");
}

TEST_CASE("Every term of a condition must hold")
{
    const auto names = [](bool specular, int lights) {
        const Sketch sketch{
            {"a: -> x", R"(b: x -> y | "when": {"scene.specular": true, "scene.lights": true},
                           "bypass": {"y": "x"})",
             "c: y -> z"},
            {{"out", "z"}}};
        SceneTraits traits;
        traits.specular = specular;
        traits.lights = lights;
        return passNames(planOf(describe(sketch), traits));
    };
    CHECK(names(true, 3) == "a, b, c");
    CHECK(names(true, 0) == "a, c");
    CHECK(names(false, 3) == "a, c");
}

TEST_CASE("Lights compare as none, at least one, or a number")
{
    const auto runs = [](const std::string& wanted, int lights) {
        const Sketch sketch{{"a: -> x", R"(b: x -> y | "when": {"scene.lights": )" + wanted +
                                            R"(}, "bypass": {"y": "x"})"},
                            {{"out", "y"}}};
        SceneTraits traits;
        traits.lights = lights;
        return planOf(describe(sketch), traits).passes.size() == 2;
    };
    CHECK(runs("false", 0));
    CHECK_FALSE(runs("false", 1));
    CHECK(runs("true", 5));
    CHECK_FALSE(runs("true", 0));
    CHECK(runs("2", 2));
    CHECK_FALSE(runs("2", 3));
    CHECK(runs("[1, 2]", 1));
}

TEST_CASE("Each trait of the scene and the camera can be a condition")
{
    const auto [name, on] = GENERATE(table<std::string, SceneTraits>(
        {{"scene.alpha_tested", {0, true, false, false, false}},
         {"scene.specular", {0, false, true, false, false}},
         {"scene.textured", {0, false, false, true, false}},
         {"camera.orthographic", {0, false, false, false, true}},
         {"camera.turned", {0, false, false, false, false, true}},
         {"camera.reversed_depth", {0, false, false, false, false, false, true}}}));
    const Description description = describe(Sketch{
        {"a: -> x", "b: x -> y | \"when\": {\"" + name + R"(": true}, "bypass": {"y": "x"})"},
        {{"out", "y"}}});
    CHECK(planOf(description, on).passes.size() == 2);
    CHECK(planOf(description).passes.size() == 1);
}

TEST_CASE("A pass at its no-op value gives a constant, and what only it needed goes too")
{
    Sketch sketch = withNoOps("0", "2");
    sketch.passes.insert(sketch.passes.begin(), "geometry: -> depth normal");
    sketch.passes[1].replace(0, 5, "ssao: depth normal ");
    const Plan plan = planOf(describe(sketch));
    CHECK(passNames(plan) == "filter, light");
    REQUIRE(plan.passes[0].inputs.size() == 1);
    CHECK(plan.passes[0].inputs[0].kind == InputKind::constant);
    CHECK(plan.constants.at(plan.passes[0].inputs[0].index).value == 1.0f);
    const Elided* left = elided(plan, "pass ssao");
    REQUIRE(left);
    CHECK(left->optimization == "no_op");
    CHECK(left->reason == "intensity is 0, so ao is 1");
    REQUIRE(elided(plan, "pass geometry"));
    CHECK(elided(plan, "pass geometry")->optimization == "dead_pass");
}

TEST_CASE("A pass at its no-op value gives its input")
{
    const Plan plan = planOf(describe(withNoOps("1", "0")));
    CHECK(passNames(plan) == "ssao, light");
    CHECK(plan.targets[plan.outputs[0].target].name == "ao");
}

TEST_CASE("Identities are followed through one another, down to an output that is a constant")
{
    const Plan plan = planOf(describe(withNoOps("0", "0")));
    CHECK(passNames(plan) == "light");
    REQUIRE(plan.outputs[0].name == "ao");
    REQUIRE(plan.outputs[0].constant >= 0);
    CHECK(plan.outputs[0].target == -1);
    CHECK(plan.constants[plan.outputs[0].constant].value == 1.0f);
    CHECK(plan.constants.size() == 1);
}

TEST_CASE("A no-op holds at its exact value alone")
{
    CHECK(passNames(planOf(describe(withNoOps("1e-6", "1")))) == "ssao, filter, light");
}

TEST_CASE("A pass stays when its no-op value leaves out an output that is needed")
{
    const auto names = [](const std::string& reads) {
        return passNames(planOf(describe(
            Sketch{{R"(ssao: -> ao bent | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})",
                    "light: " + reads + " -> lit"},
                   {{"out", "lit"}},
                   {},
                   R"("params": {"intensity": {"default": 0}})"})));
    };
    CHECK(names("ao") == "light");
    CHECK(names("ao bent") == "ssao, light");
}

TEST_CASE("The next no-op is tried when the first leaves out an output that is needed")
{
    const Plan plan = planOf(
        describe(Sketch{{R"(ssao: -> ao bent | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}},
                                            "radius": {"at": 0, "gives": {"ao": 1, "bent": 0}}})",
                         "light: ao bent -> lit"},
                        {{"out", "lit"}},
                        {},
                        R"("params": {"intensity": {"default": 0}, "radius": {"default": 0}})"}));
    CHECK(passNames(plan) == "light");
    CHECK(plan.constants.size() == 2);
    CHECK(elided(plan, "pass ssao")->reason == "radius is 0, so ao is 1, bent is 0");
}

TEST_CASE("What a no-op gives counts as read, so no param's value can break the graph")
{
    const auto noOp = [](const std::string& gives) {
        return R"( | "no_op": {"amount": {"at": 0, "gives": {)" + gives + "}}}";
    };
    const auto described = [](const std::vector<std::string>& passes, const std::string& amount) {
        return describe(Sketch{passes,
                               {{"out", "x"}},
                               {{"ghost", R"({"format": ["r8"]})"}},
                               R"("params": {"amount": {"default": )" + amount + "}}"});
    };
    const std::string amount = GENERATE("0", "1");
    SECTION("a target that no pass writes")
    {
        const Diagnostic error =
            onlyError(described({"a: -> x" + noOp(R"("x": "ghost")")}, amount));
        CHECK(error.code == Code::never_written);
        CHECK(error.pointer == "/passes/a/no_op/amount/gives/x");
    }
    SECTION("its own output")
    {
        CHECK(onlyError(described({"a: -> x" + noOp(R"("x": "x")")}, amount)).code ==
              Code::reads_own_output);
    }
    SECTION("one another's outputs")
    {
        CHECK(
            onlyError(described({"a: -> x" + noOp(R"("x": "y")"), "b: -> y" + noOp(R"("y": "x")")},
                                amount))
                .code == Code::cycle);
    }
    SECTION("what is made from the output")
    {
        const Description description =
            described({"a: -> x" + noOp(R"("x": "y")"), "b: x -> y"}, amount);
        CHECK(onlyError(description).code == Code::cycle);
    }
}

TEST_CASE("A vector param is at a no-op when each component is")
{
    const auto passes = [](const std::string& tint) {
        return planOf(describe(Sketch{
                          {"a: -> x",
                           R"(b: x -> y | "no_op": {"tint": {"at": 1, "gives": {"y": "x"}}})"},
                          {{"out", "y"}},
                          {},
                          R"("params": {"tint": {"type": "vec3", "default": )" + tint + "}}"}))
            .passes.size();
    };
    CHECK(passes("[1, 1, 1]") == 1);
    CHECK(passes("[1, 1, 0.5]") == 2);
}

TEST_CASE("A pass that keeps constants goes where it reads one, down a chain")
{
    const auto chain = [](const std::string& intensity, const std::string& extra = "") {
        return describe(Sketch{
            {R"(ssao: -> ao | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})",
             R"(x: ao -> blur | "preserves_constant": {"blur": "ao"})",
             R"(y: blur -> smooth )" + extra + R"(| "preserves_constant": {"smooth": "blur"})",
             "light: smooth -> lit"},
            {{"ao", "smooth"}, {"color", "lit"}},
            {},
            R"("params": {"intensity": {"default": )" + intensity + "}}"});
    };
    const Plan plan = planOf(chain("0"));
    CHECK(passNames(plan) == "light");
    REQUIRE(plan.passes[0].inputs.size() == 1);
    CHECK(plan.passes[0].inputs[0].kind == InputKind::constant);
    REQUIRE(plan.constants.size() == 1);
    CHECK(plan.constants[0].value == 1.0f);
    CHECK(plan.outputs[0].constant == 0);
    const Elided* left = elided(plan, "pass y");
    REQUIRE(left);
    CHECK(left->optimization == "no_op");
    CHECK(left->reason == "blur is 1 everywhere, and so is smooth");

    CHECK(passNames(planOf(chain("1"))) == "ssao, x, y, light");
    CHECK(passNames(planOf(chain("0"), {}, keeping("no_op"))) == "ssao, x, y, light");
}

TEST_CASE("A pass that keeps constants stays for what else is needed of it")
{
    const Description description =
        describe(Sketch{{R"(ssao: -> ao | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})",
                         R"(x: ao -> blur edges | "preserves_constant": {"blur": "ao"})",
                         R"(y: blur -> smooth | "preserves_constant": {"smooth": "blur"})",
                         "light: smooth edges -> lit"},
                        {{"color", "lit"}},
                        {},
                        R"("params": {"intensity": {"default": 0}})"});
    const Plan plan = planOf(description);
    CHECK(passNames(plan) == "x, y, light");
    REQUIRE(plan.passes[0].inputs.size() == 1);
    CHECK(plan.passes[0].inputs[0].kind == InputKind::constant);
}

TEST_CASE("A constant is kept of a sampler that the shader has")
{
    const Diagnostic error = onlyError(
        describe(Sketch{{"ssao: -> ao", R"(x: ao -> blur | "preserves_constant": {"blur": "aoo"})"},
                        {{"ao", "blur"}}}));
    CHECK(error.code == Code::input_unused);
    CHECK(error.pointer == "/passes/x/preserves_constant/blur");
    CHECK(error.help.find("'ao'") != error.help.npos);
}

TEST_CASE("The no-op optimization can be switched off")
{
    const Description description = describe(withNoOps("0", "0"));
    CHECK(passNames(planOf(description, {}, keeping("no_op"))) == "ssao, filter, light");
    CHECK(passNames(planOf(description, {}, keeping("all"))) == "ssao, filter, light");
    CHECK(passNames(planOf(description, {}, keeping("aliasing"))) == "light");
}

TEST_CASE("An attachment that nobody reads gets no texture, and is listed as left out")
{
    const Description description =
        describe(Sketch{{"g: -> normal albedo", "s: normal -> ao"}, {{"out", "ao"}}});
    const Plan plan = planOf(description);
    const PlanAttachment* albedo = attachmentOf(plan, "albedo");
    REQUIRE(albedo);
    CHECK(albedo->target == -1);
    CHECK(albedo->store == StoreOp::discard);
    const Elided* left = elided(plan, "attachment albedo");
    REQUIRE(left);
    CHECK(left->optimization == "dead_pass");

    CHECK(plan.programs[plan.passes[0].program].fragment.text.find("out vec4 to_albedo") ==
          std::string::npos);

    const Plan kept = planOf(description, {}, keeping("dead_pass"));
    CHECK(kept.programs[kept.passes[0].program].fragment.text.find("out vec4 to_albedo") !=
          std::string::npos);
    CHECK(attachmentOf(kept, "albedo")->target >= 0);
    CHECK(attachmentOf(kept, "albedo")->store == StoreOp::discard);
    CHECK_FALSE(elided(kept, "attachment albedo"));
}

TEST_CASE("Passes that nobody needs run when the unread optimization is switched off")
{
    const Description description =
        describe(Sketch{{"used: -> a", "unused: a -> b", "end: a -> c"}, {{"out", "c"}}});
    CHECK(passNames(planOf(description, {}, keeping("dead_pass"))) == "used, unused, end");
}

TEST_CASE("A no-op is dropped where the formats do not store the same values")
{
    for (const char* format : {"r16f", "rgb10_a2"}) {
        INFO(format);
        Sketch sketch = withNoOps("1", "0");
        CHECK(passNames(planOf(describe(sketch))) == "ssao, light");
        sketch.targets = {{"ao", R"({"format": [")" + std::string(format) + "\"]}"}};
        CHECK(passNames(planOf(describe(sketch))) == "ssao, filter, light");
    }
}

TEST_CASE("A stand-in must hold the kind of values that it replaces")
{
    SECTION("depth is no colour")
    {
        Sketch sketch = filtered(R"("bypass": {"smooth": "ao"})");
        sketch.targets = {{"smooth", R"({"format": ["depth24"]})"}};
        const Diagnostics errors = tryCompile(describe(sketch)).diagnostics();
        REQUIRE(errors.size() == 2);  // the first: depth is no colour attachment
        CHECK(errors[1].code == Code::bypass_class);
        CHECK(errors[1].pointer == "/passes/filter/bypass/smooth");
        CHECK(textAt(errors[1].place) == "\"ao\"");
    }
    SECTION("floats stand in for bytes where a pass is switched off")
    {
        Sketch sketch = filtered(R"("when": {"soft": true}, "bypass": {"smooth": "ao"})", kSoft);
        sketch.targets = {{"ao", R"({"format": ["r16f"]})"}};
        CHECK(passNames(planOf(describe(sketch))) == "ssao, light");
    }
    SECTION("sizes may differ")
    {
        Sketch sketch = withNoOps("1", "0");
        sketch.targets = {{"ao", R"({"format": ["r8"], "size": {"scale": 0.5}})"}};
        CHECK(passNames(planOf(describe(sketch))) == "ssao, light");
    }
}

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

}  // namespace

TEST_CASE(
    "A pass that is drawn where a mask says is tested against it, and cleared to what is elsewhere")
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

TEST_CASE(
    "A mask is left out with its optimization, where its pass is off, and where it does not fit")
{
    const auto drawnWhole = [](const Plan& plan) {
        return passNames(plan) == "geometry, ao, light" && !plan.passes[1].has_depth &&
               plan.passes[1].color[0].load == LoadOp::discard;
    };
    CHECK(drawnWhole(planOf(describe(masked()), {}, keeping("depth_mask"))));
    CHECK(drawnWhole(planOf(describe(masked(R"(, "when": {"soft": true})")))));
    Sketch smaller = masked();
    smaller.targets["mask"] = R"({"format": ["depth16"], "size": {"scale": 0.5}})";
    CHECK(drawnWhole(planOf(describe(smaller))));
    Sketch finer = masked();
    finer.targets["mask"] = R"({"format": ["depth16"], "samples": 4})";
    CHECK(drawnWhole(planOf(describe(finer))));
}

TEST_CASE("A pass whose mask is a constant is drawn everywhere")
{
    Sketch sketch = masked(R"(, "no_op": {"fill": {"at": 0, "gives": {"mask": 1}}})");
    sketch.extra += R"(, "params": {"fill": {"default": 0}})";
    const Plan plan = planOf(describe(sketch));
    CHECK(passNames(plan) == "geometry, ao, light");
    CHECK_FALSE(plan.passes[1].has_depth);
    CHECK(plan.passes[1].inputs.size() == 1);
}

TEST_CASE("A long chain of passes that each read twice what is before is planned at once")
{
    Sketch sketch;
    sketch.passes = {R"(pass_0: -> t_0 | "type": "draw", "frustum_scale": 1)"};
    for (int i = 1; i < 40; ++i) {
        const std::string now = std::to_string(i), before = "t_" + std::to_string(i - 1);
        sketch.passes.push_back("pass_" + now + ": " + before + " again -> t_" + now +
                                R"( | "scissor": true,
            "clear": {"t_)" + now +
                                R"(": 0}, "inputs": {"again": ")" + before + "\"}");
    }
    sketch.outputs = {{"out", "t_39"}};
    sketch.extra = R"("imports": {"scene": {"type": "draw_list"}})";
    CHECK(planOf(describe(sketch)).passes.back().scissor);
}

TEST_CASE("A mask must be a depth target of another pass")
{
    Sketch color = masked();
    color.passes[2] = R"(ao: normal -> ao | "mask": "normal", "clear": {"ao": 1})";
    color.passes.erase(color.passes.begin() + 1);
    color.targets.erase("mask");
    CHECK(onlyError(describe(color)).code == Code::attachment_kind);
}

TEST_CASE(
    "A bounded pass is drawn within the bounds of draws where all that it reads comes from them")
{
    const auto bounded = [](const Sketch& sketch, const std::string& kept = "none") {
        const CompileOptions options = kept == "none" ? sized() : keeping(kept);
        const Plan plan = planOf(describe(sketch), {}, options);
        const PlanPass* pass = findNamed(plan.passes, "ao");
        CHECK((pass->color[0].load == LoadOp::clear || kept == "all"));
        return pass->scissor;
    };
    const Sketch sketch = masked("", R"(, "scissor": true)");
    CHECK(bounded(sketch));
    CHECK_FALSE(bounded(sketch, "scissor"));
    CHECK_FALSE(bounded(sketch, "all"));
    CHECK_FALSE(bounded(masked()));

    Sketch moved = sketch;  // a vertex shader may put vertices anywhere
    moved.passes[0] = R"(geometry: -> normal | "type": "draw")";
    CHECK_FALSE(bounded(moved));
    Sketch remembering = sketch;  // which has what was drawn elsewhere in the last frame
    remembering.passes[2] =
        R"(ao: normal ao_history -> ao | "mask": "mask", "clear": {"ao": 1}, "scissor": true)";
    remembering.targets["ao"] = R"({"format": ["r8"], "history": true})";
    CHECK_FALSE(bounded(remembering));
    Sketch hosts = sketch;
    hosts.passes[0] = "geometry: host -> normal";
    hosts.extra = R"("imports": {"host": {"type": "texture"}},
                     "features": {"soft": {"type": "bool", "default": false}})";
    CHECK_FALSE(bounded(hosts));
}
