// SPDX-License-Identifier: MIT
// What hosts do wrong, on a real context: calls without it or in another one, ids of nothing.
// A host that is amid something when crevice is called: what cannot be set aside is refused before
// anything is drawn. What can, as transform feedback, is in the random states of hosts.
#include <crevice/effect.h>

#include "backends/gl/objects.h"
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

constexpr std::uint32_t kPoison = 12345;

struct Host : GlFixture {
    std::vector<float> draw()
    {
        need(renderer->render(stage.frame));
        return read(renderer->output("ao")).pixels;
    }

    Stage stage{*device};
    std::unique_ptr<Renderer> renderer = stage.make("balanced");
};

/// What a host may call, each of which must say CV6004; gl_failure_test has the rest.
void checkRefused(Host& host)
{
    Device& device = *host.device;
    Renderer& renderer = *host.renderer;
    const TextureId ao = renderer.output("ao");
    const Extent extent = host.stage.extent;
    const auto status = [](const auto& result) { return Status(result.diagnostics()); };
    const ProgramDesc program = {"p", stage(kFullscreenVertex), stage(fragment("void main() {}"))};
    const Status all[] = {
        renderer.render(host.stage.frame),
        status(Renderer::create(device, descriptionOf({"mobile"}), {extent}, {})),
        status(device.readTexture(ao)),
        device.writeTexture(ao, Image(extent, 1)),
        device.present(ao, {0, 0, 0, extent}),
        status(device.createTexture({"t", Format::r8, {4, 4}})),
        status(device.adoptTexture({1, "t", Format::r8, {4, 4}})),
        status(device.createProgram(program)),
    };
    for (const Status& each : all) {
        INFO("call " << &each - all);
        CHECK(onlyCode(each) == Code::gl_version);
    }
}

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
        onlyError(image, Code::host_busy);
        const Diagnostic error = onlyError(frame, Code::host_busy);
        CHECK(!error.help.empty());
        return error.message;
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

TEST_CASE("In another context every call is CV6004, and what is there stays as it is")
{
    Host host;
    const std::vector<float> picture = host.draw();
    host.stage.frame.camera.view_from_world[3][0] += 0.25;
    {
        auto context = need(makeContext(testBackend()));
        const GlApi gl = need(loadGlApi(context->loader()));
        std::unique_ptr<Device> device;  // whose objects have the same names
        if (GENERATE(false, true)) device = need(makeGlDevice(context->loader()));
        GLuint own = 0;
        gl.GenVertexArrays(1, &own);
        gl.BindVertexArray(own);
        std::vector<GLuint> mine(200);
        gl.GenTextures(200, mine.data());
        for (const GLuint each : mine) gl.BindTexture(GL_TEXTURE_2D, each);
        checkRefused(host);
        const MeshId mesh = host.stage.frame.draws[0].mesh;
        host.device->destroy(mesh);
        CHECK_FALSE(host.device->info(mesh).exists);
        for (const GLuint each : mine) CHECK(gl.IsTexture(each));
        GLint bound = 0;
        gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
        CHECK(bound == static_cast<GLint>(own));
        gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
        CHECK(bound == static_cast<GLint>(mine.back()));
        CHECK(gl.GetError() == GL_NO_ERROR);
        if (device) need(device->createTexture({"t", Format::r8, {4, 4}}));
    }
    need(testContext().makeCurrent());
    // The mesh that was destroyed.
    onlyWarning(host.renderer->render(host.stage.frame), Code::bad_input);
    CHECK(host.read(host.renderer->output("ao")).pixels != picture);
}

TEST_CASE("A device that is destroyed in another context deletes nothing there")
{
    GlFixture fixture;
    auto context = need(makeContext(testBackend()));
    auto device = need(makeGlDevice(context->loader()));
    const TextureId texture = need(device->createTexture({"t", Format::r8, {4, 4}}));
    const GLuint name = device->nativeName(texture);
    need(testContext().makeCurrent());
    std::vector<GLuint> mine(64);
    fixture.gl.GenTextures(64, mine.data());
    for (const GLuint each : mine) fixture.gl.BindTexture(GL_TEXTURE_2D, each);
    const bool there = fixture.gl.IsTexture(name);
    device.reset();
    CHECK(bool(fixture.gl.IsTexture(name)) == there);
    for (const GLuint each : mine) CHECK(fixture.gl.IsTexture(each));
    fixture.gl.DeleteTextures(64, mine.data());
    CHECK(takeErrors(fixture.gl, "the test").ok());
}

TEST_CASE_METHOD(GlFixture,
                 "ids that are none are errors of reading, writing and presenting, and no crash")
{
    const TextureId gone = texture(Format::r8);
    device->destroy(gone);
    device->destroy(gone);
    for (const TextureId id : {TextureId{}, TextureId{kPoison}, TextureId{0xffffffff}, gone}) {
        INFO(id.value);
        onlyError(device->readTexture(id), Code::bad_input);
        onlyError(device->writeTexture(id, Image({4, 4}, 1)), Code::bad_input);
        onlyError(device->present(id, {0, 0, 0, {4, 4}}), Code::bad_input);
        CHECK(device->nativeName(id) == 0);
        CHECK_FALSE(device->info(id).exists);
        CHECK_FALSE(device->info(MeshId{id.value}).exists);
        device->destroy(id);
        device->destroy(MeshId{id.value});
        device->destroy(ProgramId{id.value});
        device->destroy(FramebufferId{id.value});
        if (id) onlyError(device->createFramebuffer({"f", {id}, {}}), Code::bad_input);
    }
    TextureDesc samples{"samples", Format::rgba8, {4, 4}};
    samples.samples = 4;
    const TextureId drawn = need(device->createTexture(samples));
    onlyError(device->readTexture(drawn), Code::bad_input);
    onlyError(device->present(drawn, {0, 0, 0, {4, 4}}), Code::bad_input);
    CHECK(device->nativeName(drawn) == 0);
}

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
    onlyWarning(device->endFrame(), Code::gl_error);
    CHECK(refusal().empty());

    Effect effect = need(Effect::create(*device, "mobile_low", {16, 16}, {"ao"}));
    need(effect.render());
    gl.Enable(0xFFFF);
    onlyWarning(effect.render(), Code::gl_error);
}
