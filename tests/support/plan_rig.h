// SPDX-License-Identifier: MIT
// Plans for tests: graphs sketched in a line a pass, and compiling with few words.
#pragma once

#include <crevice/compile.h>

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/support/test_config.h"
#include "tools/show/plan/print.h"

#include <set>
#include <sstream>

namespace crevice {

inline const char* const kFullVertex =
    "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n";

/// A config of fullscreen passes. "blur: ao depth -> smooth" samples ao and depth and writes
/// smooth; what follows a '|' goes into the pass's JSON. Targets are r8 unless `targets` says more.
struct Sketch {
    std::vector<std::string> passes;
    std::map<std::string, std::string> outputs;       ///< Name and target, or JSON.
    std::map<std::string, std::string> targets = {};  ///< Name and JSON.
    std::string extra = {};                           ///< Further keys at the top: "params": {...}
};

inline std::vector<std::string> words(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> result;
    for (std::string word; stream >> word;) result.push_back(word);
    return result;
}

inline Description describe(const Sketch& sketch)
{
    std::map<std::string, std::string> targets = sketch.targets;
    std::vector<std::string> passes, shaders, declared, exported;
    std::vector<TestFile> files = {{"full.vert", kFullVertex}};
    for (const std::string& line : sketch.passes) {
        const auto bar = line.find('|');
        const auto arrow = line.find("->");
        const std::string name = line.substr(0, line.find(':'));
        std::string glsl = "#version 300 es\nprecision highp float;\n";
        for (const auto& read : words(line.substr(name.size() + 1, arrow - name.size() - 1)))
            glsl += "uniform sampler2D " + read + ";\n";
        std::vector<std::string> color;
        for (const auto& target : words(line.substr(arrow + 2, bar - arrow - 2))) {
            glsl += "layout(location = " + std::to_string(color.size()) + ") out vec4 to_" +
                    target + ";\n";
            color.push_back("\"" + target + "\"");
            targets.insert({target, R"({"format": ["r8"]})"});
        }
        files.push_back({name + ".frag", glsl + "void main() {}\n"});
        shaders.push_back("\"" + name + R"(": {"vertex": "full.vert", "fragment": ")" + name +
                          ".frag\"}");
        passes.push_back("\"" + name + R"(": {"shader": ")" + name + "\"" +
                         (color.empty() ? "" : ", \"color\": [" + joined(color) + "]") +
                         (bar == line.npos ? "" : "," + line.substr(bar + 1)) + "}");
    }
    std::string extra = sketch.extra.empty() ? "" : ",\n" + sketch.extra;
    if (joined(passes).find("\"draw\"") != std::string::npos &&
        extra.find("\"draw_list\"") == std::string::npos)
        extra += R"(, "imports": {"scene": {"type": "draw_list"}})";
    for (const auto& [name, json] : targets) declared.push_back("\"" + name + "\": " + json);
    for (const auto& [name, target] : sketch.outputs)
        exported.push_back("\"" + name +
                           "\": " + (target[0] == '{' ? target : "\"" + target + "\""));
    return describe("{\"format\": 1, \"name\": \"sketch\",\n\"targets\": {" + joined(declared) +
                        "},\n\"shaders\": {" + joined(shaders) + "},\n\"passes\": {" +
                        joined(passes) + "},\n\"outputs\": {" + joined(exported) + "}" + extra +
                        "}",
                    files);
}

/// Every format and size that a test may want.
inline DeviceCaps ampleCaps()
{
    DeviceCaps caps = minimumCaps();
    for (bool& each : caps.renderable) each = true;
    for (auto& each : caps.sample_counts) each = 1u << 1 | 1u << 3;  // 2 and 4
    return caps;
}

inline CompileOptions sized(int width = 64, int height = 32)
{
    CompileOptions options;
    options.extent = {width, height};
    return options;
}

inline Result<Plan> tryCompile(const Description& description, const SceneTraits& traits = {})
{
    return compile(description, traits, ampleCaps(), sized());
}

/// The plan; the test fails here when there is none.
inline Plan planOf(const Description& description, const SceneTraits& traits = {},
                   const CompileOptions& options = sized())
{
    return need(compile(description, traits, ampleCaps(), options));
}

inline std::string passNames(const Plan& plan) { return joined(namesOf(plan.passes)); }

inline const PlanAttachment* attachmentOf(const Plan& plan, const std::string& target)
{
    for (const PlanPass& pass : plan.passes) {
        for (const PlanAttachment& color : pass.color)
            if (color.name == target) return &color;
        if (pass.has_depth && pass.depth.name == target) return &pass.depth;
    }
    return nullptr;
}

inline const Elided* elided(const Plan& plan, const std::string& what)
{
    for (const Elided& each : plan.elided)
        if (each.what == what) return &each;
    return nullptr;
}

/// What left it out and why, as "dead_pass: no pass reads it"; empty where nothing did.
inline std::string leftOut(const Plan& plan, const std::string& what)
{
    const Elided* found = elided(plan, what);
    return found ? found->optimization + ": " + found->reason : "";
}

/// What comes of a description: the passes of its plan in their order, or its errors, as
/// "CV2204 /passes/a; CV2201 /passes/b/color/0".
inline std::string outcome(const Description& description, const SceneTraits& traits = {},
                           const CompileOptions& options = sized(),
                           const DeviceCaps& caps = ampleCaps())
{
    const Result<Plan> plan = compile(description, traits, caps, options);
    if (plan) return passNames(*plan);
    std::vector<std::string> errors;
    for (const Diagnostic& each : plan.diagnostics()) {
        CHECK_FALSE((each.message.empty() || each.help.empty()));
        errors.push_back(codeName(each.code) + " " + each.pointer);
    }
    return joined(errors, "; ");
}

/// A sketch and what comes of it.
struct SketchRow {
    const char* what;
    Sketch sketch;
    const char* outcome;
};

inline void checkEach(const std::vector<SketchRow>& rows)
{
    for (const SketchRow& row : rows) {
        INFO(row.what);
        CHECK(outcome(describe(row.sketch)) == row.outcome);
    }
}

/// With an optimization switched off.
inline CompileOptions keeping(const std::string& optimization)
{
    CompileOptions options = sized();
    options.disable = {optimization};
    return options;
}

}  // namespace crevice
