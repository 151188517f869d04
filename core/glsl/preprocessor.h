// SPDX-License-Identifier: MIT
// The preprocessor: resolves includes, follows #if as the driver will, and writes one text; with
// macros and constant expressions, as it and array sizes know them, over lines and tokens at the
// author's lines and columns, to which all later steps point back.
//
// It evaluates conditions only to know which includes and declarations count; the text keeps the
// author's directives, and the driver evaluates them again.
#pragma once

#include <crevice/glsl_stage.h>

#include <cstdint>
#include <deque>
#include <set>

namespace crevice {

/// A word, number or sign. `text` points into the text that was read, which must outlive it.
struct GlslToken {
    enum class Kind { identifier, number, quoted, symbol };

    Kind kind = Kind::symbol;
    std::string_view text;  ///< With the quotes, when quoted.
    int file = -1;          ///< Source-string number; -1 when it comes from no file.
    int line = 0;           ///< From 1.
    int column = 0;         ///< From 1, in bytes.

    bool is(std::string_view other) const { return text == other; }
};

using GlslTokens = std::vector<GlslToken>;

/// A text whose comments are spaces; lines and columns are unchanged.
struct BlankedText {
    std::string text;
    int open_line = 0;  ///< Line of a comment that never ends; 0 when all end.
};
BlankedText blankComments(std::string_view text);

/// A line with those it continues on after a backslash.
struct GlslLine {
    std::string text;  ///< As it is to be written, ending in a newline.
    GlslTokens tokens;
    int line = 0;   ///< Of the first.
    int count = 0;  ///< Lines of the file.

    bool isDirective() const { return !tokens.empty() && tokens[0].is("#"); }

    /// The word after '#'; empty for a lone '#'. Requires isDirective().
    std::string_view directive() const { return tokens.size() > 1 ? tokens[1].text : ""; }
};

/// The lines of a blanked text, which must outlive their tokens.
std::vector<GlslLine> glslLines(std::string_view text, int file);

/// Appends the tokens of one line, whose first byte is in column 1.
void tokenize(std::string_view text, int file, int line, GlslTokens& tokens);

/// Replacements that one stage may take. A shader needs some thousands; macros that double
/// themselves over and over would otherwise fill the memory.
constexpr int kMaxMacroSteps = 1 << 20;

/// Macros that stand for macros that stand for macros ...: keeps the recursion off the stack's end.
constexpr int kMaxMacroDepth = 256;

/// The macros that are defined at one point of the text.
class GlslMacros {
public:
    /// From the start those of `offered` are, which must outlive this; each is read when asked for.
    explicit GlslMacros(const std::map<std::string, std::string>& offered) : offered_(offered) {}

    /// A function-like macro counts as defined and is not expanded.
    void define(std::string_view name, GlslTokens body, bool function_like = false)
    {
        macros_[std::string(name)] = Macro{std::move(body), function_like, false};
    }
    void undefine(std::string_view name) { macros_[std::string(name)].reset(); }
    bool defined(std::string_view name) { return find(name) != nullptr; }

    /// All names that are defined.
    std::vector<std::string> names();

    /// Appends `token`, or what it stands for, at its place. False when a limit is reached.
    bool expand(const GlslToken& token, GlslTokens& out);

    /// Expands the condition of an #if: `defined X` becomes 1 or 0. False when a limit is reached.
    bool expandCondition(const GlslToken* begin, const GlslToken* end, GlslTokens& out);

private:
    struct Macro {
        GlslTokens body;
        bool function_like = false;
        bool open = false;  ///< Being expanded: its own name in it stays as it is.
    };

    Macro* find(std::string_view name);

    const std::map<std::string, std::string>& offered_;
    std::map<std::string, std::optional<Macro>, std::less<>> macros_;  ///< None: it is undefined.
    std::deque<std::string> values_;  ///< What tokens of those offered point into.
    int steps_ = 0;
    int depth_ = 0;
};

/// A value on one line and without comments, so that a #define holds all of it.
std::string onOneLine(const std::string& value);

/// The value of an integer expression of ! ~ * / % + - << >> < <= > >= == != & ^ | && || and
/// parentheses. Empty when it cannot be read, or has a name or divides by zero where that matters.
std::optional<std::int64_t> evaluate(const GlslToken* begin, const GlslToken* end);

/// `#line` counts an included file's lines from its source-string number times this, because Mesa
/// (22.3.6, all drivers) gives source string 0 for most errors, wherever they are. Line 7 of file 2
/// is line 200007 to the driver; explainLog takes it apart again.
constexpr int kLinesPerFile = 100000;

/// A stage after preprocessing.
struct GlslUnit {
    /// Before the first line, `defines` are, which must outlive it.
    explicit GlslUnit(const GlslDefines& defines) : macros(defines) {}

    std::string version;           ///< "300 es" or "310 es".
    std::string text;              ///< All that follows the #version line, without comments.
    std::vector<SourceRef> files;  ///< By source-string number.
    GlslTokens tokens;             ///< What is active, macros expanded.
    std::set<std::string_view> mentioned;  ///< Every name outside comments.
    GlslMacros macros;                     ///< As they stand at the end.
    Diagnostics errors;
    std::deque<std::string> blanked;  ///< What tokens and names point into; a deque never moves it.
};

/// Fills `unit` from the stage that begins in `files.at(path)`. Errors: those of assembleStage.
void preprocess(const std::map<std::string, SourceRef>& files,
                const std::map<std::string, std::string>& interfaces, const std::string& path,
                GlslUnit& unit);

/// Where a token stands; nowhere when it comes from no file.
Place placeOf(const GlslToken& token, const std::vector<SourceRef>& files);

/// Reads an #include line of `source`. False when it is malformed.
bool readInclude(const GlslLine& line, const SourceRef& source, GlslInclude& include);

}  // namespace crevice
