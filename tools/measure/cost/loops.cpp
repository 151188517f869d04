// SPDX-License-Identifier: MIT
#include "tools/measure/cost/loops.h"

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"

namespace crevice {
namespace {

/// The active tokens of a text, in it.
class LoopReader {
public:
    explicit LoopReader(const std::string& text) : unit_(defines_)
    {
        auto source = std::make_shared<SourceText>();
        source->text = text;
        preprocess({{"shader", source}}, {}, "shader", unit_);
        if (!unit_.errors.empty()) return;
        const std::string& blanked = unit_.blanked.front();
        std::vector<std::size_t> lines = {0};  // where they begin
        for (std::size_t at = 0; (at = blanked.find('\n', at)) != std::string::npos;)
            lines.push_back(++at);
        for (const GlslToken& token : unit_.tokens) {
            const std::size_t at =
                lines[static_cast<std::size_t>(token.line) - 1] + token.column - 1;
            if (token.text.data() != blanked.data() + at) continue;  // what a macro stands for
            tokens_.push_back(token);
            places_.push_back(at);
        }
    }

    std::vector<GlslLoop> loops()
    {
        readFunctions();
        std::vector<GlslLoop> loops;
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i)
            if ((is(i, "for") || is(i, "while")) && is(i + 1, "(") && !endsDo(i))
                loops.push_back(loopAt(i));
        for (std::size_t outer = 0; outer < loops.size(); ++outer)
            for (const std::size_t inner : within(loops[outer].whole, loops))
                if (inner != outer) loops[inner].around.push_back(static_cast<int>(outer));
        return loops;
    }

private:
    struct Function {
        std::string_view name;
        TextPart body;
    };

    bool is(std::size_t i, const char* word) const
    {
        return i < tokens_.size() && tokens_[i].is(word);
    }
    std::size_t placeOf(std::size_t i) const
    {
        return i < places_.size() ? places_[i] : unit_.blanked.front().size();
    }

    /// The token after the bracket that closes the one at token `open`.
    std::size_t after(std::size_t open) const
    {
        int depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            if (is(i, "(") || is(i, "{")) ++depth;
            if ((is(i, ")") || is(i, "}")) && --depth == 0) return i + 1;
        }
        return tokens_.size();
    }

    /// The token after the statement at token `i`.
    std::size_t afterStatement(std::size_t i) const
    {
        if (is(i, "{")) return after(i);
        if (is(i, "for") || is(i, "while")) return afterStatement(after(i + 1));
        if (is(i, "if")) {
            const std::size_t end = afterStatement(after(i + 1));
            return is(end, "else") ? afterStatement(end + 1) : end;
        }
        while (i < tokens_.size() && !is(i, ";")) ++i;
        return i + 1;
    }

    /// Whether the `while` at token `i` is that of a `do`.
    bool endsDo(std::size_t i) const
    {
        return is(i, "while") && i > 0 && is(i - 1, "}") && is(after(i + 1), ";");
    }

    GlslLoop loopAt(std::size_t i) const
    {
        GlslLoop loop;
        const std::size_t end = after(i + 1), last = afterStatement(end);
        const std::size_t inside = placeOf(i + 1) + 1, closes = placeOf(end - 1);
        loop.whole = {placeOf(i), placeOf(last - 1) + tokens_[last - 1].text.size()};
        loop.body = {placeOf(end), loop.whole.end};
        loop.condition = {inside, closes};
        if (is(i, "while")) return loop;
        std::vector<std::size_t> semicolons;
        for (std::size_t at = i; at < end; ++at)
            if (is(at, ";")) semicolons.push_back(placeOf(at));
        semicolons.resize(2, closes);
        loop.initial = {inside, semicolons[0]};
        loop.condition = {semicolons[0] + 1, semicolons[1]};
        loop.step = {semicolons[1] + 1, closes};
        return loop;
    }

    void readFunctions()
    {
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
            if (is(i, "{")) i = after(i) - 1;  // of a struct or a block
            const bool named = tokens_[i].kind == GlslToken::Kind::identifier && is(i + 1, "(");
            if (!named || !is(after(i + 1), "{")) continue;
            const std::size_t body = after(i + 1), end = after(body);
            functions_.push_back({tokens_[i].text, {placeOf(body), placeOf(end - 1)}});
            i = end - 1;
        }
    }

    /// The loops that lie within the part or that functions called there run.
    std::vector<std::size_t> within(TextPart part, const std::vector<GlslLoop>& loops) const
    {
        std::vector<TextPart> parts = {part};
        for (std::size_t next = 0; next < parts.size(); ++next)
            for (std::size_t i = 0; i < tokens_.size(); ++i)
                for (const Function& function : functions_) {
                    const bool met = parts[next].holds(placeOf(i)) && is(i + 1, "(") &&
                                     tokens_[i].text == function.name;
                    const auto same = [&](const TextPart& other) {
                        return other.begin == function.body.begin;
                    };
                    if (met && !anyOf(parts, same)) parts.push_back(function.body);
                }
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (anyOf(parts, [&](TextPart each) { return each.holds(loops[i].whole.begin); }))
                found.push_back(i);
        return found;
    }

    GlslDefines defines_;
    GlslUnit unit_;
    GlslTokens tokens_;
    std::vector<std::size_t> places_;  ///< Of the tokens, in bytes.
    std::vector<Function> functions_;
};

struct Writer {
    const std::string& text;
    const std::vector<GlslLoop>& loops;
    int twice;

    std::string of(TextPart part) const
    {
        std::string written;
        std::size_t from = part.begin;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const TextPart& whole = loops[i].whole;
            if (whole.begin < from || whole.end > part.end) continue;  // within one before, outside
            written += text.substr(from, whole.begin - from) + unrolled(static_cast<int>(i));
            from = whole.end;
        }
        return written + text.substr(from, part.end - from);
    }

    std::string unrolled(int index) const
    {
        const GlslLoop& loop = loops[index];
        const std::string body = of(loop.body), condition = of(loop.condition);
        const std::string asked = trimmed(condition).empty() ? "true" : condition;
        // `continue` and `break` end one run of the body, as what follows costs the same then.
        const bool jumps = has(body, "break") || has(body, "continue");
        const std::string once =
            jumps ? "do { if (!(" + asked + ")) break;\n" + body + "\n} while (false);\n"
                  : "if (" + asked + ")\n" + body + "\n";
        const std::string step = of(loop.step) + ";\n";
        // Such as the #endif of an #if about the head alone.
        const std::size_t closes = std::max(loop.condition.end, loop.step.end);
        const std::string between = text.substr(closes + 1, loop.body.begin - closes - 1);
        return "{ " + of(loop.initial) + ";\n" + between + once + step +
               (index == twice ? once + step : "") + "}";
    }
};

}  // namespace

std::vector<GlslLoop> loopsOf(const std::string& text) { return LoopReader(text).loops(); }

std::string withoutLoops(const std::string& text, const std::vector<GlslLoop>& loops, int twice)
{
    return Writer{text, loops, twice}.of({0, text.size()});
}

double costAsItRuns(const std::vector<GlslLoop>& loops, double once,
                    const std::vector<double>& twice, const std::vector<double>& runs)
{
    std::vector<double> own(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) own[i] = std::max(twice[i] - once, 0.0);
    const std::vector<double> bodies = own;
    for (std::size_t inner = 0; inner < loops.size(); ++inner)
        for (const int outer : loops[inner].around) {
            const auto between = [&](int other) {
                return anyOf(loops[other].around, [outer](int each) { return each == outer; });
            };
            if (!anyOf(loops[inner].around, between)) own[outer] -= bodies[inner];
        }
    double cost = once;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        double times = runs[i];
        for (const int outer : loops[i].around) times *= runs[outer];
        cost += std::max(own[i], 0.0) * (times - 1.0);
    }
    return std::max(cost, 0.0);
}

}  // namespace crevice
