// SPDX-License-Identifier: MIT
// The radius of a scene whose units nobody knows.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// Makes lengths that only files as shipped set 5% of the scene: two thirds of what 0.5 is of the
/// scene 'room'. `document` is the description's.
void fitLengths(Description& description, const Node& document);

}  // namespace crevice
