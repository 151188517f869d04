// SPDX-License-Identifier: MIT
// Whether tests cross everything with everything, which takes minutes, or take samples of it.
#pragma once

#include <cstdlib>

namespace crevice {

/// True where the environment variable CREVICE_NIGHTLY is set, as `tools/test.sh --nightly` does.
inline bool nightly() { return std::getenv("CREVICE_NIGHTLY") != nullptr; }

}  // namespace crevice
