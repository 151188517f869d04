// SPDX-License-Identifier: MIT
// GLSL that no compiler takes is refused without one of the driver's, at its line and with a way
// out.
#include "tools/render/glsl/glsl_check.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_config.h"
#include "tools/show/plan/planning.h"

#include <crevice/shipped.h>

using namespace crevice;

namespace {

constexpr const char* kConfig = R"({"format": 1,
    "imports": {"depth": {"type": "texture"}},
    "params": {"radius": {"type": "float", "default": 0.5, "min": 0, "max": 1},
               "power": {"type": "float", "default": 1, "min": 0, "max": 8}},
    "targets": {"ao": {"format": ["r8"]}, "two": {"format": ["r8"]}},
    "shaders": {"x": {"vertex": "x.vert", "fragment": "x.frag"},
                "y": {"vertex": "x.vert", "fragment": "y.frag"}},
    "passes": {"x": {"type": "fullscreen", "shader": "x", "color": ["ao"]},
               "y": {"type": "fullscreen", "shader": "y", "color": ["two"]}},
    "outputs": {"ao": "ao", "two": "two"}})";

constexpr const char* kVertex =
    "#version 300 es\nout highp vec2 uv;\n"
    "void main() { uv = vec2(gl_VertexID); gl_Position = vec4(uv, 0.0, 1.0); }\n";

constexpr const char* kRight =
    "#version 300 es\nprecision highp float;\n#include \"part.glsl\"\nin vec2 uv;\n"
    "uniform float power;\nlayout(location = 0) out float two;\n"
    "void main() { two = part(uv.x) * power; }\n";

constexpr const char* kPart = "float part(float x)\n{\n    return x;\n}\n";

Diagnostics errorsOf(const std::string& fragment, const std::string& vertex = kVertex,
                     const std::string& part = kPart, const std::string& user = "")
{
    const Description description = describe(kConfig, {{"x.vert", vertex},
                                                       {"x.frag", fragment},
                                                       {"y.frag", kRight},
                                                       {"part.glsl", part},
                                                       {"user.glsl", user}});
    const Result<Plan> plan =
        compile(description, usualTraits(), usualCaps(), {Extent{64, 64}, {}, {}});
    if (!plan) return plan.diagnostics();
    GlslCheck shaders;
    shaders.add(*plan);
    Diagnostics found = shaders.check(description);
    for (const Diagnostic& each : plan.diagnostics())
        if (each.code == Code::preprocessor) found.push_back(each);
    return found;
}

// The body begins in line 9.
std::string shader(const std::string& body)
{
    return "#version 300 es\nprecision highp float;\nuniform highp sampler2D depth;\n"
           "uniform float radius;\nin vec2 uv;\nlayout(location = 0) out float ao;\n"
           "float half_of(vec2 p) { return p.x * 0.5; }\n"
           "float last() { return radius + texture(depth, uv).r; }\n" +
           body;
}

struct Mistake {
    const char* body;
    const char* place;
    const char* cause;
    const char* way_out;
    Code code = Code::shader_compile;
};

const Mistake kMistakes[] = {
    {"void main() {\n  float a = radius\n  ao = a;\n}", "10:19", "';'", "add ';'"},
    {"void main() {\n  float a = radius\n#if 1\n  ao = a;\n#endif\n}", "10:19", "';'", "add ';'"},
    {"struct S { float a; }\nvoid main() { ao = 1.0; }", "9:22", "';'", "add ';'"},
    {"void main() {\n  ao = raduis;\n}", "10:8", "'raduis' is not", "did you mean 'radius'"},
    {"void main() {\n  ao = half_off(uv);\n}", "10:8", "'half_off' is not", "'half_of'"},
    {"void main() {\n  { float hit = 1.0; }\n  ao = hit;\n}", "11:8", "'hit' is not", "block"},
    {"void main() {\n  ao = radius / 5;\n}", "10:15", "float and int", "5.0"},
    {"void main() {\n  uint u = 3;\n}", "10:8", "int, wanted uint", "3u"},
    {"void main() {\n  vec3 v = uv;\n}", "10:8", "vec2, wanted vec3", "vec3"},
    {"void main() {\n  ao = texture(depth, uv);\n}", "10:6", "vec4, wanted float", ".x"},
    {"void main() {\n  ao = texture2D(depth, uv).r;\n}", "10:8", "'texture2D'", "texture("},
    {"varying vec2 other;\nvoid main() {}", "9:1", "'varying'", "out in the vertex"},
    {"void main() {\n  ao = half_of(uv, 1.0);\n}", "10:8", "arguments", "float half_of(vec2 p)"},
    {"void main() {\n  ao = pow(radius, 2);\n}", "10:8", "arguments", "2.0"},
    {"void main() {\n  ao = below(1.0);\n}\nfloat below(float x) { return x; }", "10:8",
     "above its declaration", "float below(float x);"},
    {"twice(float x) { return x; }\nvoid main() {}", "9:1", "no return type", "float twice("},
    {"float f() { ao = 1.0; }\nvoid main() {}", "9:9", "'f' can end without", "return"},
    {"void main() {\n  float a = 1.0;\n  float a = 2.0;\n}", "11:9", "'a' is declared twice", ""},
    {"void main() {\n  uv = vec2(0.0);\n}", "10:6", "'uv' is an input", "copy"},
    {"void main() {\n  ao = radius 2.0;\n}", "10:15", "between 'radius' and '2.0'", "*"},
    {"void main() {\n  if (radius) ao = 1.0;\n}", "10:3", "true or false", "x > 0.0"},
    {"void main() {\n  float input = 1.0;\n}", "10:9", "'input'", "another name"},
    {"void main() {\n  ao = (1.0 + radius;\n}", "10:21", "')'", "add ')'"},
    {"void main() {\n  if (radius > 0.0) {\n    ao = 1.0;\n}", "10:21", "'{'", "add '}'"},
    {"float f() {\n  if (radius > 0.0) {\n  return 1.0;\n}\nvoid main() { ao = f(); }", "10:21",
     "'{'", "add '}'"},
    {"void main() {}\n}", "10:1", "'}' closes nothing", "take it out"},
    {"void f() {}", "9:11", "no function main", "void main()", Code::shader_link},
    {"float f(float x);\nfloat g(float x) { return f(x); }\nfloat f(float x) { return g(x); }\n"
     "void main() { ao = f(1.0); }",
     "9:7", "calls itself", "loop", Code::shader_link},
    {"void main() {\n  ao = power;\n}", "10:8", "'power' is not", "write uniform float power;"},
    {"void main() {\n  ao = texture(two, uv).r;\n}", "10:16", "'two'",
     "uniform highp sampler2D two;"},
    {"void main() {\n  ao = texelFetch(depth, uv, 0).r;\n}", "10:8", "arguments", "ivec2("},
    {"void main() {\n  ao = texture(depth, ivec2(uv)).r;\n}", "10:8", "arguments", "vec2("},
    {"void main() {\n  float w[3] = float[3](1.0, 2.0, 3.0);\n  ao = w[3];\n}", "11:9",
     "'w' has no element 3", "from 0 to 2"},
    {"void main() {\n  ao = uv[2];\n}", "10:10", "'uv' has no element 2", "from 0 to 1"},
    {"float f = 1.0 / radius;\nvoid main() {}", "9:7", "initializer", "in main()"},
    {"float max(float a, float b) { return a; }\nvoid main() {}", "9:27", "'max' is a function",
     "another name"},
    {"int f(isampler2D s) { return 1; }\nvoid main() {}", "9:18", "'isampler2D' has no precision",
     "precision highp isampler2D;"},
    {"void main() {\n  float $x = 1.0;\n}", "10:9", "'$' (U+0024)", "take it out"},
    {"void main() {\n  ao = 2.0 \xC3\x97 uv.x;\n}", "10:12", "'\xC3\x97' (U+00D7)", "take it out"},
    {"void main() {\n  float w[3] = float[](1.0, 2.0);\n}", "10:9", "float[2], wanted float[3]",
     ""},
    {"void main() {\n  if (uv > vec2(1.0)) ao = 1.0;\n}", "10:10", "vec2 and vec2",
     "any(greaterThan(a, b))"},
    {"void main() {\n  if (radius = 0.0) ao = 1.0;\n}", "10:14", "'=' writes", "=="},
    {"void main() {\n  uint u = 1u << 3.0;\n}", "10:15", "uint and float", "whole number"},
    {"void main() {\n  float sum{0.0};\n}", "10:12", "begin with '{'", "sum = "},
    {"void main() {\n  double d = 1.0;\n}", "10:3", "no 'double'", "float"},
    {"noperspective in vec2 p;\nvoid main() {}", "9:1", "no 'noperspective'", "without it"},
    {"void main() {\n  precise float f = 1.0;\n}", "10:3", "no 'precise'", "without it"},
    {"void main() {\n  ao = gl_ClipDistance[0];\n}", "10:8", "no 'gl_ClipDistance'", "discard"},
    {"float radius;\nvoid main() {}", "9:7", "'radius' is declared twice", ""},
    {"void f(out vec2 p) { p = uv; }\nvoid main() {\n  f(vec2(uv));\n}", "11:10", "plain value",
     "variable"},
    {"uniform float power = 0.5;\nvoid main() {}", "9:1", "begins with a value", "default"},
    {"void main() {\n  ao = radius.x;\n}", "10:15", "no 'scalar swizzle'", "x for x.x"},
    {"float f(mediump sampler2D s[2], int i) { return texture(s[i], uv).r; }\nvoid main() {}",
     "9:57", "'variable indexing sampler array'", "constant index"},
    {"void main() {\n  ao = textureGather(depth, uv).x;\n}", "10:8", "'textureGather'",
     "texelFetch"},
    {"void main() {\n  switch (1) {\n    case 1:\n  }\n}", "10:3", "last case", "break;"},
    {"void main() {\n  float w[2] = { 1.0, 2.0 };\n}", "10:16", "style initializers", "float[]("},
    {"void main() {\n  float w[2][2];\n}", "10:9", "arrays of arrays", "w[i * 2 + j]"},
    {"void main() {\n  int n = uv.length();\n}", "10:14", "'.length'", "components"},
    {"void main() {\n  float f(float x);\n}", "10:18", "local function", "outside"},
    {"void main() {}\n;", "10:1", "extraneous semicolon", "no ';'"},
    {"layout(binding = 0) uniform mediump sampler2D two;\nvoid main() {}", "9:8", "'binding'",
     "by name"},
    {"#define GL_MINE 1\nvoid main() {}", "9:1", "begin with GL_", "another name"},
    {"float f() { return 1; }\nvoid main() {}", "9:13", "of the type", "return that type"},
    {"struct A { struct B { float x; } b; };\nvoid main() {}", "9:12", "in another", "above"},
    {"void main(int x) {}", "9:6", "no parameters", "void main()"},
    {"in ivec2 p;\nvoid main() {}", "9:1", "interpolated", "flat"},
    {"void main() {\n  float w[];\n}", "10:9", "no size", "w[3]"},
    {"void main() {\n  ao = textureOffset(depth, uv, ivec2(uv)).r;\n}", "10:42", "constant",
     "coordinate"},
    {"void main() {\n  ao = textureOffset(depth, uv, ivec2(99)).r;\n}", "10:42", "-8 to 7",
     "coordinate"},
    {"void main() {\n  uint u = 0xFFFFFFFFFu;\n}", "10:12", "32 bits", "smaller"},
    {"void main() {\n  int o = 089;\n}", "10:11", "octal", "0"},
    {"#define GLUE(a, b) a##b\nvoid main() { float GLUE(x, y); }", "10:30", "token pasting",
     "whole name"},
    {"float f(mediump float x) { return x; }\nfloat f(highp float x) { return x; }\nvoid main() {}",
     "10:9", "parameters alone", "rename"},
    {"float f(float x) { return x; }\nint f(float x) { return 1; }\nvoid main() {}", "10:5",
     "parameters alone", "rename"},
    {"float f;\nfloat f(float x) { return x; }\nvoid main() {}", "10:7", "'f' is declared twice",
     ""},
    {"void main() {\n  switch (1) {\n    case 1: break;\n    case 1: break;\n  }\n}", "12:5",
     "two cases", "take one"},
    {"#define K 1\n#define K 2\nvoid main() {}", "10:1", "two #defines", "#undef"},
    {"#define SQ(a) ((a) * (a))\nvoid main() {\n  ao = SQ(1.0, 2.0);\n}", "11:8", "arguments",
     "#define"},
    {"void main() {\n  vec2 v = uv;\n  v.xx = uv;\n}", "11:8", "twice", ".xy"},
    {"void main() {\n  break;\n}", "10:3", "in loops", "return;"},
    {"#extension GL_FOO_bar : enable\nvoid main() {}", "9:2", "below code", "#version",
     Code::preprocessor},
    {"#if 1\n#else\n#elif 1\n#endif\nvoid main() {}", "11:2", "#elif after #else", "above",
     Code::preprocessor},
    {"void main() {\n  float w[2000000000];\n}", "10:11", "4096", "shorter", Code::preprocessor},
    {"const int N = 1000000;\nvoid main() {\n  float w[N];\n}", "11:11", "4096", "shorter",
     Code::preprocessor},
    {"#if NEVER\n#endif\nvoid main() {}", "9:5", "'NEVER'", "feature 'never'", Code::preprocessor},
};

std::string numbersOf(const Place& place)
{
    return std::to_string(place.line) + ":" + std::to_string(place.column);
}

}  // namespace

TEST_CASE("Each usual mistake in a shader is one error with its place, its cause and a way out")
{
    if (!warnUnchecked().empty()) return;
    CHECK(errorsOf(shader("void main() { ao = last() + 1e-5 + .5; ao += half_of(uv); }")).empty());
    for (const Mistake& each : kMistakes) {
        const Diagnostics errors = errorsOf(shader(each.body));
        INFO(each.body << "\n" << toText(errors));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].code == each.code);
        CHECK(errors[0].place.source->name == "x.frag");
        CHECK(numbersOf(errors[0].place) == each.place);
        CHECK(errors[0].message.find(each.cause) != std::string::npos);
        CHECK(errors[0].message.find("''") == std::string::npos);
        CHECK(errors[0].help.find(each.way_out) != std::string::npos);
        CHECK(errors[0].pointer.find("/shaders/x") == 0);
    }
}

TEST_CASE("A float without a precision is refused, which some drivers take")
{
    if (!warnUnchecked().empty()) return;
    const Diagnostics errors = errorsOf(
        "#version 300 es\nuniform float radius;\nlayout(location = 0) out mediump float "
        "ao;\nvoid main() { ao = radius; }\n");
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].place.line == 2);
    CHECK(errors[0].help.find("precision highp float;") != std::string::npos);
}

TEST_CASE("A shader that glslang falls over is refused, and so are lines that are nowhere")
{
    if (!warnUnchecked().empty()) return;
    std::string sum = "radius";
    for (int i = 0; i < 100000; ++i) sum += "+uv.x";
    Diagnostics errors = errorsOf(shader("void main() { ao = " + sum + "; }"));
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].place.source->name == "x.frag");
    CHECK_FALSE(errors[0].help.empty());

    errors = errorsOf(shader("#line 7 9\nvoid main() { ao = raduis; }"));
    REQUIRE(errors.size() == 1);
    CHECK(placeName(errors[0].place) == "x.frag");
    CHECK(errors[0].help == "did you mean 'radius'?");
}

TEST_CASE("Stages that do not fit are refused at the input that does not")
{
    if (!warnUnchecked().empty()) return;
    const std::string fragment = shader("void main() { ao = uv.x; }");
    const std::string start = "#version 300 es\n", end = " gl_Position = vec4(1.0); }\n";
    const Diagnostics versions = errorsOf("#version 310" + fragment.substr(12));
    REQUIRE(versions.size() == 1);
    CHECK(versions[0].code == Code::shader_link);
    CHECK(placeName(versions[0].place) == "x.frag");
    for (const std::string& vertex :
         {start + "out highp vec2 vu;\nvoid main() { vu = vec2(1.0);" + end,
          start + "out highp vec3 uv;\nvoid main() { uv = vec3(1.0);" + end,
          start + "flat out highp vec2 uv;\nvoid main() { uv = vec2(1.0);" + end}) {
        Diagnostics errors = errorsOf(fragment, vertex);
        INFO(toText(errors));
        errors.erase(std::remove_if(errors.begin(), errors.end(),
                                    [](const Diagnostic& each) {
                                        return each.place.source->name != "x.frag";
                                    }),
                     errors.end());
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].code == Code::shader_link);
        CHECK(numbersOf(errors[0].place) == "5:9");
        CHECK(errors[0].message.find("'uv'") != std::string::npos);
        CHECK_FALSE(errors[0].help.empty());
    }
}

TEST_CASE("What drivers draw black with, or need not have, is said before one is asked")
{
    const std::string start = "#version 300 es\n", rest = "precision highp float;\nin vec2 uv;\n";
    const Diagnostics whole =
        errorsOf(start + rest + "out uvec4 ao;\nvoid main() { ao = uvec4(1u); }");
    REQUIRE(whole.size() == 1);
    CHECK(whole[0].code == Code::output_mismatch);
    CHECK(placeName(whole[0].place) == "x.frag:4:11");
    CHECK(whole[0].message.find("of format r8") != std::string::npos);
    CHECK(whole[0].help.find("out float ao;") != std::string::npos);

    const Diagnostics other = errorsOf(start + rest +
                                       "uniform mediump isampler2D depth;\n"
                                       "out float ao;\nvoid main() { ao = 1.0; }");
    REQUIRE(other.size() == 1);
    CHECK(placeName(other[0].place) == "x.frag:4:28");
    CHECK(other[0].message.find("isampler2D depth") != std::string::npos);

    const Diagnostics required = errorsOf(start + "#extension GL_EXT_gpu_shader5 : require\n" +
                                          rest + "out float ao;\nvoid main() { ao = uv.x; }");
    REQUIRE(required.size() == 1);
    CHECK(required[0].severity == Severity::warning);
    CHECK(placeName(required[0].place) == "x.frag:2:12");
}

TEST_CASE("A mistake in a file that two shaders include is reported once, in that file")
{
    if (!warnUnchecked().empty()) return;
    const std::string fragment =
        "#version 300 es\nprecision highp float;\n#include \"part.glsl\"\nin vec2 uv;\n"
        "layout(location = 0) out float ao;\nvoid main() { ao = part(uv.y); }\n";
    const Diagnostics errors =
        errorsOf(fragment, kVertex, "\nfloat part(float x)\n{\n    return y;\n}\n");
    REQUIRE(errors.size() == 1);
    CHECK(placeName(errors[0].place) == "part.glsl:4:12");
}

TEST_CASE("A function of a file that a shader does not include names the file")
{
    if (!warnUnchecked().empty()) return;
    const Diagnostics errors = errorsOf(shader("void main() { ao = part(uv.x); }"));
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].help.find("#include \"part.glsl\"") != std::string::npos);

    const std::string user =
        "#version 300 es\nprecision highp float;\n#include \"user.glsl\"\n"
        "layout(location = 0) out float ao;\nvoid main() { ao = user(); }\n";
    const Diagnostics included =
        errorsOf(user, kVertex, kPart, "float user() { return part(1.0); }\n");
    REQUIRE(included.size() == 1);
    CHECK(placeName(included[0].place) == "x.frag:3:11");
    CHECK(placeName(included[0].notes.at(0).place) == "user.glsl:1:23");
}

TEST_CASE("A mistake that one variant or one scene alone compiles is found, and which one is said")
{
    if (!warnUnchecked().empty()) return;
    const TemporaryFolder folder("glsl_check");
    folder.write("x.frag",
                 "#version 300 es\nprecision highp float;\nin vec2 uv;\n"
                 "layout(location = 0) out float ao;\nvoid main()\n{\n    ao = uv.x;\n"
                 "#if STEPS == 4\n    ao = steps;\n#endif\n"
                 "#if CAMERA_ORTHOGRAPHIC\n    ao = width;\n#endif\n}\n");
    const auto errorsOfVariant = [&](const std::string& variant) {
        ConfigOptions options;
        options.config = folder.write("x.json", R"({"format": 1,
            "params": {"steps": {"type": "int", "default": 2, "min": 1, "max": 4,
                                 "bind": "define"}},
            "targets": {"ao": {"format": ["r8"]}},
            "shaders": {"x": {"vertex": "common/fullscreen.vert", "fragment": "./x.frag"}},
            "passes": {"x": {"type": "fullscreen", "shader": "x", "color": ["ao"]}},
            "outputs": {"ao": "ao"}, "variants": {"more": {"params": {"steps": 4}}}})");
        options.variant = variant;
        GlslCheck shaders;
        return toText(planForEveryScene(loadDescription(options, shippedSources()), options.variant,
                                        kUsualExtent, shaders)
                          .diagnostics());
    };
    const std::string base = errorsOfVariant(""), more = errorsOfVariant("more");
    INFO(base << more);
    CHECK(base.find("'steps'") == std::string::npos);
    CHECK(base.find("'width' is not declared") != std::string::npos);
    CHECK(base.find("camera.orthographic 1") != std::string::npos);
    CHECK(more.find("'steps' is not declared") != std::string::npos);
    CHECK(more.find("variant 'more'") != std::string::npos);
}
