// SPDX-License-Identifier: MIT
// The loops of a shader's text, and that text with each loop's body written out a given number of
// times: what a compiler takes more for twice than for once is what one run of the body costs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace crevice {

/// Bytes of a text.
struct TextPart {
    std::size_t begin = 0;
    std::size_t end = 0;

    bool holds(std::size_t at) const { return begin <= at && at < end; }
};

/// A `for` or `while`. One `do` is no loop here: its body counts once.
struct GlslLoop {
    TextPart whole, initial, condition, step, body;
    std::vector<int> around;  ///< The loops whose bodies run this one, by calls too.
};

/// Loops of what is active in the text of a stage, by where they begin; comments are blanks. None
/// where the text cannot be read.
std::vector<GlslLoop> loopsOf(const std::string& text);

/// The text with the body of loop `twice` run up to two times and all others' once, none in a loop;
/// -1: all of them once.
std::string withoutLoops(const std::string& text, const std::vector<GlslLoop>& loops, int twice);

/// What all of a shader costs as it runs, from what it costs with every loop's body once (`once`),
/// with that of one loop twice (`twice`), and the times that a body runs whenever its loop is
/// entered (`runs`). What runs more often than once is what a body adds, less what loops within it
/// add, times the runs of the loops around it and its own.
double costAsItRuns(const std::vector<GlslLoop>& loops, double once,
                    const std::vector<double>& twice, const std::vector<double>& runs);

}  // namespace crevice
