// SPDX-License-Identifier: MIT
// The scan: what a stage declares, found without a GL context.
#include <crevice/glsl_stage.h>

#include "tests/support/catch.h"

#include <algorithm>

using namespace crevice;

namespace {

Result<GlslStage> scan(const std::string& body, const GlslDefines& defines = {})
{
    const SourceRef source =
        std::make_shared<SourceText>(SourceText{"main.frag", "#version 300 es\n" + body});
    return assembleStage({{"main.frag", source}}, {}, "main.frag", defines);
}

GlslStage stageOf(const std::string& body, const GlslDefines& defines = {})
{
    Result<GlslStage> stage = scan(body, defines);
    INFO(toText(stage.diagnostics()));
    REQUIRE(stage.ok());
    return *stage;
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
