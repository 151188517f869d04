// SPDX-License-Identifier: MIT
// What a test needs in order to go on.
#pragma once

#include <crevice/result.h>

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

}  // namespace crevice
