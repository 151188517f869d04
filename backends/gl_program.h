// SPDX-License-Identifier: MIT
// Programs: compiled, linked, and asked for their uniforms.
#pragma once

#include "backends/gl_objects.h"
#include "core/device.h"

#include <vector>

namespace crevice {

struct GlLinkedProgram {
    GlProgram program;
    std::vector<UniformInfo> uniforms;
};

/// Errors: CV5001 and CV5002, at the author's file and line.
Result<GlLinkedProgram> linkProgram(GlApi& gl, const ProgramDesc& desc);

/// Sets a uniform of the current program; see Device::setUniform.
void setUniformValues(const GlApi& gl, int location, GlslType type, int count, const void* data);

}  // namespace crevice
