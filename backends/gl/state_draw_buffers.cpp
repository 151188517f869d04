// SPDX-License-Identifier: MIT
// Blending and colour masks, of each draw buffer where the context has them apart.
#include "backends/gl/state.h"

namespace crevice {

void GlState::saveMask(int index)
{
    DrawBuffer& buffer = saved_.draw_buffers[index];
    if (gl_.IsEnabledi) {
        buffer.blend = gl_.IsEnabledi(GL_BLEND, index);
        gl_.GetIntegeri_v(GL_COLOR_WRITEMASK, index, buffer.mask);
    } else {
        buffer.blend = gl_.IsEnabled(GL_BLEND);
        gl_.GetIntegerv(GL_COLOR_WRITEMASK, buffer.mask);
    }
}

void GlState::restoreMask(int index) const
{
    const DrawBuffer& b = saved_.draw_buffers[index];
    auto mask = [&](int channel) { return static_cast<GLboolean>(b.mask[channel] != 0); };
    if (gl_.IsEnabledi) {
        (b.blend ? gl_.Enablei : gl_.Disablei)(GL_BLEND, index);
        gl_.ColorMaski(index, mask(0), mask(1), mask(2), mask(3));
    } else {
        setEnabled(GL_BLEND, b.blend);
        gl_.ColorMask(mask(0), mask(1), mask(2), mask(3));
    }
}

void GlState::saveBlend(int index)
{
    DrawBuffer& buffer = saved_.draw_buffers[index];
    auto get = [&](GLenum name, GLint& value) {
        if (gl_.BlendEquationi)
            gl_.GetIntegeri_v(name, index, &value);
        else
            gl_.GetIntegerv(name, &value);
    };
    get(GL_BLEND_SRC_RGB, buffer.source_rgb);
    get(GL_BLEND_SRC_ALPHA, buffer.source_alpha);
    get(GL_BLEND_DST_RGB, buffer.target_rgb);
    get(GL_BLEND_DST_ALPHA, buffer.target_alpha);
    get(GL_BLEND_EQUATION_RGB, buffer.equation_rgb);
    get(GL_BLEND_EQUATION_ALPHA, buffer.equation_alpha);
}

void GlState::restoreBlend(int index) const
{
    const DrawBuffer& b = saved_.draw_buffers[index];
    // The advanced equations of OpenGL ES 3.2 are refused by the "Separate" functions.
    const bool one_equation = b.equation_rgb == b.equation_alpha;
    if (gl_.BlendEquationi) {
        gl_.BlendFuncSeparatei(index, b.source_rgb, b.target_rgb, b.source_alpha, b.target_alpha);
        if (one_equation)
            gl_.BlendEquationi(index, b.equation_rgb);
        else
            gl_.BlendEquationSeparatei(index, b.equation_rgb, b.equation_alpha);
    } else {
        gl_.BlendFuncSeparate(b.source_rgb, b.target_rgb, b.source_alpha, b.target_alpha);
        if (one_equation)
            gl_.BlendEquation(b.equation_rgb);
        else
            gl_.BlendEquationSeparate(b.equation_rgb, b.equation_alpha);
    }
}

}  // namespace crevice
