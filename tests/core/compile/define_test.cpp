// SPDX-License-Identifier: MIT
// Defines that shaders see, and programs that passes share.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

// The fragment text of a pass whose shader mentions `names`.
std::string textWith(const std::string& names, const std::string& extra = "",
                     const SceneTraits& traits = {}, const std::string& defines = "{}")
{
    std::string mentions;
    for (const std::string& name : words(names)) mentions += "#ifdef " + name + "\n#endif\n";
    const Plan plan = planOf(
        describe(R"({"format": 1, "targets": {"x": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "v", "fragment": "f", "defines": )" +
                     defines + R"(}},
        "passes": {"p": {"shader": "s", "color": "x"}}, "outputs": {"x": "x"})" +
                     (extra.empty() ? "" : ", " + extra) + "}",
                 {{"v", kFullVertex},
                  {"f", "#version 300 es\n" + mentions + "out highp vec4 c;\nvoid main() {}\n"}}),
        traits);
    return plan.programs.at(0).fragment.text;
}

bool defines(const std::string& text, const std::string& what)
{
    return text.find("#define " + what + "\n") != text.npos;
}

}  // namespace

TEST_CASE("A param bound as a define reaches GLSL as a literal of its type")
{
    const auto value = [](const std::string& json) {
        const std::string text = textWith("SIZE", "\"params\": {\"size\": " + json + "}");
        const auto start = text.find("#define SIZE ") + 13;
        return text.substr(start, text.find('\n', start) - start);
    };
    CHECK(value(R"({"type": "int", "default": 64, "bind": "define"})") == "64");
    CHECK(value(R"({"type": "int", "default": -3, "bind": "define"})") == "-3");
    CHECK(value(R"({"type": "int", "default": 1000000, "bind": "define"})") == "1000000");
    CHECK(value(R"({"default": 0.5, "bind": "define"})") == "0.5");
    CHECK(value(R"({"default": 2, "bind": "define"})") == "2.0");
    CHECK(value(R"({"default": 1e-9, "bind": "define"})") == "1e-09");
    CHECK(value(R"({"default": 100000000, "bind": "define"})") == "1e+08");
}

TEST_CASE("Shaders that ask get the resolution of a texture")
{
    const auto step = [](const std::string& format) {
        return textWith("DEPTH_STEP", R"("imports": {"depth": {"type": "texture")" + format + "}}");
    };
    CHECK(defines(textWith("X_STEP"), "X_STEP vec2(3.922e-03, 0.000e+00)"));  // r8: 1 in 255
    CHECK(defines(step(R"(, "format": "depth16")"), "DEPTH_STEP vec2(1.526e-05, 0.000e+00)"));
    CHECK(defines(step(R"(, "format": "r16f")"), "DEPTH_STEP vec2(5.960e-08, 9.766e-04)"));
    CHECK(defines(step(""), "DEPTH_STEP vec2(5.960e-08, 0.000e+00)"));  // as depth24
}

TEST_CASE("A shader's own defines win")
{
    CHECK(defines(
        textWith("SOFT", R"("features": {"soft": {"type": "bool"}})", {}, R"({"SOFT": "7"})"),
        "SOFT 7"));
}

TEST_CASE("Passes whose text is the same share a program, others do not")
{
    const auto programs = [](const std::string& first, const std::string& second) {
        return planOf(describe(R"({"format": 1, "features": {"soft": {"type": "bool"}},
            "targets": {"x": {"format": ["r8"]}, "y": {"format": ["r8"]}},
            "shaders": {"s": {"vertex": "v", "fragment": "f", "defines": )" +
                                   first + R"(},
                        "t": {"vertex": "v", "fragment": "f", "defines": )" +
                                   second + R"(}},
            "passes": {"a": {"shader": "s", "color": "x"}, "b": {"shader": "t", "color": "y"}},
            "outputs": {"x": "x", "y": "y"}})",
                               {{"v", kFullVertex},
                                {"f",
                                 "#version 300 es\n#if AXIS\n#endif\nout highp vec4 c;\nvoid "
                                 "main() {}\n"}}))
            .programs;
    };
    CHECK(programs(R"({"AXIS": 0})", R"({"AXIS": 1})").size() == 2);
    CHECK(programs(R"({"AXIS": 1, "UNUSED": 2})", R"({"AXIS": 1})").size() == 1);
    const auto same = programs(R"({"AXIS": 0})", R"({"AXIS": 0})");
    REQUIRE(same.size() == 1);
    CHECK(same[0].label == "s");
    CHECK(same[0].pointer == "/shaders/s");
    CHECK(same[0].key.size() == 16);
    CHECK(same[0].key.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(same[0].key != programs(R"({"AXIS": 1})", R"({"AXIS": 1})")[0].key);
}
