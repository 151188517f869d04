// SPDX-License-Identifier: MIT
// The smallest patch between two configs, as the text of a config.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// A config that extends these and says, beyond them, only in what `now` differs from `base`. What
/// a module that was swapped took with it is left out. Errors: those of decode, for `now`.
Result<std::string> patchText(const Node& base, Node now, const std::vector<std::string>& extends,
                              const SourceSet& sources);

}  // namespace crevice
