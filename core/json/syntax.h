// SPDX-License-Identifier: MIT
// Syntax errors in plain words. document.cpp reads with a parser that says little about what it
// could not read; this looks again at the place where it stopped.
#pragma once

#include <crevice/document.h>

namespace crevice {

/// Where a reader stopped.
struct SyntaxStop {
    enum class After { nothing, opening, key, value };

    SourceRef source;
    std::string_view text;            ///< Of the source, with blanks for comments and last commas.
    std::size_t offset = 0;           ///< Behind the last token that made sense.
    After after = After::nothing;     ///< What that token ended. A closing bracket ends a value.
    const Node* container = nullptr;  ///< The innermost object or array not closed yet.
    std::size_t bad = 0;              ///< The byte that breaks a string; 0 where none does.
};

/// What was found behind the stop and what was wanted there: CV1001, or CV1003 for a number that is
/// well formed but out of range.
Diagnostic explainSyntax(const SyntaxStop& stop);

/// The place of `length` bytes at `offset`.
Place placeAt(const SourceRef& source, std::size_t offset, std::size_t length = 1);

/// Bytes of white space at `offset`.
std::size_t spaceLength(std::string_view text, std::size_t offset);

/// Bytes of the string at `offset` with its quotes; one that is not closed ends with its line.
std::size_t stringLength(std::string_view text, std::size_t offset);

}  // namespace crevice
