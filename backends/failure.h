// SPDX-License-Identifier: MIT
// Diagnostics that have no place in a text.
#pragma once

#include "core/diagnostic.h"

#include <utility>

namespace crevice {

/// What was found and wanted, and the way out.
inline Diagnostic failure(Code code, std::string message, std::string help)
{
    Diagnostic diagnostic{code, std::move(message)};
    diagnostic.help = std::move(help);
    return diagnostic;
}

}  // namespace crevice
