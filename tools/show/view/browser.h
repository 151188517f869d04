// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crevice {

/// Has xdg-open show the address, without a shell and without waiting. False where there is no such
/// program.
bool openBrowser(const std::string& address);

}  // namespace crevice
