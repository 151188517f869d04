// SPDX-License-Identifier: MIT
// Diagnostics that have no place in a text.
#pragma once

#include <crevice/diagnostic.h>

#include <utility>

namespace crevice {

/// What was found and wanted, and the way out.
inline Diagnostic failure(Code code, std::string message, std::string help)
{
    Diagnostic diagnostic{code, std::move(message)};
    diagnostic.help = std::move(help);
    return diagnostic;
}

/// Whether the last of them says that the context is lost, so that further calls report nothing
/// more.
inline bool tellsLoss(const Diagnostics& diagnostics)
{
    return !diagnostics.empty() && diagnostics.back().code == Code::context_lost;
}

}  // namespace crevice
