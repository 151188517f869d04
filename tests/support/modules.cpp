// SPDX-License-Identifier: MIT
#include "tests/support/modules.h"

#include "core/base/text.h"
#include "tests/support/shipped_subjects.h"

namespace crevice {
namespace {

const std::vector<Member>& membersOf(const Node& node, const char* key)
{
    static const std::vector<Member> none;
    const Node* object = node.find(key);
    return object ? object->members : none;
}

std::set<std::string> keysOf(const Node& document, const char* key)
{
    std::set<std::string> keys;
    for (const Member& member : membersOf(document, key)) keys.insert(member.key);
    return keys;
}

std::string textAt(const Node& node, const char* key)
{
    const Node* value = node.find(key);
    return value ? value->text : "";
}

/// The text of a fragment shader and of the files of its own folder that it includes.
std::string shaderText(const std::string& path)
{
    const SourceRef source = shippedSources().find(path);
    std::string text = source ? source->text : "";
    const std::string include = "#include \"" + path.substr(0, path.find('/') + 1);
    for (auto at = text.find(include); at != std::string::npos; at = text.find(include, at + 1)) {
        const auto first = text.find('"', at) + 1;
        text += shaderText(text.substr(first, text.find('"', first) - first));
    }
    return text;
}

Module describe(const std::string& name, const Node& document)
{
    Module module;
    module.name = name;
    module.targets = keysOf(document, "targets");
    module.options = keysOf(document, "params");
    module.options.merge(keysOf(document, "features"));
    for (const Member& target : membersOf(document, "targets"))
        module.remembers |= target.value.find("history") != nullptr;
    for (const Member& import : membersOf(document, "imports")) {
        if (textAt(import.value, "type") != "texture") continue;
        module.targets.insert(import.key);
        module.host_textures = true;
    }
    for (const Member& shader : membersOf(document, "shaders")) {
        const std::string text = shaderText(textAt(shader.value, "fragment"));
        module.reads_normals |=
            has(text, "#include <surface>") && !has(text, "SURFACE_WITHOUT_NORMAL");
    }
    return module;
}

/// False for a base module, which leaves the fragment shader to what extends it.
bool everyPassHasItsShader(const Node& document)
{
    const Node* shaders = document.find("shaders");
    for (const Member& pass : membersOf(document, "passes")) {
        const Node* shader = shaders ? shaders->find(textAt(pass.value, "shader")) : nullptr;
        if (!shader || !shader->find("fragment")) return false;
    }
    return true;
}

/// Not every context reads several samples a pixel.
bool readsSamples(const Node& document)
{
    for (const Member& shader : membersOf(document, "shaders"))
        if (has(shaderText(textAt(shader.value, "fragment")), "sampler2DMS")) return true;
    return false;
}

std::string outputAo(const Node& document)
{
    const Node* outputs = document.find("outputs");
    return outputs ? textAt(*outputs, "ao") : "";
}

template <class Chosen>
std::vector<Module> modulesBelow(const std::string& folder, Chosen&& chosen)
{
    std::vector<Module> modules;
    for (const std::string& path : shippedSources().list()) {
        const bool json = path.size() > 5 && path.compare(path.size() - 5, 5, ".json") == 0;
        if (!json || path.rfind(folder + "/", 0) != 0) continue;
        const std::string name = path.substr(0, path.size() - 5);
        const GivenConfig config({name});
        const Node document = need(loadConfig(config.sources(), {"given"}));
        if (chosen(document)) modules.push_back(describe(name, document));
    }
    return modules;
}

}  // namespace

GivenConfig::GivenConfig(const std::vector<std::string>& modules, const std::string& more,
                         const std::vector<File>& files)
    : layers_({&mine_, &shippedSources()})
{
    for (const auto& [path, text] : files) mine_.add(path, text);
    std::string list;
    for (const std::string& name : modules) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    mine_.add("configs/given.json",
              R"({"format": 1, "name": "given", "extends": [)" + list + "]" + more + "}");
}

Description GivenConfig::description(const std::vector<std::string>& overrides) const
{
    return descriptionOf({"given"}, overrides, layers_);
}

Description filterOver(const std::string& ao, const std::string& filter, const char* format,
                       const std::vector<std::string>& overrides, const char* radius)
{
    const std::string module = R"({"format": 1, "imports": {"camera": {"type": "camera"}},
        "params": {"radius": {"default": )" +
                               std::string(radius) + R"(}}, "targets": {"ao": {"format": [")" +
                               format + R"("]}},
        "shaders": {"ssao": {"vertex": "common/fullscreen.vert", "fragment": "ssao/given.frag"}},
        "passes": {"ssao": {"type": "fullscreen", "shader": "ssao", "color": ["ao"]}}})";
    const std::string shader = R"(#version 300 es
precision highp float;
precision highp int;
#include <surface>
uniform mat4 world_from_view;
uniform int frame_index;
uniform float radius;
in vec2 uv;
layout(location = 0) out float ao;
void main() {
    vec3 point;
    bool known = viewPosition(uv, point);
    vec3 world = (world_from_view * vec4(point, 1.0)).xyz + 1e-9 * float(frame_index) * radius;
    ao = known ? )" + ao + " : 1.0; }\n";
    return GivenConfig({"geometry/depth_normal", "ssao/given", "filter/" + filter}, "",
                       {{"ssao/given.frag", shader}, {"ssao/given.json", module}})
        .description(overrides);
}

const std::vector<Module>& shippedInputs()
{
    static const std::vector<Module> inputs = modulesBelow("geometry", [](const Node& document) {
        return keysOf(document, "interfaces").count("surface") > 0 && !readsSamples(document);
    });
    return inputs;
}

const std::vector<Module>& shippedEstimators()
{
    static const std::vector<Module> estimators = modulesBelow("ssao", [](const Node& document) {
        return outputAo(document) == "ao" && everyPassHasItsShader(document);
    });
    return estimators;
}

const std::vector<Module>& shippedFilters()
{
    static const std::vector<Module> filters = modulesBelow("filter", [](const Node& document) {
        return outputAo(document) != "" && outputAo(document) != "ao" &&
               everyPassHasItsShader(document);
    });
    return filters;
}

}  // namespace crevice
