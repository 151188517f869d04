// SPDX-License-Identifier: MIT
#include "backends/gl/caps.h"

#include "backends/gl/failure.h"
#include "backends/gl/formats.h"
#include "backends/gl/objects.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <type_traits>

namespace crevice {

namespace {

constexpr GLenum kMaxFragmentUniformComponents = 0x8B49;
constexpr GLenum kMaxVertexUniformComponents = 0x8B4A;

std::string text(const GlApi& gl, GLenum name)
{
    const GLubyte* string = gl.GetString(name);
    return string ? reinterpret_cast<const char*>(string) : "";
}

int integer(const GlApi& gl, GLenum name)
{
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

std::vector<std::string> readExtensions(const GlApi& gl)
{
    std::vector<std::string> names;
    const int count = integer(gl, GL_NUM_EXTENSIONS);
    for (int i = 0; i < count; ++i)
        if (const GLubyte* name = gl.GetStringi(GL_EXTENSIONS, i))
            names.emplace_back(reinterpret_cast<const char*>(name));
    return names;
}

/// The OpenGL ES version whose shaders and rules a desktop context takes; 0 for none.
int compatibleVersion(const GlInfo& info)
{
    if (info.has("GL_ARB_ES3_2_compatibility")) return 320;
    if (info.has("GL_ARB_ES3_1_compatibility") || info.native_version >= 450) return 310;
    if (info.has("GL_ARB_ES3_compatibility") || info.native_version >= 430) return 300;
    return info.native_version >= 330 ? 300 : 0;  // with shaders of its own
}

bool isSoftware(const std::string& renderer)
{
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (renderer.find(name) != std::string::npos) return true;
    return false;
}

bool mayRender(const GlInfo& info, const FormatInfo& format)
{
    if (format.core_renderable) return true;
    if (info.bare || format.format_class != FormatClass::floating) return false;
    if (info.desktop) return true;
    if (info.version >= 320 || info.has("GL_EXT_color_buffer_float")) return true;
    const bool half = format.format == Format::r16f || format.format == Format::rg16f ||
                      format.format == Format::rgba16f;
    return half && info.has("GL_EXT_color_buffer_half_float");
}

/// True when a framebuffer of that format is really complete: some drivers promise too much.
bool tryRender(GlApi& gl, const FormatInfo& format)
{
    constexpr int kSize = 4;
    auto texture = GlTexture::make(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    allocateTexture(gl, glFormat(format.format).internal, {kSize, kSize});
    auto framebuffer = GlFramebuffer::make(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    const GLenum point =
        format.format_class == FormatClass::depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
    gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, GL_TEXTURE_2D, texture.name(), 0);
    const GLenum buffer = point == GL_DEPTH_ATTACHMENT ? GL_NONE : GL_COLOR_ATTACHMENT0;
    gl.DrawBuffers(1, &buffer);
    gl.ReadBuffer(buffer);  // desktop OpenGL before 4.1 wants what is read to be there
    const bool complete = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    const bool quiet = takeErrors(gl, "").ok();
    return complete && quiet;
}

/// The counts of samples that a renderbuffer of that format may have, as in DeviceCaps.
std::uint32_t readSampleCounts(const GlApi& gl, GLenum internal)
{
    GLint counts[kMaxSamples] = {2, 4, 8, 16};
    GLint most = integer(gl, GL_MAX_SAMPLES);
    if (gl.GetInternalformativ) {
        most = kMaxSamples;
        std::fill(std::begin(counts), std::end(counts), 0);
        gl.GetInternalformativ(GL_RENDERBUFFER, internal, GL_SAMPLES, kMaxSamples, counts);
    }
    std::uint32_t bits = 0;
    for (const GLint count : counts)
        if (count > 0 && count <= most) bits |= std::uint32_t(1) << (count - 1);
    return bits;
}

/// What ends the names of the functions that mask or blend draw buffers apart; null for no such.
const char* drawBufferMaskSuffix(const GlInfo& info)
{
    if (info.bare) return nullptr;
    if (info.desktop || info.native_version >= 320) return "";
    if (info.has("GL_OES_draw_buffers_indexed")) return "OES";
    return info.has("GL_EXT_draw_buffers_indexed") ? "EXT" : nullptr;
}

/// The same for blend functions and equations, which came later to desktop OpenGL.
const char* drawBufferBlendSuffix(const GlInfo& info)
{
    if (!info.desktop || info.bare || info.native_version >= 400) return drawBufferMaskSuffix(info);
    return info.has("GL_ARB_draw_buffers_blend") ? "ARB" : nullptr;
}

/// The same for timer queries.
const char* timerSuffix(const GlInfo& info)
{
    if (info.bare) return nullptr;
    if (info.web) return info.has("GL_EXT_disjoint_timer_query_webgl2") ? "" : nullptr;
    if (!info.desktop) return info.has("GL_EXT_disjoint_timer_query") ? "EXT" : nullptr;
    return info.native_version >= 330 || info.has("GL_ARB_timer_query") ? "" : nullptr;
}

/// The same for several viewports, which have switches apart as draw buffers do.
const char* viewportSuffix(const GlInfo& info)
{
    if (info.bare) return nullptr;
    if (info.desktop)
        return info.native_version >= 410 || info.has("GL_ARB_viewport_array") ? "" : nullptr;
    return info.native_version >= 320 && info.has("GL_OES_viewport_array") ? "OES" : nullptr;
}

/// The same for glGetGraphicsResetStatus.
const char* resetSuffix(const GlInfo& info)
{
    if (info.bare) return nullptr;
    if (info.native_version >= (info.desktop ? 450 : 320)) return "";
    if (info.has("GL_KHR_robustness")) return info.desktop ? "" : "KHR";
    if (info.desktop) return info.has("GL_ARB_robustness") ? "ARB" : nullptr;
    return info.has("GL_EXT_robustness") ? "EXT" : nullptr;
}

/// Desktop OpenGL loads functions that its version lacks.
void dropWhatIsMissing(GlApi& gl, const GlInfo& info)
{
    const auto lacks = [&info](int version, const char* extension) {
        return info.desktop && info.native_version < version && !info.has(extension);
    };
    if (lacks(430, "GL_ARB_invalidate_subdata")) gl.InvalidateFramebuffer = nullptr;
    if (lacks(420, "GL_ARB_internalformat_query")) gl.GetInternalformativ = nullptr;
    if (lacks(420, "GL_ARB_texture_storage")) gl.TexStorage2D = nullptr;
    if (lacks(410, "GL_ARB_ES2_compatibility")) gl.DepthRangef = nullptr;
    if (lacks(400, "GL_ARB_transform_feedback2"))
        gl.PauseTransformFeedback = gl.ResumeTransformFeedback = nullptr;
    if (!info.desktop && info.native_version < 310) gl.GetTexLevelParameteriv = nullptr;
    if (lacks(410, "GL_ARB_get_program_binary")) {
        gl.GetProgramBinary = nullptr;
        gl.ProgramBinary = nullptr;
        gl.ProgramParameteri = nullptr;
    }
}

}  // namespace

bool GlInfo::has(const char* extension) const
{
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Result<GlInfo> readInfo(const GlApi& gl, bool ignore_extensions)
{
    GlInfo info;
    const std::string version = text(gl, GL_VERSION);
    const char* const prefix = "OpenGL ES ";
    info.desktop = version.rfind(prefix, 0) != 0;
    info.web = version.find("WebGL") != version.npos;
    const char* number = version.c_str() + (info.desktop ? 0 : std::strlen(prefix));
    int major = 0;
    int minor = 0;
    std::sscanf(number, "%d.%d", &major, &minor);
    info.native_version = major * 100 + minor * 10;
    if (info.native_version >= 300) info.extensions = readExtensions(gl);
    info.version = info.desktop ? compatibleVersion(info) : info.native_version;
    if (info.version < 300)
        return failure(Code::gl_version,
                       "the context is '" + version +
                           "'; crevice wants OpenGL ES 3.0 or newer, or desktop OpenGL 3.3",
                       "ask for a newer context, or update the driver of " + text(gl, GL_RENDERER));
    if (ignore_extensions) {
        info.bare = true;
        info.native_version = info.version = 300;
        info.extensions.clear();
    }
    return info;
}

void settleOptional(GlApi& gl, const GlInfo& info, const GlLoader& load)
{
    auto find = [&](auto& function, const char* name, const char* suffix) {
        using Function = std::decay_t<decltype(function)>;
        const std::string full = std::string(name) + (suffix ? suffix : "");
        function = suffix ? reinterpret_cast<Function>(load(full.c_str())) : nullptr;
    };
    const char* masks = drawBufferMaskSuffix(info);
    find(gl.ColorMaski, "glColorMaski", masks);
    find(gl.Disablei, "glDisablei", masks);
    find(gl.Enablei, "glEnablei", masks);
    find(gl.IsEnabledi, "glIsEnabledi", masks);
    const char* blending = drawBufferBlendSuffix(info);
    find(gl.BlendEquationi, "glBlendEquationi", blending);
    find(gl.BlendEquationSeparatei, "glBlendEquationSeparatei", blending);
    find(gl.BlendFuncSeparatei, "glBlendFuncSeparatei", blending);

    const char* viewports = viewportSuffix(info);
    find(gl.DepthRangeIndexed, "glDepthRangeIndexed", info.desktop ? viewports : nullptr);
    find(gl.DepthRangeIndexedf, "glDepthRangeIndexedf", info.desktop ? nullptr : viewports);
    find(gl.ScissorIndexed, "glScissorIndexed", viewports);
    find(gl.ViewportIndexedf, "glViewportIndexedf", viewports);

    const char* timers = timerSuffix(info);
    find(gl.BeginQuery, "glBeginQuery", timers);
    find(gl.DeleteQueries, "glDeleteQueries", timers);
    find(gl.EndQuery, "glEndQuery", timers);
    find(gl.GenQueries, "glGenQueries", timers);
    const bool web = timers && info.web;  // where that alone is Emscripten's, with its suffix
    find(gl.GetQueryObjectui64v, "glGetQueryObjectui64v", web ? "EXT" : timers);

    find(gl.GetGraphicsResetStatus, "glGetGraphicsResetStatus", resetSuffix(info));
    find(gl.GetBufferSubData, "glGetBufferSubData", info.web ? "" : nullptr);

    dropWhatIsMissing(gl, info);

    const bool clips = info.desktop ? info.native_version >= 450 || info.has("GL_ARB_clip_control")
                                    : info.has("GL_EXT_clip_control");
    find(gl.ClipControl, "glClipControl", !clips ? nullptr : info.desktop ? "" : "EXT");
    const bool modes = info.desktop || info.has("GL_NV_polygon_mode");
    find(gl.PolygonMode, "glPolygonMode", !modes ? nullptr : info.desktop ? "" : "NV");
    gl.glsl_330 = info.desktop && !info.bare && info.native_version < 430 &&
                  !info.has("GL_ARB_ES3_compatibility");

    const bool core_labels = info.native_version >= (info.desktop ? 430 : 320);
    const char* labels = core_labels || info.desktop ? "" : "KHR";
    if (!core_labels && !info.has("GL_KHR_debug")) labels = nullptr;
    find(gl.ObjectLabel, "glObjectLabel", labels);
}

DeviceCaps readCaps(GlApi& gl, const GlInfo& info)
{
    DeviceCaps caps;
    const std::string renderer = text(gl, GL_RENDERER);
    caps.name = renderer + ", " + text(gl, GL_VERSION);
    caps.version = std::min(info.version, 320);
    caps.software = isSoftware(renderer);
    gl.emulates_mediump = caps.software;
    caps.equal_attachments = info.web;  // WebGL 2.0, 4.1.5: else a framebuffer is incomplete
    caps.max_texture_size = integer(gl, GL_MAX_TEXTURE_SIZE);
    caps.max_volume_size = integer(gl, GL_MAX_3D_TEXTURE_SIZE);
    caps.max_color_attachments = std::min({integer(gl, GL_MAX_COLOR_ATTACHMENTS),
                                           integer(gl, GL_MAX_DRAW_BUFFERS), kMaxColorAttachments});
    caps.max_texture_units = std::min(integer(gl, GL_MAX_TEXTURE_IMAGE_UNITS), kMaxTextureUnits);
    if (info.desktop) {  // whose names in vectors came with 4.1
        caps.max_fragment_uniform_vectors = integer(gl, kMaxFragmentUniformComponents) / 4;
        caps.max_vertex_uniform_vectors = integer(gl, kMaxVertexUniformComponents) / 4;
    } else {
        caps.max_fragment_uniform_vectors = integer(gl, GL_MAX_FRAGMENT_UNIFORM_VECTORS);
        caps.max_vertex_uniform_vectors = integer(gl, GL_MAX_VERTEX_UNIFORM_VECTORS);
    }
    for (const FormatInfo& format : allFormats()) {
        if (!mayRender(info, format) || !tryRender(gl, format)) continue;
        caps.renderable[static_cast<int>(format.format)] = true;
        caps.sample_counts[static_cast<int>(format.format)] =
            readSampleCounts(gl, glFormat(format.format).internal);
    }
    return caps;
}

bool canFilter(const GlInfo& info, Format format)
{
    if (formatInfo(format).format_class == FormatClass::depth) return false;
    const bool full_float =
        format == Format::r32f || format == Format::rg32f || format == Format::rgba32f;
    return !full_float || (info.desktop && !info.bare) || info.has("GL_OES_texture_float_linear");
}

}  // namespace crevice
