// SPDX-License-Identifier: MIT
// A host that is amid something when crevice is called: what can be set aside is, and all else is
// refused before anything is drawn.
#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

constexpr GLenum kSamplesPassed = 0x8914;
constexpr GLenum kQueryWait = 0x8E13;
constexpr GLenum kPolygonMode = 0x0B40;
constexpr GLenum kLine = 0x1B01;
constexpr GLenum kClipDistance0 = 0x3000;
constexpr GLenum kUpperLeft = 0x8CA2;
constexpr GLenum kZeroToOne = 0x935F;

struct BusyHost : GlFixture {
    BusyHost() : target(texture(Format::rgba8)), paint(program(kWhite))
    {
        load(begin_feedback, "glBeginTransformFeedback");
        load(end_feedback, "glEndTransformFeedback");
        load(bind_base, "glBindBufferBase");
        load(varyings, "glTransformFeedbackVaryings");
        load(clip_control, "glClipControl");
        load(polygon_mode, "glPolygonMode");
        load(begin_conditional, "glBeginConditionalRender");
        load(end_conditional, "glEndConditionalRender");
        load(begin_query, "glBeginQuery");
        load(end_query, "glEndQuery");
        load(gen_queries, "glGenQueries");
        desktop = testBackend() == "osmesa";
    }

    template <class Function>
    void load(Function& function, const char* name)
    {
        function = reinterpret_cast<Function>(testContext().loader()(name));
    }

    /// What a frame, a reading and a presenting say; all three must agree.
    std::string refusal()
    {
        const Status frame = device->beginFrame();
        if (frame) need(device->endFrame());
        const auto image = device->readTexture(target);
        CHECK(image.ok() == frame.ok());
        if (frame) return "";
        CHECK(frame.diagnostics()[0].code == Code::host_busy);
        CHECK(image.diagnostics()[0].code == Code::host_busy);
        CHECK(!frame.diagnostics()[0].help.empty());
        return frame.diagnostics()[0].message;
    }

    static constexpr const char* kWhite = "out vec4 color; void main() { color = vec4(1.0); }";
    TextureId target;
    ProgramId paint;
    bool desktop = false;
    PFNGLBEGINTRANSFORMFEEDBACKPROC begin_feedback = nullptr;
    PFNGLENDTRANSFORMFEEDBACKPROC end_feedback = nullptr;
    PFNGLBINDBUFFERBASEPROC bind_base = nullptr;
    PFNGLTRANSFORMFEEDBACKVARYINGSPROC varyings = nullptr;
    PFNGLCLIPCONTROLEXTPROC clip_control = nullptr;
    PFNGLPOLYGONMODENVPROC polygon_mode = nullptr;
    PFNGLBEGINCONDITIONALRENDERNVPROC begin_conditional = nullptr;
    PFNGLENDCONDITIONALRENDERNVPROC end_conditional = nullptr;
    PFNGLBEGINQUERYPROC begin_query = nullptr;
    PFNGLENDQUERYPROC end_query = nullptr;
    PFNGLGENQUERIESPROC gen_queries = nullptr;
};

GLuint linked(const GlApi& gl, PFNGLTRANSFORMFEEDBACKVARYINGSPROC varyings)
{
    const GLuint made = gl.CreateProgram();
    const std::string fragment_text = fragment(BusyHost::kWhite);
    const char* const texts[] = {kFullscreenVertex, fragment_text.c_str()};
    for (int i = 0; i < 2; ++i) {
        const GLuint shader = gl.CreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        gl.ShaderSource(shader, 1, &texts[i], nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(made, shader);
        gl.DeleteShader(shader);
    }
    const char* const captured[] = {"gl_Position"};
    if (varyings) varyings(made, 1, captured, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(made);
    return made;
}

}  // namespace

TEST_CASE_METHOD(BusyHost, "A query that would count what is drawn is refused, and goes on")
{
    GLuint query = 0;
    gen_queries(1, &query);
    std::vector<GLenum> targets = {GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE};
    if (desktop) targets.push_back(kSamplesPassed);
    if (desktop || device->caps().version >= 320) targets.push_back(GL_PRIMITIVES_GENERATED);
    for (const GLenum each : targets) {
        INFO(each);
        auto own = GlQuery::make(gl);
        begin_query(each, own.name());
        CHECK(refusal().find("of the host is active") != std::string::npos);
        texture(Format::r8);
        end_query(each);
        GLuint counted = 1;
        gl.GetQueryObjectuiv(own.name(), GL_QUERY_RESULT, &counted);
        CHECK(counted == 0);
        CHECK(refusal().empty());
    }
    gl.DeleteQueries(1, &query);
    CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(BusyHost, "Conditional rendering is refused, and goes on")
{
    if (!desktop) return;  // OpenGL ES has none
    auto own = GlQuery::make(gl);
    begin_query(kSamplesPassed, own.name());
    end_query(kSamplesPassed);
    CHECK(refusal().empty());
    begin_conditional(own.name(), kQueryWait);
    CHECK(refusal().find("conditionally") != std::string::npos);
    end_conditional();
    CHECK(gl.GetError() == GL_NO_ERROR);
    CHECK(refusal().empty());
}

TEST_CASE_METHOD(BusyHost, "Transform feedback of the host is paused while crevice draws")
{
    const GLuint captures = linked(gl, varyings);
    auto buffer = GlBuffer::make(gl);
    gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer.name());
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
    bind_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.name());
    auto written = GlQuery::make(gl);
    gl.UseProgram(captures);
    begin_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, written.name());
    begin_feedback(GL_TRIANGLES);
    drawInto(target, paint);
    CHECK(refusal().empty());
    GLint current = 0;
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    CHECK(static_cast<GLuint>(current) == captures);
    GLboolean active = GL_FALSE, paused = GL_TRUE;
    gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    CHECK(active);
    CHECK(!paused);
    end_feedback();
    end_query(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    GLuint count = 1;
    gl.GetQueryObjectuiv(written.name(), GL_QUERY_RESULT, &count);
    CHECK(count == 0);
    gl.UseProgram(0);
    gl.DeleteProgram(captures);
    CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(BusyHost, "A current program that is marked for deletion stays current")
{
    const GLuint program = linked(gl, nullptr);
    gl.UseProgram(program);
    CHECK(refusal().empty());
    gl.DeleteProgram(program);
    CHECK(refusal().find("marked for deletion") != std::string::npos);
    texture(Format::r8);
    GLint current = 0, still = GL_FALSE;
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    gl.GetProgramiv(program, GL_DELETE_STATUS, &still);
    CHECK(static_cast<GLuint>(current) == program);
    CHECK(still);
    gl.UseProgram(0);
    CHECK(refusal().empty());
}

TEST_CASE_METHOD(BusyHost,
                 "Clip control, polygon mode and clip distances change no picture, and stay")
{
    if (!desktop) return;
    drawInto(target, paint);
    const Image calm = read(target);
    clip_control(kUpperLeft, kZeroToOne);
    polygon_mode(GL_FRONT_AND_BACK, kLine);
    for (int i = 0; i < 8; ++i) gl.Enable(kClipDistance0 + i);
    CHECK(device->clipControl() == ClipControl{true, true});
    drawInto(target, paint);
    CHECK(read(target).pixels == calm.pixels);
    GLint origin = 0, depth = 0, mode[2] = {};
    gl.GetIntegerv(GL_CLIP_ORIGIN_EXT, &origin);
    gl.GetIntegerv(GL_CLIP_DEPTH_MODE_EXT, &depth);
    gl.GetIntegerv(kPolygonMode, mode);
    CHECK(static_cast<GLenum>(origin) == kUpperLeft);
    CHECK(static_cast<GLenum>(depth) == kZeroToOne);
    CHECK(static_cast<GLenum>(mode[0]) == kLine);
    for (int i = 0; i < 8; ++i) CHECK(gl.IsEnabled(kClipDistance0 + i));
    for (int i = 0; i < 8; ++i) gl.Disable(kClipDistance0 + i);
    clip_control(GL_LOWER_LEFT_EXT, GL_NEGATIVE_ONE_TO_ONE_EXT);
    polygon_mode(GL_FRONT_AND_BACK, 0x1B02);
    CHECK(device->clipControl() == ClipControl());
}
