// SPDX-License-Identifier: MIT
// Macros and constant expressions, as GLSL's preprocessor and its array sizes know them.
#pragma once

#include "core/glsl/lexer.h"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace crevice {

/// Replacements that one stage may take. A shader needs some thousands; macros that double
/// themselves over and over would otherwise fill the memory.
constexpr int kMaxMacroSteps = 1 << 20;

/// Macros that stand for macros that stand for macros ...: keeps the recursion off the stack's end.
constexpr int kMaxMacroDepth = 256;

/// The macros that are defined at one point of the text.
class GlslMacros {
public:
    /// From the start those of `offered` are, which must outlive this; each is read when it is
    /// first asked for.
    explicit GlslMacros(const std::map<std::string, std::string>& offered) : offered_(offered) {}

    /// A function-like macro counts as defined and is not expanded.
    void define(std::string_view name, GlslTokens body, bool function_like = false);
    void undefine(std::string_view name);
    bool defined(std::string_view name) { return find(name) != nullptr; }

    /// All names that are defined.
    std::vector<std::string> names();

    /// Appends `token`, or what it stands for, at the place of `token`. False when a limit is
    /// reached.
    bool expand(const GlslToken& token, GlslTokens& out);

    /// Expands the condition of an #if, where `defined X` and `defined(X)` become 1 or 0. False
    /// when a limit is reached.
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

}  // namespace crevice
