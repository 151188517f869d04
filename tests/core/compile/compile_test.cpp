// SPDX-License-Identifier: MIT
// Compiling: the order of passes, writers and readers, cycles, and what is asked for.
// Defines that shaders see, and programs that passes share.
// Shaders in a plan: what samplers, uniforms and outputs bind to, and what does not fit.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

const char* const kByte = R"({"format": ["r8"]})";
const char* const kDepth = R"({"format": ["depth24"]})";

// The fragment text of a pass whose shader mentions `names`.
std::string textWith(const std::string& names, const std::string& extra = "",
                     const SceneTraits& traits = {}, const std::string& defines = "{}")
{
    std::string mentions;
    for (const std::string& name : words(names)) mentions += "#ifdef " + name + "\n#endif\n";
    const Plan plan = planOf(
        describe(R"({"format": 1, "targets": {"x": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "v", "fragment": "f", "defines": )" +
                     defines + R"(}},
        "passes": {"p": {"shader": "s", "color": "x"}}, "outputs": {"x": "x"})" +
                     (extra.empty() ? "" : ", " + extra) + "}",
                 {{"v", kFullVertex},
                  {"f", "#version 300 es\n" + mentions + "out highp vec4 c;\nvoid main() {}\n"}}),
        traits);
    return plan.programs.at(0).fragment.text;
}

bool defines(const std::string& text, const std::string& what)
{
    return text.find("#define " + what + "\n") != text.npos;
}

const std::string kHead = "#version 300 es\nprecision highp float;\n";
const std::string kOut = "layout(location = 0) out vec4 color;\n";

// One pass "p" with this GLSL, over all that a name can stand for.
Description onePass(const std::string& fragment, const std::string& keys = "",
                    const std::string& extra = "", const std::string& vertex = kFullVertex)
{
    return describe(
        R"({"format": 1, "name": "one",
        "params": {"radius": {"default": 0.5}, "taps": {"type": "int", "default": 3},
                   "tint": {"type": "vec3", "default": [1, 1, 1]},
                   "samples": {"type": "int", "default": 4, "min": 1, "bind": "define"}},
        "imports": {"eye": {"type": "camera"}, "draws": {"type": "draw_list"},
                    "lights": {"type": "lights", "optional": true}, "decal": {"type": "texture"}},
        "generated": {"kernel": {"generator": "sphere_kernel", "count": "samples"},
                      "noise": {"generator": "rotation_noise", "count": 8}},
        "targets": {"color": {"format": ["rgba8"]}, "ghost": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "p.vert", "fragment": "p.frag"}},
        "passes": {"p": {"shader": "s", "color": "color")" +
            (keys.empty() ? "" : ", " + keys) + "}}, \"outputs\": {\"out\": \"color\"}" +
            (extra.empty() ? "" : ", " + extra) + "}",
        {{"p.vert", vertex}, {"p.frag", fragment}, {"part.glsl", "uniform float deep;\n"}});
}

Description body(const std::string& declarations, const std::string& keys = "")
{
    return onePass(kHead + declarations + kOut + "void main() {}\n", keys);
}

}  // namespace

TEST_CASE("Passes run in the order of the data, and where that decides nothing of the document")
{
    checkEach({
        {"the order of the data",
         {{"last: b -> c", "middle: a -> b", "first: -> a"}, {{"o", "c"}}},
         "first, middle, last"},
        {"two that are ready",
         {{"right: -> r", "left: -> l", "join: l r -> x"}, {{"o", "x"}}},
         "right, left, join"},
        {"one that no output needs",
         {{"used: -> a", "no: a -> b", "end: a -> c"}, {{"o", "c"}}},
         "used, end"},
    });
}

TEST_CASE("A graph that cannot be ordered is one error for each of its mistakes")
{
    checkEach({
        {"a cycle behind a pass that is in none",
         {{"start: -> s", "a: s z -> x", "b: x -> y", "c: y -> z"}, {{"o", "z"}}},
         "CV2204 /passes/a"},
        {"two cycles",
         {{"a: y -> x", "b: x -> y", "c: q -> p", "d: p -> q"}, {{"o", "x"}}},
         "CV2204 /passes/a; CV2204 /passes/c"},
        {"reading its own depth through another name",
         {{R"(a: from -> x | "type": "draw", "depth": "d", "inputs": {"from": "d"})"},
          {{"o", "x"}},
          {{"d", kDepth}}},
         "CV2203 /passes/a/inputs/from"},
        {"never written, however many read it",
         {{"a: ghost -> x", "b: ghost x -> y"}, {{"o", "y"}}, {{"ghost", kByte}}},
         "CV2202 /passes/a"},
        {"an output that is never written",
         {{"a: -> x"}, {{"o", "ghost"}}, {{"ghost", kByte}}},
         "CV2202 /outputs/o"},
        {"a mistake where no output needs it",
         {{"a: -> x", "b: typo -> y"}, {{"o", "x"}}},
         "CV5003 /passes/b/shader"},
    });
}

TEST_CASE("Only the outputs asked for keep passes alive")
{
    const Description description =
        describe(Sketch{{"ssao: -> ao", "light: ao -> lit"}, {{"ao", "ao"}, {"color", "lit"}}});
    CompileOptions options = sized();
    options.outputs = {"ao"};
    const Plan plan = planOf(description, {}, options);
    CHECK(passNames(plan) == "ssao");
    REQUIRE(plan.outputs.size() == 1);
    CHECK(plan.outputs[0].name == "ao");
    CHECK(outcome(description) == "ssao, light");
}

TEST_CASE("A param bound as a define reaches GLSL as a literal of its type")
{
    const auto value = [](const std::string& json) {
        const std::string text = textWith("SIZE", "\"params\": {\"size\": " + json + "}");
        const auto start = text.find("#define SIZE ") + 13;
        return text.substr(start, text.find('\n', start) - start);
    };
    CHECK(value(R"({"type": "int", "default": 64, "bind": "define"})") == "64");
    CHECK(value(R"({"type": "int", "default": -3, "bind": "define"})") == "-3");
    CHECK(value(R"({"type": "int", "default": 1000000, "bind": "define"})") == "1000000");
    CHECK(value(R"({"default": 0.5, "bind": "define"})") == "0.5");
    CHECK(value(R"({"default": 2, "bind": "define"})") == "2.0");
    CHECK(value(R"({"default": 1e-9, "bind": "define"})") == "1e-09");
    CHECK(value(R"({"default": 100000000, "bind": "define"})") == "1e+08");
}

TEST_CASE("Shaders that ask get the resolution of a texture")
{
    const auto step = [](const std::string& format) {
        return textWith("DEPTH_STEP", R"("imports": {"depth": {"type": "texture")" + format + "}}");
    };
    CHECK(defines(textWith("X_STEP"), "X_STEP vec2(3.922e-03, 0.000e+00)"));  // r8: 1 in 255
    CHECK(defines(step(R"(, "format": "depth16")"), "DEPTH_STEP vec2(1.526e-05, 0.000e+00)"));
    CHECK(defines(step(R"(, "format": "r16f")"), "DEPTH_STEP vec2(5.960e-08, 9.766e-04)"));
    CHECK(defines(step(""), "DEPTH_STEP vec2(5.960e-08, 0.000e+00)"));  // as depth24
}

TEST_CASE("A shader's own defines win")
{
    CHECK(defines(
        textWith("SOFT", R"("features": {"soft": {"type": "bool"}})", {}, R"({"SOFT": "7"})"),
        "SOFT 7"));
}

TEST_CASE("Passes whose text is the same share a program, others do not")
{
    const auto programs = [](const std::string& first, const std::string& second) {
        return planOf(describe(R"({"format": 1, "features": {"soft": {"type": "bool"}},
            "targets": {"x": {"format": ["r8"]}, "y": {"format": ["r8"]}},
            "shaders": {"s": {"vertex": "v", "fragment": "f", "defines": )" +
                                   first + R"(},
                        "t": {"vertex": "v", "fragment": "f", "defines": )" +
                                   second + R"(}},
            "passes": {"a": {"shader": "s", "color": "x"}, "b": {"shader": "t", "color": "y"}},
            "outputs": {"x": "x", "y": "y"}})",
                               {{"v", kFullVertex},
                                {"f",
                                 "#version 300 es\n#if AXIS\n#endif\nout highp vec4 c;\nvoid "
                                 "main() {}\n"}}))
            .programs;
    };
    CHECK(programs(R"({"AXIS": 0})", R"({"AXIS": 1})").size() == 2);
    CHECK(programs(R"({"AXIS": 1, "UNUSED": 2})", R"({"AXIS": 1})").size() == 1);
    const auto same = programs(R"({"AXIS": 0})", R"({"AXIS": 0})");
    REQUIRE(same.size() == 1);
    CHECK(same[0].label == "s");
    CHECK(same[0].pointer == "/shaders/s");
    CHECK(same[0].key.size() == 16);
    CHECK(same[0].key.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(same[0].key != programs(R"({"AXIS": 1})", R"({"AXIS": 1})")[0].key);
}

TEST_CASE("A sampler binds to the generated texture or import of its name")
{
    const Plan plan = planOf(body("uniform sampler2D noise;\nuniform sampler2D decal;\n"));
    const auto& inputs = plan.passes[0].inputs;
    REQUIRE(inputs.size() == 2);
    CHECK(inputs[0].kind == InputKind::generated);
    CHECK(plan.generated.at(inputs[0].index).name == "noise");
    CHECK(inputs[0].sampling.wrap == Wrap::repeat);
    CHECK(inputs[1].kind == InputKind::imported);
    CHECK(plan.imports.at(inputs[1].index).name == "decal");
    CHECK(inputs[1].sampling.wrap == Wrap::clamp);
    CHECK(inputs[1].sampling.filter == Filter::nearest);
}

TEST_CASE("Uniforms of every source bind by name, and what they need is collected")
{
    const Plan plan =
        planOf(body("uniform float radius;\nuniform int taps;\nuniform vec3 tint;\n"
                    "uniform vec3 kernel[SAMPLES];\nuniform mat4 clip_from_view;\n"
                    "uniform vec4 light_position[MAX_LIGHTS];\n"
                    "uniform vec2 viewport_size;\n"));
    CHECK(joined(namesOf(plan.imports)) == "eye, lights");
    CHECK(joined(namesOf(plan.generated)) == "kernel");
    CHECK(plan.generated[0].count == 4);
    CHECK(joined(namesOf(plan.params)) == "radius, taps, tint");
    const std::vector<PlanUniform>& uniforms = plan.passes[0].uniforms;
    REQUIRE(uniforms.size() == 7);
    CHECK(plan.params[uniforms[2].index].name == "tint");
    CHECK(plan.params[uniforms[2].index].type == GlslType::vec3);
    CHECK(uniforms[3].source == UniformSource::kernel);
    CHECK(uniforms[3].count == 4);
    CHECK(uniforms[5].source == UniformSource::frame);
    CHECK(uniforms[5].count == kMaxLights);
}

TEST_CASE("A uniform of another type or length than its value is refused")
{
    const auto [declared, name] =
        GENERATE(table<std::string, std::string>({{"float taps", "taps"},
                                                  {"vec4 tint", "tint"},
                                                  {"float radius[2]", "radius"},
                                                  {"vec3 kernel[3]", "kernel"},
                                                  {"vec3 kernel", "kernel"},
                                                  {"vec4 kernel[SAMPLES]", "kernel"},
                                                  {"mat3 clip_from_view", "clip_from_view"},
                                                  {"vec4 light_position[3]", "light_position"},
                                                  {"float ghost", "ghost"}}));
    CAPTURE(declared);
    const Diagnostic error =
        onlyError(tryCompile(body("uniform " + declared + ";\n")), Code::uniform_type);
    CHECK(textAt(error.place) == name);
    CHECK(error.pointer == "/passes/p/shader");
    CHECK(error.help.find("uniform ") != error.help.npos);
}

TEST_CASE("Renaming what an #if hides is fine")
{
    const Plan hidden = planOf(body("#if SAMPLES > 90\nuniform sampler2D grain;\n#endif\n",
                                    R"("inputs": {"grain": "noise"})"));
    CHECK(hidden.passes[0].inputs.empty());
    CHECK(outcome(body("#if SAMPLES > 90\n#include \"part.glsl\"\n#endif\n",
                       R"("inputs": {"deep": "noise"})")) == "p");
}

TEST_CASE("Outputs of the shader are the pass's colour targets")
{
    const auto compiled = [](const std::string& outputs, const std::string& color,
                             const std::string& exported = "a") {
        return describe(R"({"format": 1,
            "targets": {"a": {"format": ["r8"]}, "b": {"format": ["r8"]}},
            "shaders": {"s": {"vertex": "v", "fragment": "f"}},
            "passes": {"p": {"shader": "s", "color": )" +
                            color + R"(}}, "outputs": {"o": ")" + exported + "\"}}",
                        {{"v", kFullVertex}, {"f", kHead + outputs + "void main() {}\n"}});
    };
    const std::string a = "layout(location = 0) out vec4 a;\n";
    const std::string both = a + "layout(location = 1) out vec4 b;\n";
    CHECK(outcome(compiled(both, R"(["a", "b"])")) == "p");
    const std::string other_names =
        "layout(location = 0) out vec4 first;\nlayout(location = 1) out vec4 second;\n";
    CHECK(outcome(compiled(other_names, R"(["b", "a"])")) == "p");

    // A last output that an #if leaves out takes its target off the pass.
    const std::string maybe = a + "#if SCENE_TEXTURED\nlayout(location = 1) out vec4 b;\n#endif\n";
    const Description last = compiled(maybe, R"(["a", "b"])");
    CHECK(planOf(last).passes[0].color.size() == 1);
    CHECK(planOf(last, {0, false, false, true}).passes[0].color.size() == 2);
    const Result<Plan> unread = tryCompile(compiled(maybe, R"(["a", "b"])", "b"));
    CHECK(has(onlyError(unread, Code::never_written).message, "an #if takes it out"));
    CHECK(outcome(compiled(maybe, R"(["b", "a"])")) == "CV5008 /passes/p/color/1");
}

TEST_CASE("More uniforms than the device holds are refused before the driver sees them")
{
    Description description = body("uniform vec3 kernel[SAMPLES];\nuniform mat4 clip_from_view;\n");
    ParamDesc& samples = description.params[3];
    REQUIRE(samples.name == "samples");
    samples.value[0] = 220;  // and 4 of the matrix: as many as there are
    CHECK(tryCompile(description).ok());
    samples.value[0] = 221;
    const auto check = [&](const std::string& pointer, const std::string& help) {
        const Diagnostic error = onlyError(tryCompile(description), Code::too_many);
        CHECK(error.pointer == pointer);
        CHECK_THAT(error.message, Catch::Contains("225") && Catch::Contains("224"));
        CHECK_THAT(error.help, Catch::Contains(help));
    };
    check("/params/samples", "lower 'samples' to 220");
    description.generated[0].count = 221;
    description.generated[0].count_param = {};
    check("/generated/kernel", "lower its `count` to 220");
}
