// SPDX-License-Identifier: MIT
// The C API from tests in C++.
#pragma once

#include <crevice/crevice.h>

#include "tests/support/need.h"

/// The test ends where there is an error, which is freed.
inline void need(crevice_error* error)
{
    INFO(crevice_error_text(error));
    const bool failed = error != nullptr;
    crevice_error_free(error);
    REQUIRE(!failed);
}

/// 0 for none; the error is freed.
inline int codeOf(crevice_error* error)
{
    const int code = crevice_error_code(error);
    crevice_error_free(error);
    return code;
}

/// A struct with its size and zeros.
template <class Struct>
Struct sized()
{
    Struct made = {};
    made.struct_size = sizeof made;
    return made;
}
