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

TEST_CASE("An input renames a sampler and says how it is sampled")
{
    const Plan plan = planOf(
        body("uniform sampler2D grain;\n",
             R"("inputs": {"grain": {"from": "noise", "filter": "linear", "wrap": "clamp"}})"));
    const PlanInput& input = plan.passes[0].inputs.at(0);
    CHECK(input.sampler == "grain");
    CHECK(plan.generated.at(input.index).name == "noise");
    CHECK(input.sampling.filter == Filter::linear);
    CHECK(input.sampling.wrap == Wrap::clamp);
}

TEST_CASE("A material's texture is for draw passes")
{
    const std::string sampler = "uniform sampler2D base_color_map;\n";
    const Plan plan = planOf(body(sampler, R"("type": "draw")"));
    CHECK(plan.passes[0].inputs.at(0).kind == InputKind::material);
    CHECK(plan.passes[0].inputs.at(0).sampling.wrap == Wrap::repeat);
    const Diagnostic error = onlyError(body(sampler));
    CHECK(error.code == Code::uniform_unbound);
    CHECK(textAt(error.notes.at(0).place) == "base_color_map");
}

TEST_CASE(
    "A sampler of nothing is refused where the pass names its shader, with the nearest texture")
{
    const Diagnostic error = onlyError(body("uniform sampler2D noize;\n"));
    CHECK(error.code == Code::uniform_unbound);
    CHECK(error.place.source->name == "test.json");
    CHECK(error.notes.at(0).place.source->name == "p.frag");
    CHECK(error.notes.at(0).place.line == 3);
    CHECK(textAt(error.notes.at(0).place) == "noize");
    CHECK(error.pointer == "/passes/p/shader");
    CHECK(error.help.find("'noise'") != error.help.npos);
}

TEST_CASE("A sampler in both stages is one input")
{
    const std::string vertex = "#version 300 es\nuniform sampler2D noise;\nvoid main() {}\n";
    const std::string fragment = kHead + "uniform sampler2D noise;\n" + kOut + "void main() {}\n";
    CHECK(planOf(onePass(fragment, "", "", vertex)).passes[0].inputs.size() == 1);
}

TEST_CASE("An array of samplers is refused")
{
    const Diagnostic error = onlyError(body("uniform sampler2D noise[2];\n"));
    CHECK(error.code == Code::uniform_type);
    CHECK(textAt(error.notes.at(0).place) == "noise");
}

TEST_CASE("A mistake in GLSL that two passes share is one error")
{
    const Diagnostic error =
        onlyError(describe(R"({"format": 1,
        "targets": {"x": {"format": ["r8"]}, "y": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "v", "fragment": "f"}},
        "passes": {"a": {"shader": "s", "color": "x"}, "b": {"shader": "s", "color": "y"}},
        "outputs": {"x": "x", "y": "y"}})",
                           {{"v", kFullVertex},
                            {"f", kHead + "uniform float raduis;\n" + kOut + "void main() {}\n"}}));
    CHECK(error.code == Code::uniform_unbound);
    CHECK(textAt(error.notes.at(0).place) == "raduis");
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

TEST_CASE("A draw uses the draw list, and what is not used is not collected")
{
    CHECK(joined(namesOf(planOf(body("", R"("type": "draw")")).imports)) == "draws");
    CHECK(planOf(body("")).imports.empty());
}

TEST_CASE("Values of a draw exist in draw passes alone")
{
    const std::string uniform = "uniform mat4 clip_from_model;\n";
    CHECK(planOf(body(uniform, R"("type": "draw")")).passes.size() == 1);
    const Diagnostic error = onlyError(body(uniform));
    CHECK(error.code == Code::uniform_unbound);
    CHECK(error.message.find("draw") != error.message.npos);
}

TEST_CASE("A uniform that nothing supplies is refused, with the GLSL and the nearest value")
{
    const Diagnostic error = onlyError(body("uniform float raduis;\n"));
    CHECK(error.code == Code::uniform_unbound);
    CHECK(textAt(error.notes.at(0).place) == "raduis");
    CHECK(error.help.find("'radius'") != error.help.npos);
}

TEST_CASE("A uniform of another type or length than its value is refused")
{
    const auto [declared, name] =
        GENERATE(table<std::string, std::string>({{"int radius", "radius"},
                                                  {"float taps", "taps"},
                                                  {"vec4 tint", "tint"},
                                                  {"float radius[2]", "radius"},
                                                  {"vec3 kernel[3]", "kernel"},
                                                  {"vec3 kernel", "kernel"},
                                                  {"vec4 kernel[SAMPLES]", "kernel"},
                                                  {"mat3 clip_from_view", "clip_from_view"},
                                                  {"vec4 light_position[3]", "light_position"},
                                                  {"vec4 noise", "noise"},
                                                  {"float ghost", "ghost"}}));
    const Diagnostic error = onlyError(body("uniform " + declared + ";\n"));
    CAPTURE(declared);
    CHECK(error.code == Code::uniform_type);
    CHECK(textAt(error.notes.at(0).place) == name);
    CHECK(error.pointer == "/passes/p/shader");
    CHECK(error.help.find("uniform ") != error.help.npos);
}

TEST_CASE("Renaming what the shader nowhere has is refused, and what an #if hides is fine")
{
    const std::string noise = "uniform sampler2D noise;\n";
    const Diagnostic error = onlyError(body(noise, R"("inputs": {"noize": "noise"})"));
    CHECK(error.code == Code::input_unused);
    CHECK(error.pointer == "/passes/p/inputs/noize");
    CHECK(textAt(error.place) == "\"noize\"");
    CHECK_THAT(error.help, Catch::Contains("'noise'"));
    // By a name far from that of what it reads, which the shader has.
    const Diagnostic far = onlyError(body(noise, R"("inputs": {"grain": "noise"})"));
    CHECK(far.code == Code::input_unused);
    CHECK_THAT(far.help, Catch::StartsWith("did you mean 'noise'? the shader declares: "));

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
    const Diagnostic without_target = onlyError(compiled(both, R"("a")"));
    CHECK(without_target.code == Code::output_mismatch);
    CHECK(textAt(without_target.notes.at(0).place) == "b");
    CHECK(outcome(compiled(a, R"(["a", "b"])")) == "CV5008 /passes/p/color/1");
    const Diagnostic other_order = onlyError(compiled(both, R"(["b", "a"])"));
    CHECK(other_order.code == Code::output_mismatch);
    CHECK(other_order.notes.at(0).place.source->name == "f");
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

TEST_CASE("GLSL that cannot be read stops its pass and brings no further errors")
{
    const Diagnostic error =
        onlyError(onePass(kHead + "#if (\n#endif\n" + kOut, R"("inputs": {"x": "noise"})"));
    CHECK(error.code == Code::preprocessor);
    CHECK(error.place.source->name == "p.frag");
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

TEST_CASE("More uniforms than the device holds are the pass's fault where no kernel is to blame")
{
    const Description description = body("uniform mat4 clip_from_view;\n");
    DeviceCaps caps = ampleCaps();
    caps.max_fragment_uniform_vectors = 3;
    CHECK(onlyError(description, {}, caps).pointer == "/passes/p");
}
