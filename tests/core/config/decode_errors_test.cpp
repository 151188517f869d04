// SPDX-License-Identifier: MIT
// Decoding: keys, types, names and ranges that are wrong, beyond those of tests/data/bad, and how
// errors are told.
#include "tests/core/config/decode_fixture.h"

using namespace crevice;

TEST_CASE("a missing key is an error at what lacks it", "[decode]")
{
    checkEach({
        {"format", "", "CV3003 "},
        {"imports", R"({"photo": {"type": "texture"}, "eye": {}})", "CV3003 /imports/eye"},
        {"views", R"({"v": {"scale": 1}})", "CV3003 /views/v"},
        {"passes", R"({"p": {"shader": "ao", "color": "ao", "no_op": {"radius": {}}}})",
         "CV3003 /passes/p/no_op/radius; CV3003 /passes/p/no_op/radius"},
        {"features", R"({"check": {"type": "enum"}})", "CV3003 /features/check"},
    });
}

TEST_CASE("a value of another type, length or word is an error at the value", "[decode]")
{
    checkEach({
        {"name", "1", "CV3002 /name"},
        {"targets", "[]", "CV3002 /targets"},
        {"targets", "null", "CV3002 /targets"},
        {"views", R"({"v": {"target": "ao", "scale": true}})", "CV3002 /views/v/scale"},
        {"imports", R"({"photo": {"type": "texture", "optional": 1}})",
         "CV3002 /imports/photo/optional"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": 16.7}})",
         "CV3002 /generated/k/count"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "seed": 1e3}})",
         "CV3002 /generated/k/seed"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "lengths": "gauss"}})",
         "CV3005 /generated/k/lengths"},
        {"passes", R"({"p": {"shader": "ao", "color": ["ao", 3]}})", "CV3002 /passes/p/color/1"},
        {"passes", R"({"p": {"shader": "ao", "color": "ao", "when": {"fast": [true, {}]}}})",
         "CV3002 /passes/p/when/fast/1"},
        {"passes", R"({"p": {"shader": "ao", "color": "ao", "inputs": {"a": 3}}})",
         "CV3002 /passes/p/inputs/a"},
        {"passes", R"({"p": {"shader": "ao", "depth": "depth", "clear": {"depth": [1, 1, 1, 1]}}})",
         "CV3006 /passes/p/clear/depth"},
        {"features", R"({"check": {"type": "enum", "values": ["one"]}})",
         "CV3006 /features/check/values"},
        {"params", R"({"samples": {"type": "int", "default": 1},
                       "a": {"type": "vec2", "default": [1, "2"]}})",
         "CV3002 /params/a/default/1"},
        {"targets", R"({"depth": {"format": "depth24"}, "ao": {"format": ["r8", "rgba_8"]},
                        "ao_filtered": {"format": "none"}})",
         "CV3005 /targets/ao/format/1; CV3005 /targets/ao_filtered/format"},
    });
}

TEST_CASE("a wrong type says what was found and what was wanted", "[decode]")
{
    const auto result = decodeWith({{"views", R"({"v": {"target": "ao", "scale": "abc"}})"}});
    const Diagnostic& error = result.diagnostics().at(0);
    CHECK_THAT(error.message, Catch::Contains("found the string \"abc\", wanted a number"));
    CHECK_THAT(underlined(error), Catch::Contains("abc"));
}

TEST_CASE("a value outside its range is an error", "[decode]")
{
    checkEach({
        {"format", "2", "CV4001 /format"},
        {"params", R"({"samples": {"type": "int", "default": 65, "max": 64}})",
         "CV4001 /params/samples/default"},
        {"params", R"({"samples": {"type": "int", "default": 99999999}})",
         "CV4001 /params/samples/default"},
        {"params", R"({"samples": {"type": "int", "default": 1},
                       "a": {"type": "vec2", "default": [0.5, 2], "max": 1}})",
         "CV4001 /params/a/default/1"},
        {"params", R"({"samples": {"type": "int", "default": 1, "max": 8, "soft_max": 9}})",
         "CV4001 /params/samples/soft_max"},
        {"params", R"({"samples": {"type": "int", "default": 1, "max": 1e300}})",
         "CV4001 /params/samples/max"},
        {"params", R"({"samples": {"type": "int", "default": 5, "max": -2e29, "min": 1}})",
         "CV4002 /params/samples/min"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": 0}})",
         "CV4001 /generated/k/count"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": -1}})",
         "CV4001 /generated/k/count"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": 257}})",
         "CV4001 /generated/k/count"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "seed": 1152921504606846976}})",
         "CV4001 /generated/k/seed"},
        {"targets", R"({"depth": {"format": "depth24", "samples": -1},
                        "ao": {"format": "r8", "samples": 33},
                        "ao_filtered": {"format": "r8", "size": {"scale": 0}}})",
         "CV4001 /targets/depth/samples; CV4001 /targets/ao/samples; "
         "CV4001 /targets/ao_filtered/size/scale"},
        {"views", R"({"v": {"target": "ao", "scale": 1e39}})", "CV4001 /views/v/scale"},
        {"passes", R"({"p": {"shader": "ao", "depth": "depth", "clear": {"depth": 2}}})",
         "CV4001 /passes/p/clear/depth"},
    });
}

TEST_CASE("a range error names value, range and unit, and points at the number", "[decode]")
{
    const std::string text =
        "{ \"format\": 1, \"params\": {\n"
        "  \"radius\": { \"min\": 0.001, \"max\": 100,\n"
        "              \"unit\": \"scene units\", \"default\": -0.5 } } }\n";
    const auto result = decode(parsed(text), MemorySources());
    REQUIRE(errorsOf(result) == "CV4001 /params/radius/default");
    const Diagnostic& error = result.diagnostics().at(0);
    CHECK(error.message == "radius default -0.5 is outside [0.001, 100] scene units");
    CHECK(error.place.line == 3);
    CHECK(error.place.column == 49);
    CHECK(underlined(error) == "-0.5");
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

TEST_CASE("words of an enum and macros have names that GLSL can spell", "[decode]")
{
    checkEach({
        {"features", R"({"check": {"type": "enum", "values": ["4", "8", "no way"]}})",
         "CV3004 /features/check/values/2"},
        {"features", R"({"check": {"type": "enum", "values": ["a", "b", "a"]}})",
         "CV2107 /features/check/values/2"},
        {"features", R"({"check": {"values": ["a", "b"]}})", "CV3001 /features/check/values"},
        {"shaders", R"({"ao": {"vertex": "common/fullscreen.vert", "fragment": "ssao/ao.frag",
                        "defines": {"A B": 1, "GL_ES": 1, "ok": [], "OK": 2}}})",
         "CV3004 /shaders/ao/defines/A B; CV3004 /shaders/ao/defines/GL_ES; "
         "CV3002 /shaders/ao/defines/ok"},
    });
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

TEST_CASE("a document of nothing but mistakes gets a thousand errors, and the number of the rest",
          "[decode]")
{
    std::string params = R"("samples": {"type": "int", "default": 16})";
    for (int i = 0; i < 1500; ++i)
        params += ", \"p" + std::to_string(i) + R"(": {"default": 1, "mni": 0})";
    const Result<Description> result = decodeWith({{"params", "{" + params + "}"}});
    REQUIRE(result.diagnostics().size() == 1000);
    const Diagnostic& last = result.diagnostics().back();
    CHECK(last.pointer == "/params/p999/mni");
    REQUIRE_FALSE(last.notes.empty());
    CHECK(last.notes.back().text == "500 more errors were found and are not listed");
}
