// SPDX-License-Identifier: MIT
#include "backends/gl/api.h"

#include "backends/gl/failure.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace crevice {

namespace {

/// glGetError is asked this often at most: without a current context some drivers never say no.
constexpr int kMaxPendingErrors = 16;

/// Shortest GL_MAX_LABEL_LENGTH that a driver may have, less the terminating zero.
constexpr std::size_t kMaxLabelLength = 255;

/// The table's functions in a row, each with '!' or '?' before it, for those that must be there and
/// those that may: one text, so that loading them is a loop, and no code for each.
constexpr char kFunctionNames[] =
#define CREVICE_GL_true "!"
#define CREVICE_GL_false "?"
#define CREVICE_GL_NAME(name, upper, required) CREVICE_GL_##required "gl" #name "\0"
    CREVICE_GL_FUNCTIONS(CREVICE_GL_NAME);
#undef CREVICE_GL_NAME

using GlFunction = void (*)();
constexpr std::size_t kFunctionCount = 0
#define CREVICE_GL_COUNT(name, upper, required) +1
    CREVICE_GL_FUNCTIONS(CREVICE_GL_COUNT);
#undef CREVICE_GL_COUNT
static_assert(offsetof(GlApi, emulates_mediump) == kFunctionCount * sizeof(GlFunction),
              "the table begins with its functions");

const char* const kGlHelp = "crevice needs OpenGL ES 3.0, and the context's own loader";

Diagnostic contextLost(const std::string& what)
{
    return failure(Code::context_lost, what + " found the GL context lost",
                   "destroy what was made in it, make a new context, and in that a new device and "
                   "renderer");
}

/// What desktop OpenGL alone may lack.
std::vector<const char*> missingOnEs(const GlApi& gl)
{
    std::vector<const char*> missing;
    const GLubyte* version = gl.GetString ? gl.GetString(GL_VERSION) : nullptr;
    const bool es = version && std::strstr(reinterpret_cast<const char*>(version), "OpenGL ES");
    if (es && !gl.DepthRangef) missing.push_back("DepthRangef");
    if (es && !gl.TexStorage2D) missing.push_back("TexStorage2D");
    return missing;
}

/// Some loaders find nothing where no context is current, GLFW's among them; others find functions
/// that do nothing.
Status checkCurrent(const GlApi& gl)
{
    if (gl.GetString && gl.GetString(GL_VERSION)) return {};
    if (gl.GetError && gl.GetError() == GL_CONTEXT_LOST) return contextLost("makeGlDevice");
    return failure(Code::gl_version,
                   std::string("no GL context is current on this thread") +
                       (gl.GetString ? "" : ", or the loader finds none of its functions"),
                   "make the context current before making a device in it, and give the loader of "
                   "what made it");
}

template <class Value, class... Arguments>
void silence(Value(GL_APIENTRY*& function)(Arguments...))
{
    if (function) function = [](Arguments...) -> Value { return Value(); };
}

}  // namespace

Result<GlApi> loadGlApi(const GlLoader& load)
{
    if (!load)
        return failure(Code::gl_function, "the loader of GL functions is empty",
                       "give makeGlDevice a function such as eglGetProcAddress");
    GlApi api;
    std::vector<std::string> missing;
    char* place = reinterpret_cast<char*>(&api);
    for (const char* name = kFunctionNames; *name != '\0'; name += std::strlen(name) + 1) {
        const auto function = load(name + 1);
        static_assert(sizeof function == sizeof(GlFunction), "as pointers to functions are");
        std::memcpy(place, &function, sizeof function);
        place += sizeof function;
        if (*name == '!' && !function) missing.push_back(name + 1);
    }
    if (const Status status = checkCurrent(api); !status) return status.diagnostics();
    for (const char* name : missingOnEs(api)) missing.push_back("gl" + std::string(name));
    if (missing.empty()) return api;
    return failure(Code::gl_function, "the context has no function " + joined(missing), kGlHelp);
}

const char* glErrorName(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST: return "GL_CONTEXT_LOST";
    default: return "an unknown GL error";
    }
}

const char* framebufferStatusName(GLenum status)
{
    switch (status) {
    case GL_FRAMEBUFFER_UNDEFINED: return "GL_FRAMEBUFFER_UNDEFINED";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT: return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS: return "GL_FRAMEBUFFER_INCOMPLETE_DIMENSIONS";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE: return "GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE";
    case GL_FRAMEBUFFER_UNSUPPORTED: return "GL_FRAMEBUFFER_UNSUPPORTED";
    default: return "an unknown framebuffer status";
    }
}

void setDepthRange(const GlApi& gl, float near_depth, float far_depth)
{
    if (gl.DepthRangeIndexed)
        gl.DepthRangeIndexed(0, near_depth, far_depth);
    else if (gl.DepthRangeIndexedf)
        gl.DepthRangeIndexedf(0, near_depth, far_depth);
    else if (gl.DepthRangef)
        gl.DepthRangef(near_depth, far_depth);
    else if (gl.DepthRange)
        gl.DepthRange(near_depth, far_depth);
}

void setScissor(const GlApi& gl, GLint x, GLint y, GLsizei width, GLsizei height)
{
    if (gl.ScissorIndexed)
        gl.ScissorIndexed(0, x, y, width, height);
    else
        gl.Scissor(x, y, width, height);
}

void setViewport(const GlApi& gl, float x, float y, float width, float height)
{
    if (gl.ViewportIndexedf)
        gl.ViewportIndexedf(0, x, y, width, height);
    else
        gl.Viewport(static_cast<GLint>(x), static_cast<GLint>(y), static_cast<GLsizei>(width),
                    static_cast<GLsizei>(height));
}

Status takeErrors(GlApi& gl, const char* what, const char* label)
{
    GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) return {};
    Code code = Code::gl_error;
    std::string who = what;
    if (*label) who += std::string(" '") + label + "'";
    std::string message = who + " gave ";
    for (int i = 0; i < kMaxPendingErrors && error != GL_NO_ERROR; ++i, error = gl.GetError()) {
        if (error == GL_CONTEXT_LOST) {
            abandon(gl);
            return contextLost(who);
        }
        if (i > 0) message += ", ";
        message += glErrorName(error);
        if (error == GL_OUT_OF_MEMORY) code = Code::out_of_memory;
    }
    const char* help = code == Code::out_of_memory
                           ? "render at a smaller size, or free other textures of this device"
                           : "the driver refused a call; its name and version help with a report";
    return failure(code, message, help);
}

void abandon(GlApi& gl)
{
#define CREVICE_GL_SILENCE(name, upper, required) silence(gl.name);
    CREVICE_GL_FUNCTIONS(CREVICE_GL_SILENCE)
#undef CREVICE_GL_SILENCE
    gl.GetError = []() -> GLenum { return GL_CONTEXT_LOST; };
}

void noticeReset(GlApi& gl)
{
    if (gl.GetGraphicsResetStatus && gl.GetGraphicsResetStatus() != GL_NO_ERROR) abandon(gl);
}

void setLabel(const GlApi& gl, GLenum identifier, GLuint name, const std::string& label)
{
    if (!gl.ObjectLabel || label.empty()) return;
    const auto length = static_cast<GLsizei>(std::min(label.size(), kMaxLabelLength));
    gl.ObjectLabel(identifier, name, length, label.data());
}

}  // namespace crevice
