// SPDX-License-Identifier: MIT
// The scan: finds what a preprocessed stage declares at its outermost level.
#pragma once

#include "core/glsl/preprocessor.h"

namespace crevice {

/// Appends the uniforms and outputs of `unit` to `stage`, and what is wrong with them to
/// `unit.errors`: array sizes and locations that cannot be read.
void scanDeclarations(GlslUnit& unit, GlslStage& stage);

}  // namespace crevice
