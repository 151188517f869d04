// SPDX-License-Identifier: MIT
// What the program of the tests has from operator new; counted in allocation_test.cpp.
#pragma once

namespace crevice {

/// Calls of operator new so far.
long allocationCount();

/// Bytes that were not given back; the C library rounds each allocation up, now more and now less.
long allocatedBytes();

}  // namespace crevice
