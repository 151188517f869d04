// SPDX-License-Identifier: MIT
// Objects of the GL device: formats, readback, errors, lifetimes.
// Drawing on the GL device: uniforms, samplers, fixed-function state, load and store, present.
#include "tests/support/gl_fixture.h"

#include "backends/gl/formats.h"
#include "backends/gl/objects.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

/// The widest gap between neighbouring values of a format in 0..1.
float stepOf(Format format)
{
    switch (format) {
    case Format::rgb565: return 1.0f / 31;
    case Format::rgb10_a2: return 1.0f / 1023;
    case Format::r16f:
    case Format::rg16f:
    case Format::rgba16f: return 1.0f / 2048;
    case Format::r11g11b10f: return 1.0f / 32;
    case Format::r32f:
    case Format::rg32f:
    case Format::rgba32f: return 0.0f;
    case Format::depth16: return 1.0f / 65535;
    case Format::depth24: return 1.0f / 16777215;
    case Format::depth32f: return 0.0f;
    default: return 1.0f / 255;
    }
}

bool isDepth(const FormatInfo& info) { return info.format_class == FormatClass::depth; }

using Pixel = std::vector<float>;

Pixel pixel(const Image& image, int x, int y)
{
    Pixel values;
    for (int c = 0; c < image.channels; ++c) values.push_back(image.at(x, y, c));
    return values;
}

}  // namespace

TEST_CASE("a bare OpenGL ES 3.0 renders to no float format, yet floats are written and read")
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    GlFixture bare(options);
    const DeviceCaps& caps = bare.device->caps();
    CHECK(caps.version == 300);
    for (const FormatInfo& info : allFormats()) {
        INFO(info.name);
        CHECK(caps.canRender(info.format) == info.core_renderable);
    }
    const TextureId texture = bare.texture(Format::rgba16f);
    need(bare.device->writeTexture(texture, Image({4, 4}, 4, -2.5f)));
    CHECK(bare.read(texture).at(3, 3, 2) == -2.5f);
}

TEST_CASE_METHOD(GlFixture,
                 "a clear lands in every format that can be rendered to, and a host can sample it")
{
    const float wanted[] = {0.25f, 0.5f, 0.75f, 1.0f};
    for (const FormatInfo& info : allFormats()) {
        if (!device->caps().canRender(info.format)) continue;
        INFO(info.name);
        const TextureId target = texture(info.format);
        const FramebufferId into = isDepth(info) ? framebuffer({}, target) : framebuffer({target});
        PassInfo pass = wholePass(into, {4, 4}, isDepth(info) ? 0 : 1);
        std::copy(wanted, wanted + 4, pass.clear_color[0]);
        pass.has_depth = isDepth(info);
        pass.depth_load = LoadOp::clear;
        pass.clear_depth = 0.25f;
        clearPass(pass);
        const Image image = read(target);
        REQUIRE(image.channels == info.channels);
        for (int c = 0; c < info.channels; ++c)
            CHECK(std::abs(image.at(1, 2, c) - wanted[c]) <= stepOf(info.format));
        GLint filter = 0;  // without levels, so that a host's shader sees it without a sampler
        gl.BindTexture(GL_TEXTURE_2D, device->nativeName(target));
        gl.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
        CHECK(filter == GL_NEAREST);
    }
}

TEST_CASE_METHOD(GlFixture, "what is written to a texture is read back, in every format")
{
    const Extent extent = {5, 3};  // rows of odd length
    for (const FormatInfo& info : allFormats()) {
        INFO(info.name);
        Image image(extent, info.channels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = static_cast<float>(i) / image.pixels.size();
        const TextureId id = texture(info.format, extent);
        need(device->writeTexture(id, image));
        const Image back = read(id);
        REQUIRE(back.extent == extent);
        REQUIRE(back.channels == info.channels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const bool two_bits = info.format == Format::rgb10_a2 && i % 4 == 3;
            const float step = two_bits ? 1.0f / 3 : stepOf(info.format);
            CHECK(std::abs(back.pixels[i] - image.pixels[i]) <= step);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a texel comes back by itself, in a later frame")
{
    const TextureId half = texture(Format::r16f), byte = texture(Format::rgba8);
    need(device->writeTexture(byte, Image({4, 4}, 4, 1.0f)));
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    const ProgramId written = program("out vec4 color; void main() { color = vec4(0.375); }");
    PassInfo pass = wholePass(framebuffer({half}), {4, 4});
    pass.within_area = true;  // a state of which no read may know
    pass.area = {2, 2, {1, 1}};
    pass.clear_color[0][0] = 0.25f;
    need(device->beginFrame());
    CHECK_FALSE(device->takeRead(half));
    device->beginPass(pass);
    device->setProgram(written, {Compare::greater, true, Cull::front, Blend::over});
    device->drawFullscreen();
    device->endPass();
    need(device->beginRead(half));
    need(device->beginRead(byte));
    CHECK(device->beginRead(TextureId{99}).diagnostics()[0].code == Code::bad_input);
    need(device->endFrame());
    device->finish();
    GLint bound = 0;
    gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bound);
    CHECK(bound == static_cast<GLint>(buffer));
    need(device->beginFrame());
    for (const auto& [id, value] : {std::make_pair(byte, 1.0f), std::make_pair(half, 0.25f)}) {
        const auto texel = device->takeRead(id);
        REQUIRE(texel);
        CHECK((*texel)[0] == value);
        CHECK_FALSE(device->takeRead(id));  // once
    }
    need(device->endFrame());
    gl.DeleteBuffers(1, &buffer);
}

TEST_CASE_METHOD(GlFixture, "depth that a shader wrote is read back exactly")
{
    const ProgramId written =
        program("void main() { gl_FragDepth = (gl_FragCoord.x + 0.123) / 4.5; }");
    for (Format format : {Format::depth16, Format::depth24, Format::depth32f}) {
        INFO(formatInfo(format).name);
        const TextureId depth = texture(format);
        const FramebufferId into = framebuffer({}, depth);
        PassInfo pass = wholePass(into, {4, 4}, 0);
        pass.has_depth = true;
        pass.depth_load = LoadOp::clear;
        drawPass(pass, [&] {
            StateDesc state;
            state.depth_write = true;  // with the test at its default, always
            device->setProgram(written, state);
            device->drawFullscreen();
        });
        const Image image = read(depth);
        for (int x = 0; x < 4; ++x)
            CHECK(std::abs(image.at(x, 1) - (x + 0.623f) / 4.5f) <= stepOf(format) + 1e-7f);
    }
}

TEST_CASE_METHOD(GlFixture, "what cannot be made or written is refused by name and reason")
{
    const Extent wide = {device->caps().max_texture_size + 1, 1};
    const TextureId one = texture(Format::r8);
    const std::vector<TextureId> many(device->caps().max_color_attachments + 1, one);
    const auto made = [this](const char* label, Extent extent) {
        return device->createTexture({label, Format::rgba8, extent});
    };
    const auto framed = [this](const std::vector<TextureId>& color) {
        return device->createFramebuffer({"framebuffer", color, {}});
    };
    CHECK(has(onlyError(made("huge", wide), Code::too_big_for_device).message, "'huge'"));
    for (const Extent none : {Extent{0, 4}, {4, 0}, {-1, 4}, {4, -2147483647}})
        CHECK(has(onlyError(made("nothing", none), Code::gl_error).message, "INVALID_VALUE"));
    onlyError(made("endless", {1, 2147483647}), Code::too_big_for_device);
    CHECK(has(onlyError(framed({}), Code::gl_error).message, "MISSING_ATTACHMENT"));
    const auto depth = framed({texture(Format::depth24)});
    CHECK(has(onlyError(depth, Code::gl_error).message, "INCOMPLETE_ATTACHMENT"));
    onlyError(framed(many), Code::too_many);
    onlyError(device->writeTexture(one, Image({4, 5}, 1)), Code::bad_input);
    for (const std::uint32_t none : {0u, 123456u})
        onlyError(device->adoptTexture({none}), Code::bad_input);
}

TEST_CASE_METHOD(GlFixture, "objects carry their labels where the context has labels")
{
    auto get_label =
        reinterpret_cast<PFNGLGETOBJECTLABELPROC>(testContext().loader()("glGetObjectLabel"));
    if (device->caps().version < 320 || !get_label) return;
    const GLuint name = device->nativeName(texture(Format::r8, {4, 4}, "a label to find"));
    char label[64] = {};
    GLsizei length = 0;
    get_label(GL_TEXTURE, name, sizeof(label), &length, label);
    CHECK(std::string(label) == "a label to find");
}

TEST_CASE_METHOD(GlFixture, "uniforms of every type reach the shader, arrays whole")
{
    const ProgramId sum = program(R"(
uniform float a; uniform vec2 b; uniform vec3 c[3]; uniform vec4 d;
uniform int e; uniform ivec2 f; uniform uint g; uniform bool h; uniform mat3 i; uniform mat4 j; out vec4 color;
void main()
{
    color.x = a + b.y + c[0].x + c[1].y + c[2].z + d.w;
    color.y = float(e + f.y) + float(g) + (h ? 0.5 : 0.0);
    color.z = (i * vec3(0, 1, 0)).x;
    color.w = (j * vec4(0, 0, 0, 1)).x;
})");
    for (const UniformInfo& info : device->uniforms(sum)) {
        CHECK(info.name.size() == 1);
        CHECK(info.count == (info.name == "c" ? 3 : 1));
        CHECK(info.location >= 0);
    }
    CHECK(device->uniforms(sum).size() == 10);

    const float floats[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    const std::int32_t ints[] = {100, 200, 300, 400};
    const TextureId target = texture(Format::rgba32f);
    const FramebufferId into = framebuffer({target});
    drawPass(wholePass(into, {4, 4}), [&] {
        device->setProgram(sum, {});
        const std::pair<const char*, GlslType> of_floats[] = {
            {"a", GlslType::float_}, {"b", GlslType::vec2}, {"c", GlslType::vec3},
            {"d", GlslType::vec4},   {"i", GlslType::mat3}, {"j", GlslType::mat4}};
        for (const auto& [name, type] : of_floats)
            device->setUniform(location(sum, name), type, name[0] == 'c' ? 3 : 1, floats);
        const std::pair<const char*, GlslType> of_ints[] = {{"e", GlslType::int_},
                                                            {"f", GlslType::ivec2},
                                                            {"g", GlslType::uint_},
                                                            {"h", GlslType::bool_}};
        for (const auto& [name, type] : of_ints)
            device->setUniform(location(sum, name), type, 1, ints);
        device->drawFullscreen();
    });
    // by columns: i * y is the second column, j * w the fourth
    CHECK(pixel(read(target), 0, 0) == Pixel{1 + 2 + 1 + 5 + 9 + 4, 100 + 200 + 100 + 0.5f, 4, 13});
}

TEST_CASE_METHOD(GlFixture, "samplers filter and wrap as asked, also on full floats and depth")
{
    const ProgramId look = program(R"(uniform highp sampler2D source; uniform vec2 at;
out vec4 color; void main() { color = texture(source, at); })");
    const TextureId target = texture(Format::rgba32f, {1, 1});
    const FramebufferId into = framebuffer({target});
    Image two({2, 1}, 1);
    two.pixels = {0.0f, 1.0f};
    auto sample = [&](TextureId source, Filter filter, Wrap wrap, float u) {
        const float at[] = {u, 0.5f};
        drawPass(wholePass(into, {1, 1}), [&] {
            device->setProgram(look, {});
            device->setTexture(location(look, "source"), 3, source, {filter, wrap});
            device->setUniform(location(look, "at"), GlslType::vec2, 1, at);
            device->drawFullscreen();
        });
        return read(target).at(0, 0);
    };
    for (Format format : {Format::r8, Format::r32f, Format::depth24}) {
        INFO(formatInfo(format).name);
        const TextureId source = texture(format, {2, 1});
        need(device->writeTexture(source, two));
        CHECK(sample(source, Filter::nearest, Wrap::clamp, 0.49f) == 0.0f);
        CHECK(sample(source, Filter::nearest, Wrap::clamp, 1.2f) == 1.0f);
        CHECK(sample(source, Filter::nearest, Wrap::repeat, 1.2f) == 0.0f);
        const float middle = sample(source, Filter::linear, Wrap::clamp, 0.4999f);
        if (format == Format::r8) CHECK(middle == Approx(0.5f).margin(0.01));
        if (format == Format::depth24) CHECK(middle == 0.0f);
    }
}

TEST_CASE_METHOD(
    GlFixture,
    "depth is kept without writes, the next pass clears it, and an error has its pass's name")
{
    const ProgramId flat =
        program("uniform vec4 value; out vec4 color; void main() { color = value; }", kMeshVertex);
    const TextureId target = texture(Format::rgba32f), depth = texture(Format::depth32f);
    PassInfo pass = wholePass(framebuffer({target}, depth), {4, 4});
    pass.has_depth = true;
    pass.depth_load = LoadOp::clear;
    pass.depth_store = StoreOp::store;
    pass.clear_depth = 0.5f;
    StateDesc greater;
    greater.depth_test = Compare::greater_equal;
    const MeshId squares[] = {need(device->createMesh(square(0.5f))),
                              need(device->createMesh(square(-0.5f)))};
    const float colors[2][4] = {{0, 1, 0, 1}, {1, 0, 0, 1}};
    drawPass(pass, [&] {
        device->setProgram(flat, greater);
        for (const bool nearer : {false, true}) {
            device->setUniform(location(flat, "value"), GlslType::vec4, 1, colors[nearer]);
            device->draw(squares[nearer], 0, 6);
        }
    });
    CHECK(pixel(read(target), 0, 3) == Pixel{0, 1, 0, 1});
    CHECK(read(depth).at(0, 3) == 0.5f);
    pass.clear_depth = 0.125f;
    clearPass(pass);
    CHECK(read(depth).at(1, 2) == 0.125f);

    need(device->beginFrame());
    device->beginPass(pass);
    device->setProgram(flat, {});
    device->setUniform(location(flat, "value"), GlslType::int_, 1, colors);  // it is a vec4
    device->endPass();
    const Status status = device->endFrame();
    REQUIRE(onlyCode(status) == Code::gl_error);
    CHECK(status.diagnostics()[0].message == "pass 'test pass' gave GL_INVALID_OPERATION");
    need(device->beginFrame());
    need(device->endFrame());
}

}  // namespace crevice
