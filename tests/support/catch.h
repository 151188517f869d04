// SPDX-License-Identifier: MIT
// The one place that includes Catch2: Debian's is 2.13, and version 3 has other headers.
#pragma once

#include <catch2/catch.hpp>
