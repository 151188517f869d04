// SPDX-License-Identifier: MIT
// What a plan leaves out: conditions with bypasses, no-ops, attachments nobody reads.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

const char* const kSoft = R"("features": {"soft": {"type": "bool", "default": false}})";

// ssao -> filter -> light, with a filter that can be switched off.
Sketch filtered(const std::string& filter_keys, const std::string& extra = kSoft)
{
    return {{"ssao: -> ao", "filter: ao -> smooth |" + filter_keys, "light: smooth -> lit"},
            {{"ao", "smooth"}, {"color", "lit"}},
            {},
            extra};
}

const char* const kBypassed = R"("when": {"soft": true}, "bypass": {"smooth": "ao"})";

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

std::string outcome(const Sketch& sketch, const SceneTraits& traits = {},
                    const CompileOptions& options = sized())
{
    return crevice::outcome(describe(sketch), traits, options);
}

/// Whether a pass with this condition runs.
bool runs(const std::string& condition, const SceneTraits& traits)
{
    const Sketch sketch{
        {"a: -> x", "b: x -> y | \"when\": {" + condition + R"(}, "bypass": {"y": "x"})"},
        {{"out", "y"}}};
    return outcome(sketch, traits) == "a, b";
}

/// The name of the target that a pass reads first.
std::string firstRead(const Plan& plan, std::size_t pass)
{
    return plan.targets.at(plan.passes.at(pass).inputs.at(0).index).name;
}

}  // namespace

TEST_CASE("A pass whose condition fails is left out, and its bypass stands in for it")
{
    const Description description = describe(filtered(kBypassed));
    const Plan plan = planOf(description);
    CHECK(passNames(plan) == "ssao, light");
    CHECK(plan.passes[1].inputs.size() == 1);
    CHECK(firstRead(plan, 1) == "ao");
    CHECK(plan.targets[plan.outputs[0].target].name == "ao");
    CHECK(leftOut(plan, "pass filter") == "condition: it needs soft true, and soft is false");
    // A condition is meaning: no option switches it off.
    CHECK(passNames(planOf(description, {}, keeping("all"))) == "ssao, light");

    const Plan through = planOf(describe(
        Sketch{{"a: -> x", R"(b: x -> y | "when": {"soft": true}, "bypass": {"y": "x"})",
                R"(c: y -> z | "when": {"soft": true}, "bypass": {"z": "y"})", "d: z -> w"},
               {{"out", "w"}},
               {},
               kSoft}));
    CHECK(passNames(through) == "a, d");
    CHECK(firstRead(through, 1) == "x");
}

TEST_CASE("A pass that no output needs is left out with a warning, unless that was asked for")
{
    const Description description = describe(Sketch{{"a: -> x", "b: -> y"}, {{"out", "x"}}});
    const Result<Plan> plan = tryCompile(description);
    CHECK(onlyWarning(plan, Code::dead_pass).pointer == "/passes/b");
    CHECK(passNames(*plan) == "a");
    CHECK_THAT(leftOut(*plan, "pass b"), Catch::StartsWith("dead_pass: "));
    CHECK(passNames(planOf(description, {}, keeping("dead_pass"))) == "a, b");

    CompileOptions one = sized();
    one.outputs = {"out"};
    CHECK(compile(description, {}, ampleCaps(), one).diagnostics().empty());
}

TEST_CASE("An output on request is drawn, with what it alone needs, where it is asked for by name")
{
    const auto exporting = [](const char* late) {
        return describe(
            Sketch{{"a: -> x", "b: x -> y", "c: y -> z"}, {{"out", "x"}, {"late", late}}});
    };
    const Description description = exporting(R"({"target": "z", "on_request": true})");
    const Result<Plan> plan = tryCompile(description);
    REQUIRE(plan.ok());
    CHECK(passNames(*plan) == "a");
    CHECK(plan.diagnostics().empty());  // no pass is forgotten
    CompileOptions options = sized();
    options.outputs = {"late"};
    CHECK(passNames(planOf(description, {}, options)) == "a, b, c");
    CHECK(passNames(planOf(exporting(R"({"target": "z"})"))) == "a, b, c");
    Description all = description;
    for (OutputDesc& output : all.outputs) output.on_request = true;
    onlyError(tryCompile(all), Code::no_outputs);
}

TEST_CASE("A condition holds where each of its terms does")
{
    const auto lit = [](int lights, bool specular = false) {
        SceneTraits traits;
        traits.lights = lights;
        traits.specular = specular;
        return traits;
    };
    const std::string both = R"("scene.specular": true, "scene.lights": true)";
    CHECK(runs(both, lit(3, true)));
    CHECK_FALSE(runs(both, lit(0, true)));
    CHECK_FALSE(runs(both, lit(3, false)));
    // Lights compare as none, at least one, or a number.
    const auto lights = [&](const std::string& wanted, int count) {
        return runs("\"scene.lights\": " + wanted, lit(count));
    };
    CHECK((lights("false", 0) && !lights("false", 1)));
    CHECK((lights("true", 5) && !lights("true", 0)));
    CHECK((lights("2", 2) && !lights("2", 3)));
    CHECK(lights("[1, 2]", 1));
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
    CHECK(runs("\"" + name + "\": true", on));
    CHECK_FALSE(runs("\"" + name + "\": true", {}));
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
    CHECK(plan.constants.at(plan.passes[0].inputs[0].index) == 1.0f);
    CHECK(leftOut(plan, "pass ssao") == "no_op: intensity is 0, so ao is 1");
    CHECK_THAT(leftOut(plan, "pass geometry"), Catch::StartsWith("dead_pass: "));
}

TEST_CASE("A no-op holds at its exact value, gives what its target can store, and can be kept")
{
    const Plan input = planOf(describe(withNoOps("1", "0")));
    CHECK(passNames(input) == "ssao, light");
    CHECK(input.targets[input.outputs[0].target].name == "ao");

    const Description both = describe(withNoOps("0", "0"));
    const Plan plan = planOf(both);
    CHECK(passNames(plan) == "light");
    REQUIRE(plan.outputs[0].name == "ao");
    REQUIRE(plan.outputs[0].constant >= 0);
    CHECK(plan.outputs[0].target == -1);
    CHECK(plan.constants[plan.outputs[0].constant] == 1.0f);
    CHECK(plan.constants.size() == 1);
    CHECK(passNames(planOf(both, {}, keeping("no_op"))) == "ssao, filter, light");
    CHECK(passNames(planOf(both, {}, keeping("all"))) == "ssao, filter, light");
    CHECK(passNames(planOf(both, {}, keeping("aliasing"))) == "light");

    CHECK(outcome(withNoOps("1e-6", "1")) == "ssao, filter, light");
    for (const char* format : {"r16f", "rgb10_a2"}) {
        INFO(format);
        Sketch sketch = withNoOps("1", "0");
        sketch.targets = {{"ao", R"({"format": [")" + std::string(format) + "\"]}"}};
        CHECK(outcome(sketch) == "ssao, filter, light");
    }
}

TEST_CASE("A pass stays when its no-op values leave out an output that is needed")
{
    const auto names = [](const std::string& reads, const std::string& more = "") {
        return outcome(
            Sketch{{R"(ssao: -> ao bent | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}})" +
                        more + "}",
                    "light: " + reads + " -> lit"},
                   {{"out", "lit"}},
                   {},
                   R"("params": {"intensity": {"default": 0}, "radius": {"default": 0}})"});
    };
    CHECK(names("ao") == "light");
    CHECK(names("ao bent") == "ssao, light");
    // The next one is tried.
    CHECK(names("ao bent", R"(, "radius": {"at": 0, "gives": {"ao": 1, "bent": 0}})") == "light");
}

TEST_CASE("What a no-op gives counts as read, so no param's value can break the graph")
{
    const auto noOp = [](const std::string& gives) {
        return R"( | "no_op": {"amount": {"at": 0, "gives": {)" + gives + "}}}";
    };
    const std::string amount = GENERATE("0", "1");
    const auto made = [&](const std::vector<std::string>& passes) {
        return outcome(Sketch{passes,
                              {{"out", "x"}},
                              {{"ghost", R"({"format": ["r8"]})"}},
                              R"("params": {"amount": {"default": )" + amount + "}}"});
    };
    CHECK(made({"a: -> x" + noOp(R"("x": "ghost")")}) == "CV2202 /passes/a/no_op/amount/gives/x");
    CHECK_THAT(made({"a: -> x" + noOp(R"("x": "x")")}), Catch::StartsWith("CV2203 "));
    CHECK_THAT(made({"a: -> x" + noOp(R"("x": "y")"), "b: -> y" + noOp(R"("y": "x")")}),
               Catch::StartsWith("CV2204 "));
    CHECK_THAT(made({"a: -> x" + noOp(R"("x": "y")"), "b: x -> y"}), Catch::StartsWith("CV2204 "));
}

TEST_CASE("A pass that keeps constants goes where it reads one, down a chain")
{
    const auto chain = [](const std::string& intensity) {
        return describe(
            Sketch{{R"(ssao: -> ao | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})",
                    R"(x: ao -> blur | "preserves_constant": {"blur": "ao"})",
                    R"(y: blur -> smooth | "preserves_constant": {"smooth": "blur"})",
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
    CHECK(plan.constants[0] == 1.0f);
    CHECK(plan.outputs[0].constant == 0);
    CHECK(leftOut(plan, "pass y") == "no_op: blur is 1 everywhere, and so is smooth");

    CHECK(passNames(planOf(chain("1"))) == "ssao, x, y, light");
    CHECK(passNames(planOf(chain("0"), {}, keeping("no_op"))) == "ssao, x, y, light");
}

TEST_CASE("An attachment that nobody reads gets no texture, and is listed as left out")
{
    const Description description =
        describe(Sketch{{"g: -> normal albedo", "s: normal -> ao"}, {{"out", "ao"}}});
    const auto declared = [](const Plan& plan) {
        return plan.programs[plan.passes[0].program].fragment.text.find("out vec4 to_albedo") !=
               std::string::npos;
    };
    const Plan plan = planOf(description);
    const PlanAttachment* albedo = attachmentOf(plan, "albedo");
    REQUIRE(albedo);
    CHECK(albedo->target == -1);
    CHECK(albedo->store == StoreOp::discard);
    CHECK_THAT(leftOut(plan, "attachment albedo"), Catch::StartsWith("dead_pass: "));
    CHECK_FALSE(declared(plan));

    const Plan kept = planOf(description, {}, keeping("dead_pass"));
    CHECK(declared(kept));
    CHECK(attachmentOf(kept, "albedo")->target >= 0);
    CHECK(attachmentOf(kept, "albedo")->store == StoreOp::discard);
    CHECK(leftOut(kept, "attachment albedo") == "");
}
