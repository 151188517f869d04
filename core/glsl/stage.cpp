// SPDX-License-Identifier: MIT
// Shader stages from GLSL files.
#include <crevice/glsl_stage.h>

#include "core/glsl/preprocessor.h"

namespace crevice {

namespace {

constexpr struct {
    GlslType type;
    const char* name;
} kTypes[] = {
    {GlslType::float_, "float"},
    {GlslType::vec2, "vec2"},
    {GlslType::vec3, "vec3"},
    {GlslType::vec4, "vec4"},
    {GlslType::int_, "int"},
    {GlslType::ivec2, "ivec2"},
    {GlslType::ivec3, "ivec3"},
    {GlslType::ivec4, "ivec4"},
    {GlslType::uint_, "uint"},
    {GlslType::bool_, "bool"},
    {GlslType::mat3, "mat3"},
    {GlslType::mat4, "mat4"},
    {GlslType::sampler2d, "sampler2D"},
    {GlslType::sampler2d_ms, "sampler2DMS"},
};

/// The defines that the text mentions, or that the values of such defines mention.
std::vector<std::string> usedDefines(const GlslDefines& defines, const GlslUnit& unit)
{
    std::set<std::string> used;
    auto reach = [&](auto& self, std::string_view name) -> void {
        const auto found = defines.find(std::string(name));
        if (found == defines.end() || !used.insert(found->first).second) return;
        GlslTokens tokens;
        const std::string value = onOneLine(found->second);
        tokenize(value, -1, 0, tokens);
        for (const GlslToken& token : tokens) self(self, token.text);
    };
    for (const std::string_view name : unit.mentioned) reach(reach, name);
    return {used.begin(), used.end()};
}

}  // namespace

const char* glslName(GlslType type)
{
    for (const auto& known : kTypes)
        if (known.type == type) return known.name;
    return "other";
}

GlslType glslTypeFromName(std::string_view name)
{
    const auto* known = findNamed(kTypes, name);
    return known ? known->type : GlslType::other;
}

bool isSampler(GlslType type)
{
    return type == GlslType::sampler2d || type == GlslType::sampler2d_ms;
}

std::vector<GlslInclude> findIncludes(const SourceRef& source)
{
    std::vector<GlslInclude> includes;
    const BlankedText blanked = blankComments(source->text);
    for (const GlslLine& line : glslLines(blanked.text, 0)) {
        GlslInclude include;
        const bool found = line.isDirective() && line.directive() == "include";
        if (found && readInclude(line, source, include)) includes.push_back(std::move(include));
    }
    return includes;
}

Result<GlslStage> assembleStage(const std::map<std::string, SourceRef>& files,
                                const std::map<std::string, std::string>& interfaces,
                                const std::string& path, const GlslDefines& defines)
{
    GlslUnit unit{defines};
    GlslStage stage;
    preprocess(files, interfaces, path, unit);
    if (unit.errors.empty()) scanDeclarations(unit, stage);
    if (!unit.errors.empty()) return std::move(unit.errors);
    stage.defines_used = usedDefines(defines, unit);
    stage.text = "#version " + unit.version + "\n";
    for (const std::string& name : stage.defines_used)
        stage.text += "#define " + name + " " + onOneLine(defines.at(name)) + "\n";
    stage.text += unit.text;
    stage.files = std::move(unit.files);
    return stage;
}

}  // namespace crevice
