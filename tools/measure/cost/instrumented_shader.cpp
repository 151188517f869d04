// SPDX-License-Identifier: MIT
// A fragment shader rewritten to count its fetches, token by token: the text is one that the
// library assembled, so includes are in it, and macros are as their authors wrote them.
#include "tools/measure/cost/counting_device.h"

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"

namespace crevice {

namespace {

constexpr const char* kCount = "crevice_fetches";
constexpr const char* kMain = "crevice_uncounted_main";

bool fetches(std::string_view word)
{
    static const std::vector<std::string> kFunctions = {
        "texture",           "textureLod",        "textureOffset",        "textureLodOffset",
        "textureGrad",       "textureGradOffset", "textureProj",          "textureProjLod",
        "textureProjOffset", "textureProjGrad",   "textureProjLodOffset", "textureProjGradOffset",
        "texelFetch",        "texelFetchOffset",  "textureGather",        "textureGatherOffset"};
    return contains(kFunctions, word);
}

/// Puts `what` at the byte.
struct Insertion {
    std::size_t at;
    std::size_t replaced;  ///< Bytes that it takes the place of.
    std::string what;
};

/// Where the parenthesis that opens at token `open` closes; the number of tokens where it does not.
std::size_t closing(const GlslTokens& tokens, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        if (tokens[i].is("(")) ++depth;
        if (tokens[i].is(")") && --depth == 0) return i;
    }
    return tokens.size();
}

/// The `out` of an output's declaration, and the layout before it, become nothing.
void dropOut(const GlslTokens& tokens, std::size_t out, const char* text,
             std::vector<Insertion>& insertions)
{
    std::size_t first = out;
    if (out > 0 && tokens[out - 1].is(")"))
        while (first > 0 && !tokens[first].is("layout")) --first;
    const auto begin = static_cast<std::size_t>(tokens[first].text.data() - text);
    const auto end = static_cast<std::size_t>(tokens[out].text.data() + 3 - text);
    insertions.push_back({begin, end - begin, ""});
}

std::string applied(const std::string& text, const std::vector<Insertion>& insertions)
{
    std::string result;
    std::size_t from = 0;
    for (const Insertion& each : insertions) {
        result.append(text, from, each.at - from).append(each.what);
        from = each.at + each.replaced;
    }
    return result.append(text, from, std::string::npos);
}

/// What must change at each token outside of directives, in the order of the text.
std::vector<Insertion> insertionsIn(const std::string& text, const GlslTokens& tokens)
{
    std::vector<Insertion> insertions;
    std::vector<std::size_t> ends;  // tokens, of calls that are still open
    int braces = 0, parentheses = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const GlslToken& token = tokens[i];
        const auto at = static_cast<std::size_t>(token.text.data() - text.data());
        braces += token.is("{") ? 1 : token.is("}") ? -1 : 0;
        parentheses += token.is("(") ? 1 : token.is(")") ? -1 : 0;
        const bool call = i + 1 < tokens.size() && tokens[i + 1].is("(");
        if (token.is("out") && braces == 0 && parentheses == 0)
            dropOut(tokens, i, text.data(), insertions);
        if (token.is("main") && braces == 0 && call) insertions.push_back({at, 4, kMain});
        if (fetches(token.text) && call) {
            insertions.push_back({at, 0, std::string("(++") + kCount + ", "});
            ends.push_back(closing(tokens, i + 1));
        }
        for (; !ends.empty() && ends.back() == i; ends.pop_back())
            insertions.push_back({at + 1, 0, ")"});
    }
    return insertions;
}

}  // namespace

std::optional<std::string> countedFragment(const std::string& text)
{
    const std::string blanked = blankComments(text).text;
    GlslTokens tokens;
    std::size_t begin = 0, body = 0;  // of the line; of what follows #version and #extension
    int line = 1;
    while (begin < blanked.size()) {
        const std::size_t end = std::min(blanked.find('\n', begin), blanked.size());
        const std::string_view whole(blanked.data() + begin, end - begin);
        GlslTokens found;
        tokenize(whole, 0, line++, found);
        const bool directive = !found.empty() && found[0].is("#");
        begin = std::min(end + 1, blanked.size());
        if (directive && found.size() > 1 && (found[1].is("version") || found[1].is("extension")))
            body = begin;
        if (directive && (found.size() < 2 || !found[1].is("define"))) continue;
        tokens.insert(tokens.end(), found.begin(), found.end());
    }
    const std::vector<Insertion> insertions = insertionsIn(blanked, tokens);
    std::string counted = applied(blanked, insertions);
    if (!has(counted, kMain)) return std::nullopt;
    counted.insert(body, std::string("highp int ") + kCount + " = 0;\n");
    counted += std::string("\nout highp vec4 crevice_count;\nvoid main()\n{\n    ") + kMain +
               "();\n    crevice_count = vec4(" + kCount + " & 255, " + kCount +
               " >> 8, 0, 255) / 255.0;\n}\n";
    return counted;
}

}  // namespace crevice
