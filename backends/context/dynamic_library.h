// SPDX-License-Identifier: MIT
// A shared library opened at run time.
#pragma once

#include <crevice/diagnostic.h>

#include <string>
#include <vector>

namespace crevice {

/// Opens the first of `names` that the system has. It stays open until the process ends: GL drivers
/// leave thread-local destructors behind that must not outlive their code.
///
/// Errors: one of `code` with a note for each name, and `help`.
Result<void*> openLibrary(const std::vector<std::string>& names, Code code,
                          const std::string& help);

/// A function of an open library, or null.
void* findSymbol(void* library, const char* name);

}  // namespace crevice
