// SPDX-License-Identifier: MIT
// Decoding: keys, types, names and ranges that are wrong, beyond those of tests/data/bad, and how
// errors are told.
#include "tests/core/config/decode_fixture.h"

using namespace crevice;

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
