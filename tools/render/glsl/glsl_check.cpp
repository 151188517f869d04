// SPDX-License-Identifier: MIT
#include "tools/render/glsl/glsl_check.h"

#include "core/base/text.h"
#include "core/compile/steps.h"
#include "core/glsl/compiler_words.h"
#include "tools/commands/cli/child_process.h"
#include "tools/render/glsl/glslang_stage.h"

#include <glslang/Public/resource_limits_c.h>

namespace crevice {
namespace {

/// A stage and what glslang says of it.
struct CheckedStage {
    explicit CheckedStage(const GlslStage& of) : stage(of), spread(crevice::spread(of)) {}

    Diagnostics errors() const
    {
        return explainSpread(stage, spread.tokens, Code::shader_compile, log);
    }

    const GlslStage& stage;
    SpreadStage spread;
    std::string log = {};
};

struct CheckedProgram {
    const PlanProgram& program;
    CheckedStage vertex, fragment;
    std::string log = {};  ///< Of the linker.
    bool ended = false;    ///< Whether glslang came to an end with it.
};

void compile(CheckedProgram& program)
{
    ParsedStage vertex = parseStage(program.vertex.spread.text, GLSLANG_STAGE_VERTEX, false);
    ParsedStage fragment = parseStage(program.fragment.spread.text, GLSLANG_STAGE_FRAGMENT, false);
    program.vertex.log = std::move(vertex.log);
    program.fragment.log = std::move(fragment.log);
    if (!program.vertex.log.empty() || !program.fragment.log.empty()) return;
    const GlslangProgram linked(glslang_program_create());
    for (const ParsedStage* each : {&vertex, &fragment})
        glslang_program_add_shader(linked.get(), each->shader.get());
    if (!glslang_program_link(linked.get(), GLSLANG_MSG_DEFAULT_BIT))
        program.log = glslang_program_get_info_log(linked.get());
}

/// In a process of its own: a sum of a hundred thousand terms overflows glslang's stack, and macros
/// that double themselves fill the memory.
ChildEnd compileApart(std::vector<CheckedProgram>& programs)
{
    constexpr ChildLimits kLimits = {10.0, 1ull << 30};
    static const bool ready = [] {  // with what every child would build anew
        for (const glslang_stage_t kind : {GLSLANG_STAGE_VERTEX, GLSLANG_STAGE_FRAGMENT})
            for (const char* version : {"300", "310"})
                parseStage(std::string("#version ") + version + " es\nvoid main() {}", kind, false);
        return true;
    }();
    if (!ready || programs.empty()) return ChildEnd::done;
    const auto logsOf = [](CheckedProgram& each) {
        return std::array<std::string*, 3>{&each.vertex.log, &each.fragment.log, &each.log};
    };
    std::string answer;
    const auto send = [&](Sender& sender) {
        for (CheckedProgram& each : programs) {
            compile(each);
            for (const std::string* log : logsOf(each)) sender.bytes(log->c_str(), log->size() + 1);
            sender.flush();
        }
    };
    const ChildEnd end = runInChild(kLimits, send, answer);
    const std::vector<std::string_view> logs = split(answer, '\0');  // and what a crash cut off
    std::size_t next = 0;
    for (CheckedProgram& each : programs) {
        each.ended = next + 3 < logs.size();
        for (std::string* log : logsOf(each))
            if (each.ended) *log = logs[next++];
    }
    return end;
}

/// Whether the name at `i` is declared with the word before it.
bool declaredWith(const GlslTokens& tokens, std::size_t i, std::string_view word)
{
    while (i > 0 && tokens[i - 1].kind == GlslToken::Kind::identifier && !tokens[i - 1].is(word))
        --i;
    return i > 0 && tokens[i - 1].is(word);
}

/// What glslang lets pass: inputs that the vertex shader does not write, or not so.
Diagnostics wrongInputs(const CheckedStage& vertex, const CheckedStage& fragment)
{
    const std::vector<std::string> outputs = namesOf(vertex.stage.outputs);
    const GlslTokens &tokens = fragment.spread.tokens, &outs = vertex.spread.tokens;
    Diagnostics errors;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!tokens[i + 1].is(";") || !declaredWith(tokens, i, "in")) continue;
        const std::string name(tokens[i].text);
        const auto same = [&](const GlslToken& token) { return token.is(name); };
        const Place place = placeOf(tokens[i], fragment.stage.files);
        if (!contains(outputs, name)) {
            if (std::count_if(tokens.begin(), tokens.end(), same) > 1)
                errors.push_back({Code::shader_link,
                                  "'" + name + "' comes in from no output of the vertex shader",
                                  suggestName(name, outputs, "outputs"), place});
            continue;
        }
        std::size_t out = 0;
        while (out + 1 < outs.size() && !(same(outs[out]) && declaredWith(outs, out, "out"))) ++out;
        for (const std::string word : {"flat", "centroid"})
            if (declaredWith(tokens, i, word) != declaredWith(outs, out, word))
                errors.push_back({Code::shader_link,
                                  "'" + name + "' is " + word + " in one shader alone",
                                  "write '" + word + "' in both, or in neither", place});
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

Diagnostics linkErrors(const CheckedProgram& program)
{
    const CheckedStage &vertex = program.vertex, &fragment = program.fragment;
    const std::string version(lineOf(vertex.stage.text, 1)), other(lineOf(fragment.stage.text, 1));
    if (version != other)
        return {{Code::shader_link,
                 "a '" + other + "' does not fit the vertex shader's '" + version + "'",
                 "write one version in both",
                 {fragment.stage.files.front()}}};
    Diagnostics errors = wrongInputs(vertex, fragment);
    const std::string& log = program.log;
    constexpr std::string_view kError = "ERROR: ";
    for (std::size_t at = 0, end = 0; (at = log.find(kError, end)) != log.npos;) {
        end = std::min(log.find(kError, at + 1), log.size());
        const std::string_view text = std::string_view(log).substr(at, end - at);
        const CheckedStage& of = has(text, "fragment") ? fragment : vertex;
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

Diagnostics errorsOf(const CheckedProgram& program, ChildEnd end)
{
    if (!program.ended)
        return {{Code::shader_compile,
                 std::string("glslang ") +
                     (end == ChildEnd::too_long ? "takes too long over" : "falls over") +
                     " this shader",
                 "make its expressions and macros shorter",
                 {program.fragment.stage.files.front()}}};
    Diagnostics errors = program.vertex.errors();
    append(errors, program.fragment.errors());
    return errors.empty() ? linkErrors(program) : errors;
}

/// Whether the file has a function of that name.
bool declares(const SourceText& source, const std::string& name)
{
    GlslTokens tokens;
    const std::string text = blankComments(source.text).text;
    if (findWord(text, name) != text.npos) tokenize(text, 0, 1, tokens);
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i)
        if (tokens[i].is(name) && tokens[i + 1].is("(") && !tokens[i - 1].is("return") &&
            tokens[i - 1].kind == GlslToken::Kind::identifier)
            return true;
    return false;
}

/// How to include the function of that name, where a file of the config has one.
std::string includeOf(const Description& description, const std::string& name)
{
    const auto& files = description.files;
    const auto has = [&](const std::string& path) {
        const auto found = files.find(path);
        return found != files.end() && declares(*found->second, name);
    };
    for (const InterfaceDesc& each : description.interfaces) {
        bool here = has(each.file.name);
        if (const auto file = files.find(each.file.name); file != files.end())
            for (const GlslInclude& part : findIncludes(file->second))
                here = here || has(resolvePath(file->first, part.name));
        if (here) return "add: #include <" + each.name + ">, which declares it";
    }
    for (const auto& file : files)
        if (endsWith(file.first, ".glsl") && has(file.first))
            return "add: #include \"" + file.first + "\", which declares it";
    return {};
}

/// Where a file lacks what its includer could include first, the includer's line is to blame.
void suggestInclude(Diagnostic& error, const Description& description, const PlanProgram& program)
{
    if (!endsWith(error.message, kNotDeclared)) return;
    const std::string name(quotedName(error.message));
    const std::string supply = compiler::declarationOf(description, name);
    std::string help = supply.empty() ? includeOf(description, name) : supply;
    if (const GlslOutput* out = findNamed(program.vertex.outputs, name))
        help = "add: in " + std::string(glslName(out->type)) + " " + name +
               "; which the vertex shader writes";
    if (!help.empty()) error.help = help;
    if (help.empty() || !supply.empty()) return;
    for (const GlslStage* stage : {&program.vertex, &program.fragment})
        for (const GlslInclude& each : findIncludes(stage->files.front()))
            if (each.name == error.place.source->path) blame(error, each.place, "it is used here");
}

/// Once a process.
struct Glslang {
    Glslang() { glslang_initialize_process(); }
    ~Glslang() { glslang_finalize_process(); }
};

}  // namespace

Diagnostics warnUnchecked() { return {}; }

void GlslCheck::add(const Plan& plan, const std::string& found_with)
{
    for (const PlanProgram& program : plan.programs)
        if (known_.insert(program.key).second) waiting_.push_back({program, found_with});
}

Diagnostics GlslCheck::check(const Description& description, Device* device)
{
    std::vector<CheckedProgram> programs;
    for (const Waiting& each : waiting_)
        programs.push_back(
            {each.program, CheckedStage(each.program.vertex), CheckedStage(each.program.fragment)});
    const ChildEnd end = compileApart(programs);
    Diagnostics errors;
    bool ended = true;  // else those after it were not compiled
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const PlanProgram& program = waiting_[i].program;
        Diagnostics found = ended ? errorsOf(programs[i], end) : Diagnostics();
        if (!ended || !found.empty()) known_.erase(program.key);
        ended = ended && programs[i].ended;
        Diagnostics driver;
        if (device && ended && !found.empty())
            driver = device->createProgram({program.label, program.vertex, program.fragment})
                         .diagnostics();
        for (Diagnostic& error : found) {
            suggestInclude(error, description, program);
            error.pointer = program.pointer;
            error.notes.push_back({program.place, "in shader '" + program.label + "'"});
            if (const std::string& what = waiting_[i].found_with; !what.empty())
                error.notes.push_back({{}, "found with " + what});
            for (const Diagnostic& each : driver)
                error.notes.push_back({each.place, "the driver says: " + each.message});
            addOnce(errors, std::move(error));
        }
    }
    waiting_.clear();
    return errors;
}

ParsedStage parseStage(const std::string& text, glslang_stage_t kind, bool spirv)
{
    static const Glslang glslang;
    glslang_input_t input = {};
    input.language = GLSLANG_SOURCE_GLSL;
    input.stage = kind;
    input.client = spirv ? GLSLANG_CLIENT_OPENGL : GLSLANG_CLIENT_NONE;
    input.client_version = GLSLANG_TARGET_OPENGL_450;
    input.target_language = spirv ? GLSLANG_TARGET_SPV : GLSLANG_TARGET_NONE;
    input.target_language_version = GLSLANG_TARGET_SPV_1_0;
    input.code = text.c_str();
    input.default_version = 310;
    input.default_profile = GLSLANG_ES_PROFILE;
    input.messages = GLSLANG_MSG_DEFAULT_BIT;
    input.resource = glslang_default_resource();
    ParsedStage parsed = {GlslangShader(glslang_shader_create(&input)), {}};
    glslang_shader_t* shader = parsed.shader.get();
    // SPIR-V wants numbers for all that GLSL finds by name.
    if (spirv)
        glslang_shader_set_options(
            shader, GLSLANG_SHADER_AUTO_MAP_BINDINGS | GLSLANG_SHADER_AUTO_MAP_LOCATIONS);
    if (!glslang_shader_preprocess(shader, &input) || !glslang_shader_parse(shader, &input))
        parsed.log = glslang_shader_get_info_log(shader) + std::string("\n");
    return parsed;
}

}  // namespace crevice
