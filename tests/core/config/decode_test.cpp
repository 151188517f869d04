// SPDX-License-Identifier: MIT
// Decoding: what each key becomes, and its default.
#include "tests/core/config/decode_fixture.h"

using namespace crevice;

namespace {

Description decoded(const Sections& replaced)
{
    const Result<Description> result = decodeWith(replaced);
    INFO(configText(replaced) << toText(result.diagnostics()));
    REQUIRE(result.ok());
    return *result;
}

}  // namespace

TEST_CASE("the base config decodes without a word", "[decode]")
{
    const Result<Description> result = decodeWith({});
    CHECK(errorsOf(result) == "");
    CHECK(result.ok());
}

TEST_CASE("a config of nothing but its format decodes to an empty description", "[decode]")
{
    const Result<Description> result = decode(parsed(R"({"format": 1})"), MemorySources());
    REQUIRE(result.ok());
    CHECK(result->format == 1);
    CHECK(result->name.empty());
    CHECK(result->passes.empty());
    CHECK(result->files.empty());
}

TEST_CASE("names and places come from the keys", "[decode]")
{
    const Description d = decoded({{"name", "\"mine\""}, {"description", "\"For tests.\""}});
    CHECK(d.name == "mine");
    CHECK(d.text == "For tests.");
    const TargetDesc* target = findNamed(d.targets, "ao");
    REQUIRE(target);
    CHECK(target->pointer == "/targets/ao");
    REQUIRE(target->place.source);
    CHECK(underlined({Code::internal, "", "", target->place}).find("ao") != std::string::npos);
    CHECK(namesOf(d.targets) == std::vector<std::string>{"depth", "ao", "ao_filtered"});
}

TEST_CASE("a param has the documented defaults", "[decode]")
{
    const Description d = decoded({{"params", R"({"radius": {"default": 2},
        "samples": {"type": "int", "default": 8}})"}});
    const ParamDesc& p = d.params.at(0);
    CHECK(p.type == ParamType::float_);
    CHECK(p.value == std::array<float, 4>{2, 0, 0, 0});
    CHECK(p.min == -1e30);
    CHECK(p.max == 1e30);
    CHECK(p.soft_max == 0.0);
    CHECK(p.step == 0.0);
    CHECK((p.unit + p.label + p.tooltip + p.group).empty());
    CHECK(p.bind == Bind::uniform);
}

TEST_CASE("a param takes every key", "[decode]")
{
    const Description d = decoded({{"params", R"({"samples": {"type": "int", "default": 8},
        "tint": {"type": "vec3", "default": [0.25, 0.5, 1], "min": 0, "max": 1, "soft_max": 0.5,
                 "step": 0.125, "unit": "1", "label": "Tint", "tooltip": "Colour.",
                 "group": "Look", "bind": "uniform"},
        "slope": {"default": 1.5, "bind": "define"}})"}});
    const ParamDesc& p = d.params.at(1);
    CHECK(p.type == ParamType::vec3);
    CHECK(p.value == std::array<float, 4>{0.25f, 0.5f, 1, 0});
    CHECK(p.min == 0.0);
    CHECK(p.max == 1.0);
    CHECK(p.soft_max == 0.5);
    CHECK(p.step == 0.125);
    CHECK(p.unit == "1");
    CHECK(p.label == "Tint");
    CHECK(p.tooltip == "Colour.");
    CHECK(p.group == "Look");
    CHECK(d.params.at(2).bind == Bind::define);
}

TEST_CASE("a feature is a bool or one of its words", "[decode]")
{
    const Description d = decoded({{"features", R"({
        "off": {}, "on": {"type": "bool", "default": true},
        "first": {"type": "enum", "values": ["a", "b"]},
        "second": {"type": "enum", "values": ["a", "b"], "default": "b"}})"}});
    for (const FeatureDesc& each : d.features) {
        const bool boolean = each.name == "off" || each.name == "on";
        CHECK(each.boolean == boolean);
        CHECK(each.value == (each.name == "on" || each.name == "second" ? 1 : 0));
        CHECK(each.values == (boolean ? std::vector<std::string>{"false", "true"}
                                      : std::vector<std::string>{"a", "b"}));
    }
}

TEST_CASE("an import is there for certain unless it says otherwise", "[decode]")
{
    const Description d = decoded({{"imports", R"({"camera": {"type": "camera"},
        "scene": {"type": "draw_list"}, "lights": {"type": "lights", "optional": true},
        "photo": {"type": "texture"}})"}});
    CHECK(d.imports.at(0).type == ImportType::camera);
    CHECK(d.imports.at(1).type == ImportType::draw_list);
    CHECK(d.imports.at(2).type == ImportType::lights);
    CHECK(d.imports.at(3).type == ImportType::texture);
    CHECK_FALSE(d.imports.at(0).optional);
    CHECK(d.imports.at(2).optional);
}

TEST_CASE("a generated value counts by itself or by a param", "[decode]")
{
    const Description d = decoded({{"generated", R"({"plain": {"generator": "sphere_kernel"},
        "kernel": {"generator": "hemisphere_kernel", "count": "samples",
                   "shape": "cube", "lengths": "quadratic", "seed": 4294967295}})"}});
    CHECK(d.generated.at(0).count == 16);
    CHECK(d.generated.at(0).count_param.empty());
    CHECK(d.generated.at(0).shape == "ball");
    CHECK(d.generated.at(0).seed == 1);
    CHECK(d.generated.at(1).generator == "hemisphere_kernel");
    CHECK(d.generated.at(1).count_param.name == "samples");
    CHECK(d.generated.at(1).count_param.pointer == "/generated/kernel/count");
    CHECK(d.generated.at(1).shape + d.generated.at(1).lengths == "cubequadratic");
    CHECK(d.generated.at(1).seed == 4294967295u);
}

TEST_CASE("a target follows the output unless it says otherwise", "[decode]")
{
    const Description d = decoded({{"targets", R"({"depth": {"format": "depth24"},
        "ao": {"format": ["r8", "rgba8"]},
        "ao_filtered": {"format": "r16f", "size": {"of": "ao", "scale": 0.5}},
        "wide": {"format": "r16f", "size": {"scale": 1.5, "border": true}}})"}});
    CHECK(d.targets.at(0).formats == std::vector<Format>{Format::depth24});
    CHECK(d.targets.at(0).size.of.empty());
    CHECK(d.targets.at(0).size.scale == 1.0f);
    CHECK_FALSE(d.targets.at(0).size.border);
    CHECK(d.targets.at(1).formats == std::vector<Format>{Format::r8, Format::rgba8});
    CHECK(d.targets.at(2).size.of.name == "ao");
    CHECK(d.targets.at(2).size.scale == 0.5f);
    CHECK(d.targets.at(3).size.scale == 1.5f);
    CHECK(d.targets.at(3).size.border);
}

TEST_CASE("defines are text as GLSL writes it", "[decode]")
{
    const Description d = decoded({{"shaders", R"json({"ao": {"vertex": "common/fullscreen.vert",
        "fragment": "ssao/ao.frag", "defines": {"AXIS": "vec2(1.0, 0.0)", "TAPS": 4, "SCALE": 1.50,
        "ON": true, "OFF": false}}})json"}});
    const auto& defines = d.shaders.at(0).defines;
    CHECK(defines.at("AXIS") == "vec2(1.0, 0.0)");
    CHECK(defines.at("TAPS") == "4");
    CHECK(defines.at("SCALE") == "1.50");
    CHECK(defines.at("ON") == "1");
    CHECK(defines.at("OFF") == "0");
}

TEST_CASE("a pass has the documented defaults", "[decode]")
{
    const PassDesc p = decoded({}).passes.at(0);
    CHECK(p.type == PassType::fullscreen);
    CHECK(p.shader.name == "ao");
    CHECK(p.color.at(0).pointer == "/passes/ssao/color/0");
    CHECK(p.depth.empty());
    CHECK(p.clear.empty());
    CHECK(p.when.terms.empty());
    CHECK(p.bypass.empty());
    CHECK(p.no_op.empty());
    CHECK(p.inputs.empty());
    CHECK(p.state.depth_test == Compare::always);
    CHECK_FALSE(p.state.depth_write);
    CHECK(p.state.cull == Cull::none);
}

TEST_CASE("only a draw pass with depth tests and writes depth by default", "[decode]")
{
    const char* passes[] = {R"({"p": {"type": "draw", "shader": "ao", "depth": "depth"}})",
                            R"({"p": {"type": "draw", "shader": "ao", "color": "ao"}})",
                            R"({"p": {"shader": "ao", "depth": "depth"}})",
                            R"({"p": {"state": {"depth_write": false, "cull": "back"},
                                "type": "draw", "shader": "ao", "depth": "depth"}})"};
    const Compare tests[] = {Compare::less, Compare::always, Compare::always, Compare::less};
    const bool writes[] = {true, false, false, false};
    for (int i = 0; i < 4; ++i) {
        const StateDesc state = decoded({{"passes", passes[i]}}).passes.at(0).state;
        CHECK(state.depth_test == tests[i]);
        CHECK(state.depth_write == writes[i]);
        CHECK(state.cull == (i == 3 ? Cull::back : Cull::none));
    }
}

TEST_CASE("a pass takes every key", "[decode]")
{
    const PassDesc p = decoded({{"passes", R"({"p": {"type": "draw", "shader": "ao",
        "color": ["ao", "ao_filtered"], "depth": "depth",
        "clear": {"ao": 0.5, "ao_filtered": [1, 2, 3, 4], "depth": 1},
        "when": {"fast": true, "check": ["hard", "smooth"], "scene.lights": 3},
        "bypass": {"ao": "depth"},
        "no_op": {"radius": {"at": 0, "gives": {"ao": 1, "ao_filtered": "depth"}}},
        "inputs": {"base_color_map": {"filter": "linear", "wrap": "repeat"}, "photo": {},
                   "tile": "noise", "lowered": {"from": "photo", "filter": "nearest"}},
        "state": {"depth_test": "greater_equal", "depth_write": true, "cull": "front"}}})"}})
                           .passes.at(0);
    CHECK(p.type == PassType::draw);
    CHECK(p.color.at(1).name == "ao_filtered");
    CHECK(p.clear.at(0).value == std::array<float, 4>{0.5f, 0.5f, 0.5f, 0.5f});
    CHECK(p.clear.at(1).value == std::array<float, 4>{1, 2, 3, 4});
    CHECK(p.clear.at(2).value[0] == 1.0f);
    CHECK(p.when.terms.at(0).values == std::vector<std::string>{"true"});
    CHECK(p.when.terms.at(1).values == std::vector<std::string>{"hard", "smooth"});
    CHECK(p.when.terms.at(2).subject.name == "scene.lights");
    CHECK(p.when.terms.at(2).values == std::vector<std::string>{"3"});
    CHECK(p.bypass.at(0).output.name == "ao");
    CHECK(p.bypass.at(0).input.name == "depth");
    CHECK(p.no_op.at(0).param.name == "radius");
    CHECK(p.no_op.at(0).at == 0.0f);
    CHECK(p.no_op.at(0).gives.at(0).constant);
    CHECK(p.no_op.at(0).gives.at(0).value == 1.0f);
    CHECK_FALSE(p.no_op.at(0).gives.at(1).constant);
    CHECK(p.no_op.at(0).gives.at(1).input.name == "depth");
    CHECK(p.state.depth_test == Compare::greater_equal);

    CHECK(p.inputs.at(0).from.empty());
    CHECK(p.inputs.at(0).filter == Filter::linear);
    CHECK(p.inputs.at(0).wrap == Wrap::repeat);
    CHECK((p.inputs.at(0).has_filter && p.inputs.at(0).has_wrap));
    CHECK_FALSE((p.inputs.at(1).has_filter || p.inputs.at(1).has_wrap));
    CHECK(p.inputs.at(1).filter == Filter::nearest);
    CHECK(p.inputs.at(1).wrap == Wrap::clamp);
    CHECK(p.inputs.at(2).sampler.name == "tile");
    CHECK(p.inputs.at(2).from.name == "noise");
    CHECK(p.inputs.at(3).from.pointer == "/passes/p/inputs/lowered/from");
    CHECK((p.inputs.at(3).has_filter && !p.inputs.at(3).has_wrap));
}

TEST_CASE("outputs and views name targets", "[decode]")
{
    const Description d = decoded({{"views", R"({"plain": {"target": "ao"},
        "shifted": {"target": "depth", "scale": 0.1, "offset": -0.5}})"}});
    CHECK(d.outputs.at(0).name == "ao");
    CHECK(d.outputs.at(0).target.name == "ao_filtered");
    CHECK(d.views.at(0).scale == 1.0f);
    CHECK(d.views.at(0).offset == 0.0f);
    CHECK(d.views.at(1).scale == 0.1f);
    CHECK(d.views.at(1).offset == -0.5f);
}

TEST_CASE("keys that begin with x- are the host's at every level", "[decode]")
{
    const Description d =
        decoded({{"x-editor", R"({"zoom": [1, "2", null]})"},
                 {"targets", R"({"x-note": 1, "depth": {"format": "depth24", "x-why": "precise"},
                        "ao": {"format": "r8"},
                        "ao_filtered": {"format": "r8", "size": {"x-a": {}, "scale": 1}}})"}});
    CHECK(d.targets.size() == 3);
}
