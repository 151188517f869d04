// SPDX-License-Identifier: MIT
// Fusion of shader texts: what the one text says, and which two stay two.
#include "core/glsl_fuse.h"

#include "tests/catch.h"

using namespace crevice;

namespace {

GlslStage stageOf(const std::string& name, const std::string& body, const GlslDefines& defines = {})
{
    const auto source =
        std::make_shared<SourceText>(SourceText{name, "#version 300 es\nprecision highp float;\n" + body});
    const Result<GlslStage> stage = assembleStage({{name, source}}, {}, name, defines);
    INFO(toText(stage.diagnostics()));
    REQUIRE(stage.ok());
    return *stage;
}

const std::string kWriter =
    "uniform mediump sampler2D ao;\nuniform float power;\nin vec2 uv;\nout float bent;\n"
    "void main() { bent = pow(texture(ao, uv).r, power); }\n";
const std::string kReader =
    "uniform highp sampler2D visibility;\nin vec2 uv;\nout vec4 color;\n"
    "void main() { color = texture(visibility, uv).rrrr; }\n";
const GlslSeam kSeam = {"bend", "visibility", "uv", 1, "v"};

std::optional<GlslStage> fused(const std::string& writer, const std::string& reader = kReader,
                               const GlslSeam& seam = kSeam)
{
    return fuse(stageOf("bend.frag", writer), stageOf("light.frag", reader), seam);
}

/// The writer with one text in place of another, which it must have.
std::string but(std::string text, const std::string& old, const std::string& fresh)
{
    REQUIRE(text.find(old) != text.npos);
    return text.replace(text.find(old), old.size(), fresh);
}

bool has(const GlslStage& stage, const std::string& text) { return stage.text.find(text) != stage.text.npos; }

std::string uniformsOf(const GlslStage& stage)
{
    std::string names;
    for (const GlslUniform& each : stage.uniforms) names += each.name + " ";
    return names;
}

}  // namespace

TEST_CASE("Fused, the reader calls the writer where it sampled, each at its author's lines")
{
    const auto both = fused(kWriter);
    REQUIRE(both);
    CHECK(both->text ==
          "#version 300 es\n#line 2 0\nprecision highp float;\nuniform mediump sampler2D ao;\n"
          "uniform float power;\nin vec2 uv;\nfloat fused_bend_bent;\n"
          "void fused_bend_main() { fused_bend_bent = pow(texture(ao, uv).r, power); }\n"
          "highp vec4 fused_bend_stored()\n"
          "{ fused_bend_main(); highp vec4 v = vec4(fused_bend_bent, 0.0, 0.0, 1.0); return v; }\n"
          "#line 100002 1\nprecision highp float;\n\n\nout vec4 color;\n"
          "void main() { color = fused_bend_stored() .rrrr; }\n");
    CHECK(uniformsOf(*both) == "ao power ");
    REQUIRE(both->outputs.size() == 1);
    CHECK(both->outputs[0].name == "color");
    REQUIRE(both->files.size() == 2);
    CHECK(both->files[1]->name == "light.frag");
}

TEST_CASE("A driver's message about fused text leads to the line of either author")
{
    const auto both = fused(kWriter);
    REQUIRE(both);
    const Diagnostics errors = explainLog(*both, Code::shader_compile, "0:7(3): error: a\n1:100006(3): error: b\n");
    REQUIRE(errors.size() == 2);
    CHECK(errors[0].place.source->name == "bend.frag");
    CHECK(errors[0].place.line == 7);
    CHECK(errors[1].place.source->name == "light.frag");
    CHECK(errors[1].place.line == 6);
}

TEST_CASE("What both declare alike is declared once, and all else of the writer gets its own name")
{
    const std::string writer =
        "struct Pair { float power; float kHalf; };\nconst float kHalf = 0.5, kOne = 1.0;\n"
        "uniform highp sampler2D depth;\nuniform float power;\nin vec2 uv;\n"
        "float open(float x) { Pair p; p.power = power; p.kHalf = kHalf * kOne; return x * p.power * p.kHalf; }\n"
        "out vec2 bent;\nvoid main() { bent = vec2(open(texture(depth, uv).x)); }\n";
    const std::string reader =
        "uniform highp sampler2D depth;\nuniform highp sampler2D visibility;\nuniform float power;\nin vec2 uv;\n"
        "const float kHalf = 0.25;\nfloat open(float x) { return kHalf * x; }\nout vec4 color;\n"
        "void main() { color = vec4(open(texture(depth, uv).x) * power * texture(visibility, uv).g); }\n";
    const auto both = fused(writer, reader, {"bend", "visibility", "uv", 2, "v"});
    REQUIRE(both);
    CHECK(has(*both, "struct fused_bend_Pair { float power; float kHalf; };"));
    CHECK(has(*both, "const float fused_bend_kHalf = 0.5, fused_bend_kOne = 1.0;"));
    CHECK(has(*both, "float fused_bend_open(float x) { fused_bend_Pair p; p.power = power; "
                     "p.kHalf = fused_bend_kHalf * fused_bend_kOne; return x * p.power * p.kHalf; }"));
    CHECK(has(*both, "vec4(fused_bend_bent.x, fused_bend_bent.y, 0.0, 1.0)"));
    CHECK(has(*both, "const float kHalf = 0.25;"));
    CHECK(uniformsOf(*both) == "depth power ");
}

TEST_CASE("Conditions are resolved and macros expanded before two texts become one")
{
    const auto writer = stageOf("bend.frag", "uniform highp sampler2D ao;\nin vec2 uv;\nout float bent;\n#if TWICE\n"
                                "#define BY x += 2.0\n#else\n#define BY x += 1.0\n#endif\n"
                                "void main() { float x = texture(ao, uv).r; BY; bent = x; }\n", {{"TWICE", "1"}});
    const auto both = fuse(writer, stageOf("light.frag", kReader, {{"TWICE", "0"}}), kSeam);
    REQUIRE(both);
    CHECK(has(*both, "x += 2.0 ; fused_bend_bent = x;"));
    CHECK_FALSE(has(*both, "BY"));
    CHECK(both->defines_used == std::vector<std::string>{"TWICE"});
}

TEST_CASE("A reader may fetch the texel at its place in the window instead")
{
    CHECK(fused(kWriter, but(kReader, "texture(visibility, uv)",
                             "texelFetch(visibility, ivec2(gl_FragCoord.xy), 0)"),
                {"bend", "visibility", "", 1, "v"}));
    CHECK_FALSE(fused(kWriter, kReader, {"bend", "visibility", "", 1, "v"}));
}

TEST_CASE("A reader may take in one writer after another, and what one of them reads")
{
    const auto first = fused(but(kWriter, "mediump sampler2D", "highp sampler2D"));
    REQUIRE(first);
    const auto join = stageOf("join.frag", "uniform highp sampler2D a;\nuniform highp sampler2D b;\nin vec2 uv;\n"
                                           "out float least;\n"
                                           "void main() { least = min(texture(a, uv).r, texture(b, uv).r); }\n");
    const auto both = fuse(join, *first, {"join", "ao", "uv", 1, "v"});
    REQUIRE(both);
    CHECK(has(*both, "fused_bend_bent = pow(fused_join_stored() .r, power);"));
    CHECK(uniformsOf(*both) == "a b power ");
    CHECK(both->files.size() == 3);
}

TEST_CASE("A reader that samples elsewhere, again, or rounded stays as it is")
{
    const char* const sampled = "texture(visibility, uv)";
    for (const char* other : {"texture(visibility, uv + 0.5)", "texture(visibility, 0.5 * uv)",
                              "textureLod(visibility, uv, 0.0)", "texelFetch(visibility, ivec2(uv), 0)",
                              "(texture(visibility, uv) + texture(visibility, uv))"}) {
        INFO(other);
        CHECK_FALSE(fused(kWriter, but(kReader, sampled, other)));
    }
    CHECK_FALSE(fused(kWriter, but(kReader, "highp sampler2D", "mediump sampler2D")));
    CHECK_FALSE(fused(kWriter, but(kReader, "highp sampler2D", "sampler2D")));
    CHECK_FALSE(fused(kWriter, but(kReader, "void main() {", "vec4 at(vec2 uv) { return texture(visibility, uv); }\n"
                                   "void main() { color = at(uv * 0.5);} void other() {")));
}

TEST_CASE("A writer that looks about itself, or whose pixels hang on more than textures, stays as it is")
{
    const char* const body = "bent = pow(texture(ao, uv).r, power);";
    for (const char* other :
         {"bent = texture(ao, uv).r + texture(ao, uv + 0.1).r;",
          "bent = 0.0; for (int i = 0; i < 2; ++i) bent += power;",
          "if (uv.x > 0.5) discard; bent = 1.0;", "bent = dFdx(texture(ao, uv).r);"}) {
        INFO(other);
        CHECK_FALSE(fused(but(kWriter, body, other)));
    }
    CHECK_FALSE(fused(but(kWriter, "out float bent;", "out float bent;\nfloat sum = 0.0;")));
    CHECK_FALSE(fused(but(kWriter, "out float bent;", "layout(location = 0) out float bent;\n"
                                                      "layout(location = 1) out float more;")));
}

TEST_CASE("Fetches count through the functions that make them")
{
    const std::string through = "float at(vec2 p) { return texture(ao, p).r; }\n"
                                "float both() { return at(uv) + at(0.5 * uv); }\n";
    CHECK(fused(but(kWriter, "void main()", through + "void main()")));  // that nobody calls
    CHECK_FALSE(fused(but(but(kWriter, "void main()", through + "void main()"), "texture(ao, uv).r", "both()")));
}

TEST_CASE("Names that stand for two things keep two passes")
{
    CHECK_FALSE(fused(but(kWriter, "uniform float power;", "uniform vec2 power;"),
                      but(kReader, "in vec2 uv;", "in vec2 uv;\nuniform float power;")));
    CHECK_FALSE(fused(but(kWriter, "uniform float power;", "uniform mediump float power;"),
                      but(kReader, "in vec2 uv;", "in vec2 uv;\nuniform float power;")));
    CHECK_FALSE(fused(kWriter, but(kReader, "in vec2 uv;", "in vec2 uv;\nconst float power = 2.0;")));
    CHECK_FALSE(fused(kWriter, but(kReader, "in vec2 uv;", "in vec2 uv;\nconst float fused_bend_x = 2.0;")));
    CHECK_FALSE(fused(kWriter, kReader, {"bend_", "visibility", "uv", 1, "v"}));
    CHECK_FALSE(fused(kWriter, kReader, {"bend", "visibility", "uv", 2, "v"}));  // a float fills no two channels
}

TEST_CASE("Text of no known form is left alone")
{
    CHECK_FALSE(fused("precision highp int;\n" + kWriter));
    CHECK_FALSE(fused("#extension GL_OES_standard_derivatives : enable\n" + kWriter));
    CHECK_FALSE(fused(kWriter + "void open() {"));
    CHECK_FALSE(fused(kWriter + "= 3;\n"));
    CHECK_FALSE(fused(kWriter, kReader + "struct {"));
}

TEST_CASE("An output of a vertex stage spans the picture where its position is made of it at the end")
{
    const auto spanning = [](const std::string& body) {
        return spanningOutput(stageOf("full.vert", "out highp vec2 uv;\n" + body));
    };
    const std::string assign = "uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);";
    const std::string position = "gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);";
    CHECK(spanning("void main() { " + assign + " " + position + " }") == "uv");
    CHECK(spanning("void main() { " + position + " " + assign + " }").empty());
    CHECK(spanning("void main() { " + assign + " if (uv.x > 0.5) " + position + " }").empty());
    CHECK(spanning("void main() { vec2 uv = vec2(0.0); " + position + " }").empty());
    CHECK(spanning("void main() { gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 2.0); }").empty());
    CHECK(spanning("void main() {}").empty());
}
