// SPDX-License-Identifier: MIT
// Shaders in a plan: what samplers, uniforms and outputs bind to, and what does not fit.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

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
    const Diagnostic error = onlyError(body("uniform " + declared + ";\n"));
    CAPTURE(declared);
    CHECK(error.code == Code::uniform_type);
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
    const Diagnostic unread = onlyError(compiled(maybe, R"(["a", "b"])", "b"));
    CHECK(unread.code == Code::never_written);
    CHECK_THAT(unread.message, Catch::Contains("an #if takes it out"));
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
        const Diagnostic error = onlyError(description);
        CHECK(error.code == Code::too_many);
        CHECK(error.pointer == pointer);
        CHECK_THAT(error.message, Catch::Contains("225") && Catch::Contains("224"));
        CHECK_THAT(error.help, Catch::Contains(help));
    };
    check("/params/samples", "lower 'samples' to 220");
    description.generated[0].count = 221;
    description.generated[0].count_param = {};
    check("/generated/kernel", "lower its `count` to 220");
}
