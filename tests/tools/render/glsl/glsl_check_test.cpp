// SPDX-License-Identifier: MIT
// GLSL that no compiler takes is refused without one of the driver's, at its line and with a way
// out.
#include "tools/render/glsl/glsl_check.h"

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_config.h"
#include "tools/show/plan/planning.h"

#include <sstream>

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
    std::string begin, cause, way_out, body;
};

/// Those of tests/data/mistakes.glsl.txt.
std::vector<Mistake> mistakes()
{
    std::vector<Mistake> all;
    std::istringstream lines(readFile(CREVICE_SOURCE_DIR "/tests/data/mistakes.glsl.txt")->text);
    for (std::string line; std::getline(lines, line);)
        if (startsWith(line, "--- ")) {
            const std::size_t cause = line.find(" | "), way_out = line.find(" | ", cause + 1);
            all.push_back({"x.frag:" + line.substr(4, cause - 4),
                           line.substr(cause + 3, way_out - cause - 3), line.substr(way_out + 3),
                           ""});
        } else if (!all.empty()) {
            all.back().body += line + "\n";
        }
    return all;
}

}  // namespace

TEST_CASE("Each usual mistake in a shader is one error with its place, its cause and a way out")
{
    if (!warnUnchecked().empty()) return;
    CHECK(errorsOf(shader("void main() { ao = last() + 1e-5 + .5; ao += half_of(uv); }")).empty());
    for (const Mistake& each : mistakes()) {
        const bool whole = startsWith(each.body, "#version");
        const Diagnostics errors = errorsOf(whole ? each.body : shader(each.body));
        INFO(each.begin << "\n" << each.body << "\n" << toText(errors));
        REQUIRE(errors.size() == 1);
        CHECK(startsWith(toText(errors), each.begin));
        CHECK(errors[0].message.find(each.cause) != std::string::npos);
        CHECK(errors[0].message.find("''") == std::string::npos);
        CHECK(errors[0].help.find(each.way_out) != std::string::npos);
    }
}

TEST_CASE("An output that nothing writes is warned of at its declaration")
{
    const Description description =
        describe(kConfig, {{"x.vert", kVertex},
                           {"x.frag", shader("void main() { ao == 1.0; }")},
                           {"y.frag", kRight},
                           {"part.glsl", kPart}});
    GlslCheck shaders;
    const Result<Plan> plan = planForEveryScene(description, "", kUsualExtent, shaders);
    CHECK(placeName(onlyWarning(plan, Code::output_mismatch).place) == "x.frag:6:32");
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
        eraseIf(errors, [](const Diagnostic& each) { return each.place.source->name != "x.frag"; });
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].code == Code::shader_link);
        CHECK(placeName(errors[0].place) == "x.frag:5:9");
        CHECK(errors[0].message.find("'uv'") != std::string::npos);
        CHECK_FALSE(errors[0].help.empty());
    }
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
