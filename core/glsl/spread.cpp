// SPDX-License-Identifier: MIT
// A stage with a token a line.
#include "core/base/text.h"
#include "core/glsl/compiler_words.h"
#include "core/glsl/preprocessor.h"

namespace crevice {

namespace {

/// Whether the sign is one of its own wherever it stands.
bool stands(const GlslToken& token)
{
    return std::string_view("(){}[];,").find(token.text) != std::string_view::npos;
}

/// Whether there may be a line's end between the two: not amid "+=", ".5" or "1e-5".
bool isApart(const GlslToken& a, const GlslToken& b)
{
    using Kind = GlslToken::Kind;
    if (a.line != b.line || a.column + int(a.text.size()) != b.column) return true;
    if (a.kind == Kind::number) return lowerCase(a.text).back() != 'e';
    return a.kind == Kind::identifier || b.kind == Kind::identifier || stands(a) || stands(b);
}

}  // namespace

SpreadStage spread(const GlslStage& stage)
{
    SpreadStage spread;
    int file = -1, offset = 0;  // of the author's lines; nowhere above the first #line
    for (const GlslLine& line : glslLines(stage.text, 0)) {
        const GlslTokens& tokens = line.tokens;
        if (line.isDirective() && line.directive() == "line") {  // an author's may say anything
            const auto number = [&](std::size_t i) {
                return i < tokens.size() ? evaluate(&tokens[i], &tokens[i] + 1).value_or(-1) : -1;
            };
            const bool known = number(3) >= 0 && number(3) < std::int64_t(stage.files.size());
            file = known ? int(number(3)) : -1;
            offset = int(number(2) % kLinesPerFile) - line.line - line.count;
            continue;
        }
        const auto place = [&](GlslToken token) {
            token.file = file;
            token.line += offset;
            spread.tokens.push_back(token);
        };
        if (line.isDirective()) {
            spread.text += line.text;
            for (int i = 0; i < line.count; ++i) place(tokens[0]);
            continue;
        }
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const bool apart = i == 0 || isApart(tokens[i - 1], tokens[i]);
            if (apart) place(tokens[i]);
            if (apart && !spread.text.empty() && spread.text.back() != '\n') spread.text += '\n';
            spread.text += tokens[i].text;
        }
        if (!tokens.empty()) spread.text += '\n';
    }
    return spread;
}

}  // namespace crevice
