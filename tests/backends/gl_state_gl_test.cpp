// SPDX-License-Identifier: MIT
// The host's state: strange values go in, the same come out, and the picture does not care. Whole
// lives of hosts are in host_states_gl_test.cpp.
#include "backends/gl/caps.h"
#include "tests/backends/host/states/random_host.h"
#include "tests/support/gl_fixture.h"

namespace crevice {

namespace {

constexpr std::uint32_t kSeeds = 6;

/// A context apart, so that no other test meets what is left in it.
struct OwnContext {
    std::unique_ptr<Context> own = need(makeContext(testBackend()));
};

/// A loader that knows nothing of several draw buffers or viewports.
GlLoader withoutIndices(const GlLoader& load)
{
    return [load](const char* name) -> void* {
        const std::string text = name;
        const bool indexed = text.find("Indexed") != text.npos || text == "glColorMaski" ||
                             text == "glBlendEquationi" ||
                             (text.find("glBlend") == 0 && text.back() == 'i');
        return indexed ? nullptr : load(name);
    };
}

/// A host with an object of every kind bound and nothing at its default.
class HostileHost : private OwnContext, public GlFixture {
public:
    explicit HostileHost(const GlDeviceOptions& options = {}) : GlFixture(options, *own)
    {
        settleOptional(gl, need(readInfo(gl, options.ignore_extensions)), own->loader());
        hostile.emplace(gl,
                        options.ignore_extensions ? withoutIndices(own->loader()) : own->loader());
    }

    /// One frame of everything: a pass that tests depth within an area, which is all of it, through
    /// two texture units, into several samples or one.
    Image frame(int samples = 1);

    std::optional<RandomHost> hostile;
};

Image HostileHost::frame(int samples)
{
    const TextureId source = texture(Format::rgba8);
    need(device->writeTexture(source, Image({4, 4}, 4, 0.5f)));
    const TextureId target = texture(Format::rgba32f);
    const TextureId depth = texture(Format::depth32f);
    const MeshId mesh = need(device->createMesh(square(0)));
    const ProgramId sum = program(R"(uniform sampler2D a; uniform sampler2D b;
in vec2 uv; out vec4 color; void main() { color = texture(a, uv) + texture(b, uv); })",
                                  kMeshVertex);
    FramebufferDesc desc{"framebuffer", {target}, depth};
    if (samples > 1) {
        const auto drawn = [&](Format format) {
            return need(device->createTexture({"drawn", format, {4, 4}, samples}));
        };
        desc = {"framebuffer", {drawn(Format::rgba32f)}, drawn(Format::depth32f), {target}, depth};
    }
    PassInfo pass = wholePass(need(device->createFramebuffer(desc)), {4, 4});
    pass.clear_color[0][0] = 0.25f;
    pass.has_depth = true;
    pass.depth_load = LoadOp::clear;
    pass.depth_store = StoreOp::store;
    pass.within_area = true;
    pass.area.extent = {4, 4};
    StateDesc state;
    state.depth_test = Compare::less;
    state.depth_write = true;
    state.cull = Cull::back;
    need(device->beginFrame());
    device->beginPass(pass);
    device->setProgram(sum, state);
    device->setTexture(location(sum, "a"), 0, source, {});
    device->setTexture(location(sum, "b"), 1, source, {});
    device->draw(mesh, 0, 6);
    device->endPass();
    need(device->endFrame());
    CHECK(read(depth).pixels == std::vector<float>(16, 0.5f));
    return read(target);
}

}  // namespace

TEST_CASE_METHOD(HostileHost, "a frame, and all calls around it, leave the host's state as it was")
{
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        hostile->randomize(seed);
        const Snapshot before = hostile->snapshot();
        frame();
        frame(4);
        CHECK(difference(before, hostile->snapshot()) == "");
    }
}

TEST_CASE_METHOD(HostileHost, "no state of the host changes the picture")
{
    const Image calm = frame();
    CHECK(calm.pixels[0] == Approx(1.0f).margin(0.01));
    CHECK(frame(4).pixels == calm.pixels);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        hostile->randomize(seed);
        CHECK(frame().pixels == calm.pixels);
        CHECK(frame(4).pixels == calm.pixels);
    }
}

TEST_CASE_METHOD(HostileHost, "reading samples of a texture leaves the host's in its unit")
{
    if (device->caps().version < 310) return;  // then it reads none
    const auto storage = reinterpret_cast<PFNGLTEXSTORAGE2DMULTISAMPLEPROC>(
        testContext().loader()("glTexStorage2DMultisample"));
    GLuint names[3] = {};
    gl.GenTextures(3, names);
    for (const GLuint name : names) {
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
        storage(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_RGBA8, 4, 4, GL_TRUE);
    }
    const TextureId read_from =
        need(device->adoptTexture({names[0], "host", Format::rgba8, {4, 4}, 4}));
    const ProgramId reads = need(device->createProgram(
        {"reads", stage("#version 310 es\nvoid main() { gl_Position = vec4(0.0); }\n"),
         stage("#version 310 es\nuniform highp sampler2DMS host;\nout highp vec4 color;\n"
               "void main() { color = texelFetch(host, ivec2(0), 3); }\n")}));
    const FramebufferId into = framebuffer({texture(Format::rgba8)});
    hostile->randomize(1);
    for (const GLuint bound : {names[1], names[2]}) {
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE0 + 1}) {
            gl.ActiveTexture(unit);
            gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, bound);
        }
        const Snapshot before = hostile->snapshot();
        need(device->beginFrame());
        device->beginPass(wholePass(into, {4, 4}));
        device->setProgram(reads, {});
        device->setTexture(location(reads, "host"), 1, read_from, {});
        device->drawFullscreen();
        device->endPass();
        need(device->endFrame());
        CHECK(difference(before, hostile->snapshot()) == "");
    }
    gl.DeleteTextures(3, names);
}

TEST_CASE_METHOD(HostileHost, "making a device leaves the host's state as it was")
{
    hostile->randomize(2);
    const Snapshot before = hostile->snapshot();
    const auto second = need(makeGlDevice(testContext().loader()));
    CHECK(difference(before, hostile->snapshot()) == "");
}

TEST_CASE("a context without state per draw buffer is put back too")
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    HostileHost host(options);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        host.hostile->randomize(seed);
        const Snapshot before = host.hostile->snapshot();
        host.texture(Format::r8);
        need(host.device->beginFrame());
        need(host.device->endFrame());
        CHECK(difference(before, host.hostile->snapshot()) == "");
    }
}

TEST_CASE("a host that wants no restoring gets the picture all the same")
{
    GlDeviceOptions options;
    options.restore_state = false;
    options.check_errors = false;
    HostileHost host(options);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        host.hostile->randomize(seed);
        GLboolean feedback = GL_FALSE;  // nothing pauses it then, and drawing is refused
        host.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &feedback);
        if (!feedback) CHECK(host.frame().pixels[0] == Approx(1.0f).margin(0.01));
    }
}

}  // namespace crevice
