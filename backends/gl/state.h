// SPDX-License-Identifier: MIT
// The context's state: the host's is kept and put back, and set to known values in between.
//
// Kept, neutralised and put back:
//   bindings     draw and read framebuffer, renderbuffer, program, vertex array, array buffer;
//                pixel pack and unpack buffer, active texture unit; for each unit used: its sampler
//                and its texture, the 2D or the multisampled one
//   fragments    for each draw buffer, where the context has them apart: blending on or off, its
//                functions and equations, colour mask; dither, scissor test, stencil test, sample
//                alpha to coverage, sample coverage, sample mask, sample shading
//   depth        test, function, mask, range
//   geometry     viewport, scissor box, cull face test and mode, front face, polygon offset fill,
//                rasterizer discard, primitive restart with fixed index
//   pixels       alignment, row length, skipped pixels and rows, for packing and unpacking
//   desktop      sRGB framebuffer, logic operation, depth clamp, primitive restart, swapped bytes,
//                multisampling, sample alpha to one
//
// Never touched: all else; clear values and polygon offset among it. Must be at its default, for
// nothing here changes it: clip control, polygon mode, clip distances. Must not be active:
// transform feedback, queries that count samples, conditional rendering; nor, while the device's
// timers run, queries that measure time. Errors that are pending when a frame begins are dropped.
#pragma once

#include "backends/gl/caps.h"

namespace crevice {

/// Which contexts have a piece of state.
enum class GlWhere { everywhere, desktop, not_web, sample_mask, sample_shading };

class GlState {
public:
    /// With `restore` off the host gets its context back in whatever state the last pass left it.
    GlState(const GlApi& gl, const GlInfo& info, bool restore);

    /// Keeps the host's state, unless an outer `enter` did, and sets the known one.
    void enter();

    /// Puts the host's state back when it leaves the outermost `enter`.
    void leave();

    bool entered() const { return depth_ > 0; }

    /// Binds to a unit and leaves that unit active.
    void bindTexture(int unit, GLuint texture, GLuint sampler, GLenum target = GL_TEXTURE_2D);

    /// Undoes what a pass sets: clears and copies want all masks open, and no test or blending.
    void unmask() const;

    void setEnabled(GLenum capability, bool enabled) const;

private:
    static constexpr int kMaxSwitches = 20;
    static constexpr int kMaxPixelStores = 10;

    struct DrawBuffer {
        bool blend;
        GLint mask[4];
        GLint source_rgb, source_alpha, target_rgb, target_alpha;
        GLint equation_rgb, equation_alpha;
    };

    struct Unit {
        GLint texture, sampler, multisampled;
    };

    struct Saved {
        GLint draw_framebuffer, read_framebuffer, renderbuffer, program, vertex_array, active_unit;
        GLint array_buffer, pack_buffer, unpack_buffer;
        GLint viewport[4];
        GLint scissor[4];
        GLfloat depth_range[2];
        GLint depth_function, cull_mode, front_face;
        GLboolean depth_mask;
        bool switches[kMaxSwitches];
        GLint pixel_stores[kMaxPixelStores];
        DrawBuffer draw_buffers[kMaxColorAttachments];
    };

    void save();
    void restore();
    void saveMask(int index);
    void saveBlend(int index);
    void restoreMask(int index) const;
    void restoreBlend(int index) const;
    void restoreUnits();
    bool has(GlWhere where) const;

    const GlApi& gl_;
    bool restore_;
    bool desktop_;
    bool web_;
    bool sample_mask_;
    bool sample_shading_;
    int mask_count_ = 1;   // draw buffers that are masked apart
    int blend_count_ = 1;  // ... and blended apart
    int depth_ = 0;
    Saved saved_ = {};
    Unit units_[kMaxTextureUnits] = {};
    std::uint32_t saved_units_ = 0;         // a bit for each
    std::uint32_t saved_multisampled_ = 0;  // likewise
};

}  // namespace crevice
