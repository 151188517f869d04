// SPDX-License-Identifier: MIT
// A fragment shader's text made to count what it does.
#pragma once

#include "tools/measure/cost/loops.h"

#include <optional>

namespace crevice {

constexpr const char* kWhich = "crevice_which";  ///< The uniform that says what is counted.

/// The fragment shader's text with outputs as plain variables, each call of a built-in function
/// that fetches from a texture counted, and an output of its own of the format rgba8: two counts,
/// each as its low and high byte, as unsigned normalized numbers. Where the uniform crevice_which
/// is 0 they are fetches and 1; where it is n, they say how often the `n - 1`th of `loops`, which
/// are the text's, was entered and its body run. Nothing where the text has no `main`.
///
/// A `discard` discards the count too. textureGather counts as one. A macro may be another name of
/// such a function.
std::optional<std::string> countedFragment(const std::string& text,
                                           const std::vector<GlslLoop>& loops);

}  // namespace crevice
