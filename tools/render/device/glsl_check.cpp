// SPDX-License-Identifier: MIT
#include "tools/render/device/glsl_check.h"

#include "core/base/text.h"
#include "core/glsl/compiler_words.h"
#include "core/glsl/preprocessor.h"
#include "tools/render/device/glslang_stage.h"

#include <algorithm>

namespace crevice {
namespace {

struct CheckedStage {
    const GlslStage& stage;
    SpreadStage spread;
    ParsedStage parsed;

    CheckedStage(const GlslStage& of, glslang_stage_t kind)
        : stage(of),
          spread(crevice::spread(of)),
          parsed(parseStage(spread.text, kind, false))
    {
    }

    Diagnostics errors() const
    {
        return explainSpread(stage, spread.tokens, Code::shader_compile, parsed.log);
    }
};

/// Inputs that the fragment shader uses and the vertex shader does not write, which glslang lets
/// pass.
Diagnostics missingInputs(const CheckedStage& vertex, const CheckedStage& fragment)
{
    const std::vector<std::string> outputs = namesOf(vertex.stage.outputs);
    const GlslTokens& tokens = fragment.spread.tokens;
    Diagnostics errors;
    for (std::size_t i = 3; i + 1 < tokens.size(); ++i) {
        const std::string name(tokens[i].text);
        const auto same = [&](const GlslToken& token) { return token.is(name); };
        const bool input =
            tokens[i + 1].is(";") && (tokens[i - 2].is("in") || tokens[i - 3].is("in"));
        if (!input || contains(outputs, name) ||
            std::count_if(tokens.begin(), tokens.end(), same) == 1)
            continue;
        errors.push_back(
            {Code::shader_link, "'" + name + "' comes in from no output of the vertex shader",
             suggestName(name, outputs, "outputs"), placeOf(tokens[i], fragment.stage.files)});
    }
    return errors;
}

/// The name that an error of the linker is about.
std::string linkedName(std::string_view error)
{
    const std::size_t quote = error.rfind('"'), calls = error.find("; calling");
    std::size_t end = calls != error.npos ? error.rfind('(', calls) : quote;
    if (end != error.npos && end > 0 && error[end - 1] == '"') end = error.rfind(' ', end);
    if (end == error.npos) return {};
    std::size_t begin = end;
    while (begin > 0 && isWord(error[begin - 1])) --begin;
    return std::string(error.substr(begin, end - begin));
}

Diagnostics linkErrors(const CheckedStage& vertex, const CheckedStage& fragment)
{
    const GlslangProgram program(glslang_program_create());
    for (const CheckedStage* each : {&vertex, &fragment})
        glslang_program_add_shader(program.get(), each->parsed.shader.get());
    Diagnostics errors = missingInputs(vertex, fragment);
    if (glslang_program_link(program.get(), GLSLANG_MSG_DEFAULT_BIT)) return errors;
    const std::string log = glslang_program_get_info_log(program.get());
    constexpr std::string_view kError = "ERROR: ";
    for (std::size_t at = 0, end = 0; (at = log.find(kError, end)) != log.npos;) {
        end = std::min(log.find(kError, at + 1), log.size());
        const std::string_view text = std::string_view(log).substr(at, end - at);
        const CheckedStage& of = text.find("fragment") == text.npos ? vertex : fragment;
        const std::string name = linkedName(text);
        const GlslTokens& tokens = of.spread.tokens;
        const auto found = std::find_if(tokens.begin(), tokens.end(),
                                        [&](const GlslToken& token) { return token.is(name); });
        const GlslToken& token = found != tokens.end() ? *found : tokens.back();
        Diagnostic error{Code::shader_link,
                         "'" + name + "' : " + std::string(text.substr(0, text.find('\n'))), "",
                         placeOf(token, of.stage.files)};
        sayPlainly(of.stage, tokens, error);
        errors.push_back(std::move(error));
    }
    return errors;
}

Diagnostics errorsOf(const PlanProgram& program)
{
    const CheckedStage vertex(program.vertex, GLSLANG_STAGE_VERTEX);
    const CheckedStage fragment(program.fragment, GLSLANG_STAGE_FRAGMENT);
    Diagnostics errors = vertex.errors();
    append(errors, fragment.errors());
    return errors.empty() ? linkErrors(vertex, fragment) : errors;
}

/// How to include the file of the config that declares the name, where one does.
std::string includeOf(const Description& description, const std::string& name)
{
    for (const auto& [path, source] : description.files) {
        GlslTokens tokens;
        const std::string text = blankComments(source->text).text;
        if (findWord(text, name) != text.npos) tokenize(text, 0, 1, tokens);
        for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
            const bool declares = tokens[i].is(name) && tokens[i + 1].is("(") &&
                                  tokens[i - 1].kind == GlslToken::Kind::identifier &&
                                  !tokens[i - 1].is("return");
            if (!declares) continue;
            for (const InterfaceDesc& each : description.interfaces)
                if (each.file.name == path)
                    return "add: #include <" + each.name + ">, which declares it";
            return "add: #include \"" + path + "\", which declares it";
        }
    }
    return {};
}

}  // namespace

Diagnostics warnUnchecked() { return {}; }

Diagnostics GlslCheck::check(const Description& description, const Plan& plan, Device* device)
{
    Diagnostics errors;
    for (const PlanProgram& program : plan.programs) {
        if (right_.count(program.key) > 0) continue;
        Diagnostics found = errorsOf(program);
        if (found.empty()) right_.insert(program.key);
        if (found.empty()) continue;
        Diagnostics driver;
        if (device)
            driver = device->createProgram({program.label, program.vertex, program.fragment})
                         .diagnostics();
        for (Diagnostic& error : found) {
            if (endsWith(error.message, kNotDeclared))
                if (std::string help =
                        includeOf(description, std::string(quotedName(error.message)));
                    !help.empty())
                    error.help = std::move(help);
            error.pointer = program.pointer;
            error.notes.push_back({program.place, "in shader '" + program.label + "'"});
            for (const Diagnostic& each : driver)
                error.notes.push_back({each.place, "the driver says: " + each.message});
            addOnce(errors, std::move(error));
        }
    }
    return errors;
}

}  // namespace crevice
