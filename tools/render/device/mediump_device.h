// SPDX-License-Identifier: MIT
// A device on which mediump has the width that is asked for, whatever the driver does. Some compute
// it in full, some in half floats here and there, such as llvmpipe on CPUs with half-float
// instructions.
//
// glslang turns each shader into SPIR-V, rewriteMediump rewrites that, SPIRV-Cross writes it as
// GLSL again, all in highp. Mediump values are decorated RelaxedPrecision there. In half floats
// each of them is rounded as it arises: from 65520 on to infinity, below 2^-14 to 0, which is the
// least that every phone keeps. What a phone has no instruction for is taken apart first, so that
// what overflows on the way does so here too: normalize() is a dot product, an inverse root and a
// product, pow() a logarithm, a product and an exponential, a / b is a * (1 / b).
#pragma once

#include <crevice/device.h>

namespace crevice {

enum class Mediump {
    full,  ///< Computed in 32 bits, as on a desktop.
    /// Rounded to half floats and 16-bit integers after each step, as on a phone at its worst.
    half,
};

/// Draws on `device` with every shader rewritten; its name says so. Its createProgram fails with
/// CV5001 where glslang does not understand a shader. Errors: CV6012 where crevice was built
/// without glslang and SPIRV-Cross.
Result<std::unique_ptr<Device>> makeMediumpDevice(std::unique_ptr<Device> device, Mediump mediump);

/// The module `words`, all else as it was; none of its values is mediump any more. Of locations and
/// bindings only those of vertex inputs and fragment outputs stay: everything else goes by name.
std::vector<std::uint32_t> rewriteMediump(const std::vector<std::uint32_t>& words, Mediump mediump);

/// Whether this build can make one.
bool canRewriteMediump();

}  // namespace crevice
