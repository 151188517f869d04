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
    CHECK(p.when.at(0).values == std::vector<std::string>{"true"});
    CHECK(p.when.at(1).values == std::vector<std::string>{"hard", "smooth"});
    CHECK(p.when.at(2).name == "scene.lights");
    CHECK(p.when.at(2).values == std::vector<std::string>{"3"});
    CHECK(p.bypass.at(0).name == "ao");
    CHECK(p.bypass.at(0).input.name == "depth");
    CHECK(p.no_op.at(0).name == "radius");
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
    CHECK(p.inputs.at(2).name == "tile");
    CHECK(p.inputs.at(2).from.name == "noise");
    CHECK(p.inputs.at(3).from.pointer == "/passes/p/inputs/lowered/from");
    CHECK((p.inputs.at(3).has_filter && !p.inputs.at(3).has_wrap));
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
