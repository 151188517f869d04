// SPDX-License-Identifier: MIT
#include "tools/measure/cost/counted_fragment.h"

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"

namespace crevice {
namespace {

constexpr const char* kCount = "crevice_fetches";
constexpr const char* kLoops = "crevice_loops";
constexpr const char* kMain = "crevice_uncounted_main";

const std::vector<std::string> kFetches = {
    "texture",           "textureLod",        "textureOffset",        "textureLodOffset",
    "textureGrad",       "textureGradOffset", "textureProj",          "textureProjLod",
    "textureProjOffset", "textureProjGrad",   "textureProjLodOffset", "textureProjGradOffset",
    "texelFetch",        "texelFetchOffset",  "textureGather",        "textureGatherOffset"};

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
    for (std::size_t i = out; i > 0 && !tokens[i - 1].is(";") && !tokens[i - 1].is("define"); --i)
        if (tokens[i - 1].is("layout")) first = i - 1;
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

/// What must change at each token, but for directives other than #define, in the order of the text.
/// `names` are those of functions that fetch.
std::vector<Insertion> insertionsIn(const std::string& text, const GlslTokens& tokens,
                                    const std::vector<std::string>& names)
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
        if (contains(names, token.text) && call) {
            insertions.push_back({at, 0, std::string("(++") + kCount + ", "});
            ends.push_back(closing(tokens, i + 1));
        }
        for (; !ends.empty() && ends.back() == i; ends.pop_back())
            insertions.push_back({at + 1, 0, ")"});
    }
    return insertions;
}

/// Counts how often each loop is entered, and its body run.
void countLoops(const std::vector<GlslLoop>& loops, std::vector<Insertion>& insertions)
{
    std::vector<Insertion> before, after;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const std::string count = std::string(kLoops) + "[" + std::to_string(i) + "]";
        const TextPart& condition = loops[i].condition;
        before.push_back({loops[i].whole.begin, 0, "{ ++" + count + ".x; "});
        const bool always = condition.begin == condition.end;
        before.push_back({condition.begin, 0, always ? "(true" : "("});
        after.push_back({condition.end, 0, ") && ++" + count + ".y > 0"});
        after.push_back({loops[i].whole.end, 0, " }"});
    }
    insertions.insert(insertions.begin(), before.begin(), before.end());
    insertions.insert(insertions.end(), after.begin(), after.end());
    std::stable_sort(insertions.begin(), insertions.end(),
                     [](const Insertion& a, const Insertion& b) { return a.at < b.at; });
}

}  // namespace

std::optional<std::string> countedFragment(const std::string& text,
                                           const std::vector<GlslLoop>& loops)
{
    const std::string blanked = blankComments(text).text;
    GlslTokens tokens;
    std::size_t begin = 0, body = 0;  // of the line; of what follows #version and #extension
    std::vector<std::string> names = kFetches;
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
        if (directive && found.size() == 4 && contains(names, found[3].text))
            names.emplace_back(found[2].text);  // another name of such a function
        tokens.insert(tokens.end(), found.begin(), found.end());
    }
    std::vector<Insertion> insertions = insertionsIn(blanked, tokens, names);
    countLoops(loops, insertions);
    std::string counted = applied(blanked, insertions);
    if (!has(counted, kMain)) return std::nullopt;
    const std::string size = std::to_string(loops.size() + 1);
    counted.insert(body, std::string("highp int ") + kCount + " = 0;\nhighp ivec2 " + kLoops + "[" +
                             size + "];\nuniform highp int " + kWhich + ";\n");
    counted +=
        std::string("\nout highp vec4 crevice_count;\nvoid main()\n{\n    for (int i = 0; i < ") +
        size + "; ++i) " + kLoops + "[i] = ivec2(0);\n    " + kMain +
        "();\n    highp ivec2 count = " + kWhich + " == 0 ? ivec2(" + kCount + ", 1) : " + kLoops +
        "[" + kWhich +
        " - 1];\n    crevice_count = vec4(count.x & 255, "
        "count.x >> 8, count.y & 255, count.y >> 8) / 255.0;\n}\n";
    return counted;
}

}  // namespace crevice
