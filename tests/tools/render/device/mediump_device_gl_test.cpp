// SPDX-License-Identifier: MIT
// That mediump is what the device was asked for, and that nothing else changes.
// Every target of every shipped config in 32-bit floats: nothing that 8 bits would hide.
#include "tests/support/gl_fixture.h"
#include "tests/support/need.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/device/open_device.h"
#include "tools/render/device/poison_device.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/target_diagnosis.h"

#include <cmath>
#include <limits>

using namespace crevice;

namespace {

/// The four values that a fragment shader's body leaves in `color`, with `value` as its one
/// uniform.
std::vector<float> drawAs(Mediump mediump, const std::string& body, std::vector<float> value)
{
    GlFixture gl;
    gl.device = need(makeMediumpDevice(std::move(gl.device), mediump));
    const TextureId target = gl.texture(Format::rgba32f, {1, 1});
    const ProgramId program = gl.program(
        "uniform highp vec4 value;\nlayout(location = 0) out vec4 color;\nvoid main()\n{\n" + body +
        "}\n");
    const FramebufferId into = gl.framebuffer({target});
    value.resize(4);
    need(gl.device->beginFrame());
    gl.device->beginPass(wholePass(into, {1, 1}));
    gl.device->setProgram(program, {});
    for (const UniformInfo& info : gl.device->uniforms(program))
        gl.device->setUniform(info.location, GlslType::vec4, 1, value.data());
    gl.device->drawFullscreen();
    gl.device->endPass();
    need(gl.device->endFrame());
    return gl.read(target).pixels;
}

std::vector<float> drawHalf(const std::string& body, const std::vector<float>& value)
{
    return drawAs(Mediump::half, body, value);
}

const float kInfinity = std::numeric_limits<float>::infinity();

constexpr Extent kSize = {96, 54};

/// What is wrong with the targets of two frames of a config, each "pass target", in floats.
std::vector<std::string> faults(Device& device, Description description, const Frame& frame)
{
    CompileOptions options;
    options.extent = kSize;
    options.disable = {"aliasing"};
    const Plan plan = need(compile(description, traitsOf(frame), device.caps(), options));
    const std::vector<WatchedTarget> watched = watchAll(plan, description);
    FloatDevice floats(device);
    const auto renderer = need(Renderer::create(floats, description, options, traitsOf(frame)));
    for (int i = 0; i < 2; ++i) REQUIRE(renderer->render(frame).ok());
    std::vector<std::string> found;
    for (const WatchedTarget& each : watched) {
        const Image image = need(readOutput(floats, *renderer, each.output));
        TargetHealth health = examine(image, image);
        examineFloats(image, formatOf(plan, each.target), health);
        if (health.bad()) found.push_back(each.pass + " " + each.target);
    }
    CHECK(watched.size() > 2);
    return found;
}

}  // namespace

TEST_CASE("In half floats 2049 is 2048, 65536 is infinite and 2^-15 is 0, and highp is exact")
{
    if (!canRewriteMediump()) return;
    const std::vector<float> value = {2049.0f, 65536.0f, 1.0f / 32768.0f, -2051.0f};
    CHECK(drawHalf("    mediump vec4 v = value; color = v;\n", value) ==
          std::vector<float>({2048.0f, kInfinity, 0.0f, -2052.0f}));
    CHECK(drawHalf("    color = value;\n", value) == value);
    CHECK(drawHalf("    mediump float one = value.x; color = vec4(one + 2048.0, one * 2049.0, 0.0, "
                   "0.0);\n",
                   {1.0f}) == std::vector<float>({2048.0f, 2048.0f, 0.0f, 0.0f}));
}

TEST_CASE("Set to full, mediump has 32 bits on any driver")
{
    if (!canRewriteMediump()) return;
    CHECK(drawAs(Mediump::full,
                 "    mediump vec3 v = value.xyz; mediump int i = int(value.w);\n"
                 "    color = vec4(dot(v, v), length(v), v.x + 1749.0, float(i));\n",
                 {300.0f, 0.0f, 0.0f, 40000.0f}) ==
          std::vector<float>({90000.0f, 300.0f, 2049.0f, 40000.0f}));
}

TEST_CASE("In half floats what overflows on the way to a result is lost, as on a phone")
{
    if (!canRewriteMediump()) return;
    const std::string in = "    mediump vec3 v = value.xyz;\n";
    const std::vector<float> far = {300.0f, 0.0f, 0.0f};
    CHECK(
        drawHalf(in + "    color = vec4(dot(v, v), length(v), normalize(v).x, distance(v, -v));\n",
                 far) == std::vector<float>({kInfinity, kInfinity, 0.0f, kInfinity}));
    CHECK(drawHalf("    highp vec3 v = value.xyz; color = vec4(dot(v, v), length(v), 0.0, 0.0);\n",
                   far) == std::vector<float>({90000.0f, 300.0f, 0.0f, 0.0f}));
    CHECK(
        std::isnan(drawHalf("    mediump float a = value.x; color = vec4(a / a);\n", {1e-5f})[0]));
}

TEST_CASE("In half floats the built-in functions are right to half precision")
{
    if (!canRewriteMediump()) return;
    const std::vector<float> value = {0.25f, 0.5f, 0.75f, 2.0f};
    const std::string in =
        "    mediump vec4 v = value; mediump vec3 a = v.xyz; mediump vec3 b = v.zxw;\n";
    const auto near = [&](const std::string& mediump, std::vector<float> exact) {
        const std::vector<float> got = drawHalf(in + "    color = " + mediump + ";\n", value);
        INFO(mediump);
        for (int i = 0; i < 4; ++i) CHECK(got[i] == Approx(exact[i]).margin(2e-3));
    };
    near("vec4(pow(v.x, v.y), smoothstep(v.x, v.w, v.z), mix(v.x, v.w, v.z), mod(v.w, v.z))",
         {0.5f, 0.198251f, 1.5625f, 0.5f});
    near("vec4(cross(a, b), dot(a, b))", {0.8125f, 0.0625f, -0.3125f, 1.8125f});
    near("vec4(normalize(a), length(b))", {0.267261f, 0.534522f, 0.801784f, 2.150581f});
    near("vec4(mat3(a, b, a) * b, (b * mat3(a, b, a)).y)", {0.875f, 1.4375f, 2.5625f, 4.625f});
}

TEST_CASE(
    "In half floats mediump integers have 16 bits, and textures the precision of their sampler")
{
    if (!canRewriteMediump()) return;
    CHECK(drawHalf("    mediump int i = int(value.x); mediump uint u = uint(value.y);\n"
                   "    highp int whole = int(value.x);\n"
                   "    color = vec4(float(i), float(u), float(whole), 0.0);\n",
                   {40000.0f, 65537.0f}) == std::vector<float>({-25536.0f, 1.0f, 40000.0f, 0.0f}));

    GlFixture gl;
    gl.device = need(makeMediumpDevice(std::move(gl.device), Mediump::half));
    const TextureId source = gl.texture(Format::r32f, {1, 1});
    Image third;
    third.extent = {1, 1};
    third.channels = 1;
    third.pixels = {0.33333334f};
    need(gl.device->writeTexture(source, third));
    const auto sampledAs = [&](const std::string& precision) {
        const TextureId target = gl.texture(Format::r32f, {1, 1});
        const ProgramId program = gl.program("uniform " + precision +
                                             " sampler2D source;\nin vec2 uv;\n"
                                             "layout(location = 0) out float color;\n"
                                             "void main() { color = texture(source, uv).r; }\n");
        const FramebufferId into = gl.framebuffer({target});
        need(gl.device->beginFrame());
        gl.device->beginPass(wholePass(into, {1, 1}));
        gl.device->setProgram(program, {});
        gl.device->setTexture(gl.location(program, "source"), 0, source, {});
        gl.device->drawFullscreen();
        gl.device->endPass();
        need(gl.device->endFrame());
        return gl.read(target).pixels[0];
    };
    CHECK(sampledAs("highp") == 0.33333334f);
    CHECK(sampledAs("mediump") == 0.333251953125f);
    CHECK(sampledAs("lowp") == 0.333251953125f);
}

TEST_CASE("No pass of a shipped config writes what its target's format hides")
{
    GlFixture gl;
    for (const char* name : {"room", "spheres"}) {
        const Scene scene = need(loadScene(name));
        const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
        const double aspect = double(kSize.width) / kSize.height;
        const SceneCamera camera = need(chooseCamera(scene, uploaded.bounds(), "", aspect));
        const Frame frame = makeFrame(uploaded, camera, kSize);
        for (const Subject& subject : subjects()) {
            INFO(name << " " << subject.config << " " << subject.variant);
            CHECK(faults(*gl.device, descriptionOf(subject), frame) == std::vector<std::string>());
        }
    }
}
