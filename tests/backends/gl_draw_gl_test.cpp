// SPDX-License-Identifier: MIT
// Drawing on the GL device: uniforms, samplers, fixed-function state, load and store, present.
#include "tests/support/gl_fixture.h"

#include "backends/gl/objects.h"

#include <algorithm>

namespace crevice {

namespace {

using Pixel = std::vector<float>;

const char* const kFlat = "uniform vec4 value; out vec4 color; void main() { color = value; }";

Pixel pixel(const Image& image, int x, int y)
{
    Pixel values;
    for (int c = 0; c < image.channels; ++c) values.push_back(image.at(x, y, c));
    return values;
}

/// Draws squares at some depths, each in its own colour, under one state.
class SquareFixture : public GlFixture {
public:
    SquareFixture()
        : target(texture(Format::rgba32f)),
          depth(texture(Format::depth32f)),
          into(framebuffer({target}, depth)),
          flat(program(kFlat, kMeshVertex)),
          value(location(flat, "value"))
    {
    }

    PassInfo pass() const
    {
        PassInfo info = wholePass(into, {4, 4});
        info.has_depth = true;
        info.depth_load = LoadOp::clear;
        return info;
    }

    void drawSquare(const StateDesc& state, float z, const Pixel& color)
    {
        device->setProgram(flat, state);
        device->setUniform(value, GlslType::vec4, 1, color.data());
        device->draw(z > 0 ? far_square : near_square, 0, 6);
    }

    TextureId target, depth;
    FramebufferId into;
    ProgramId flat;
    int value;
    MeshId far_square = need(device->createMesh(square(0.5f)));
    MeshId near_square = need(device->createMesh(square(-0.5f)));
};

const Pixel kRed = {1, 0, 0, 1};
const Pixel kGreen = {0, 1, 0, 1};

}  // namespace

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

TEST_CASE_METHOD(GlFixture, "a pass writes several targets and leaves out a null attachment")
{
    const TextureId first = texture(Format::r8);
    const TextureId third = texture(Format::rgba8);
    const ProgramId three = program(R"(
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
layout(location = 2) out vec4 c;
void main() { a = vec4(0.2); b = vec4(0.4); c = vec4(0.6); })");
    const FramebufferId into = framebuffer({first, {}, third});
    drawPass(wholePass(into, {4, 4}, 3), [&] {
        device->setProgram(three, {});
        device->drawFullscreen();
    });
    CHECK(read(first).at(1, 1) == Approx(0.2f));
    CHECK(read(third).at(1, 1, 3) == Approx(0.6f));
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

TEST_CASE_METHOD(SquareFixture, "the depth test keeps the nearer square, whatever the order")
{
    StateDesc less;
    less.depth_test = Compare::less;
    less.depth_write = true;
    for (bool near_first : {true, false}) {
        drawPass(pass(), [&] {
            drawSquare(less, near_first ? -0.5f : 0.5f, near_first ? kGreen : kRed);
            drawSquare(less, near_first ? 0.5f : -0.5f, near_first ? kRed : kGreen);
        });
        CHECK(pixel(read(target), 2, 2) == kGreen);
        CHECK(read(depth).at(2, 2) == 0.25f);
    }
}

TEST_CASE_METHOD(SquareFixture, "a pass without depth writes leaves the depth as it was")
{
    StateDesc greater;
    greater.depth_test = Compare::greater_equal;
    need(device->beginFrame());
    PassInfo info = pass();
    info.clear_depth = 0.5f;
    device->beginPass(info);
    drawSquare(greater, 0.5f, kGreen);
    drawSquare(greater, -0.5f, kRed);
    device->endPass();
    need(device->endFrame());
    CHECK(pixel(read(target), 0, 3) == kGreen);
    CHECK(read(depth).at(0, 3) == 0.5f);
}

TEST_CASE_METHOD(SquareFixture, "a pass clears its depth, though the pass before wrote none")
{
    need(device->beginFrame());
    device->beginPass(pass());
    drawSquare({}, 0.5f, kRed);
    device->endPass();
    PassInfo second = pass();
    second.clear_depth = 0.125f;
    device->beginPass(second);
    device->endPass();
    need(device->endFrame());
    CHECK(read(depth).at(1, 2) == 0.125f);
}

TEST_CASE_METHOD(SquareFixture, "culling drops triangles by their side")
{
    auto drawn = [&](Cull cull) {
        drawPass(pass(), [&] {
            StateDesc state;
            state.cull = cull;
            drawSquare(state, 0.5f, kRed);
        });
        return pixel(read(target), 1, 1) == kRed;
    };
    CHECK(drawn(Cull::none));
    CHECK(drawn(Cull::back));
    CHECK_FALSE(drawn(Cull::front));
}

TEST_CASE_METHOD(GlFixture, "a mesh feeds positions, normals and uvs, from any first index")
{
    const ProgramId show = program(
        "in vec3 normal; in vec2 uv; out vec4 color;"
        " void main() { color = vec4(normal.xy, uv); }",
        kMeshVertex);
    const MeshId mesh = need(device->createMesh(square(0)));
    const TextureId target = texture(Format::rgba32f);
    const FramebufferId into = framebuffer({target});
    drawPass(wholePass(into, {4, 4}), [&] {
        device->setProgram(show, {});
        device->draw(mesh, 3, 3);  // the upper right half alone
    });
    const Image image = read(target);
    CHECK(pixel(image, 0, 0) == Pixel{0, 0, 0, 0});
    CHECK(image.at(3, 2, 0) == Approx(0.25f));
    CHECK(image.at(3, 2, 1) == Approx(0.5f));
    CHECK(image.at(3, 2, 2) == Approx(0.875f));
    CHECK(image.at(3, 2, 3) == Approx(0.625f));
}

TEST_CASE_METHOD(SquareFixture, "loading keeps what an earlier pass stored")
{
    need(device->beginFrame());
    PassInfo info = pass();
    info.clear_color[0][1] = 0.5f;
    info.depth_store = StoreOp::discard;
    device->beginPass(info);
    device->endPass();
    info.color_load[0] = LoadOp::load;
    info.depth_load = LoadOp::discard;
    device->beginPass(info);
    device->endPass();
    need(device->endFrame());
    CHECK(pixel(read(target), 2, 1)[1] == 0.5f);
}

TEST_CASE_METHOD(SquareFixture, "a driver's error comes out of endFrame with the pass's name")
{
    need(device->beginFrame());
    device->beginPass(pass());
    device->setProgram(flat, {});
    device->setUniform(value, GlslType::int_, 1, kRed.data());  // it is a vec4
    device->endPass();
    const Status status = device->endFrame();
    REQUIRE(status.diagnostics().size() == 1);
    CHECK(status.diagnostics()[0].code == Code::gl_error);
    CHECK(status.diagnostics()[0].message == "pass 'test pass' gave GL_INVALID_OPERATION");
    need(device->beginFrame());
    need(device->endFrame());
}

TEST_CASE_METHOD(SquareFixture, "errors that the host left are not blamed on a pass, and stay")
{
    const auto raise = [&](GLenum error) {
        if (error == GL_INVALID_ENUM) gl.Enable(0xFFFF);
        if (error == GL_INVALID_VALUE) gl.Viewport(0, 0, -1, -1);
        if (error == GL_INVALID_OPERATION) gl.UseProgram(0x7FFFFFFF), (void)gl.GetError();
        if (error == GL_INVALID_OPERATION) gl.Uniform1i(5, 1);
        if (error == GL_INVALID_FRAMEBUFFER_OPERATION) {
            auto empty = GlFramebuffer::make(gl);
            gl.BindFramebuffer(GL_FRAMEBUFFER, empty.name());
            gl.Clear(GL_COLOR_BUFFER_BIT);
        }
    };
    gl.UseProgram(0);
    const TextureId shown = texture(Format::rgba8);
    for (const GLenum error : {GL_INVALID_ENUM, GL_INVALID_VALUE, GL_INVALID_OPERATION,
                               GL_INVALID_FRAMEBUFFER_OPERATION}) {
        INFO(glErrorName(error));
        raise(error);
        need(device->beginFrame());
        need(device->endFrame());
        CHECK(gl.GetError() == error);
        raise(error);
        texture(Format::r8);
        program("out vec4 color; void main() { color = vec4(1.0); }");
        read(shown);
        CHECK(gl.GetError() == error);
        CHECK(gl.GetError() == GL_NO_ERROR);
    }
}

}  // namespace crevice
