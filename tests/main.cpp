// SPDX-License-Identifier: MIT
// Entry of the tests that need no GL.
#define CATCH_CONFIG_MAIN
#include "tests/support/catch.h"
