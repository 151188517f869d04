// SPDX-License-Identifier: MIT
// Passes that a plan makes one, and those that it must not.
#include "tests/plan_rig.h"

#include "core/numbers.h"

using namespace crevice;

namespace {

/// A pass of a chain: it samples `reads` at its own pixel and draws their least.
struct Link {
    std::string name;
    std::vector<std::string> reads;
    std::string writes;
    std::string keys = {};   ///< Further JSON of the pass.
    std::string glsl = {};   ///< Further GLSL at the top.
};

std::string fragmentOf(const Link& link)
{
    std::string text = "#version 300 es\nprecision highp float;\n" + link.glsl + "in vec2 uv;\nout vec4 to_" +
                       link.writes + ";\n";
    std::string least = "vec4(1.0)";
    for (const std::string& read : link.reads) {
        text += "uniform highp sampler2D " + read + ";\n";
        least = "min(" + least + ", texture(" + read + ", uv))";
    }
    return text + "void main() { to_" + link.writes + " = " + least + "; }\n";
}

Description chain(const std::vector<Link>& links, const std::string& outputs,
                  const std::map<std::string, std::string>& targets = {}, const std::string& extra = "")
{
    std::vector<TestFile> files = {{"full.vert", "#version 300 es\nout vec2 uv;\nvoid main() {\n"
                                                 "    uv = vec2(gl_VertexID & 2, gl_VertexID & 1);\n"
                                                 "    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);\n}\n"}};
    std::vector<std::string> declared, shaders, passes;
    for (const auto& [name, reads, writes, keys, glsl] : links) {
        const auto target = targets.find(writes);
        const std::string named = "\"" + name + "\": ";
        files.push_back({name + ".frag", fragmentOf({name, reads, writes, keys, glsl})});
        declared.push_back("\"" + writes + "\": " +
                           (target == targets.end() ? R"({"format": ["r8"]})" : target->second));
        shaders.push_back(named + R"({"vertex": "full.vert", "fragment": ")" + name + ".frag\"}");
        passes.push_back(named + R"({"type": "fullscreen", "shader": ")" + name + R"(", "color": [")" + writes +
                         "\"]" + (keys.empty() ? "" : ", " + keys) + "}");
    }
    return describe(R"({"format": 1, "name": "chain", "targets": {)" + joined(declared) + "}, \"shaders\": {" +
                        joined(shaders) + "}, \"passes\": {" + joined(passes) + "}, \"outputs\": {" + outputs +
                        "}" + (extra.empty() ? "" : ", " + extra) + "}",
                    files);
}

const std::string kColor = R"("color": "lit")";
const std::string kBlended = R"("state": {"blend": "add"})";  // never one with another

Description three(const std::string& keys = "", const std::map<std::string, std::string>& targets = {},
                  const std::string& outputs = kColor)
{
    return chain({{"ssao", {}, "ao"}, {"bend", {"ao"}, "bent", keys}, {"light", {"bent"}, "lit"}}, outputs, targets);
}

CompileOptions keeping(const std::string& rule)
{
    CompileOptions options = sized();
    options.keep = {rule};
    return options;
}

}  // namespace

TEST_CASE("A chain of passes that read their own pixel is one pass, with nothing between")
{
    const Plan plan = planOf(three());
    CHECK(passNames(plan) == "light");
    REQUIRE(plan.programs.size() == 1);
    CHECK(plan.programs[0].label == "light with bend and ssao");
    CHECK(namesOf(plan.targets) == std::vector<std::string>{"lit"});
    const LeftOut* left = leftOut(plan, "target bent");
    REQUIRE(left);
    CHECK(left->rule == "fusion");
    CHECK(left->reason == "pass light finds it as pass bend would, where it samples it");
    CHECK(left->bytes == 2 * 64 * 32);
    CHECK(left->texture_bytes == 64 * 32);
}

TEST_CASE("The rule can be switched off")
{
    for (const char* rule : {"fusion", "all"})
        CHECK(passNames(planOf(three(), {}, keeping(rule))) == "ssao, bend, light");
}

TEST_CASE("The pass at the end reads what those that it takes in read")
{
    const Plan plan = planOf(chain({{"ssao", {}, "ao", kBlended},
                                    {"baked", {}, "map", kBlended},
                                    {"join", {"ao", "map"}, "joined"},
                                    {"light", {"joined", "map"}, "lit"}},
                                   kColor));
    CHECK(passNames(plan) == "ssao, baked, light");
    std::vector<std::string> samplers;
    for (const PlanInput& input : plan.passes[2].inputs) samplers.push_back(input.sampler);
    CHECK(samplers == std::vector<std::string>{"ao", "map"});
    CHECK(plan.targets[plan.passes[2].inputs[0].index].last_pass == 2);
}

TEST_CASE("A target that someone else wants too stays")
{
    const auto names = [](const std::vector<Link>& links, const std::string& outputs,
                          const std::map<std::string, std::string>& targets = {}) {
        return passNames(planOf(chain(links, outputs, targets)));
    };
    CHECK(passNames(planOf(three("", {}, R"("color": "lit", "ao": "bent")"))) == "bend, light");
    CHECK(names({{"ssao", {}, "ao"}, {"a", {"ao"}, "x", kBlended}, {"light", {"ao", "x"}, "lit"}}, kColor) ==
          "ssao, a, light");
    CHECK(names({{"ssao", {}, "ao"}, {"mean", {"ao", "ao_history"}, "bent"}, {"light", {"ao"}, "lit"}},
                R"("color": "lit", "mean": "bent")", {{"ao", R"({"format": ["r8"], "history": true})"}}) ==
          "ssao, mean, light");
}

TEST_CASE("Where passes differ in what surrounds their shaders they stay two")
{
    const std::string all = "ssao, bend, light";
    const auto names = [](const std::string& keys, const std::map<std::string, std::string>& targets = {}) {
        return passNames(planOf(three(keys, targets)));
    };
    CHECK(names(kBlended) == all);
    CHECK(names(R"("state": {"cull": "back"})") == all);
    CHECK(names(R"("inputs": {"ao": {"filter": "linear"}})") == "ssao, light");
    CHECK(names("", {{"bent", R"({"format": ["r8"], "size": {"scale": 0.5}})"}}) == all);
    CHECK(names("", {{"bent", R"({"format": ["r11g11b10f"]})"}}) == "bend, light");
    CHECK(names("", {{"bent", R"({"format": ["rgb10_a2"]})"}}) == "bend, light");
    CHECK(names("", {{"bent", R"({"format": ["r16f"]})"}}) == "bend, light");
    CHECK(names("", {{"bent", R"({"format": ["r32f"]})"}}) == "light");
    CHECK(names("", {{"bent", R"({"format": ["r8"], "samples": 4})"}}) == all);
}

TEST_CASE("No param's value decides: it would compile shaders")
{
    const auto names = [](const std::string& bend, const std::string& side, float strength) {
        return passNames(planOf(chain({{"ssao", {}, "ao", kBlended}, {"bend", {"ao"}, "bent", bend},
                                       {"side", {"bent"}, "more", side}, {"light", {"bent", "more"}, "lit"}},
                                      kColor, {},
                                      R"("params": {"strength": {"default": )" + shortest(strength) + "}}")));
    };
    const std::string known = R"("identity": {"strength": {"at": 0, "gives": {"more": 1}}})";
    CHECK(names("", known, 1) == "ssao, bend, side, light");
    CHECK(names("", known, 0) == "ssao, bend, light");  // side might read it again

    const std::string passes = R"("identity": {"strength": {"at": 0, "gives": {"bent": "ao"}}})";
    const auto alone = [&](float strength) {
        return passNames(planOf(chain({{"ssao", {}, "ao"}, {"bend", {"ao"}, "bent", passes}, {"light", {"bent"}, "lit"}},
                                      kColor, {},
                                      R"("params": {"strength": {"default": )" + shortest(strength) + "}}")));
    };
    CHECK(alone(1) == "ssao, bend, light");
    CHECK(alone(0) == "ssao, light");
}

TEST_CASE("A uniform that the reader takes from elsewhere keeps two passes")
{
    const std::string uniform = "uniform float power;\n";
    const auto plan = [&](const std::string& keys) {
        return passNames(planOf(chain(
            {{"bend", {}, "bent", "", uniform}, {"light", {"bent"}, "lit", keys, uniform}}, kColor, {},
            R"("params": {"power": {"default": 1}, "gain": {"default": 1}})")));
    };
    CHECK(plan("") == "light");
    CHECK(plan(R"("uniforms": {"power": "gain"})") == "bend, light");
}

TEST_CASE("One texture that the two sample differently keeps two passes, by default or by what they say")
{
    const auto names = [](const std::string& bend, const std::string& light) {
        return passNames(planOf(chain({{"bend", {"noise"}, "bent", bend}, {"light", {"noise", "bent"}, "lit", light}},
                                      kColor, {},
                                      R"("generated": {"noise": {"generator": "rotation_noise", "count": 4}})")));
    };
    const std::string clamped = R"("inputs": {"noise": {"wrap": "clamp"}})";  // repeats otherwise
    CHECK(names("", "") == "light");
    CHECK(names(clamped, clamped) == "light");
    CHECK(names("", clamped) == "bend, light");
    CHECK(names(clamped, "") == "bend, light");
}

TEST_CASE("More textures than a device takes keep two passes")
{
    DeviceCaps caps = ampleCaps();
    caps.max_texture_units = 2;
    std::vector<Link> links;
    for (const char* name : {"a", "b", "c"})
        links.push_back({name, {}, std::string("to_") + name, kBlended});
    links.push_back({"join", {"to_a", "to_b"}, "joined"});
    links.push_back({"light", {"joined", "to_c"}, "lit"});
    const Description description = chain(links, kColor);
    CHECK(passNames(*compile(description, {}, caps, sized())) == "a, b, c, join, light");
    caps.max_texture_units = 3;
    CHECK(passNames(*compile(description, {}, caps, sized())) == "a, b, c, light");
}
