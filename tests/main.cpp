// SPDX-License-Identifier: MIT
// Entry of the tests that need no GL.
#define CATCH_CONFIG_MAIN
#include "tests/support/catch.h"

// For the leak sanitizer: glibc 2.36 keeps the folders of LOCPATH, which the tests of locales set.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:argz_add_sep\n"; }
