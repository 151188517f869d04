// SPDX-License-Identifier: MIT
// Assembled stages in a real driver: what it reads, and where its messages lead.
#include <crevice/glsl_stage.h>

#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

GlslStage including(const std::string& included, const GlslDefines& defines)
{
    const std::string main =
        "#version 300 es\nprecision highp float;\n#include \"b.glsl\"\n"
        "out vec4 color;\nvoid main() { color = vec4(value()); }\n";
    const auto text = [](const char* name, const std::string& content) {
        return std::make_shared<SourceText>(SourceText{name, content});
    };
    return need(assembleStage(
        {{"main.frag", text("main.frag", main)}, {"b.glsl", text("b.glsl", included)}}, {},
        "main.frag", defines));
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "a driver compiles an assembled stage, conditions and defines included")
{
    const GlslStage fragment_stage =
        including("#if MODE == 2 // why\nfloat value() { return SCALE * 0.5; }\n#endif",
                  {{"MODE", "2"}, {"SCALE", "2.0"}});
    CHECK(device->createProgram({"fits", stage(kFullscreenVertex), fragment_stage}).ok());
}

TEST_CASE_METHOD(GlFixture, "a driver too refuses a condition over a name without a define")
{
    const GlslStage broken =
        stage(fragment("#if UNKNOWN\n#endif\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n"));
    CHECK_FALSE(device->createProgram({"unknown", stage(kFullscreenVertex), broken}).ok());
}

TEST_CASE_METHOD(GlFixture, "a driver's error in an included file leads into that file")
{
    const GlslStage broken =
        including("// comment\nfloat value()\n{\n    /* why */ return missing;\n}\n", {});
    const auto result = device->createProgram({"broken", stage(kFullscreenVertex), broken});
    REQUIRE_FALSE(result.ok());
    CHECK(placeName(result.diagnostics()[0].place) == "b.glsl:4:22");
}
