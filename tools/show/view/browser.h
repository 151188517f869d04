// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace crevice {

/// Has xdg-open show the address, without a shell and without waiting. False where there is no such
/// program. Ended children are no longer waited for from here on: runInChild must not be used.
bool openBrowser(const std::string& address);

}  // namespace crevice
