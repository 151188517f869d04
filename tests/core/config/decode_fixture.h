// SPDX-License-Identifier: MIT
// A small valid config whose sections a test replaces, and its errors as one line of text.
#pragma once

#include <crevice/config.h>

#include "tests/support/need.h"

namespace crevice {

using Sections = std::map<std::string, std::string>;

/// Sources with the GLSL files that the base config names.
inline MemorySources glslSources()
{
    MemorySources sources;
    sources.add("common/fullscreen.vert", "void main() {}\n");
    sources.add("common/view.glsl", "float view() { return 1.0; }\n");
    sources.add("ssao/ao.frag",
                "#version 300 es\n#include \"common/view.glsl\"\n#include <surface>\n");
    sources.add("geometry/a.surface.glsl", "#include \"./normal.glsl\"\n");
    sources.add("geometry/normal.glsl", "// normals\n");
    sources.add("geometry/shaders/mesh.vert", "void main() {}\n");
    return sources;
}

/// The base config with some sections replaced, added, or (by an empty text) left out.
inline std::string configText(const Sections& replaced)
{
    Sections sections = {
        {"format", "1"},
        {"params", R"({"radius": {"default": 0.5, "min": 0, "max": 10},
                       "samples": {"type": "int", "default": 16, "min": 1, "max": 64}})"},
        {"features", R"({"fast": {"type": "bool"},
                         "check": {"type": "enum", "values": ["hard", "smooth"]}})"},
        {"imports", R"({"camera": {"type": "camera"}, "photo": {"type": "texture"}})"},
        {"generated", R"({"kernel": {"generator": "sphere_kernel", "count": "samples"},
                          "noise": {"generator": "rotation_noise", "count": 4}})"},
        {"targets", R"({"depth": {"format": "depth24"}, "ao": {"format": ["r8", "rgba8"]},
                        "ao_filtered": {"format": ["r8"], "size": {"of": "ao"}}})"},
        {"shaders", R"({"ao": {"vertex": "common/fullscreen.vert", "fragment": "ssao/ao.frag"}})"},
        {"interfaces", R"({"surface": "geometry/a.surface.glsl"})"},
        {"passes", R"({"ssao": {"shader": "ao", "color": ["ao"]},
                       "blur": {"shader": "ao", "color": "ao_filtered",
                                "bypass": {"ao_filtered": "ao"}}})"},
        {"outputs", R"({"ao": "ao_filtered"})"},
        {"views", R"({"view_ao": {"target": "ao"}})"},
    };
    for (const auto& [name, text] : replaced) sections[name] = text;
    std::string out;
    for (const auto& [name, text] : sections)
        if (!text.empty()) out += (out.empty() ? "{\n\"" : ",\n\"") + name + "\": " + text;
    return out + "\n}\n";
}

inline Node parsed(const std::string& text)
{
    INFO(text);
    return need(
        parseDocument(std::make_shared<SourceText>(SourceText{"my.json", text, "my.json"})));
}

inline Result<Description> decodeWith(const Sections& replaced,
                                      const SourceSet& sources = glslSources())
{
    return decode(parsed(configText(replaced)), sources);
}

/// The errors as "CV2103 /passes/blur/inputs/ao; CV3001 /targts"; empty when there are none.
inline std::string errorsOf(const Result<Description>& result)
{
    std::string out;
    for (const Diagnostic& each : result.diagnostics())
        out += (out.empty() ? "" : "; ") + codeName(each.code) + " " + each.pointer;
    return out;
}

/// A config with one section replaced, and the errors that it must give.
struct BadConfig {
    const char* section;
    std::string text;
    const char* errors;
};

inline void checkEach(const std::vector<BadConfig>& cases)
{
    for (const BadConfig& each : cases) {
        const Result<Description> result = decodeWith({{each.section, each.text}});
        INFO(each.section << ": " << each.text << "\n" << toText(result.diagnostics()));
        CHECK(errorsOf(result) == each.errors);
        for (const Diagnostic& error : result.diagnostics()) {
            CHECK(error.place.line > 0);
            CHECK_FALSE(error.help.empty());
        }
    }
}

}  // namespace crevice
