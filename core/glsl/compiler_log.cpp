// SPDX-License-Identifier: MIT
// Driver logs. After #line a driver reports the source-string number and the line:
//
//   Mesa                     0:5(12): error: `foo' undeclared
//   NVIDIA                   0(5) : error C1503: undefined variable "foo"
//   ANGLE, Qualcomm, Apple   ERROR: 0:5: 'foo' : undeclared identifier
//   ARM                      0:5: L0001: Undefined variable 'foo'
//   linkers                  error: vertex shader does not write `uv'
//
// And stages with a token a line, for compilers that tell no columns.
#include "core/base/text.h"
#include "core/glsl/compiler_words.h"

#include <cstdio>

namespace crevice {

namespace {

constexpr std::string_view kLineEnds("\n\0", 2);  // a log may hold its own terminator

struct LogLine {
    bool known = false;
    bool continues = false;  ///< Mesa indents what belongs to the message before.
    Severity severity = Severity::error;
    int file = -1;
    int line = 0;
    int column = 0;
    std::string_view message;
};

/// Takes "error", "warning" and Mesa's "preprocessor error", with what separates them from the
/// message, off the text.
bool takeSeverity(std::string_view& text, Severity& severity)
{
    for (const std::string_view word : {"preprocessor error", "error", "warning"}) {
        if (lowerCase(text.substr(0, word.size())) != word) continue;
        std::string_view rest = text.substr(word.size());
        if (!rest.empty() && isWord(rest[0])) return false;
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        for (const char sign : {':', ' '})
            if (!rest.empty() && rest[0] == sign) rest.remove_prefix(1);
        severity = word == "warning" ? Severity::warning : Severity::error;
        text = rest;
        return true;
    }
    return false;
}

/// Takes "0:5(12):", "0:5:" or "0(5) :" off the text.
bool takePlace(std::string_view& text, LogLine& line)
{
    const std::string copy(text);
    int file = 0, number = 0, column = 0, end = 0;  // nine digits are what an int holds
    std::sscanf(copy.c_str(), "%9d:%9d(%9d) : %n", &file, &number, &column, &end);
    if (end == 0) column = 0;
    if (end == 0) std::sscanf(copy.c_str(), "%9d:%9d : %n", &file, &number, &end);
    if (end == 0) std::sscanf(copy.c_str(), "%9d(%9d) : %n", &file, &number, &end);
    if (end == 0 || number < 0 || column < 0) return false;
    line.file = number < kLinesPerFile ? file : number / kLinesPerFile;
    line.line = number % kLinesPerFile;
    line.column = column;
    text.remove_prefix(std::size_t(end));
    return true;
}

LogLine readLine(std::string_view text)
{
    LogLine line;
    std::string_view rest = text;
    const bool severity_first = takeSeverity(rest, line.severity);
    const bool place = takePlace(rest, line);
    if (place && !severity_first) takeSeverity(rest, line.severity);
    line.known = place || (severity_first && !rest.empty());
    line.continues = line.known && !rest.empty() && rest[0] == ' ';
    line.message = trimmed(line.known ? rest : text, " \t.");
    return line;
}

/// Headings and counts that drivers put around their messages.
bool saysNothing(std::string_view line)
{
    constexpr std::string_view kHeading = " info";
    if (trimmed(line, "- \t").empty()) return true;
    for (const char* empty : {"No code generated", "compilation terminated"})
        if (has(line, empty)) return true;
    return line.size() > kHeading.size() && endsWith(line, kHeading);
}

/// The column of the author's line for one that Mesa counted after each run of spaces became one.
int authorColumn(std::string_view text, int column)
{
    const auto space = [&](std::size_t i) { return text[i] == ' ' || text[i] == '\t'; };
    int counted = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i == 0 || !space(i) || !space(i - 1)) ++counted;
        if (counted == column && (i + 1 == text.size() || !space(i) || !space(i + 1)))
            return int(i) + 1;
    }
    return column;
}

/// Points at the name that the message quotes, or else where the driver does.
void refine(Place& place, std::string_view message)
{
    const std::string_view text = lineOf(place.source->text, place.line);
    if (place.column > 0) place.column = authorColumn(text, place.column);
    const std::string_view name = quotedName(message);
    const std::size_t at = findWord(text, name);
    if (name.empty() || at == std::string_view::npos) return;
    place.column = int(at) + 1;
    place.length = int(name.size());
}

/// Of the token that a compiler's line is, or of the name it quotes, which it may have read past.
Place placeAt(const GlslStage& stage, const GlslTokens& tokens, std::size_t at,
              std::string_view message)
{
    constexpr std::size_t kBack = 16;
    const std::string_view name = quotedName(message);
    const std::size_t last = std::min(at, tokens.size() - 1);
    for (std::size_t i = last; i + kBack > last && i < tokens.size(); --i)
        if (tokens[i].is(name) && !isDigit(name[0])) return placeOf(tokens[i], stage.files);
    return placeOf(tokens[last], stage.files);
}

Place placeIn(const GlslStage& stage, const LogLine& line)
{
    Place place;
    const bool known = line.file >= 0 && std::size_t(line.file) < stage.files.size();
    if (!stage.files.empty()) place.source = stage.files[known ? std::size_t(line.file) : 0];
    if (!known) return place;
    place.line = line.line;
    place.column = line.column;
    refine(place, line.message);
    return place;
}

/// Adds a candidate, say, to the message "no matching function; candidates are:".
void join(std::string& message, std::string_view more)
{
    if (!message.empty()) message += message.back() == ':' ? " " : "; ";
    message += more;
}

/// What a mistake makes of the rest of its line is no mistake of its own.
bool follows(const Diagnostics& diagnostics, const Diagnostic& next)
{
    if (diagnostics.empty() || next.place.line == 0) return false;
    const Diagnostic& last = diagnostics.back();
    return last.severity == Severity::error && last.place.source == next.place.source &&
           last.place.line == next.place.line;
}

/// Whether the sign is one of its own wherever it stands.
bool stands(const GlslToken& token) { return has("(){}[];,", token.text); }

/// Whether there may be a line's end between the two: not amid "+=", ".5" or "1e-5".
bool isApart(const GlslToken& a, const GlslToken& b)
{
    using Kind = GlslToken::Kind;
    if (a.line != b.line || a.column + int(a.text.size()) != b.column) return true;
    if (a.kind == Kind::number) return lowerCase(a.text).back() != 'e';
    return a.kind == Kind::identifier || b.kind == Kind::identifier || stands(a) || stands(b);
}

}  // namespace

std::string_view quotedName(std::string_view message)
{
    for (std::size_t at = 0; (at = message.find_first_of("`'\"", at)) != std::string_view::npos;) {
        std::size_t end = ++at;
        while (end < message.size() && isWord(message[end])) ++end;
        const char next = end < message.size() ? message[end] : ' ';
        const bool closed = next == '\'' || next == '"' || next == '(';  // `g(int)'
        if (end > at && closed) return message.substr(at, end - at);
    }
    return {};
}

Diagnostics explainSpread(const GlslStage& stage, const GlslTokens& tokens, Code code,
                          const std::string& log)
{
    Diagnostics diagnostics;
    for (const std::string_view text : split(log, '\n')) {
        const LogLine line = readLine(text);
        if (!line.known || line.severity != Severity::error || saysNothing(text)) continue;
        Diagnostic next{code, std::string(line.message), "", {stage.files.front()}};
        if (line.line > 0 && !tokens.empty())
            next.place = placeAt(stage, tokens, std::size_t(line.line) - 1, line.message);
        if (!next.place.source) next.place.source = stage.files.front();
        sayPlainly(stage, tokens, next);
        if (!follows(diagnostics, next)) diagnostics.push_back(std::move(next));
    }
    if (diagnostics.empty() && !log.empty())
        diagnostics.push_back({code, "glslang refuses this shader", "", {stage.files.front()}});
    return diagnostics;
}

Diagnostics explainLog(const GlslStage& stage, Code code, const std::string& log)
{
    Diagnostics diagnostics;
    std::string unknown;
    for (std::string_view rest = log; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(kLineEnds), rest.size());
        const std::string_view text = trimmed(rest.substr(0, end), " \t\r");
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (saysNothing(text)) continue;
        const LogLine line = readLine(text);
        if (!line.known) {
            join(unknown, line.message);
        } else if (line.continues && !diagnostics.empty()) {
            join(diagnostics.back().message, line.message);
        } else {
            Diagnostic next{code, std::string(line.message), "", placeIn(stage, line)};
            next.severity = line.severity;
            if (!follows(diagnostics, next)) diagnostics.push_back(std::move(next));
        }
    }
    constexpr std::size_t kPlain = 16;  // each may search all of the text
    const SpreadStage tokens = spread(stage);
    for (std::size_t i = 0; i < std::min(kPlain, diagnostics.size()); ++i)
        if (diagnostics[i].severity == Severity::error)
            sayPlainly(stage, tokens.tokens, diagnostics[i]);
    if (unknown.empty() && diagnostics.empty()) unknown = "the driver gave no message";
    if (!unknown.empty()) diagnostics.push_back({code, unknown, "", placeIn(stage, {})});
    return diagnostics;
}

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
            if (apart)
                place(tokens[i]);
            else  // of the same text
                spread.tokens.back().text = {
                    spread.tokens.back().text.data(),
                    spread.tokens.back().text.size() + tokens[i].text.size()};
            if (apart && !spread.text.empty() && spread.text.back() != '\n') spread.text += '\n';
            spread.text += tokens[i].text;
        }
        if (!tokens.empty()) spread.text += '\n';
    }
    return spread;
}

}  // namespace crevice
