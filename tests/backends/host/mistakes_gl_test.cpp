// SPDX-License-Identifier: MIT
// What hosts do wrong, on a real context: calls without it or in another one, ids of nothing.
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
    const Status status = host.renderer->render(host.stage.frame);
    CHECK(status.ok());
    CHECK(onlyCode(status) == Code::bad_input);  // the mesh that was destroyed
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
        CHECK(onlyCode(device->readTexture(id).diagnostics()) == Code::bad_input);
        CHECK(onlyCode(device->writeTexture(id, Image({4, 4}, 1))) == Code::bad_input);
        CHECK(onlyCode(device->present(id, {0, 0, 0, {4, 4}})) == Code::bad_input);
        CHECK(device->nativeName(id) == 0);
        CHECK_FALSE(device->info(id).exists);
        CHECK_FALSE(device->info(MeshId{id.value}).exists);
        device->destroy(id);
        device->destroy(MeshId{id.value});
        device->destroy(ProgramId{id.value});
        device->destroy(FramebufferId{id.value});
        if (id)
            CHECK(onlyCode(device->createFramebuffer({"f", {id}, {}}).diagnostics()) ==
                  Code::bad_input);
    }
    TextureDesc samples{"samples", Format::rgba8, {4, 4}};
    samples.samples = 4;
    const TextureId drawn = need(device->createTexture(samples));
    CHECK(onlyCode(device->readTexture(drawn).diagnostics()) == Code::bad_input);
    CHECK(onlyCode(device->present(drawn, {0, 0, 0, {4, 4}})) == Code::bad_input);
    CHECK(device->nativeName(drawn) == 0);
}
