// SPDX-License-Identifier: MIT
// Checks of the C API from C99: each failure is a line, and `failures` counts them.
#ifndef CREVICE_TESTS_C_API_CHECKS_H
#define CREVICE_TESTS_C_API_CHECKS_H

#include <crevice/crevice.h>

#include <stdio.h>

static int failures = 0;

#define CHECK(what) ((what) ? (void)0 : fail(__FILE__, __LINE__, #what))
/// The error has that code, 0 for none; it is freed.
#define EXPECT(code, call) expect(__FILE__, __LINE__, #call, code, call)

static void fail(const char* file, int line, const char* what)
{
    printf("%s:%d: failed: %s\n", file, line, what);
    ++failures;
}

static void expect(const char* file, int line, const char* call, int code, crevice_error* error)
{
    if (crevice_error_code(error) != code) {
        fail(file, line, call);
        printf("wanted CV%d: %s\n", code, crevice_error_text(error));
    }
    crevice_error_free(error);
}

#endif
