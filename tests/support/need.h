// SPDX-License-Identifier: MIT
// What a test needs in order to go on.
#pragma once

#include <crevice/diagnostic.h>

#include "tests/support/catch.h"

namespace crevice {

/// The value, or a failed test that prints why there is none.
template <class T>
T need(Result<T> result)
{
    INFO(toText(result.diagnostics()));
    REQUIRE(result.ok());
    return std::move(*result);
}

inline void need(const Status& status)
{
    INFO(toText(status.diagnostics()));
    REQUIRE(status.ok());
}

/// The one code of what was reported; Code::internal for several, or none.
inline Code onlyCode(const Status& status)
{
    return status.diagnostics().size() == 1 ? status.diagnostics()[0].code : Code::internal;
}

/// The one error of what failed, which has that code.
inline Diagnostic onlyError(const Status& status, Code code)
{
    INFO(toText(status.diagnostics()));
    REQUIRE_FALSE(status.ok());
    REQUIRE(onlyCode(status) == code);
    return status.diagnostics()[0];
}

/// The one warning of what was done, which has that code.
inline Diagnostic onlyWarning(const Status& status, Code code)
{
    INFO(toText(status.diagnostics()));
    REQUIRE(status.ok());
    REQUIRE(onlyCode(status) == code);
    return status.diagnostics()[0];
}

template <class T>
Diagnostic onlyError(const Result<T>& result, Code code)
{
    return onlyError(Status(result.diagnostics()), code);
}

template <class T>
Diagnostic onlyWarning(const Result<T>& result, Code code)
{
    REQUIRE(result.ok());
    return onlyWarning(Status(result.diagnostics()), code);
}

/// How often `text` has `part`.
inline int occurrences(const std::string& text, const std::string& part)
{
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace crevice
