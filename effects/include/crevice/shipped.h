// SPDX-License-Identifier: MIT
// The shipped modules and configs, embedded in the library at build time.
#pragma once

#include <crevice/source.h>

namespace crevice {

/// All of effects/ by path ("ssao/hemisphere.json", "ssao/shaders/hemisphere.frag") and all of
/// configs/ under "configs/" ("configs/learnopengl.json"). To edit one while a program runs, layer
/// MemorySources with your text of it over this set.
const SourceSet& shippedSources();

}  // namespace crevice
