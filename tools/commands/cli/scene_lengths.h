// SPDX-License-Identifier: MIT
// The radius of a scene whose units nobody knows.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// The radius of a scene whose units nobody knows: two thirds of what 0.5 is of the scene 'room'.
constexpr const char* kShareOfScene = "5%";

/// Makes lengths that only files as shipped set `length`, such as "5%", and at most 8 % of the
/// view's height at its median depth: who stands in a city does not see all of it. `document` is
/// the description's.
void fitLengths(Description& description, const Node& document, const char* length);

}  // namespace crevice
