// SPDX-License-Identifier: MIT
// Drawing on the GL device: uniforms, samplers, fixed-function state, load and store, present.
#include "tests/support/gl_fixture.h"

#include "backends/gl/objects.h"

#include <algorithm>

namespace crevice {

namespace {

using Pixel = std::vector<float>;

Pixel pixel(const Image& image, int x, int y)
{
    Pixel values;
    for (int c = 0; c < image.channels; ++c) values.push_back(image.at(x, y, c));
    return values;
}

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
