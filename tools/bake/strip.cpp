// SPDX-License-Identifier: MIT
// GLSL with what runs alone: lines that count, macros as what they stand for, declarations that
// `main` reaches.
#include "core/base/text.h"
#include "core/glsl/preprocessor.h"
#include "tools/bake/bake.h"

namespace crevice {
namespace {

using Kind = GlslToken::Kind;

/// One declaration or function at the outermost level.
struct Item {
    const GlslToken* begin;
    const GlslToken* end;
    std::vector<std::string_view> names = {};  ///< That it declares.
    bool kept = false;
};

bool isWordToken(const GlslToken& token)
{
    return token.kind == Kind::identifier || token.kind == Kind::number;
}

/// Whether a token continues the one before without a blank.
bool follows(const GlslToken& before, const GlslToken& token)
{
    return token.line == before.line && token.file == before.file &&
           token.column == before.column + int(before.text.size());
}

/// As short as it reads the same.
void append(std::string& text, const GlslToken* begin, const GlslToken* end)
{
    for (const GlslToken* token = begin; token != end; ++token) {
        const bool first = token == begin;
        const bool words = !first && isWordToken(token[-1]) && isWordToken(*token);
        const bool signs =
            !first && token[-1].kind == Kind::symbol && token->kind == Kind::symbol &&
            !follows(token[-1], *token) &&
            std::string_view("+-<>=!&|^*/%").find(token->text[0]) != std::string_view::npos &&
            std::string_view("+-<>=!&|^*/%").find(token[-1].text.back()) != std::string_view::npos;
        if (words || signs) text += ' ';
        text += token->text;
    }
}

/// Cuts the outermost level at semicolons, and at the ends of functions.
std::vector<Item> itemsOf(const GlslTokens& tokens)
{
    std::vector<Item> items;
    const GlslToken* const end = tokens.data() + tokens.size();
    for (const GlslToken* at = tokens.data(); at != end;) {
        Item item{at, at};
        int depth = 0;
        bool function = false;
        for (; at != end; ++at) {
            if (at->is("{") && depth == 0) function = at != item.begin && at[-1].is(")");
            if (at->is("{") || at->is("(") || at->is("[")) ++depth;
            if (at->is("}") || at->is(")") || at->is("]")) --depth;
            if (depth == 0 && (at->is(";") || (at->is("}") && function))) break;
        }
        if (at != end) ++at;
        item.end = at;
        items.push_back(std::move(item));
    }
    return items;
}

/// Finds what an item declares, and whether it stays whatever is reached.
void nameItem(Item& item)
{
    int depth = 0;
    bool type_seen = item.begin->is("struct"), value = false;
    item.kept = item.begin->is("precision") || item.begin->is("invariant");
    for (const GlslToken* at = item.begin; at != item.end; ++at) {
        if (at->is("{") || at->is("(") || at->is("[")) ++depth;
        if (at->is("}") || at->is(")") || at->is("]")) --depth;
        if (depth == 0 && (at->is("=") || at->is(","))) value = at->is("=");
        const GlslToken* const next = at + 1;
        const bool word = at->kind == Kind::identifier && !at->is("struct") && !at->is("layout");
        if (depth > 0 || value || !word || next == item.end) continue;
        // What is drawn, and blocks, whose members are not named here.
        item.kept = item.kept || at->is("out") || (item.begin->is("uniform") && next->is("{"));
        const bool named = next->kind == Kind::symbol && next->text.size() == 1 &&
                           std::string_view(";(=,[{").find(next->text[0]) != std::string_view::npos;
        if (named && type_seen) item.names.push_back(at->text);
        item.kept = item.kept || at->is("main");
        type_seen = true;
    }
    item.kept = item.kept || item.names.empty();
}

void keepReached(std::vector<Item>& items, std::set<std::string_view> reached)
{
    std::set<const Item*> done;
    for (bool more = true; more;) {
        more = false;
        for (Item& item : items) {
            item.kept = item.kept || anyOf(item.names, [&](std::string_view name) {
                            return reached.count(name) > 0;
                        });
            if (!item.kept || !done.insert(&item).second) continue;
            for (const GlslToken* at = item.begin; at != item.end; ++at)
                if (at->kind == Kind::identifier) reached.insert(at->text);
            more = true;
        }
    }
}

/// Lines of directives that a driver still needs: #extension, #pragma, and macros with arguments,
/// which the preprocessor leaves where they are used.
Status keepDirectives(const std::vector<GlslLine>& lines, GlslUnit& unit, std::string& out,
                      std::set<std::string_view>& reached)
{
    for (const GlslLine& line : lines) {
        if (!line.isDirective()) continue;
        if (line.directive() == "extension" || line.directive() == "pragma") out += line.text;
        const GlslTokens& tokens = line.tokens;
        if (line.directive() != "define" || tokens.size() < 4 || !tokens[3].is("(") ||
            !follows(tokens[2], tokens[3]) || !unit.macros.defined(tokens[2].text))
            continue;
        const auto close = std::find_if(tokens.begin(), tokens.end(),
                                        [](const GlslToken& token) { return token.is(")"); });
        if (close == tokens.end()) return Diagnostic{Code::preprocessor, "a macro has no ')'"};
        out += "#define ";
        append(out, &tokens[2], &*close + 1);
        GlslTokens body;
        for (auto at = close + 1; at != tokens.end(); ++at)
            if (!unit.macros.expand(*at, body))
                return Diagnostic{Code::preprocessor, "macros expand without end"};
        out += ' ';
        append(out, body.data(), body.data() + body.size());
        out += '\n';
        for (const GlslToken& token : body)
            if (token.kind == Kind::identifier) reached.insert(token.text);
    }
    return {};
}

/// Without what only tells lines; macros of those names stand for themselves.
std::string withoutLines(const std::string& text, const std::vector<std::string>& late)
{
    std::string kept;
    const BlankedText blanked = blankComments(text);
    for (const GlslLine& line : glslLines(blanked.text, 0)) {
        const bool named = line.isDirective() && line.directive() == "define" &&
                           line.tokens.size() > 2 && contains(late, line.tokens[2].text);
        if (named)
            kept += "#define " + std::string(line.tokens[2].text) + " " +
                    std::string(line.tokens[2].text) + "\n";
        else if (!line.isDirective() || line.directive() != "line")
            kept += line.text;
    }
    return kept;
}

}  // namespace

std::vector<std::string> lateMacros(const std::string& text, const std::vector<std::string>& names)
{
    const BlankedText blanked = blankComments(text);
    const std::vector<GlslLine> lines = glslLines(blanked.text, 0);
    std::set<std::string, std::less<>> deciding;
    const auto add = [&](const GlslLine& line, std::size_t from) {
        bool more = false;
        for (std::size_t i = from; i < line.tokens.size(); ++i) {
            const bool asked = line.tokens[i - 1].is("defined") ||
                               (line.tokens[i - 1].is("(") && line.tokens[i - 2].is("defined"));
            if (line.tokens[i].kind == Kind::identifier && !asked)
                more = deciding.insert(std::string(line.tokens[i].text)).second || more;
        }
        return more;
    };
    // Whether a macro is defined decides as well, and does not change with its value.
    for (const GlslLine& line : lines)
        if (line.isDirective() && (line.directive() == "if" || line.directive() == "elif"))
            add(line, 2);
    for (bool more = true; more;) {  // what a macro that decides stands for
        more = false;
        for (const GlslLine& line : lines)
            if (line.isDirective() && line.directive() == "define" && line.tokens.size() > 3 &&
                deciding.count(line.tokens[2].text) > 0)
                more = add(line, 3) || more;
    }
    std::vector<std::string> late;
    for (const std::string& name : names)
        if (deciding.count(name) == 0) late.push_back(name);
    return late;
}

Result<std::string> stripped(const std::string& text, const std::vector<std::string>& late)
{
    const auto source =
        std::make_shared<const SourceText>(SourceText{"(shader)", withoutLines(text, late)});
    const GlslDefines none;
    GlslUnit unit(none);
    preprocess({{"shader", source}}, {}, "shader", unit);
    if (hasErrors(unit.errors)) return std::move(unit.errors);
    std::string out;
    std::set<std::string_view> reached;
    const std::vector<GlslLine> lines = glslLines(unit.blanked.back(), 0);
    if (Status kept = keepDirectives(lines, unit, out, reached); !kept) return kept.diagnostics();
    std::vector<Item> items = itemsOf(unit.tokens);
    for (Item& item : items) nameItem(item);
    keepReached(items, std::move(reached));
    for (const Item& item : items) {
        if (!item.kept) continue;
        append(out, item.begin, item.end);
        out += '\n';
    }
    return out;
}

}  // namespace crevice
