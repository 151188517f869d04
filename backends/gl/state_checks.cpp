// SPDX-License-Identifier: MIT
// What of a host's state cannot be set aside, so that drawing is refused.
#include "backends/gl/failure.h"
#include "backends/gl/state.h"

namespace crevice {

namespace {

// A desktop name that the OpenGL ES headers do not have.
constexpr GLenum kSamplesPassed = 0x8914;

Diagnostic busy(const std::string& what, const char* help)
{
    return failure(Code::host_busy, what + ", which drawing would spoil", help);
}

}  // namespace

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

}  // namespace crevice
