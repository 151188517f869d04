// SPDX-License-Identifier: MIT
// Comments, lines and tokens of GLSL.
#include "core/glsl/lexer.h"

#include "core/base/text.h"

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
        GlslToken token;
        token.file = file;
        token.line = line;
        token.column = int(at) + 1;
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

}  // namespace crevice
