/* SPDX-License-Identifier: MIT */
/* No GL: what BAKED_PROGRAM finds. */
#include <stddef.h>

void* find_function(const char* name, void* user)
{
    (void)name, (void)user;
    return NULL;
}
