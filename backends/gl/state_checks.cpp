// SPDX-License-Identifier: MIT
// What of a host's state cannot be set aside, so that drawing is refused.
#include "backends/gl/failure.h"
#include "backends/gl/state.h"

namespace crevice {

namespace {

// Desktop names that the OpenGL ES headers do not have.
constexpr GLenum kSamplesPassed = 0x8914;
constexpr GLenum kFirstStatistic = 0x82EE;  // GL_VERTICES_SUBMITTED, the first of eleven
constexpr GLenum kLastStatistic = 0x82F8;
constexpr GLenum kQueryNoWait = 0x8E14;

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

/// GL has no query for it; a second conditional rendering is refused.
bool GlState::rendersConditionally()
{
    if (!gl_.BeginConditionalRender) return false;
    if (probe_.name() == 0) {
        probe_ = GlQuery::make(gl_);
        gl_.BeginQuery(kSamplesPassed, probe_.name());
        gl_.EndQuery(kSamplesPassed);
    }
    gl_.BeginConditionalRender(probe_.name(), kQueryNoWait);
    const bool refused = gl_.GetError() != GL_NO_ERROR;
    if (!refused) gl_.EndConditionalRender();
    return refused;
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
    for (GLenum each = kFirstStatistic; desktop_ && query_version_ >= 460 && each <= kLastStatistic;
         ++each)
        if (active(each)) return busy("a query of pipeline statistics of the host is active", help);
    return {};
}

Status GlState::checkHost(bool asks_errors)
{
    if (depth_ > 1) return {};  // within a frame, which asked
    if (Status status = checkQueries(); !status) return status;
    if (asks_errors && rendersConditionally())
        return busy("the host renders conditionally", "call glEndConditionalRender first");
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
