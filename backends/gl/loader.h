// SPDX-License-Identifier: MIT
// How crevice finds GL functions: by asking the context, never by a link-time symbol. OSMesa and
// the GLES library export the same names: with symbols the link order would decide which one runs.
#pragma once

#include <functional>

namespace crevice {

/// Finds a function of the current context by its name, "glClear"; null when there is none.
/// What `eglGetProcAddress` is wrapped in. Must not be empty.
using GlLoader = std::function<void*(const char* name)>;

}  // namespace crevice
