// SPDX-License-Identifier: MIT
// Shader stages from GLSL files, and enough of the grammar to read their uniforms and outputs.
#include <crevice/glsl_stage.h>

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"

namespace crevice {
namespace {

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

/// Longest array that is believed; no device has room for more uniforms.
constexpr std::int64_t kMaxArray = 65536;

/// Longest that a shader's own may be: drivers keep some 64 KiB, and for more ask for any memory.
constexpr std::int64_t kMaxElements = 4096;

constexpr std::size_t kMaxDeclared = 1024;  ///< Most uniforms and outputs of a stage.

constexpr std::string_view kQualifiers[] = {
    "uniform",   "in",        "out",    "const",  "flat",     "smooth",   "centroid",
    "invariant", "precise",   "sample", "patch",  "highp",    "mediump",  "lowp",
    "readonly",  "writeonly", "shared", "buffer", "coherent", "volatile", "restrict"};

// Whether the word stands before a type.
bool isQualifier(std::string_view word)
{
    return std::find(std::begin(kQualifiers), std::end(kQualifiers), word) != std::end(kQualifiers);
}

struct Qualifiers {
    bool uniform = false;
    bool output = false;
    int location = -1;
};

// Appends the uniforms and outputs that `unit` declares at its outermost level to `stage`, and
// what is wrong with them to `unit.errors`: array sizes and locations that cannot be read.
struct Scanner {
    GlslUnit& unit;
    GlslStage& stage;
    const GlslToken* at = unit.tokens.data();
    const GlslToken* const end = at + unit.tokens.size();

    void run()
    {
        refuseLongArrays();
        while (at != end && unit.errors.size() < kMaxDiagnostics) {
            const Qualifiers qualifiers = readQualifiers();
            if (qualifiers.uniform || qualifiers.output) readDeclaration(qualifiers);
            skipStatement();
        }
    }

    bool here(std::string_view text) const { return at != end && at->is(text); }

    void fail(std::string message, const GlslToken& token, std::string help)
    {
        unit.errors.push_back(
            {Code::preprocessor, std::move(message), std::move(help), placeOf(token, unit.files)});
    }

    /// Sizes that are numbers, or constants that are.
    void refuseLongArrays()
    {
        std::set<std::string_view> large;
        for (const GlslToken* token = at; end - token > 2; ++token) {
            const bool constant =
                token->is("=") && token > at + 1 && endsWith(token[-2].text, "int");
            if (!constant && !token->is("[")) continue;
            const GlslToken* last = token + 1;
            while (last != end && last - token < 16 && !last->is("]") && !last->is(";")) ++last;
            const bool long_ = evaluate(token + 1, last).value_or(0) > kMaxElements;
            if (constant && long_) large.insert(token[-1].text);
            if (!constant && (long_ || large.count(token[1].text) > 0))
                return fail("an array has more than " + std::to_string(kMaxElements) + " elements",
                            token[1], "make it shorter, or read a texture");
        }
    }

    Qualifiers readQualifiers()
    {
        Qualifiers qualifiers;
        for (; at != end; ++at) {
            if (at->is("layout"))
                readLayout(qualifiers);
            else if (!isQualifier(at->text))
                break;
            else if (at->is("uniform"))
                qualifiers.uniform = true;
            else if (at->is("out"))
                qualifiers.output = true;
            if (at == end) break;
        }
        return qualifiers;
    }

    /// Leaves the cursor at the closing parenthesis.
    void readLayout(Qualifiers& qualifiers)
    {
        ++at;
        const GlslToken* close = closing("(", ")");
        for (; at != close; ++at) {
            if (!at->is("location") || close - at < 3 || !at[1].is("=")) continue;
            const GlslToken* value = at + 2;
            const GlslToken* last = value;
            while (last != close && !last->is(",")) ++last;
            const auto location = evaluate(value, last);
            const bool known = location && *location >= 0 && *location < kMaxArray;
            if (known)
                qualifiers.location = int(*location);
            else
                fail("this location cannot be read, wanted a whole number", *value,
                     "write 0, 1, ...");
        }
    }

    /// Reads `type name, name[4], ...` up to the semicolon.
    void readDeclaration(const Qualifiers& qualifiers)
    {
        if (at == end || at->kind != GlslToken::Kind::identifier) return;
        const GlslToken& type = *at++;
        const bool block = here("{") || type.is("struct");
        if (block && qualifiers.uniform)
            stage.blocks.push_back(
                {std::string(type.text), GlslType::other, 1, false, placeOf(type, unit.files)});
        if (block) return;

        GlslUniform common;
        common.type = glslTypeFromName(type.text);
        common.spelling = type.text;
        readArray(common);
        while (at != end && at->kind == GlslToken::Kind::identifier) {
            if (stage.uniforms.size() + stage.outputs.size() == kMaxDeclared) {
                fail("found more than " + std::to_string(kMaxDeclared) + " uniforms and outputs",
                     *at, "make arrays of them; no device has room for so many");
                at = end;
                return;
            }
            GlslUniform variable = common;
            variable.name = at->text;
            variable.place = placeOf(*at++, unit.files);
            readArray(variable);
            const int next = int(stage.outputs.size());
            const int location = qualifiers.location < 0 ? next : qualifiers.location;
            if (qualifiers.uniform)
                stage.uniforms.push_back(std::move(variable));
            else
                stage.outputs.push_back(
                    {std::move(variable.name), location, variable.place, variable.type});
            if (!here(",")) return;
            ++at;
        }
    }

    void readArray(GlslUniform& variable)
    {
        if (!here("[")) return;
        const GlslToken& open = *at;
        const GlslToken* close = closing("[", "]");
        const auto count = evaluate(at + 1, close);
        variable.array = true;
        if (count && *count > 0 && *count <= kMaxArray)
            variable.count = int(*count);
        else
            fail("the array size of '" + variable.name + "'" +
                     (close == at + 2 ? ", '" + std::string(at[1].text) + "'," : "") +
                     " cannot be read, wanted a whole number of at least 1",
                 open,
                 "an array size has numbers and #defines only: a param with bind 'define' is one");
        at = close == end ? end : close + 1;
    }

    /// The sign that closes the one at the cursor, or the end.
    const GlslToken* closing(std::string_view open, std::string_view close) const
    {
        int depth = 0;
        for (const GlslToken* token = at; token != end; ++token) {
            if (token->is(open)) ++depth;
            if (token->is(close) && --depth == 0) return token;
        }
        return end;
    }

    /// Leaves the cursor behind the next semicolon or the body that comes before it.
    void skipStatement()
    {
        while (at != end && !here(";") && !here("{")) ++at;
        if (here("{")) at = closing("{", "}");
        if (at != end) ++at;
    }
};

// What a line `layout(...) out type name;` is as a plain variable; nothing of any other line.
std::optional<std::string> plainVariable(std::string_view line, const std::string& name)
{
    GlslTokens tokens;
    tokenize(line, 0, 1, tokens);
    const std::size_t count = tokens.size();
    if (count < 4 || !tokens[count - 1].is(";") || !tokens[count - 2].is(name)) return std::nullopt;
    std::string plain(line.substr(0, std::size_t(tokens[0].column) - 1));  // as it is indented
    bool output = false;
    std::size_t i = 0;
    if (tokens[0].is("layout"))
        while (i + 3 < count && !tokens[i++].is(")")) {
        }
    for (; i + 3 < count; ++i) {
        if (!isQualifier(tokens[i].text)) return std::nullopt;
        if (tokens[i].text.back() == 'p')  // highp, mediump, lowp
            plain += std::string(tokens[i].text) + " ";
        output = output || tokens[i].is("out");
    }
    if (!output) return std::nullopt;
    return plain + std::string(tokens[count - 3].text) + " " + name + ";";
}

}  // namespace

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
    if (!hasErrors(unit.errors)) Scanner{unit, stage}.run();
    if (hasErrors(unit.errors)) return std::move(unit.errors);
    stage.defines_used = usedDefines(defines, unit);
    stage.text = "#version " + unit.version + "\n";
    for (const std::string& name : stage.defines_used)
        stage.text += "#define " + name + " " + onOneLine(defines.at(name)) + "\n";
    stage.text += unit.text;
    stage.files = std::move(unit.files);
    stage.explain = explainLog;
    return {std::move(stage), std::move(unit.errors)};
}

bool dropOutput(GlslStage& stage, const std::string& name)
{
    std::string& text = stage.text;
    for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
        end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        const std::optional<std::string> plain = plainVariable(line, name);
        if (!plain) continue;
        text.replace(begin, line.size(), *plain);
        eraseIf(stage.outputs, [&](const GlslOutput& output) { return output.name == name; });
        return true;
    }
    return false;
}

}  // namespace crevice
