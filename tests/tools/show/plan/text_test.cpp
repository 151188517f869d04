// SPDX-License-Identifier: MIT
// Plans as text, JSON and Graphviz.
// What `crevice validate` calls ok plans in every scene and under every camera.
// Which geometry is drawn for the occlusion alone.
#include "tests/support/plan_rig.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

using namespace crevice;

namespace {

// One of everything: a draw, a condition, an no_op, unread, generated, a constant, renames.
Description everything()
{
    Sketch sketch{{R"(geometry: base_color_map -> normal albedo | "type": "draw", "depth": "depth",
            "clear": {"normal": [0, 0, 1, 0]})",
                   "ssao: depth normal noise -> ao",
                   R"(glow: -> light_glow |
            "no_op": {"strength": {"at": 0, "gives": {"light_glow": 0.5}}})",
                   R"(filter: ao -> smooth | "when": {"soft": true}, "bypass": {"smooth": "ao"})",
                   R"(light: visible light_glow -> color |
            "inputs": {"visible": {"from": "smooth", "filter": "linear"}})",
                   "debug: color -> spare"},
                  {{"ao", "smooth"}, {"color", "color"}},
                  {{"depth", R"({"format": ["depth24"]})"},
                   {"normal", R"({"format": ["rgba16f"]})"},
                   {"albedo", R"({"format": ["rgba8"]})"},
                   {"color", R"({"format": ["rgba8"]})"}},
                  R"("params": {"strength": {"default": 0}},
           "features": {"soft": {"type": "bool"}},
           "imports": {"draws": {"type": "draw_list"}},
           "generated": {"noise": {"generator": "rotation_noise", "count": 4}})"};
    return describe(sketch);
}

// A config with one more pass, which runs where the trait has that value and reads what nobody
// supplies.
ConfigOptions brokenWhere(const TemporaryFolder& folder, const std::string& condition)
{
    folder.write("broken.frag",
                 "#version 300 es\nprecision highp float;\nuniform float nowhere;\n"
                 "layout(location = 0) out float extra;\n"
                 "void main() { extra = nowhere; }\n");
    ConfigOptions options;
    options.config = folder.write("broken.json", R"({"format": 1, "extends": ["learnopengl"],
        "targets": {"extra": {"format": ["r8"]}},
        "shaders": {"extra": {"vertex": "common/fullscreen.vert", "fragment": "./broken.frag"}},
        "passes": {"extra": {"type": "fullscreen", "shader": "extra", "color": ["extra"],
                             "when": {)" + condition +
                                                     R"(}, "bypass": {"extra": "ao"}}},
        "outputs": {"extra": "extra"}})");
    return options;
}

/// The names of the passes that draw geometry for the output `ao` alone.
std::vector<std::string> ownPasses(const ConfigOptions& request, const std::string& output = "ao")
{
    const Description description = need(loadDescription(request, shippedSources()));
    const CompileOptions options{{960, 540}, {output}};
    const Plan plan = need(compile(description, usualTraits(), usualCaps(), options));
    const std::vector<bool> own =
        need(ownGeometry(plan, description, usualTraits(), usualCaps(), options));
    REQUIRE(own.size() == plan.passes.size());
    std::vector<std::string> names;
    for (std::size_t pass = 0; pass < own.size(); ++pass)
        if (own[pass]) names.push_back(plan.passes[pass].name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("The text of a plan lists passes, textures, outputs and what is left out")
{
    CHECK(toText(planOf(everything())) ==
          R"(plan sketch 64x32: 3 passes, 4 textures, 34.0 KiB
passes
  geometry: draw 64x32, program geometry, 8.0 KiB read, 24.0 KiB written
    reads   base_color_map of the material
    writes  normal: rgba16f texture 0, clear to 0 0 1 0, store
    writes  albedo: no texture, no pass reads it
    writes  depth: depth24 texture 1, clear to 1, store
  ssao: fullscreen 64x32, program ssao, 32.0 KiB read, 2.0 KiB written
    reads   depth (nearest, clamp)
    reads   normal (nearest, clamp)
    reads   noise from generated noise (nearest, repeat)
    writes  ao: r8 texture 2, discard, store
  light: fullscreen 64x32, program light, 2.0 KiB read, 8.0 KiB written
    reads   visible from target ao (linear, clamp)
    reads   light_glow from constant 0.5
    writes  color: rgba8 texture 3, discard, store
textures
  0: rgba16f 64x32, 16.0 KiB: normal
  1: depth24 64x32, 8.0 KiB: depth
  2: r8 64x32, 2.0 KiB: ao
  3: rgba8 64x32, 8.0 KiB: color
outputs
  ao: target ao
  color: target color
generated
  noise: rotation_noise 4
imports
  draws: draw_list
left out
  attachment albedo (dead_pass): no pass reads it, and it is not computed
  pass glow (no_op): strength is 0, so light_glow is 0.5
  pass filter (condition): it needs soft true, and soft is false
  pass debug (dead_pass): no output asked for needs it
  passes (cached): per frame, those whose inputs have not changed
)");
}

TEST_CASE("What a pass moves is counted by what it stores, reads and resolves")
{
    const auto moved = [](const std::string& depth, const std::string& samples) {
        const Plan plan = planOf(
            describe(Sketch{{R"(g: -> x | "type": "draw", "depth": "d")", "h: x " + depth + "-> y"},
                            {{"out", "y"}},
                            {{"x", R"({"format": ["rgba8"], "samples": )" + samples + "}"},
                             {"d", R"({"format": ["depth24"], "samples": )" + samples + "}"}}}));
        return movedBytes(plan, plan.passes[0]);
    };
    constexpr double kTexels = 64 * 32 * 4;
    CHECK(moved("", "1").written == kTexels);  // the colour alone
    CHECK(moved("d ", "1").written == 2 * kTexels);
    CHECK(moved("", "4").written == 5 * kTexels);
    CHECK(moved("", "4").read == 4 * kTexels);
}

TEST_CASE("The JSON of a plan is JSON and has the same content")
{
    const Plan plan = planOf(everything());
    const Node json =
        need(parseDocument(std::make_shared<const SourceText>(SourceText{"plan", toJson(plan)})));
    const Node& geometry = json.find("passes")->items.at(0);
    CHECK(geometry.find("color")->items[0].find("clear")->items[2].number == 1);
    CHECK(geometry.find("color")->items[1].find("texture")->kind == Node::Kind::null);
    CHECK(json.find("passes")->items.at(1).find("depth")->kind == Node::Kind::null);
    CHECK(json.find("programs")->items[0].find("key")->text == plan.programs[0].key);
    CHECK(json.find("outputs")->items[0].find("target")->text == "ao");
    CHECK(json.find("elided")->items.size() == 5);
    CHECK(json.find("texture_bytes")->number == plan.texture_bytes);
}

TEST_CASE("An output that is a constant says so everywhere")
{
    const Plan plan = planOf(
        describe(Sketch{{R"(ssao: -> ao | "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}})"},
                        {{"ao", "ao"}},
                        {},
                        R"("params": {"intensity": {"default": 0}})"}));
    CHECK(toText(plan).find("ao: constant 1\n") != std::string::npos);
    CHECK(toJson(plan).find(R"("constant": 1})") != std::string::npos);
    CHECK(toDot(plan).find("\"constant_1\" -> \"output_ao\"") != std::string::npos);
}

TEST_CASE("The Graphviz drawing has boxes for passes, ellipses for textures, and the data's way")
{
    CHECK(toDot(planOf(describe(Sketch{{"a: -> x", "b: x -> y"}, {{"out", "y"}}}))) ==
          R"(digraph "sketch" {
  rankdir=LR;
  "pass_a" [shape=box, label="a\na 64x32"];
  "target_x" [shape=ellipse, label="x\nr8 64x32, texture 0"];
  "pass_b" [shape=box, label="b\nb 64x32"];
  "target_y" [shape=ellipse, label="y\nr8 64x32, texture 1"];
  "output_out" [shape=plaintext, label="out"];
  "pass_a" -> "target_x";
  "target_x" -> "pass_b";
  "pass_b" -> "target_y";
  "target_y" -> "output_out";
}
)");
}

TEST_CASE("A name with quotes and backslashes stays inside its quotes")
{
    Plan plan = planOf(describe(Sketch{{"a: -> x"}, {{"out", "x"}}}));
    plan.config = "my \"best\\ plan";
    CHECK(toDot(plan).find(R"(digraph "my \"best\\ plan" {)") == 0);
    CHECK(toJson(plan).find(R"("config": "my \"best\\ plan")") != std::string::npos);
}

TEST_CASE("A pass that fails in some scene or under some camera fails to validate")
{
    const TemporaryFolder folder("planning");
    for (const char* condition :
         {R"("scene.lights": false)", R"("scene.lights": true)", R"("scene.alpha_tested": false)",
          R"("scene.specular": false)", R"("scene.textured": false)",
          R"("camera.orthographic": true)", R"("camera.reversed_depth": true)",
          R"("camera.turned": true)", R"("camera.views": 2)", R"("scene.normal_mapped": true)",
          R"("scene.baked_occlusion": true)", R"("scene.material_ambient": true)",
          R"("scene.baked_occlusion": true, "scene.normal_mapped": true)"}) {
        INFO(condition);
        GlslCheck shaders;
        const Result<Plan> plan =
            planForEveryScene(loadDescription(brokenWhere(folder, condition), shippedSources()), "",
                              kUsualExtent, shaders);
        CHECK_FALSE(plan.ok());
        REQUIRE(plan.diagnostics().size() == 1);
        CHECK(plan.diagnostics()[0].code == Code::uniform_unbound);
    }
}

TEST_CASE("Geometry is the occlusion's own where the lit picture does without it")
{
    CHECK(ownPasses({"gtao", "", {}, ""}).empty());  // deferred light needs the G-buffer itself
    CHECK(ownPasses({"high", "", {}, ""}) == Names{"back_faces", "second_layer", "second_back"});
    CHECK(ownPasses({"mobile", "", {}, ""}) == Names{"geometry"});  // forward light: no depth first
    CHECK(ownPasses({"mobile", "", {}, ""}, "color") == Names{"geometry"});
    CHECK(ownPasses({"balanced+geometry/host_depth", "", {}, ""}).empty());
    CHECK(ownPasses({"high", "", {"intensity=0"}, ""}, "color").empty());
}
