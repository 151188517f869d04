// SPDX-License-Identifier: MIT
// Shader stages taken apart: enough of GLSL's grammar to know what is declared at the outermost level.
#include "core/glsl_code.h"

#include "core/glsl_scan.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace crevice {

namespace {

bool isName(const GlslToken& token) { return token.kind == GlslToken::Kind::identifier; }

bool isFloats(std::string_view type)
{
    return type == "float" || type.substr(0, 3) == "vec" || type.substr(0, 3) == "mat";
}

// Takes tokens from the lines of the text to those that #line says they come from.
void placeTokens(const std::string& text, GlslTokens& tokens)
{
    int line = 0;
    int file = -1;
    int shift = 0;
    auto token = tokens.begin();
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
        ++line;
        int from = 0;
        if (std::sscanf(text.c_str() + begin, "#line %d %d", &from, &file) == 2)
            shift = from - file * kLinesPerFile - (line + 1);
        for (; token != tokens.end() && token->line == line; ++token) {
            token->file = file;
            token->line += shift;
        }
        begin = std::min(text.find('\n', begin), text.size());
    }
}

class StatementReader {
public:
    explicit StatementReader(const GlslTokens& tokens) : tokens_(tokens) {}

    /// False where the text is of no known form.
    bool read(std::vector<GlslStatement>& statements)
    {
        while (at_ < tokens_.size()) {
            if (take(";")) continue;
            GlslStatement next;
            next.begin = at_;
            if (!readOne(next)) return false;
            next.end = at_;
            statements.push_back(std::move(next));
        }
        return true;
    }

private:
    bool is(std::string_view text) const { return at_ < tokens_.size() && tokens_[at_].is(text); }

    bool take(std::string_view text)
    {
        const bool found = is(text);
        at_ += found ? 1 : 0;
        return found;
    }

    bool takeName(std::vector<std::size_t>& names)
    {
        if (at_ >= tokens_.size() || !isName(tokens_[at_])) return false;
        names.push_back(at_++);
        return true;
    }

    /// From a bracket to behind the one that closes it; false where there is none at hand.
    bool takeBrackets(std::string_view open, std::string_view close);
    bool takeAnyBrackets()
    {
        return takeBrackets("(", ")") || takeBrackets("[", "]") || takeBrackets("{", "}");
    }

    bool readQualifiers(GlslStatement& into);
    bool readOne(GlslStatement& into);
    bool readPrecision(GlslStatement& into);
    bool readStructure(GlslStatement& into);
    bool readFunction(GlslStatement& into);
    bool readVariables(GlslStatement& into);

    const GlslTokens& tokens_;
    std::size_t at_ = 0;
    std::string_view float_precision_ = {};
};

bool StatementReader::takeBrackets(std::string_view open, std::string_view close)
{
    if (!is(open)) return false;
    int depth = 0;
    for (std::size_t end = at_; end < tokens_.size(); ++end) {
        if (tokens_[end].is(open)) ++depth;
        if (!tokens_[end].is(close) || --depth > 0) continue;
        at_ = end + 1;
        return true;
    }
    return false;
}

bool StatementReader::readQualifiers(GlslStatement& into)
{
    for (; at_ < tokens_.size() && (is("layout") || isQualifier(tokens_[at_].text));) {
        const std::string_view word = tokens_[at_++].text;
        if (word == "layout" && !takeBrackets("(", ")")) return false;
        if (word == "in" || word == "out" || word == "uniform" || word == "const") into.storage = word;
        if (word == "highp" || word == "mediump" || word == "lowp") into.precision = word;
    }
    return true;
}

bool StatementReader::readOne(GlslStatement& into)
{
    if (!readQualifiers(into)) return false;
    if (take("precision")) return readPrecision(into);
    if (take("struct")) return readStructure(into);
    std::vector<std::size_t> type;
    if (!takeName(type)) return false;
    into.type = type.front();
    takeBrackets("[", "]");
    if (!takeName(into.names)) return false;
    return is("(") ? readFunction(into) : readVariables(into);
}

bool StatementReader::readPrecision(GlslStatement& into)
{
    into.kind = GlslStatement::Kind::precision;
    std::vector<std::size_t> words;
    if (!takeName(words)) return false;
    float_precision_ = tokens_[words.front()].text;
    return take("float") && take(";");
}

bool StatementReader::readStructure(GlslStatement& into)
{
    into.kind = GlslStatement::Kind::structure;
    return takeName(into.names) && takeBrackets("{", "}") && take(";");
}

bool StatementReader::readFunction(GlslStatement& into)
{
    into.kind = GlslStatement::Kind::function;
    return takeBrackets("(", ")") && (take(";") || takeBrackets("{", "}"));
}

bool StatementReader::readVariables(GlslStatement& into)
{
    if (into.precision.empty() && isFloats(tokens_[into.type].text)) into.precision = float_precision_;
    while (at_ < tokens_.size() && !take(";")) {
        if (take(",")) {
            if (!takeName(into.names)) return false;
        } else if (!takeAnyBrackets()) {
            ++at_;  // of a value
        }
    }
    return tokens_[at_ - 1].is(";");
}

}  // namespace

GlslCode::GlslCode(const GlslStage& stage)
{
    const auto source = std::make_shared<const SourceText>(SourceText{"stage", stage.text});
    preprocess({{"stage", source}}, {}, "stage", {}, unit_);
    placeTokens(stage.text, unit_.tokens);
    known_ = unit_.errors.empty() && unit_.mentioned.count("extension") == 0 &&
             unit_.mentioned.count("pragma") == 0 && StatementReader(unit_.tokens).read(statements_);
}

bool GlslCode::isFree(std::size_t i) const
{
    return isName(tokens()[i]) && (i == 0 || !tokens()[i - 1].is("."));
}

bool GlslCode::stands(std::size_t begin, std::initializer_list<std::string_view> words) const
{
    if (begin > tokens().size() || words.size() > tokens().size() - begin) return false;
    return std::equal(words.begin(), words.end(), tokens().begin() + static_cast<std::ptrdiff_t>(begin),
                      [](std::string_view word, const GlslToken& token) { return token.is(word); });
}

const GlslStatement* GlslCode::declarationOf(std::string_view name) const
{
    for (const GlslStatement& each : statements_)
        for (const std::size_t index : each.names)
            if (tokens()[index].is(name)) return &each;
    return nullptr;
}

bool GlslCode::isHidden(std::size_t token, std::string_view name) const
{
    for (const GlslStatement& each : statements_)
        for (std::size_t i = each.begin + 1; each.begin <= token && token < each.end && i < each.end; ++i)
            if (tokens()[i].is(name) && isName(tokens()[i - 1]) && !tokens()[i - 1].is("return")) return true;
    return false;
}

}  // namespace crevice
