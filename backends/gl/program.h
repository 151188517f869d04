// SPDX-License-Identifier: MIT
// Programs: compiled and linked or taken from the cache, and asked for their uniforms.
#pragma once

#include <crevice/device.h>

#include "backends/gl/objects.h"
#include "backends/gl/program_cache.h"

#include <vector>

namespace crevice {

struct GlLinkedProgram {
    GlProgram program;
    std::vector<UniformInfo> uniforms;
};

/// Takes a program from the cache, else compiles it and stores it there.
///
/// Errors: CV5001 and CV5002, at the author's file and line; CV6005, CV6009, CV6016.
Result<GlLinkedProgram> makeProgram(GlApi& gl, const GlProgramCache& cache,
                                    const ProgramDesc& desc);

/// Sets a uniform of the current program; see Device::setUniform.
void setUniformValues(const GlApi& gl, int location, GlslType type, int count, const void* data);

}  // namespace crevice
