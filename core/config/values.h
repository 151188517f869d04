// SPDX-License-Identifier: MIT
// The values of a description's params and features, to be compared with others of the same config.
#pragma once

#include <crevice/config.h>

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

/// Whether the param may have that value. Errors: CV4001, CV4003, CV3006.
Status checkValue(const ParamDesc& param, const float* values, int count);

/// Sets in `next`, which may be of another config, what `now` has and `loaded` has not. The
/// warnings CV4006 name what cannot be set there.
Diagnostics carryOver(const Values& loaded, const Description& now, Description& next);

/// The smallest merge patch, as JSON on one line, that gives a config whose values are `loaded`
/// those of `now`; "{}" where they are the same. Requires values of the same config. Floats read
/// back as they were.
std::string valuesPatch(const Values& loaded, const Description& now);

}  // namespace crevice
