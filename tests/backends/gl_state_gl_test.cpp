// SPDX-License-Identifier: MIT
// The host's state: strange values go in, the same come out, and the picture does not care.
#include "tests/support/gl_fixture.h"

#include <map>

namespace crevice {

namespace {

constexpr GLenum kFramebufferSrgb = 0x8DB9;
constexpr GLenum kColorLogicOp = 0x0BF2;
constexpr GLenum kMultisample = 0x809D;
constexpr GLenum kSampleAlphaToOne = 0x809F;

/// A context apart, so that no other test meets what is left in it.
struct OwnContext {
    std::unique_ptr<Context> own = need(makeContext(testBackend()));
};

/// A host with an object of every kind bound and nothing at its default.
class HostileHost : private OwnContext, public GlFixture {
public:
    explicit HostileHost(const GlDeviceOptions& options = {})
        : GlFixture(options, *own),
          desktop_(testBackend() == "osmesa")
    {
        auto load = own->loader();
        auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::decay_t<decltype(function)>>(load(name));
            REQUIRE(function);
        };
        find(scissor_, "glScissor");
        find(clear_color_, "glClearColor");
        find(polygon_offset_, "glPolygonOffset");
        find(sample_coverage_, "glSampleCoverage");
        makeObjects();
    }

    ~HostileHost()
    {
        gl.DeleteTextures(2, textures_);
        gl.DeleteFramebuffers(2, framebuffers_);
        gl.DeleteRenderbuffers(1, &renderbuffer_);
        gl.DeleteBuffers(3, buffers_);
        gl.DeleteVertexArrays(1, &vertex_array_);
        gl.DeleteSamplers(1, &sampler_);
    }

    void setStrangeState();

    /// Every value that the device may touch, by name.
    std::map<std::string, std::vector<float>> snapshot() const;

    GLuint hostFramebuffer() const { return framebuffers_[0]; }

    /// One frame of everything: a pass that tests depth within an area, which is all of it, through
    /// two texture units, into several samples or one.
    Image frame(int samples = 1);

private:
    void makeObjects();
    std::vector<GLenum> switches() const;
    bool perDrawBuffer() const
    {
        return gl.IsEnabledi && device->caps().version >= (desktop_ ? 310 : 320);
    }

    bool desktop_;
    PFNGLSCISSORPROC scissor_ = nullptr;
    PFNGLCLEARCOLORPROC clear_color_ = nullptr;
    PFNGLPOLYGONOFFSETPROC polygon_offset_ = nullptr;
    PFNGLSAMPLECOVERAGEPROC sample_coverage_ = nullptr;
    GLuint textures_[2] = {};
    GLuint framebuffers_[2] = {};
    GLuint buffers_[3] = {};
    GLuint renderbuffer_ = 0;
    GLuint vertex_array_ = 0;
    GLuint sampler_ = 0;
};

void HostileHost::makeObjects()
{
    gl.GenTextures(2, textures_);
    gl.GenFramebuffers(2, framebuffers_);
    for (int i = 0; i < 2; ++i) {
        gl.BindTexture(GL_TEXTURE_2D, textures_[i]);
        gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i]);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[i],
                                0);
    }
    gl.GenRenderbuffers(1, &renderbuffer_);
    gl.GenBuffers(3, buffers_);
    gl.GenVertexArrays(1, &vertex_array_);
    gl.GenSamplers(1, &sampler_);
}

std::vector<GLenum> HostileHost::switches() const
{
    std::vector<GLenum> all = {GL_BLEND,
                               GL_CULL_FACE,
                               GL_DEPTH_TEST,
                               GL_DITHER,
                               GL_POLYGON_OFFSET_FILL,
                               GL_PRIMITIVE_RESTART_FIXED_INDEX,
                               GL_RASTERIZER_DISCARD,
                               GL_SAMPLE_ALPHA_TO_COVERAGE,
                               GL_SAMPLE_COVERAGE,
                               GL_SCISSOR_TEST,
                               GL_STENCIL_TEST};
    if (device->caps().version >= 310) all.push_back(GL_SAMPLE_MASK);
    if (perDrawBuffer()) all.push_back(GL_SAMPLE_SHADING);
    if (desktop_)
        all.insert(all.end(), {kFramebufferSrgb, kColorLogicOp, kMultisample, kSampleAlphaToOne});
    return all;
}

void HostileHost::setStrangeState()
{
    for (GLenum name : switches()) gl.Enable(name);
    if (desktop_) gl.Disable(kMultisample);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
    for (int unit : {1, 0}) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        gl.BindTexture(GL_TEXTURE_2D, textures_[unit]);
        gl.BindSampler(unit, sampler_);
    }
    gl.ActiveTexture(GL_TEXTURE0 + 5);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[0]);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
    gl.BindVertexArray(vertex_array_);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffers_[1]);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers_[2]);
    gl.Viewport(1, 2, 3, 5);
    scissor_(1, 1, 1, 1);
    clear_color_(0.125f, 0.25f, 0.5f, 0.75f);
    polygon_offset_(3.0f, 5.0f);
    sample_coverage_(0.5f, GL_TRUE);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_NEVER);
    gl.DepthRangef(0.75f, 0.125f);
    gl.CullFace(GL_FRONT_AND_BACK);
    gl.FrontFace(GL_CW);
    gl.BlendFuncSeparate(GL_ZERO, GL_DST_ALPHA, GL_CONSTANT_ALPHA, GL_SRC_COLOR);
    gl.BlendEquationSeparate(GL_MIN, GL_FUNC_REVERSE_SUBTRACT);
    for (GLenum alignment : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) gl.PixelStorei(alignment, 8);
    for (GLenum skip : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS,
                        GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
        gl.PixelStorei(skip, 7);
    if (!perDrawBuffer()) return;
    gl.Disablei(GL_BLEND, 2);
    gl.ColorMaski(2, GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.BlendFuncSeparatei(2, GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl.BlendEquationi(2, GL_MAX);
}

/// What a host may have set, and how many numbers each is.
const std::pair<GLenum, int> kParameters[] = {{GL_VIEWPORT, 4},
                                              {GL_SCISSOR_BOX, 4},
                                              {GL_COLOR_CLEAR_VALUE, 4},
                                              {GL_COLOR_WRITEMASK, 4},
                                              {GL_DEPTH_RANGE, 2},
                                              {GL_BLEND_COLOR, 4},
                                              {GL_DRAW_FRAMEBUFFER_BINDING, 1},
                                              {GL_READ_FRAMEBUFFER_BINDING, 1},
                                              {GL_CURRENT_PROGRAM, 1},
                                              {GL_VERTEX_ARRAY_BINDING, 1},
                                              {GL_ACTIVE_TEXTURE, 1},
                                              {GL_ARRAY_BUFFER_BINDING, 1},
                                              {GL_ELEMENT_ARRAY_BUFFER_BINDING, 1},
                                              {GL_PIXEL_PACK_BUFFER_BINDING, 1},
                                              {GL_PIXEL_UNPACK_BUFFER_BINDING, 1},
                                              {GL_RENDERBUFFER_BINDING, 1},
                                              {GL_DEPTH_CLEAR_VALUE, 1},
                                              {GL_POLYGON_OFFSET_FACTOR, 1},
                                              {GL_POLYGON_OFFSET_UNITS, 1},
                                              {GL_SAMPLE_COVERAGE_VALUE, 1},
                                              {GL_DEPTH_WRITEMASK, 1},
                                              {GL_DEPTH_FUNC, 1},
                                              {GL_CULL_FACE_MODE, 1},
                                              {GL_FRONT_FACE, 1},
                                              {GL_BLEND_SRC_RGB, 1},
                                              {GL_BLEND_SRC_ALPHA, 1},
                                              {GL_BLEND_DST_RGB, 1},
                                              {GL_BLEND_DST_ALPHA, 1},
                                              {GL_BLEND_EQUATION_RGB, 1},
                                              {GL_BLEND_EQUATION_ALPHA, 1},
                                              {GL_PACK_ALIGNMENT, 1},
                                              {GL_PACK_ROW_LENGTH, 1},
                                              {GL_PACK_SKIP_PIXELS, 1},
                                              {GL_PACK_SKIP_ROWS, 1},
                                              {GL_UNPACK_ALIGNMENT, 1},
                                              {GL_UNPACK_ROW_LENGTH, 1},
                                              {GL_UNPACK_SKIP_PIXELS, 1},
                                              {GL_UNPACK_SKIP_ROWS, 1}};

std::map<std::string, std::vector<float>> HostileHost::snapshot() const
{
    std::map<std::string, std::vector<float>> values;
    auto floats = [&](const std::string& name, GLenum parameter, int count) {
        std::vector<float>& value = values[name];
        value.resize(16, 0.0f);
        gl.GetFloatv(parameter, value.data());
        value.resize(count);
    };
    for (const auto& [parameter, count] : kParameters)
        floats("parameter " + std::to_string(parameter), parameter, count);
    for (GLenum name : switches())
        values["switch " + std::to_string(name)] = {static_cast<float>(gl.IsEnabled(name))};
    if (perDrawBuffer()) {
        GLint equation = 0;
        GLint source = 0;
        GLint mask[4] = {};
        gl.GetIntegeri_v(GL_BLEND_EQUATION_RGB, 2, &equation);
        gl.GetIntegeri_v(GL_BLEND_SRC_RGB, 2, &source);
        gl.GetIntegeri_v(GL_COLOR_WRITEMASK, 2, mask);
        values["draw buffer 2"] = {float(gl.IsEnabledi(GL_BLEND, 2)), float(equation),
                                   float(source), float(mask[0]), float(mask[1])};
    }
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int unit = 0; unit < 8; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        floats("texture of unit " + std::to_string(unit), GL_TEXTURE_BINDING_2D, 1);
        floats("sampler of unit " + std::to_string(unit), GL_SAMPLER_BINDING, 1);
        if (device->caps().version >= 310)
            floats("samples of unit " + std::to_string(unit), GL_TEXTURE_BINDING_2D_MULTISAMPLE, 1);
    }
    gl.ActiveTexture(active);
    return values;
}

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
    setStrangeState();
    const auto before = snapshot();
    frame();
    frame(4);
    const TextureId shown = texture(Format::rgba8);
    need(device->present(shown, {hostFramebuffer(), 0, 0, {4, 4}}));
    const auto after = snapshot();
    REQUIRE(before.size() == after.size());
    for (const auto& [name, value] : before) {
        INFO(name);
        CHECK(after.at(name) == value);
    }
}

TEST_CASE_METHOD(HostileHost, "no state of the host changes the picture")
{
    const Image calm = frame();
    CHECK(calm.pixels[0] == Approx(1.0f).margin(0.01));
    const Image samples = frame(4);
    CHECK(samples.pixels == calm.pixels);
    setStrangeState();
    CHECK(frame().pixels == calm.pixels);
    CHECK(frame(4).pixels == samples.pixels);
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
    setStrangeState();
    for (const GLuint bound : {names[1], names[2]}) {
        for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE0 + 1}) {
            gl.ActiveTexture(unit);
            gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, bound);
        }
        const auto before = snapshot();
        need(device->beginFrame());
        device->beginPass(wholePass(into, {4, 4}));
        device->setProgram(reads, {});
        device->setTexture(location(reads, "host"), 1, read_from, {});
        device->drawFullscreen();
        device->endPass();
        need(device->endFrame());
        CHECK(snapshot() == before);
    }
    gl.DeleteTextures(3, names);
}

TEST_CASE("making a device leaves the host's state as it was")
{
    HostileHost host;
    host.setStrangeState();
    const auto before = host.snapshot();
    const auto second = need(makeGlDevice(testContext().loader()));
    CHECK(host.snapshot() == before);
}

TEST_CASE("a context without state per draw buffer is put back too")
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    HostileHost host(options);
    host.setStrangeState();
    const auto before = host.snapshot();
    host.texture(Format::r8);
    need(host.device->beginFrame());
    need(host.device->endFrame());
    CHECK(host.snapshot() == before);
}

TEST_CASE("a host that wants no restoring gets the picture all the same")
{
    GlDeviceOptions options;
    options.restore_state = false;
    options.check_errors = false;
    HostileHost host(options);
    host.setStrangeState();
    CHECK(host.frame().pixels[0] == Approx(1.0f).margin(0.01));
}

}  // namespace crevice
