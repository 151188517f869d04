// SPDX-License-Identifier: MIT
// Shader stages: includes, #line, defines, conditions.
#include <crevice/glsl_stage.h>

#include "tests/support/need.h"

using namespace crevice;

namespace {

using Texts = std::map<std::string, std::string>;

const std::string kVersion = "#version 300 es\n";

std::map<std::string, SourceRef> filesOf(const Texts& texts)
{
    std::map<std::string, SourceRef> files;
    for (const auto& [path, text] : texts)
        files[path] = std::make_shared<SourceText>(SourceText{path, text});
    return files;
}

Result<GlslStage> assemble(const Texts& texts, const GlslDefines& defines = {})
{
    return assembleStage(filesOf(texts), {{"surface", "geometry/surface.glsl"}}, "a/main.frag",
                         defines);
}

GlslStage stageOf(const Texts& texts, const GlslDefines& defines = {})
{
    return need(assemble(texts, defines));
}

GlslStage stageOf(const std::string& text, const GlslDefines& defines = {})
{
    return stageOf(Texts{{"a/main.frag", text}}, defines);
}

/// Whether `#if condition` holds, seen by a uniform behind it.
bool holds(const std::string& condition, const GlslDefines& defines = {})
{
    const std::string text = kVersion + "#if " + condition + "\nuniform float x;\n#endif\n";
    return stageOf(text, defines).uniforms.size() == 1;
}

}  // namespace

TEST_CASE("a stage begins with #version, the used defines in order, and its line number")
{
    const GlslStage stage = stageOf(kVersion + "float x = float(ZED + ALPHA);\n",
                                    {{"ZED", "1"}, {"ALPHA", "2"}, {"UNUSED", "3"}});
    CHECK(stage.text ==
          "#version 300 es\n#define ALPHA 2\n#define ZED 1\n#line 2 0\n"
          "float x = float(ZED + ALPHA);\n");
    CHECK(stage.defines_used == std::vector<std::string>{"ALPHA", "ZED"});
    REQUIRE(stage.files.size() == 1);
    CHECK(stage.files[0]->name == "a/main.frag");
}

TEST_CASE("an include stands between line numbers of its file and of the one that includes it")
{
    const GlslStage stage = stageOf({{"a/main.frag", kVersion + "#include \"b.glsl\"\nint y;\n"},
                                     {"b.glsl", "// comment\nint x;"}});
    CHECK(stage.text ==
          "#version 300 es\n#line 2 0\n#line 100001 1\n\nint x;\n#line 3 0\nint y;\n");
    REQUIRE(stage.files.size() == 2);
    CHECK(stage.files[1]->name == "b.glsl");
}

TEST_CASE("a file that two others include is there once")
{
    const GlslStage stage =
        stageOf({{"a/main.frag",
                  kVersion + "#include \"b.glsl\"\n#include \"c.glsl\"\n#include \"b.glsl\"\n"},
                 {"b.glsl", "#include \"c.glsl\"\n"},
                 {"c.glsl", "int once;\n"}});
    CHECK(stage.files.size() == 3);
    CHECK(stage.text.find("once") == stage.text.rfind("once"));
    CHECK(stage.text.find("include") == std::string::npos);
}

TEST_CASE("a define counts as used by code, conditions, includes and other used defines")
{
    const GlslDefines defines = {{"IN_CODE", "1"},  {"IN_IF", "1"},      {"IN_INCLUDE", "INDIRECT"},
                                 {"INDIRECT", "4"}, {"IN_COMMENT", "1"}, {"IN_DEAD_CODE", "1"}};
    const std::string text = kVersion +
                             "#include \"b.glsl\"\n// IN_COMMENT\n"
                             "/* IN_COMMENT */ int x = IN_CODE;\n"
                             "#if IN_IF > 3\nint y = IN_DEAD_CODE;\n#endif\n";
    const GlslStage stage =
        stageOf({{"a/main.frag", text}, {"b.glsl", "int z = IN_INCLUDE;\n"}}, defines);
    CHECK(stage.defines_used ==
          std::vector<std::string>{"INDIRECT", "IN_CODE", "IN_DEAD_CODE", "IN_IF", "IN_INCLUDE"});
}

TEST_CASE("conditions are evaluated as the driver evaluates them")
{
    CHECK(holds("1 + 2 * 3 == 7 && (1 + 2) * 3 == 9"));
    CHECK(holds("7 / 2 == 3 && 7 % 4 == 3 && -7 + 2 < 0 && 10 - 4 - 3 == 3"));
    CHECK(holds("1 << 4 == 16 && 0x10 == 16 && 010 == 8 && 3u == 3"));
    CHECK(holds("(6 & 3) == 2 && (6 | 3) == 7 && (6 ^ 3) == 5 && ~0 == -1"));
    CHECK(holds("!0 && !(2 >= 3) && 3 > 2 && 2 <= 2 && 1 != 2"));
    CHECK(holds("0 || 1 && 1"));
    CHECK_FALSE(holds("0 && UNKNOWN"));
    CHECK(holds("1 || UNKNOWN == 0"));
    CHECK(holds("defined(A) && defined B && !defined(C)", {{"A", "0"}, {"B", ""}}));
    CHECK(holds("A == 4", {{"A", "B + 1"}, {"B", "3"}}));
    CHECK(holds("MODE == MODE_SMOOTH", {{"MODE", "1"}, {"MODE_HARD", "0"}, {"MODE_SMOOTH", "1"}}));
    CHECK(holds("GL_ES && __VERSION__ == 300"));
    CHECK_FALSE(holds("defined(A) && 1 / A", {}));
    CHECK(holds("1 || 1 / 0"));
}

TEST_CASE("of a chain of conditions the first that holds counts")
{
    const std::string text = kVersion +
                             "#if MODE == 0\nuniform float zero;\n#elif MODE == 1\n"
                             "#ifdef DEEP\nuniform float deep;\n#else\nuniform float one;\n#endif\n"
                             "#elif 1\nuniform float more;\n#else\nuniform float none;\n#endif\n"
                             "#ifndef MODE\nuniform float no_mode;\n#endif\n";
    const auto name = [&](const GlslDefines& defines) {
        const GlslStage stage = stageOf(text, defines);
        REQUIRE(stage.uniforms.size() == 1);
        return stage.uniforms[0].name;
    };
    CHECK(name({{"MODE", "0"}}) == "zero");
    CHECK(name({{"MODE", "1"}}) == "one");
    CHECK(name({{"MODE", "1"}, {"DEEP", ""}}) == "deep");
    CHECK(name({{"MODE", "2"}, {"DEEP", ""}}) == "more");
}

TEST_CASE("conditions that decide nothing may name anything")
{
    const std::string text = kVersion +
                             "#if 1\nuniform float one;\n#elif UNKNOWN > 2\n#endif\n"
                             "#if 0\n#if UNKNOWN > 2\n#elif UNKNOWN > 1\n#endif\n#endif\n";
    CHECK(stageOf(text).uniforms.size() == 1);
}

TEST_CASE("the text's own #define and #undef count from where they stand")
{
    const GlslStage stage = stageOf(kVersion +
                                    "#ifndef N\n#define N 4\n#endif\n"
                                    "uniform float a[N];\n#undef N\n"
                                    "#define N (2 + \\\n 3)\nuniform float b[N];\n"
                                    "#define F(x) x\n#ifdef F\nuniform float c;\n#endif\n");
    REQUIRE(stage.uniforms.size() == 3);
    CHECK(stage.uniforms[0].count == 4);
    CHECK(stage.uniforms[1].count == 5);
    CHECK(stage.uniforms[1].place.line == 9);
    CHECK(stage.text.find("#define N (2 + \\\n 3)\n") != std::string::npos);
}

TEST_CASE("endless nesting and macros without end are errors, not crashes")
{
    const auto refused = [](const std::string& body) {
        onlyError(assemble({{"a/main.frag", kVersion + body}}), Code::preprocessor);
    };
    refused("#if " + std::string(100000, '(') + "\n#endif\n");
    refused("#if " + std::string(100000, '!') + "1\n#endif\n");

    std::string doubling = "#define A0 1\n", chain = "#define A0 1\n";
    for (int i = 1; i < 40; ++i) {
        const std::string last = "A" + std::to_string(i - 1);
        doubling += "#define A" + std::to_string(i) + " " + last + " " + last + "\n";
    }
    for (int i = 1; i < 20000; ++i)
        chain += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + "\n";
    refused(doubling + "int x = A39;\n");
    refused(chain + "int x = A19999;\n");
    CHECK(assemble({{"a/main.frag", kVersion + "#define A B\n#define B A\nint x = A;\n"}}).ok());
}

TEST_CASE("includes are found outside comments, with their places")
{
    const std::string text =
        "// #include \"no.glsl\"\n/*\n#include \"no.glsl\"\n*/\n"
        " # include \"a/b.glsl\" // why\n#include <surface>\r\n#include oops\n"
        "#if 0\n#include \"c//d.glsl\"\n#endif\n";
    const std::vector<GlslInclude> includes = findIncludes(filesOf({{"x", text}})["x"]);
    REQUIRE(includes.size() == 3);
    CHECK(includes[0].name == "a/b.glsl");
    CHECK_FALSE(includes[0].interface);
    CHECK(includes[0].place.line == 5);
    CHECK(includes[0].place.column == 13);
    CHECK(includes[0].place.length == 8);
    CHECK(includes[1].name == "surface");
    CHECK(includes[1].interface);
    CHECK(includes[2].name == "c//d.glsl");
}

TEST_CASE("Windows line ends change nothing")
{
    const GlslStage stage =
        stageOf("#version 300 es\r\n#define N \\\r\n 3\r\nuniform float a[N];\r\n");
    REQUIRE(stage.uniforms.size() == 1);
    CHECK(stage.uniforms[0].count == 3);
    CHECK(stage.uniforms[0].place.line == 4);
    CHECK(stage.text.find('\r') == std::string::npos);
}
