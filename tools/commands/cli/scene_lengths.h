// SPDX-License-Identifier: MIT
// The radius of a scene whose units nobody knows.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// Makes lengths that only files as shipped set `length`, such as "5%". `document` is the
/// description's.
void fitLengths(Description& description, const Node& document, const char* length);

}  // namespace crevice
