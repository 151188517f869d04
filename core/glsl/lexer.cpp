// SPDX-License-Identifier: MIT
// Comments, lines and tokens of GLSL; macro expansion and an evaluator for integer expressions.

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"

#include <cstdlib>

namespace crevice {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The offset of the line's end, which with `continued` no newline behind a backslash is.
std::size_t lineEnd(std::string_view text, std::size_t begin, bool continued)
{
    std::size_t end = begin;
    while ((end = text.find('\n', end)) != std::string_view::npos) {
        const std::size_t last = end > begin && text[end - 1] == '\r' ? end - 1 : end;
        if (!continued || last == begin || text[last - 1] != '\\') return end;
        ++end;
    }
    return text.size();
}

/// The offset behind the comment that begins at `begin`; `begin` when none does.
std::size_t commentEnd(std::string_view text, std::size_t begin, bool& open)
{
    if (text[begin] != '/') return begin;  // as nearly always
    if (text.compare(begin, 2, "//") == 0) return lineEnd(text, begin, true);
    if (text.compare(begin, 2, "/*") != 0) return begin;
    const std::size_t end = text.find("*/", begin + 2);
    open = end == std::string_view::npos;
    return open ? text.size() : end + 2;
}

std::size_t quotedEnd(std::string_view text, std::size_t begin)
{
    const std::size_t end = text.find_first_of("\"\n", begin + 1);
    if (end == std::string_view::npos) return text.size();
    return text[end] == '"' ? end + 1 : end;
}

std::size_t symbolEnd(std::string_view text, std::size_t begin)
{
    static constexpr std::string_view kPairs[] = {"||", "&&", "==", "!=", "<=", ">=", "<<", ">>"};
    static constexpr std::string_view kFirst = "|&=!<>";
    if (kFirst.find(text[begin]) == kFirst.npos) return begin + 1;
    const auto pair = std::find(std::begin(kPairs), std::end(kPairs), text.substr(begin, 2));
    return begin + (pair != std::end(kPairs) ? 2 : 1);
}

/// Sets the kind and the text of the token that begins at `begin`.
void readToken(std::string_view text, std::size_t begin, GlslToken& token)
{
    const bool number = isDigit(text[begin]);
    std::size_t end = begin;
    if (isWord(text[begin])) {
        token.kind = number ? GlslToken::Kind::number : GlslToken::Kind::identifier;
        while (end < text.size() && (isWord(text[end]) || (number && text[end] == '.'))) ++end;
    } else if (text[begin] == '"') {
        token.kind = GlslToken::Kind::quoted;
        end = quotedEnd(text, begin);
    } else {
        token.kind = GlslToken::Kind::symbol;
        end = symbolEnd(text, begin);
    }
    token.text = text.substr(begin, end - begin);
}

/// Without what a blanked comment leaves at the end, unless a backslash then continued the line.
std::string_view trimEnd(std::string_view line)
{
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    std::size_t size = line.size();
    while (size > 0 && isSpace(line[size - 1])) --size;
    return size > 0 && line[size - 1] == '\\' ? line : line.substr(0, size);
}

}  // namespace

BlankedText blankComments(std::string_view text)
{
    BlankedText blanked = {std::string(text), 0};
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '"') {
            at = quotedEnd(text, at);
            continue;
        }
        bool open = false;
        const std::size_t end = commentEnd(text, at, open);
        if (open) blanked.open_line = 1 + int(std::count(text.begin(), text.begin() + at, '\n'));
        for (std::size_t i = at; i < end; ++i)
            if (text[i] != '\n') blanked.text[i] = ' ';
        at = std::max(end, at + 1);
    }
    return blanked;
}

void tokenize(std::string_view text, int file, int line, GlslTokens& tokens)
{
    for (std::size_t at = 0; at < text.size();) {
        if (isSpace(text[at]) || text[at] == '\\') {
            ++at;
            continue;
        }
        GlslToken token{GlslToken::Kind::symbol, {}, file, line, int(at) + 1};
        readToken(text, at, token);
        tokens.push_back(token);
        at += token.text.size();
    }
}

std::vector<GlslLine> glslLines(std::string_view text, int file)
{
    std::vector<GlslLine> lines;
    bool continued = false;
    for (int number = 1; !text.empty(); ++number) {
        if (!continued) lines.emplace_back().line = number;
        const std::size_t end = lineEnd(text, 0, false);
        const std::string_view part = trimEnd(text.substr(0, end));
        continued = !part.empty() && part.back() == '\\';
        tokenize(part, file, number, lines.back().tokens);
        lines.back().text.append(part).push_back('\n');
        ++lines.back().count;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

GlslMacros::Macro* GlslMacros::find(std::string_view name)
{
    const auto found = macros_.find(name);
    if (found != macros_.end()) return found->second ? &*found->second : nullptr;
    const auto value = offered_.find(std::string(name));
    std::optional<Macro>& macro = macros_[std::string(name)];
    if (value == offered_.end()) return nullptr;
    macro.emplace();
    tokenize(values_.emplace_back(onOneLine(value->second)), -1, 0, macro->body);
    return &*macro;
}

std::vector<std::string> GlslMacros::names()
{
    std::vector<std::string> names;
    for (const auto& offered : offered_)
        if (defined(offered.first)) names.push_back(offered.first);
    for (const auto& [name, macro] : macros_)
        if (macro && offered_.count(name) == 0) names.push_back(name);
    return names;
}

bool GlslMacros::expand(const GlslToken& token, GlslTokens& out)
{
    const bool name = token.kind == GlslToken::Kind::identifier;
    Macro* const found = name ? find(token.text) : nullptr;
    if (!found || found->function_like || found->open) {
        out.push_back(token);
        return true;
    }
    found->open = true;
    bool ok = ++depth_ <= kMaxMacroDepth;
    for (const GlslToken& part : found->body) {
        const GlslToken here{part.kind, part.text, token.file, token.line, token.column};
        ok = ok && ++steps_ <= kMaxMacroSteps && expand(here, out);
    }
    found->open = false;
    --depth_;
    return ok;
}

bool GlslMacros::expandCondition(const GlslToken* begin, const GlslToken* end, GlslTokens& out)
{
    for (const GlslToken* token = begin; token != end; ++token) {
        if (!token->is("defined")) {
            if (!expand(*token, out)) return false;
            continue;
        }
        const bool parentheses = end - token > 3 && token[1].is("(") && token[3].is(")");
        const GlslToken* name = token + (parentheses ? 2 : 1);
        GlslToken value = *token;
        value.kind = GlslToken::Kind::number;
        if (name < end && name->kind == GlslToken::Kind::identifier) {
            value.text = defined(name->text) ? "1" : "0";
            token = parentheses ? name + 1 : name;
        } else {
            value.text = "?";  // no number: the condition cannot be read
        }
        out.push_back(value);
    }
    return true;
}

namespace {

/// Deepest nesting of parentheses and prefix operators; keeps the recursion off the stack's end.
constexpr int kMaxNesting = 64;

using Int = std::int64_t;
using Bits = std::uint64_t;

/// Empty is a value that is not known; it does no harm where && or || need not look at it.
using Value = std::optional<Int>;

Value wrapped(Bits bits) { return static_cast<Int>(bits); }

Value divided(Int left, Int right, bool remainder)
{
    if (right == 0) return {};
    if (right == -1) return remainder ? Value(0) : wrapped(0 - Bits(left));  // no overflow
    return remainder ? left % right : left / right;
}

/// A binary operator, and how tightly it binds.
struct Operator {
    std::string_view name;  ///< The sign.
    int level;
    Value (*apply)(Int, Int);
};

constexpr Bits kLastBit = 63;

constexpr Operator kOperators[] = {
    {"||", 1, [](Int a, Int b) -> Value { return a || b; }},
    {"&&", 2, [](Int a, Int b) -> Value { return a && b; }},
    {"|", 3, [](Int a, Int b) -> Value { return a | b; }},
    {"^", 4, [](Int a, Int b) -> Value { return a ^ b; }},
    {"&", 5, [](Int a, Int b) -> Value { return a & b; }},
    {"==", 6, [](Int a, Int b) -> Value { return a == b; }},
    {"!=", 6, [](Int a, Int b) -> Value { return a != b; }},
    {"<", 7, [](Int a, Int b) -> Value { return a < b; }},
    {"<=", 7, [](Int a, Int b) -> Value { return a <= b; }},
    {">", 7, [](Int a, Int b) -> Value { return a > b; }},
    {">=", 7, [](Int a, Int b) -> Value { return a >= b; }},
    {"<<", 8, [](Int a, Int b) { return Bits(b) > kLastBit ? Value() : wrapped(Bits(a) << b); }},
    {">>", 8, [](Int a, Int b) { return Bits(b) > kLastBit ? Value() : Value(a >> b); }},
    {"+", 9, [](Int a, Int b) { return wrapped(Bits(a) + Bits(b)); }},
    {"-", 9, [](Int a, Int b) { return wrapped(Bits(a) - Bits(b)); }},
    {"*", 10, [](Int a, Int b) { return wrapped(Bits(a) * Bits(b)); }},
    {"/", 10, [](Int a, Int b) { return divided(a, b, false); }},
    {"%", 10, [](Int a, Int b) { return divided(a, b, true); }},
};

Value combined(const Operator& by, Value left, Value right)
{
    if (!left) return {};
    const bool logical = by.name == "&&" || by.name == "||";
    if (logical && (*left != 0) == (by.name == "||")) return *left != 0;
    return right ? by.apply(*left, *right) : Value();
}

/// Reads by precedence climbing.
struct Evaluator {
    const GlslToken* at;
    const GlslToken* const end;
    bool bad = false;
    int nesting = 0;

    Value run()
    {
        const Value value = expression(1);
        return bad || at != end ? Value() : value;
    }

    Value expression(int lowest)
    {
        Value left = operand();
        while (!bad && at != end) {
            const Operator* by = findNamed(kOperators, at->text);
            if (!by || by->level < lowest) break;
            ++at;
            left = combined(*by, left, expression(by->level + 1));
        }
        return left;
    }

    Value operand()
    {
        if (at == end || bad || nesting == kMaxNesting) return fail();
        const GlslToken& token = *at++;
        if (token.kind == GlslToken::Kind::number) return number(token);
        if (token.kind == GlslToken::Kind::identifier) return {};
        ++nesting;
        const Value value = token.is("(") ? parentheses() : prefixed(token.text);
        --nesting;
        return value;
    }

    Value parentheses()
    {
        const Value value = expression(1);
        if (at == end || !at->is(")")) return fail();
        ++at;
        return value;
    }

    Value prefixed(std::string_view sign)
    {
        if (sign != "!" && sign != "-" && sign != "+" && sign != "~") return fail();
        const Value value = operand();
        if (!value || sign == "+") return value;
        if (sign == "!") return *value == 0;
        return sign == "-" ? wrapped(0 - Bits(*value)) : Value(~*value);
    }

    Value number(const GlslToken& token)
    {
        std::string digits(token.text);
        if (digits.back() == 'u' || digits.back() == 'U') digits.pop_back();
        char* rest = nullptr;
        const unsigned long long value = std::strtoull(digits.c_str(), &rest, 0);
        return digits.empty() || *rest != '\0' ? fail() : wrapped(value);
    }

    Value fail()
    {
        bad = true;
        return {};
    }
};

}  // namespace

std::string onOneLine(const std::string& value)
{
    std::string text = blankComments(value).text;
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

std::optional<std::int64_t> evaluate(const GlslToken* begin, const GlslToken* end)
{
    return Evaluator{begin, end}.run();
}

}  // namespace crevice
