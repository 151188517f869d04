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
//   geometry     the first viewport and scissor box, all scissor tests, cull face test and mode,
//                front face, polygon offset fill, rasterizer discard, primitive restart with fixed
//                index
//   pixels       alignment, row length, skipped pixels and rows, for packing and unpacking
//   desktop      logic operation, primitive restart, swapped bytes, polygon mode, smoothing and
//                offsets of lines and points; in a compatibility profile the alpha test and
//                polygon stipple
//   extensions   depth clamp, multisampling, sample alpha to one, rows that are read from the top;
//                sRGB framebuffer: desktop OpenGL writes what shaders give, OpenGL ES encodes it
//   clip space   clip control, clip distances
//   feedback     transform feedback is paused
//
// Never touched: all else; clear values and polygon offset among it. Drawing is refused where it
// would spoil what cannot be set aside (`checkHost`).
#pragma once

#include "backends/gl/caps.h"
#include "backends/gl/objects.h"

namespace crevice {

/// Which contexts have a piece of state.
enum class GlWhere {
    everywhere,
    desktop,
    compatibility,
    fixed_restart,
    sample_mask,
    sample_shading,
    depth_clamp,
    multisample_control,
    srgb_control,   // of OpenGL ES
    inverted_rows,  // of pixels that are read
    reversed_rows,  // likewise
    count
};

class GlState {
public:
    /// With `restore` off the host gets its context back in whatever state the last pass left it.
    GlState(const GlApi& gl, const GlInfo& info, bool restore);

    /// Keeps the host's state, unless an outer `enter` did, and sets the known one.
    void enter();

    /// Sets the known state again, whatever has become of it since `enter`.
    void neutralize();

    /// Puts the host's state back when it leaves the outermost `enter`.
    void leave();

    bool entered() const { return depth_ > 0; }

    /// Whether the host may be drawn beside. Errors: CV6017 for an active query that would count
    /// what is drawn, for transform feedback that cannot be paused, and for a program that is
    /// current and marked for deletion, since it would end with another one's use.
    Status checkHost() const;

    /// The host's clip control now.
    ClipControl clipControl() const;

    /// The host's depth range now, of the first viewport.
    DepthRange depthRange() const;

    /// Binds to a unit and leaves that unit active.
    void bindTexture(int unit, GLuint texture, GLuint sampler, GLenum target = GL_TEXTURE_2D);

    /// Undoes what a pass sets: clears and copies want all masks open, and no test or blending.
    void unmask() const;

    void setEnabled(GLenum capability, bool enabled) const;

private:
    static constexpr int kMaxSwitches = 26;
    static constexpr int kMaxPixelStores = 12;

    struct DrawBuffer {
        bool blend;
        GLint mask[4];
        GLint source_rgb, source_alpha, target_rgb, target_alpha;
        GLint equation_rgb, equation_alpha;
    };

    struct Unit {
        GLint texture, sampler, multisampled, volume;
    };

    struct Saved {
        GLint draw_framebuffer, read_framebuffer, renderbuffer, program, vertex_array, active_unit;
        GLint array_buffer, pack_buffer, unpack_buffer;
        GLfloat viewport[4];
        GLint scissor[4];
        GLfloat depth_range[2];
        GLint depth_function, cull_mode, front_face;
        GLint clip_origin, clip_depth;
        GLint polygon_mode[2];
        std::uint32_t clip_distances;  // a bit for each
        std::uint32_t scissor_tests;   // a bit for each viewport, where there are several
        bool pauses_feedback;
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
    void saveClipping();
    void neutralizeClipping() const;
    void restoreClipping() const;
    bool feedbackRuns() const;
    Status checkQueries() const;
    void findExtensions(const GlInfo& info);
    bool has(GlWhere where) const { return has_[static_cast<int>(where)]; }

    const GlApi& gl_;
    bool restore_;
    bool desktop_;
    bool has_[static_cast<int>(GlWhere::count)] = {};
    bool asks_feedback_;  // whether transform feedback is active
    int query_version_;   // desktop OpenGL's as it is; OpenGL ES 3.2 as 320
    int clip_distance_count_ = 0;
    int scissor_count_ = 0;
    int mask_count_ = 1;   // draw buffers that are masked apart
    int blend_count_ = 1;  // ... and blended apart
    int depth_ = 0;
    Saved saved_ = {};
    Unit units_[kMaxTextureUnits] = {};
    std::uint32_t saved_units_ = 0;         // a bit for each
    std::uint32_t saved_multisampled_ = 0;  // likewise
    std::uint32_t saved_volumes_ = 0;       // likewise
};

}  // namespace crevice
