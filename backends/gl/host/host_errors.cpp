// SPDX-License-Identifier: MIT
#include "backends/gl/host/host_errors.h"

#include "backends/gl/failure.h"
#include "backends/gl/objects.h"

#include <utility>

namespace crevice {

namespace {

/// glGetError is asked this often at most: without a current context some drivers never say no.
constexpr int kMostErrors = 16;

/// Clears a framebuffer without attachments, which is no framebuffer to clear.
void clearIncomplete(const GlApi& gl)
{
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    const auto empty = GlFramebuffer::make(gl);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, empty.name());
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
}

}  // namespace

void HostErrors::take(GlApi& gl)
{
    noticeReset(gl);
    for (int i = 0; i < kMostErrors; ++i) {
        switch (gl.GetError()) {
        case GL_NO_ERROR: return;
        case GL_INVALID_ENUM: enum_ = true; break;
        case GL_INVALID_VALUE: value_ = true; break;
        case GL_INVALID_OPERATION: operation_ = true; break;
        case GL_INVALID_FRAMEBUFFER_OPERATION: framebuffer_ = true; break;
        case GL_OUT_OF_MEMORY: memory_ = true; break;
        case GL_CONTEXT_LOST: abandon(gl); return;
        default: break;
        }
    }
}

void HostErrors::raise(const GlApi& gl)
{
    constexpr GLenum kNoCapability = 0xFFFF;
    GLuint unused = 0;
    if (std::exchange(enum_, false)) gl.Enable(kNoCapability);
    if (std::exchange(value_, false)) gl.Viewport(0, 0, -1, -1);
    if (std::exchange(operation_, false)) gl.GetQueryObjectuiv(0, GL_QUERY_RESULT, &unused);
    if (std::exchange(framebuffer_, false)) clearIncomplete(gl);
}

Diagnostics HostErrors::takeMemoryWarning()
{
    if (!std::exchange(memory_, false)) return {};
    Diagnostic warning = failure(Code::out_of_memory,
                                 "the host had left GL_OUT_OF_MEMORY pending when the call began",
                                 "ask glGetError after what took so much memory");
    warning.severity = Severity::warning;
    return {warning};
}

}  // namespace crevice
