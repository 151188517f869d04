// SPDX-License-Identifier: MIT
// GLSL text as lines and tokens: the ground under the preprocessor and the scan.
//
// Everything here keeps the author's lines and columns, since all later steps point back at them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

}  // namespace crevice
