// SPDX-License-Identifier: MIT
// The values of a description's params and features, to be compared with others of the same config.
#pragma once

#include "core/config/description.h"

#include <array>
#include <string>
#include <vector>

namespace crevice {

/// In the order of the description's lists.
struct Values {
    std::vector<std::array<float, 4>> params = {};
    std::vector<int> features = {};
};

Values valuesOf(const Description& description);

/// The smallest merge patch, as JSON on one line, that gives a config whose values are `loaded`
/// those of `now`; "{}" where they are the same. Requires values of the same config. Floats read
/// back as they were.
std::string valuesPatch(const Values& loaded, const Description& now);

}  // namespace crevice
