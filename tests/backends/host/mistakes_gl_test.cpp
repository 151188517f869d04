// SPDX-License-Identifier: MIT
// What hosts do wrong, on a real context: calls without it or in another one, ids of nothing.
#include <crevice/renderer.h>

#include "tests/support/gl_fixture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <limits>
#include <optional>

using namespace crevice;

namespace {

constexpr Extent kExtent = {32, 18};
constexpr std::uint32_t kPoison = 12345;

struct Stage {
    Stage()
    {
        const double aspect = double(kExtent.width) / kExtent.height;
        frame = makeFrame(*uploaded, need(chooseCamera(scene, uploaded->bounds(), "", aspect)),
                          kExtent);
        renderer = need(Renderer::create(*gl.device, descriptionOf({"balanced", ""}), {kExtent},
                                         traitsOf(frame)));
    }

    std::vector<float> draw()
    {
        need(renderer->render(frame));
        return gl.read(renderer->output("ao")).pixels;
    }

    GlFixture gl;
    Scene scene = need(loadScene("spheres"));
    std::optional<UploadedScene> uploaded = need(UploadedScene::upload(*gl.device, scene));
    Frame frame;
    std::unique_ptr<Renderer> renderer;
};

Code onlyCode(const Status& status)
{
    return status.diagnostics().size() == 1 ? status.diagnostics()[0].code : Code::internal;
}

/// All that a host may call, each of which must say CV6004.
void checkRefused(Stage& host)
{
    Device& device = *host.gl.device;
    Renderer& renderer = *host.renderer;
    CHECK(onlyCode(renderer.render(host.frame)) == Code::gl_version);
    CHECK(onlyCode(renderer.renderTimed(host.frame).diagnostics()) == Code::gl_version);
    CHECK(onlyCode(renderer.resize({16, 9})) == Code::gl_version);
    CHECK(onlyCode(renderer.reload(descriptionOf({"learnopengl", ""}), {kExtent})) ==
          Code::gl_version);
    CHECK(onlyCode(Renderer::create(device, descriptionOf({"mobile", ""}), {kExtent}, {})
                       .diagnostics()) == Code::gl_version);
    CHECK(onlyCode(device.readTexture(renderer.output("ao")).diagnostics()) == Code::gl_version);
    CHECK(onlyCode(device.writeTexture(renderer.output("ao"), Image(kExtent, 1))) ==
          Code::gl_version);
    CHECK(onlyCode(device.present(renderer.output("ao"), {0, 0, 0, kExtent})) == Code::gl_version);
    CHECK(onlyCode(device.createTexture({"t", Format::r8, {4, 4}}).diagnostics()) ==
          Code::gl_version);
    CHECK(onlyCode(device.createFramebuffer({}).diagnostics()) == Code::gl_version);
    CHECK(onlyCode(device.createMesh(square(0)).diagnostics()) == Code::gl_version);
    CHECK(onlyCode(device.adoptTexture({1, "t", Format::r8, {4, 4}}).diagnostics()) ==
          Code::gl_version);
    CHECK(
        onlyCode(
            device.createProgram({"p", stage(kFullscreenVertex), stage(fragment("void main() {}"))})
                .diagnostics()) == Code::gl_version);
}

}  // namespace

TEST_CASE(
    "Without a current context every call is CV6004, and with it the picture is the one asked for")
{
    Stage stage;
    const std::vector<float> before = stage.draw();
    stage.frame.camera.view_from_world[3][0] += 0.25;
    {
        auto other = need(makeContext(testBackend()));
    }  // leaves none current
    checkRefused(stage);
    need(testContext().makeCurrent());
    const std::vector<float> after = stage.draw();
    CHECK(after != before);
    ++stage.frame.revision;
    CHECK(stage.draw() == after);
}

TEST_CASE("In another context every call is CV6004, and what is there stays as it is")
{
    Stage stage;
    const std::vector<float> picture = stage.draw();
    stage.frame.camera.view_from_world[3][0] += 0.25;
    {
        auto context = need(makeContext(testBackend()));
        const GlApi gl = need(loadGlApi(context->loader()));
        std::unique_ptr<Device> device;  // whose objects have the same names
        GLuint own = 0;
        if (GENERATE(false, true))
            device = need(makeGlDevice(context->loader()));
        else {
            gl.GenVertexArrays(1, &own);
            gl.BindVertexArray(own);
        }
        std::vector<GLuint> textures;
        for (GLuint name = 1; name < 200; ++name)
            if (gl.IsTexture(name)) textures.push_back(name);
        GLuint kept = 0;
        gl.GenTextures(1, &kept);
        gl.BindTexture(GL_TEXTURE_2D, kept);
        checkRefused(stage);
        const MeshId mesh = stage.frame.draws[0].mesh;
        stage.gl.device->destroy(mesh);
        CHECK_FALSE(stage.gl.device->info(mesh).exists);
        for (const GLuint name : textures) CHECK(gl.IsTexture(name));
        GLint bound = 0;
        gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
        CHECK(bound == static_cast<GLint>(own));
        gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
        CHECK(bound == static_cast<GLint>(kept));
        CHECK(gl.GetError() == GL_NO_ERROR);
        if (device) need(device->createTexture({"t", Format::r8, {4, 4}}));
    }
    need(testContext().makeCurrent());
    const Status status = stage.renderer->render(stage.frame);
    CHECK(status.ok());
    CHECK(onlyCode(status) == Code::bad_input);  // the mesh that was destroyed
    CHECK(stage.gl.read(stage.renderer->output("ao")).pixels != picture);
}

TEST_CASE("Of two devices whose contexts give out the same names each knows its own")
{
    auto first_context = need(makeContext(testBackend()));
    auto first = need(makeGlDevice(first_context->loader()));
    auto second_context = need(makeContext(testBackend()));
    auto second = need(makeGlDevice(second_context->loader()));
    need(second->createTexture({"t", Format::r8, {4, 4}}));
    CHECK(onlyCode(first->createTexture({"t", Format::r8, {4, 4}}).diagnostics()) ==
          Code::gl_version);
    CHECK(onlyCode(first->beginFrame()) == Code::gl_version);
    second.reset();
    need(first_context->makeCurrent());
    need(first->createTexture({"t", Format::r8, {4, 4}}));
    first.reset();
    second_context.reset();
    need(testContext().makeCurrent());
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

TEST_CASE(
    "Draws of meshes and maps that are not there, or not finite, are left out, and the rest is "
    "drawn")
{
    Stage stage;
    const std::vector<float> whole = stage.draw();
    Frame rest = stage.frame;
    rest.draws[0].count = 0;
    Frame bad = stage.frame;
    std::swap(stage.frame, rest);
    const std::vector<float> without = stage.draw();
    std::swap(stage.frame, rest);
    const Material material = bad.materials[bad.draws[0].material];
    bad.materials.push_back(material);
    SECTION("mesh") { bad.draws[0].mesh = {kPoison}; }
    SECTION("null mesh") { bad.draws[0].mesh = {}; }
    SECTION("indices") { bad.draws[0].count = 0xfffffff0; }
    SECTION("matrix")
    {
        bad.draws[0].world_from_model[0][0] = std::numeric_limits<double>::quiet_NaN();
    }
    SECTION("map")
    {
        bad.draws[0].material = static_cast<int>(bad.materials.size()) - 1;
        bad.materials.back().base_color_map = {kPoison};
    }
    const Status status = stage.renderer->render(bad);
    INFO(toText(status.diagnostics()));
    CHECK(status.ok());
    CHECK((status.diagnostics().size() == 1 || status.diagnostics().size() == 2));
    CHECK(status.diagnostics().back().message.find("draw 0 is left out: ") == 0);
    CHECK(stage.gl.read(stage.renderer->output("ao")).pixels == without);
    CHECK(stage.draw() == whole);
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
