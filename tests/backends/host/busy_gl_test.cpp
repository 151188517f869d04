// SPDX-License-Identifier: MIT
// A host that is amid something when crevice is called: what cannot be set aside is refused before
// anything is drawn. What can, as transform feedback, is in the random states of hosts.
#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

constexpr GLenum kSamplesPassed = 0x8914;
constexpr GLenum kUpperLeft = 0x8CA2;
constexpr GLenum kZeroToOne = 0x935F;

struct BusyHost : GlFixture {
    BusyHost() : target(texture(Format::rgba8))
    {
        load(begin_query, "glBeginQuery");
        load(end_query, "glEndQuery");
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
    bool desktop = false;
    PFNGLBEGINQUERYPROC begin_query = nullptr;
    PFNGLENDQUERYPROC end_query = nullptr;
};

GLuint linked(const GlApi& gl)
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
    gl.LinkProgram(made);
    return made;
}

}  // namespace

TEST_CASE_METHOD(BusyHost, "A query that would count what is drawn is refused, and goes on")
{
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
    CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(BusyHost, "A current program that is marked for deletion stays current")
{
    const GLuint program = linked(gl);
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

TEST_CASE_METHOD(BusyHost, "A device tells the clip control of the context")
{
    if (!desktop) return;
    PFNGLCLIPCONTROLEXTPROC clip_control = nullptr;
    load(clip_control, "glClipControl");
    clip_control(kUpperLeft, kZeroToOne);
    CHECK(device->clipControl() == ClipControl{true, true});
    clip_control(GL_LOWER_LEFT_EXT, GL_NEGATIVE_ONE_TO_ONE_EXT);
    CHECK(device->clipControl() == ClipControl());
}

TEST_CASE_METHOD(BusyHost, "A device tells the depth range of the context")
{
    gl.DepthRangef(0.75f, 0.25f);
    CHECK(device->depthRange() == DepthRange{0.75f, 0.25f});
    gl.DepthRangef(0, 1);
    CHECK(device->depthRange() == DepthRange());
}

TEST_CASE_METHOD(BusyHost, "An error that the host left is a warning of the next frame alone")
{
    gl.Enable(0xFFFF);
    need(device->beginFrame());
    const Status status = device->endFrame();
    CHECK(status.ok());
    CHECK(onlyCode(status) == Code::gl_error);
    CHECK(refusal().empty());
}
