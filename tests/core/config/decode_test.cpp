// SPDX-License-Identifier: MIT
// Decoding: what each key becomes, and its default.
// Decoding: keys, types, names and ranges that are wrong, beyond those of tests/data/bad, and how
// errors are told.
// Decoding: the GLSL files that a config names and what they include.
// Decoding: names that lead nowhere or collide, beyond those of tests/data/bad.
#include "tests/core/config/decode_fixture.h"

#include <crevice/glsl_stage.h>

using namespace crevice;

namespace {

Description decoded(const Sections& replaced)
{
    INFO(configText(replaced));
    return need(decodeWith(replaced));
}

std::vector<std::string> keysOf(const Description& description)
{
    std::vector<std::string> keys;
    for (const auto& file : description.files) keys.push_back(file.first);
    return keys;
}

// The targets of the base config, of which some say more.
BadConfig inTargets(const std::string& depth, const std::string& ao, const char* errors,
                    const std::string& more = "")
{
    return {"targets",
            R"({"depth": {"format": "depth24")" + depth + R"(}, "ao": {"format": "r8")" + ao +
                R"(}, "ao_filtered": {"format": "r8"})" + more + "}",
            errors};
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

TEST_CASE("names are snake_case that GLSL does not reserve", "[decode]")
{
    for (const char* name :
         {"AoBlur", "ao-blur", "ao__blur", "gl_blur", "2x", "_blur", "", "größe"}) {
        const std::string views = std::string("{\"") + name + "\": {\"target\": \"ao\"}}";
        const auto result = decodeWith({{"views", views}});
        INFO(name);
        CHECK(errorsOf(result) == "CV3004 /views/" + std::string(name));
        CHECK(result.diagnostics().at(0).help.find("lower-case") != std::string::npos);
    }
    const std::string longest(64, 'a');
    CHECK(decodeWith({{"views", "{\"" + longest + "\": {\"target\": \"ao\"}}"}}).ok());
    const auto result = decodeWith({{"views", "{\"a" + longest + "\": {\"target\": \"ao\"}}"}});
    CHECK(errorsOf(result) == "CV3004 /views/a" + longest);
}

TEST_CASE("every error of a file is reported, in its order", "[decode]")
{
    const std::string text = R"({ "format": 1,
  "views": {"v": {"target": "nowhere", "scale": "big"}},
  "targets": {"ao": {"formats": "r8", "samples": 99}},
  "colour": 1,
  "params": {"Radius": {"default": "x"}}
})";
    const auto result = decode(parsed(text), MemorySources());
    CHECK(errorsOf(result) ==
          "CV2103 /views/v/target; CV3002 /views/v/scale; "
          "CV3001 /targets/ao/formats; CV4001 /targets/ao/samples; CV3001 /colour; "
          "CV3004 /params/Radius; CV3002 /params/Radius/default");
    int line = 0;
    for (const Diagnostic& each : result.diagnostics()) {
        CHECK(each.place.line >= line);
        CHECK_FALSE(each.help.empty());
        line = each.place.line;
    }
}

TEST_CASE("a document of nothing but mistakes gets a hundred errors", "[decode]")
{
    std::string params = R"("samples": {"type": "int", "default": 16})";
    for (int i = 0; i < 1000; ++i)
        params += ", \"p" + std::to_string(i) + R"(": {"default": 1, "mni": 0})";
    const Result<Description> result = decodeWith({{"params", "{" + params + "}"}});
    REQUIRE(result.diagnostics().size() == 100);
    CHECK(result.diagnostics().back().notes.back().text.find("902 more") != std::string::npos);
}

TEST_CASE("a description carries each GLSL file that it names or includes", "[decode]")
{
    const auto result = need(decodeWith({}));
    CHECK(keysOf(result) == std::vector<std::string>{"common/fullscreen.vert", "common/view.glsl",
                                                     "geometry/a.surface.glsl",
                                                     "geometry/normal.glsl", "ssao/ao.frag"});
    for (const auto& [key, file] : result.files) CHECK(file->name == key);
    need(assembleStage(result.files, {{"surface", result.interfaces.at(0).file.name}},
                       result.shaders.at(0).fragment.name, {}));  // which they are enough for
}

TEST_CASE("files that include each other are read once", "[decode]")
{
    MemorySources sources = glslSources();
    sources.add("ssao/ao.frag", "#include \"ssao/ao.frag\"\n#include \"./b.glsl\"\n");
    sources.add("ssao/b.glsl", "#include \"./ao.frag\"\n");
    const auto result = need(decodeWith({}, sources));
    CHECK(result.files.count("ssao/b.glsl") == 1);
}

TEST_CASE("one name cannot stand for two objects that GLSL or an override would see", "[decode]")
{
    checkEach({
        {"imports", R"({"photo": {"type": "texture"}, "depth": {"type": "texture"}})",
         "CV2107 /imports/depth"},
        {"generated", R"({"noise": {"generator": "rotation_noise"},
                          "radius": {"generator": "sphere_kernel"}})",
         "CV2107 /generated/radius"},
        {"features", R"({"samples": {}})", "CV2107 /features/samples"},
        {"params", R"({"samples": {"type": "int", "default": 1}, "shininess": {"default": 1}})",
         "CV2107 /params/shininess"},
        {"imports", R"({"photo": {"type": "texture"}, "depth": {"type": "camera"}})", ""},
        {"features", R"({"ao": {}, "fast": {}})", ""},
        // Nor may anything have the name of a history that there is.
        inTargets("", R"(, "history": true)", "", R"(, "ao_before": {"format": "r8"})"),
        inTargets("", R"(, "history": true)", "", R"(, "depth_history": {"format": "r8"})"),
        inTargets("", R"(, "history": true)", "CV2107 /targets/ao",
                  R"(, "ao_history": {"format": "r8"})"),
    });
}

TEST_CASE("what refers to something broken is not reported as well", "[decode]")
{
    checkEach({
        {"targets", R"({"depth": {"format": "depth24"}, "ao": {"format": 3},
                        "ao_filtered": []})",
         "CV3002 /targets/ao/format; CV3002 /targets/ao_filtered"},
        {"targets", "3", "CV3002 /targets"},
        {"shaders", R"({"ao": "ao.frag"})", "CV3002 /shaders/ao"},
        {"params", R"({"samples": {"type": "int", "default": "many"}})",
         "CV3002 /params/samples/default"},
        {"generated", R"({"noise": {"generator": "rotate"}})", "CV3005 /generated/noise/generator"},
        {"interfaces", "[]", "CV3002 /interfaces"},
    });
    // A misspelt section is one error too.
    const std::string targets = R"({"depth": {"format": "depth24"}, "ao": {"format": "r8"},
                                    "ao_filtered": {"format": "r8"}})";
    CHECK(errorsOf(decodeWith({{"targets", ""}, {"targts", targets}})) == "CV3001 /targts");
    CHECK(errorsOf(decodeWith(
              {{"interfaces", ""}, {"interface", R"({"surface": "geometry/a.surface.glsl"})"}})) ==
          "CV3001 /interface");
}
