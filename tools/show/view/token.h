// SPDX-License-Identifier: MIT
// The secret in the address of a served page: who does not know it is shown nothing.
#pragma once

#include <crevice/result.h>

#include <string>
#include <string_view>

namespace crevice {

/// 32 hex digits: 128 random bits of the system's. Errors: CV6022 where it has none to give.
Result<std::string> randomToken();

/// Whether both are the same, in a time that says nothing of where they differ.
bool sameSecret(std::string_view given, std::string_view secret);

}  // namespace crevice
