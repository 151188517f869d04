// SPDX-License-Identifier: MIT
// The device's own two shaders: one copies a texture to a framebuffer, one reads what it holds.
#pragma once

#include "backends/gl/program.h"
#include "backends/gl/state.h"

namespace crevice {

class GlCopier {
public:
    static Result<GlCopier> make(GlApi& gl, const GlProgramCache& cache);

    /// Draws the texture over the viewport of the bound framebuffer; one channel alone as grey.
    void copy(const GlApi& gl, GlState& state, GLuint texture, GLuint sampler, int channels) const;

    /// Level 0 as four floats a texel, bit for bit what a shader fetches: works for every format,
    /// for depth too, which glReadPixels refuses. `nearest` is a sampler without a filter.
    ///
    /// Errors: CV6005, CV6009, CV6016.
    Result<Image> read(GlApi& gl, GlState& state, GLuint texture, GLuint nearest,
                       Extent extent) const;

    /// Draws the bits of as many texels of level 0 into the bound framebuffer, of 32-bit integers.
    void fetchBits(const GlApi& gl, GlState& state, GLuint texture, GLuint nearest,
                   Extent extent) const;

    /// Draws three vertices that have no attributes.
    void drawTriangle(const GlApi& gl) const;

private:
    GlProgram copy_;
    GLint grey_ = -1;  // the uniform
    GlProgram fetch_bits_;
    GlVertexArray no_attributes_;
};

}  // namespace crevice
