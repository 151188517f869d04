// SPDX-License-Identifier: MIT
// Saves the host's GL state, sets what drawing needs, and restores the host's. What cannot be set
// aside is found before, so that drawing is refused.
#include "backends/gl/state.h"

#include "backends/gl/failure.h"

#include <algorithm>
#include <iterator>

namespace crevice {

namespace {

using Where = GlWhere;

struct Switch {
    GLenum capability;
    Where where;
    bool wanted = false;
};

struct PixelStore {
    GLenum parameter;
    GLint value;  // what this library wants: rows tightly packed
    Where where;
};

// Desktop names that the OpenGL ES headers do not have.
constexpr GLenum kColorLogicOp = 0x0BF2;
constexpr GLenum kDepthClamp = 0x864F;
constexpr GLenum kFramebufferSrgb = 0x8DB9;
constexpr GLenum kPrimitiveRestart = 0x8F9D;
constexpr GLenum kMultisample = 0x809D;
constexpr GLenum kSampleAlphaToOne = 0x809F;
constexpr GLenum kPolygonSmooth = 0x0B41;
constexpr GLenum kPolygonOffsetPoint = 0x2A01;
constexpr GLenum kPolygonOffsetLine = 0x2A02;
constexpr GLenum kPolygonStipple = 0x0B42;
constexpr GLenum kAlphaTest = 0x0BC0;
constexpr GLenum kSamplesPassed = 0x8914;
constexpr GLenum kPolygonMode = 0x0B40;
constexpr GLenum kFill = 0x1B02;
constexpr GLenum kClipDistance0 = 0x3000;
constexpr GLenum kMaxClipDistances = 0x0D32;
constexpr GLenum kMaxViewports = 0x825B;
constexpr GLenum kContextProfileMask = 0x9126;
constexpr GLint kCompatibilityProfile = 2;
constexpr GLenum kPackSwapBytes = 0x0D00;
constexpr GLenum kUnpackSwapBytes = 0x0CF0;
constexpr GLenum kPackInvert = 0x8758;       // of GL_MESA_pack_invert
constexpr GLenum kPackReverseRows = 0x93A4;  // of GL_ANGLE_pack_reverse_row_order

// Wanted off but for two; passes turn on what they need. Blending stands with the draw buffers. In
// WebGL 2 fixed-index restart is always on, and no index of a mesh is the one that restarts.
constexpr Switch kSwitches[] = {
    {GL_CULL_FACE, Where::everywhere},
    {GL_DEPTH_TEST, Where::everywhere},
    {GL_DITHER, Where::everywhere},
    {GL_POLYGON_OFFSET_FILL, Where::everywhere},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, Where::fixed_restart},
    {GL_RASTERIZER_DISCARD, Where::everywhere},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, Where::everywhere},
    {GL_SAMPLE_COVERAGE, Where::everywhere},
    {GL_SAMPLE_MASK, Where::sample_mask},
    {GL_SAMPLE_SHADING, Where::sample_shading},
    {GL_SCISSOR_TEST, Where::everywhere},
    {GL_STENCIL_TEST, Where::everywhere},
    {kColorLogicOp, Where::desktop},
    {kDepthClamp, Where::depth_clamp},
    {kFramebufferSrgb, Where::desktop},
    {kFramebufferSrgb, Where::srgb_control, true},
    {kMultisample, Where::multisample_control, true},
    {kSampleAlphaToOne, Where::multisample_control},
    {kPrimitiveRestart, Where::desktop},
    {kPolygonSmooth, Where::desktop},
    {kPolygonOffsetLine, Where::desktop},   // Mesa 22.3.6 on llvmpipe offsets filled triangles by
    {kPolygonOffsetPoint, Where::desktop},  // these as well
    {kAlphaTest, Where::compatibility},
    {kPolygonStipple, Where::compatibility},
};

constexpr PixelStore kPixelStores[] = {
    {GL_PACK_ALIGNMENT, 1, Where::everywhere},     {GL_PACK_ROW_LENGTH, 0, Where::everywhere},
    {GL_PACK_SKIP_PIXELS, 0, Where::everywhere},   {GL_PACK_SKIP_ROWS, 0, Where::everywhere},
    {GL_UNPACK_ALIGNMENT, 1, Where::everywhere},   {GL_UNPACK_ROW_LENGTH, 0, Where::everywhere},
    {GL_UNPACK_SKIP_PIXELS, 0, Where::everywhere}, {GL_UNPACK_SKIP_ROWS, 0, Where::everywhere},
    {kPackSwapBytes, 0, Where::desktop},           {kUnpackSwapBytes, 0, Where::desktop},
    {kPackInvert, 0, Where::inverted_rows},        {kPackReverseRows, 0, Where::reversed_rows},
};

Diagnostic busy(const std::string& what, const char* help)
{
    return failure(Code::host_busy, what + ", which drawing would spoil", help);
}

}  // namespace

GlState::GlState(const GlApi& gl, const GlInfo& info, bool restore)
    : gl_(gl),
      restore_(restore),
      desktop_(info.desktop),
      asks_feedback_(!info.desktop || info.native_version >= 400 ||
                     info.has("GL_ARB_transform_feedback2")),
      query_version_(info.native_version)
{
    findExtensions(info);
    if ((desktop_ && !info.bare) || info.has("GL_EXT_clip_cull_distance"))
        gl_.GetIntegerv(kMaxClipDistances, &clip_distance_count_);
    clip_distance_count_ = std::clamp(clip_distance_count_, 0, 32);
    if (gl_.ScissorIndexed) gl_.GetIntegerv(kMaxViewports, &scissor_count_);
    scissor_count_ = std::clamp(scissor_count_, 0, 32);
    static_assert(std::size(kSwitches) <= kMaxSwitches);
    static_assert(std::size(kPixelStores) <= kMaxPixelStores);
    static_assert(kMaxTextureUnits <= 32);
    GLint count = 1;
    gl_.GetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    count = std::min(count, kMaxColorAttachments);
    if (gl_.IsEnabledi) mask_count_ = count;
    if (gl_.BlendEquationi) blend_count_ = count;
}

void GlState::findExtensions(const GlInfo& info)
{
    GLint profile = 0;
    if (desktop_ && !info.bare && info.native_version >= 320)
        gl_.GetIntegerv(kContextProfileMask, &profile);
    const auto set = [this](GlWhere where, bool has) { has_[static_cast<int>(where)] = has; };
    const auto since = [&info](int desktop, int es) {
        return info.native_version >= (info.desktop ? desktop : es);
    };
    set(Where::everywhere, true);
    set(Where::desktop, desktop_);
    set(Where::compatibility, (profile & kCompatibilityProfile) != 0);
    set(Where::fixed_restart,
        !info.web && (since(430, 300) || info.has("GL_ARB_ES3_compatibility")));
    set(Where::sample_mask, since(320, 310));
    set(Where::sample_shading,
        since(400, 320) || info.has("GL_ARB_sample_shading") || info.has("GL_OES_sample_shading"));
    set(Where::depth_clamp, desktop_ || info.has("GL_EXT_depth_clamp"));
    set(Where::multisample_control, desktop_ || info.has("GL_EXT_multisample_compatibility"));
    set(Where::srgb_control, !desktop_ && info.has("GL_EXT_sRGB_write_control"));
    set(Where::inverted_rows, info.has("GL_MESA_pack_invert"));
    set(Where::reversed_rows, info.has("GL_ANGLE_pack_reverse_row_order"));
}

void GlState::enter()
{
    if (depth_++ == 0 && restore_) save();
    neutralize();
}

void GlState::neutralize()
{
    for (const Switch& s : kSwitches)
        if (has(s.where)) setEnabled(s.capability, s.wanted);
    for (const PixelStore& store : kPixelStores)
        if (has(store.where)) gl_.PixelStorei(store.parameter, store.value);
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl_.FrontFace(GL_CCW);
    setDepthRange(gl_, 0.0f, 1.0f);
    neutralizeClipping();
    unmask();
}

void GlState::leave()
{
    assert(depth_ > 0);
    if (--depth_ == 0 && restore_) restore();
}

void GlState::unmask() const
{
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
}

void GlState::setEnabled(GLenum capability, bool enabled) const
{
    if (enabled)
        gl_.Enable(capability);
    else
        gl_.Disable(capability);
}

void GlState::bindTexture(int unit, GLuint texture, GLuint sampler, GLenum target)
{
    assert(unit >= 0 && unit < kMaxTextureUnits);
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    const std::uint32_t bit = std::uint32_t(1) << unit;
    if (restore_ && depth_ > 0 && !(saved_units_ & bit)) {
        gl_.GetIntegerv(GL_TEXTURE_BINDING_2D, &units_[unit].texture);
        gl_.GetIntegerv(GL_SAMPLER_BINDING, &units_[unit].sampler);
        saved_units_ |= bit;
    }
    const auto keep = [&](GLenum kind, GLenum binding, GLint& bound, std::uint32_t& saved) {
        if (!restore_ || depth_ == 0 || target != kind || saved & bit) return;
        gl_.GetIntegerv(binding, &bound);
        saved |= bit;
    };
    keep(GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE, units_[unit].multisampled,
         saved_multisampled_);
    keep(GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, units_[unit].volume, saved_volumes_);
    gl_.BindTexture(target, texture);
    gl_.BindSampler(unit, sampler);
}

void GlState::save()
{
    Saved& s = saved_;
    gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &s.draw_framebuffer);
    gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &s.read_framebuffer);
    gl_.GetIntegerv(GL_RENDERBUFFER_BINDING, &s.renderbuffer);
    gl_.GetIntegerv(GL_CURRENT_PROGRAM, &s.program);
    gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &s.vertex_array);
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &s.active_unit);
    gl_.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &s.array_buffer);
    gl_.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &s.pack_buffer);
    gl_.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &s.unpack_buffer);
    gl_.GetFloatv(GL_VIEWPORT, s.viewport);
    gl_.GetIntegerv(GL_SCISSOR_BOX, s.scissor);
    gl_.GetFloatv(GL_DEPTH_RANGE, s.depth_range);
    gl_.GetIntegerv(GL_DEPTH_FUNC, &s.depth_function);
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &s.depth_mask);
    gl_.GetIntegerv(GL_CULL_FACE_MODE, &s.cull_mode);
    gl_.GetIntegerv(GL_FRONT_FACE, &s.front_face);
    for (std::size_t i = 0; i < std::size(kSwitches); ++i)
        if (has(kSwitches[i].where)) s.switches[i] = gl_.IsEnabled(kSwitches[i].capability);
    for (std::size_t i = 0; i < std::size(kPixelStores); ++i)
        if (has(kPixelStores[i].where))
            gl_.GetIntegerv(kPixelStores[i].parameter, &s.pixel_stores[i]);
    for (int i = 0; i < mask_count_; ++i) saveMask(i);
    for (int i = 0; i < blend_count_; ++i) saveBlend(i);
    saveClipping();
    s.pauses_feedback = gl_.PauseTransformFeedback && feedbackRuns();
    if (s.pauses_feedback) gl_.PauseTransformFeedback();
}

void GlState::restore()
{
    const Saved& s = saved_;
    restoreUnits();
    gl_.ActiveTexture(s.active_unit);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, s.draw_framebuffer);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, s.read_framebuffer);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, s.renderbuffer);
    gl_.UseProgram(s.program);
    gl_.BindVertexArray(s.vertex_array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, s.array_buffer);
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, s.pack_buffer);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, s.unpack_buffer);
    setViewport(gl_, s.viewport[0], s.viewport[1], s.viewport[2], s.viewport[3]);
    setScissor(gl_, s.scissor[0], s.scissor[1], s.scissor[2], s.scissor[3]);
    setDepthRange(gl_, s.depth_range[0], s.depth_range[1]);
    gl_.DepthFunc(s.depth_function);
    gl_.DepthMask(s.depth_mask);
    gl_.CullFace(s.cull_mode);
    gl_.FrontFace(s.front_face);
    for (std::size_t i = 0; i < std::size(kSwitches); ++i)
        if (has(kSwitches[i].where)) setEnabled(kSwitches[i].capability, s.switches[i]);
    for (std::size_t i = 0; i < std::size(kPixelStores); ++i)
        if (has(kPixelStores[i].where))
            gl_.PixelStorei(kPixelStores[i].parameter, s.pixel_stores[i]);
    for (int i = 0; i < mask_count_; ++i) restoreMask(i);
    for (int i = 0; i < blend_count_; ++i) restoreBlend(i);
    restoreClipping();
    if (s.pauses_feedback) gl_.ResumeTransformFeedback();
}

void GlState::saveClipping()
{
    Saved& s = saved_;
    if (gl_.ClipControl) {
        gl_.GetIntegerv(GL_CLIP_ORIGIN_EXT, &s.clip_origin);
        gl_.GetIntegerv(GL_CLIP_DEPTH_MODE_EXT, &s.clip_depth);
    }
    // A core profile has one mode for both sides, and some drivers write it once.
    s.polygon_mode[0] = s.polygon_mode[1] = 0;
    if (gl_.PolygonMode) gl_.GetIntegerv(kPolygonMode, s.polygon_mode);
    s.scissor_tests = 0;
    for (int i = 0; i < scissor_count_; ++i)
        if (gl_.IsEnabledi(GL_SCISSOR_TEST, i)) s.scissor_tests |= std::uint32_t(1) << i;
    s.clip_distances = 0;
    for (int i = 0; i < clip_distance_count_; ++i)
        if (gl_.IsEnabled(kClipDistance0 + i)) s.clip_distances |= std::uint32_t(1) << i;
}

void GlState::neutralizeClipping() const
{
    if (gl_.ClipControl) gl_.ClipControl(GL_LOWER_LEFT_EXT, GL_NEGATIVE_ONE_TO_ONE_EXT);
    if (gl_.PolygonMode) gl_.PolygonMode(GL_FRONT_AND_BACK, kFill);
    for (int i = 0; i < clip_distance_count_; ++i) gl_.Disable(kClipDistance0 + i);
}

void GlState::restoreClipping() const
{
    const Saved& s = saved_;
    if (gl_.ClipControl) gl_.ClipControl(s.clip_origin, s.clip_depth);
    if (gl_.PolygonMode && has(Where::compatibility)) {
        gl_.PolygonMode(GL_FRONT, s.polygon_mode[0]);
        gl_.PolygonMode(GL_BACK, s.polygon_mode[1]);
    } else if (gl_.PolygonMode) {
        gl_.PolygonMode(GL_FRONT_AND_BACK, s.polygon_mode[0]);
    }
    for (int i = 0; i < scissor_count_; ++i)
        (s.scissor_tests >> i & 1 ? gl_.Enablei : gl_.Disablei)(GL_SCISSOR_TEST, i);
    for (int i = 0; i < clip_distance_count_; ++i)
        setEnabled(kClipDistance0 + i, s.clip_distances >> i & 1);
}

ClipControl GlState::clipControl() const
{
    if (!gl_.ClipControl) return {};
    GLint origin = 0, depth = 0;
    gl_.GetIntegerv(GL_CLIP_ORIGIN_EXT, &origin);
    gl_.GetIntegerv(GL_CLIP_DEPTH_MODE_EXT, &depth);
    return {depth == GL_ZERO_TO_ONE_EXT, origin == GL_UPPER_LEFT_EXT};
}

DepthRange GlState::depthRange() const
{
    GLfloat range[2] = {0, 1};
    gl_.GetFloatv(GL_DEPTH_RANGE, range);
    return {range[0], range[1]};
}

void GlState::restoreUnits()
{
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
        if (!(saved_units_ >> unit & 1)) continue;
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindTexture(GL_TEXTURE_2D, units_[unit].texture);
        gl_.BindSampler(unit, units_[unit].sampler);
        if (saved_multisampled_ >> unit & 1)
            gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, units_[unit].multisampled);
        if (saved_volumes_ >> unit & 1) gl_.BindTexture(GL_TEXTURE_3D, units_[unit].volume);
    }
    saved_units_ = saved_multisampled_ = saved_volumes_ = 0;
}

bool GlState::feedbackRuns() const
{
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    if (asks_feedback_) gl_.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    if (active) gl_.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    return active && !paused;
}

Status GlState::checkQueries() const
{
    const auto active = [this](GLenum target) {
        GLint query = 0;
        gl_.GetQueryiv(target, GL_CURRENT_QUERY, &query);
        return query != 0;
    };
    const char* const help = "end it before the call, and begin another one after";
    const bool conservative = !desktop_ || query_version_ >= 430;
    const bool primitives = query_version_ >= 320;
    if ((desktop_ && active(kSamplesPassed)) || active(GL_ANY_SAMPLES_PASSED) ||
        (conservative && active(GL_ANY_SAMPLES_PASSED_CONSERVATIVE)))
        return busy("an occlusion query of the host is active", help);
    if (primitives && active(GL_PRIMITIVES_GENERATED))
        return busy("a query of primitives of the host is active", help);
    return {};
}

Status GlState::checkHost() const
{
    if (depth_ > 1) return {};  // within a frame, which asked
    if (Status status = checkQueries(); !status) return status;
    if (!(gl_.PauseTransformFeedback && restore_) && feedbackRuns())
        return busy("transform feedback of the host is active, and cannot be paused",
                    "end it before the call");
    GLint program = 0, deleted = GL_FALSE;
    gl_.GetIntegerv(GL_CURRENT_PROGRAM, &program);
    if (program != 0 && restore_)
        gl_.GetProgramiv(static_cast<GLuint>(program), GL_DELETE_STATUS, &deleted);
    if (deleted)
        return busy(
            "the host's current program " + std::to_string(program) + " is marked for deletion",
            "call glUseProgram(0) before the call, or delete the program later");
    return {};
}

// Blending and colour masks, of each draw buffer where the context has them apart.

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
