// SPDX-License-Identifier: MIT
// The scan: what a stage declares, found without a GL context.
// Driver logs become diagnostics in the author's files.
#include <crevice/glsl_stage.h>

#include "tests/support/need.h"

#include <algorithm>

using namespace crevice;

namespace {

SourceRef textOf(const std::string& name, const std::string& text)
{
    return std::make_shared<SourceText>(SourceText{name, text});
}

Result<GlslStage> scan(const std::string& body, const GlslDefines& defines = {})
{
    return assembleStage({{"main.frag", textOf("main.frag", "#version 300 es\n" + body)}}, {},
                         "main.frag", defines);
}

GlslStage stageOf(const std::string& body, const GlslDefines& defines = {})
{
    return need(scan(body, defines));
}

/// "float radius, vec3 kernel[16]"
std::string uniformsOf(const std::string& body, const GlslDefines& defines = {})
{
    std::string all;
    for (const GlslUniform& uniform : stageOf(body, defines).uniforms) {
        if (!all.empty()) all += ", ";
        all += std::string(glslName(uniform.type)) + " " + uniform.name;
        if (uniform.array) all += "[" + std::to_string(uniform.count) + "]";
    }
    return all;
}

/// Two files: what `main` includes is file 1.
GlslStage twoFiles()
{
    const std::string main =
        "#version 300 es\n#include \"b.glsl\"\nout float x;\nvoid main() {\n"
        "    /* why */ x = foo + foobar;   x = ;\n}\n";
    return need(assembleStage({{"main", textOf("main.frag", main)},
                               {"b.glsl", textOf("b.glsl", "\nfloat f() { return bar; }\n")}},
                              {}, "main", {}));
}

Diagnostics explain(const std::string& log)
{
    return explainLog(twoFiles(), Code::shader_compile, log);
}

/// The only diagnostic, as "file:line:column+length message".
std::string only(const std::string& log)
{
    const Diagnostic one = onlyError(explain(log), Code::shader_compile);
    return placeName(one.place) + "+" + std::to_string(one.place.length) + " " + one.message;
}

}  // namespace

TEST_CASE("every uniform type is known by its GLSL name")
{
    for (const char* name : {"float", "vec2", "vec3", "vec4", "int", "ivec2", "ivec3", "ivec4",
                             "uint", "bool", "mat3", "mat4", "sampler2D"}) {
        CHECK(uniformsOf("uniform " + std::string(name) + " x;\n") == std::string(name) + " x");
        CHECK(glslName(glslTypeFromName(name)) == std::string(name));
    }
    CHECK(uniformsOf("uniform samplerCube x; uniform mat2 y;") == "other x, other y");
    CHECK(isSampler(GlslType::sampler2d));
    CHECK_FALSE(isSampler(GlslType::vec4));
}

TEST_CASE("array sizes may be defines and expressions of them")
{
    CHECK(uniformsOf("uniform vec3 kernel[SAMPLES];", {{"SAMPLES", "64"}}) == "vec3 kernel[64]");
    CHECK(uniformsOf("uniform vec4 x[SAMPLES * 2 + 1];", {{"SAMPLES", "8"}}) == "vec4 x[17]");
    CHECK(uniformsOf("uniform vec4[3] x;") == "vec4 x[3]");
    CHECK(uniformsOf("uniform vec4 x[1];") == "vec4 x[1]");
}

TEST_CASE("only active declarations at the outermost level are seen")
{
    CHECK(uniformsOf("#if 0\nuniform float a;\n#endif\n// uniform float b;\n"
                     "/* uniform float c; */ uniform float d;\n"
                     "void f(in float uniform_like, out vec4 e) { float g; { int h; } }\n"
                     "struct S { float i; };\nuniform S j;\nconst float k = 1.0;\n"
                     "float l[2] = float[2](1.0, 2.0);\nuniform float m;") ==
          "float d, other j, float m");
}

TEST_CASE("a uniform block is found by its name, and its members are no uniforms")
{
    const GlslStage stage =
        stageOf("layout(std140) uniform Camera {\n  mat4 m;\n};\nuniform float x;\n");
    REQUIRE(stage.blocks.size() == 1);
    CHECK(stage.blocks[0].name == "Camera");
    CHECK(stage.blocks[0].place.column == 24);
    REQUIRE(stage.uniforms.size() == 1);
    CHECK(stage.uniforms[0].name == "x");
}

TEST_CASE("outputs have the location that they say, or that of their order")
{
    const GlslStage stage = stageOf(
        "layout(location = 1) out vec4 normal;\n"
        "layout(location = FIRST) out highp vec4 position;\n",
        {{"FIRST", "0"}});
    REQUIRE(stage.outputs.size() == 2);
    CHECK(stage.outputs[0].name == "normal");
    CHECK(stage.outputs[0].location == 1);
    CHECK(stage.outputs[1].location == 0);

    const GlslStage single = stageOf("out float ao;\nin vec2 uv;\n");
    REQUIRE(single.outputs.size() == 1);
    CHECK(single.outputs[0].location == 0);
    CHECK(single.outputs[0].place.line == 2);
}

TEST_CASE("an output that is dropped becomes a variable on its line, with its precision")
{
    const std::string body =
        "layout(location = 1) out mediump vec4 albedo;\n"
        "  highp out float far;\nout vec2 a, b;\n"
        "void f(out float far);\n";
    GlslStage stage = stageOf(body);
    const auto lines = std::count(stage.text.begin(), stage.text.end(), '\n');
    dropOutput(stage, "albedo");
    dropOutput(stage, "far");
    dropOutput(stage, "a");
    dropOutput(stage, "missing");
    CHECK(stage.text.find("\nmediump vec4 albedo;\n") != std::string::npos);
    CHECK(stage.text.find("\n  highp float far;\n") != std::string::npos);
    CHECK(stage.text.find("\nout vec2 a, b;\n") != std::string::npos);
    CHECK(stage.text.find("\nvoid f(out float far);\n") != std::string::npos);
    CHECK(std::count(stage.text.begin(), stage.text.end(), '\n') == lines);
    REQUIRE(stage.outputs.size() == 2);
    CHECK(stage.outputs[0].name == "a");
}

TEST_CASE("text that is no GLSL is left to the driver")
{
    for (const char* body :
         {"uniform", "uniform ;", "uniform float", "uniform float x[2", "layout(", "layout", "out",
          "}}}}", "{{{{", "uniform float 3;", "\"", "\x80\xff"}) {
        INFO(body);
        const Result<GlslStage> stage = scan(body);
        if (stage.ok()) CHECK(stage->text.find(body) != std::string::npos);
    }
}

TEST_CASE("each vendor's error is found at the author's line")
{
    const char* const kLogs[] = {
        "0:5(16): error: `foo' undeclared\n",
        "0(5) : error C1503: undefined variable \"foo\"\n",
        "ERROR: 0:5: 'foo' : undeclared identifier\n",
        "0:5: L0001: Undefined variable 'foo'\n",
        "0:5: error: 'foo' undeclared.\r\n",
        "0:5(3): preprocessor error: 'foo' is bad",
    };
    for (const char* log : kLogs) {
        const std::string found = only(log);
        INFO(found);
        CHECK(found.find("main.frag:5:19+3 ") == 0);
        CHECK(found.find("foo") != std::string::npos);
        CHECK(found.find("rror:") == std::string::npos);
        CHECK(found.back() != '.');
    }
    CHECK(only(kLogs[1]) == "main.frag:5:19+3 'foo' is not declared");
}

TEST_CASE("an error in an included file is found there, whichever source string the driver gives")
{
    const std::string text = twoFiles().text;
    CHECK(text.find("#line 100001 1\n") != std::string::npos);
    for (const char* log :
         {"0:100002(20): error: `bar' undeclared", "1:100002(20): error: `bar' undeclared",
          "1(100002) : error C1503: undefined variable \"bar\"",
          "ERROR: 1:100002: 'bar' : undeclared identifier"})
        CHECK(only(log).find("b.glsl:2:20+3 ") == 0);
}

TEST_CASE("a driver's warning stays a warning")
{
    for (const char* log : {"0:5(16): warning: `foo' used uninitialized",
                            "0(5) : warning C7050: \"foo\"", "WARNING: 0:5: 'foo' : unused"})
        CHECK(onlyWarning(explain(log), Code::shader_compile).place.line == 5);
}

TEST_CASE("each message of a log is a diagnostic, and what Mesa indents belongs to the one before")
{
    const Diagnostics diagnostics = explain(
        "0:5(1): error: no matching function for call to `g(int)'; candidates are:\n"
        "0:5(1): error:    float g(float)\n"
        "0:5(1): error:    float g(vec2)\n"
        "0:3(1): error: second\n");
    REQUIRE(diagnostics.size() == 2);
    CHECK(diagnostics[0].message ==
          "no matching function for call to `g(int)'; candidates are: "
          "float g(float); float g(vec2)");
    CHECK(diagnostics[1].message == "second");
    CHECK(diagnostics[1].place.line == 3);
}

TEST_CASE("places that are not in the text do no harm")
{
    CHECK(only("7:3: error: odd").find("main.frag+1 odd") == 0);
    CHECK(only("0:999: error: odd").find("main.frag:999+1 odd") == 0);
    CHECK(only("0:0: error: odd").find("main.frag+1 odd") == 0);
    CHECK(only("0:2147483647(2147483647): error: 'odd'").find("main.frag") == 0);
    CHECK(explainLog({}, Code::shader_link, "0:5: error: odd").size() == 1);
    for (const char* log : {"0", "0:", "0:5", "0(5", "0(5)", "error", "error:", ":", "'", "0:5(1)"})
        CHECK(explain(log).size() == 1);
}
