// SPDX-License-Identifier: MIT
// A device on which mediump has the width that is asked for, whatever the driver does. Some compute
// it in full, some in half floats here and there, such as llvmpipe on CPUs with half-float
// instructions.
//
// glslang turns each shader into SPIR-V, rewriteMediump (tools/render/device/mediump_words.h)
// rewrites that, SPIRV-Cross writes it as GLSL again, all in highp.
#pragma once

#include <crevice/device.h>

#include <memory>

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

/// Whether this build can make one.
bool canRewriteMediump();

}  // namespace crevice
