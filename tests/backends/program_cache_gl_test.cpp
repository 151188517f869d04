// SPDX-License-Identifier: MIT
// Programs that a host keeps between runs, on a real driver: they draw the same bits, and what the
// driver refuses is compiled in silence.
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/watched_gl.h"

#include <tuple>

using namespace crevice;

namespace {

constexpr int kOwn = 2;  // programs of the device itself

/// What a run of an application came to.
struct Run {
    Pixels pixels;
    int programs = 0;  ///< That it needs, the device's own among them.
    int compiled = 0;  ///< Of them.
};

/// Whether the driver gives program binaries at all; says so where it does not.
bool hasBinaries(const GlApi& gl)
{
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
    if (count == 0) WARN("this driver has no program binaries: nothing is kept");
    return count > 0;
}

PFNGLPROGRAMBINARYPROC program_binary = nullptr;

void GL_APIENTRY garbled(GLuint program, GLenum format, const void*, GLsizei length)
{
    const std::vector<unsigned char> bytes(length, 0x5a);
    program_binary(program, format, bytes.data(), length);
}

void GL_APIENTRY truncated(GLuint program, GLenum format, const void* binary, GLsizei length)
{
    program_binary(program, format, binary, length / 2);
}

void GL_APIENTRY ofAnotherFormat(GLuint program, GLenum format, const void* binary, GLsizei length)
{
    program_binary(program, format + 1, binary, length);
}

/// Draws a frame on a device of its own. `tamper` takes the place of glProgramBinary.
Run draw(const Description& description, const GlDeviceOptions& options,
         PFNGLPROGRAMBINARYPROC tamper = nullptr)
{
    WatchedGl gl(testContext().loader());
    const GlLoader all = gl.loader();
    program_binary = reinterpret_cast<PFNGLPROGRAMBINARYPROC>(all("glProgramBinary"));
    const auto device = need(makeGlDevice(
        [&](const char* name) {
            const bool tampered = tamper && std::string(name) == "glProgramBinary";
            return tampered ? reinterpret_cast<void*>(tamper) : all(name);
        },
        options));
    const Stage stage(*device);
    const auto renderer = stage.make(description);
    Run run;
    run.pixels = stage.draw(*renderer);
    run.programs = static_cast<int>(renderer->plan().programs.size()) + kOwn;
    run.compiled = gl.compiles() / 2;
    return run;
}

}  // namespace

TEST_CASE("Shipped configs compile nothing over kept programs, and draw the same bits")
{
    GlFixture fixture;
    const bool binaries = hasBinaries(fixture.gl);
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config);
        const Description description = descriptionOf(subject);
        KeptPrograms kept;
        const Run plain = draw(description, {});
        const Run first = draw(description, kept.options());
        CHECK(first.compiled >= first.programs);  // those of other levels too
        CHECK(kept.stores == (binaries ? first.compiled : 0));
        CHECK(kept.entries.size() == static_cast<std::size_t>(kept.stores));
        const Run second = draw(description, kept.options());
        CHECK(second.compiled == (binaries ? 0 : first.compiled));
        CHECK(kept.stores == (binaries ? first.compiled : 0));
        CHECK((first.pixels == plain.pixels));
        CHECK((second.pixels == plain.pixels));
    }
}

TEST_CASE("What the driver refuses is compiled, draws the same bits, and is stored again")
{
    GlFixture fixture;
    if (!hasBinaries(fixture.gl)) return;
    const Description description = descriptionOf({"balanced"});
    KeptPrograms kept;
    const Run first = draw(description, kept.options());
    for (const auto tamper : {garbled, truncated, ofAnotherFormat}) {
        kept.stores = 0;
        const Run run = draw(description, kept.options(), tamper);
        CHECK(run.compiled == run.programs);
        CHECK(kept.stores == run.programs);
        CHECK((run.pixels == first.pixels));
    }
    CHECK(draw(description, kept.options()).compiled == 0);
}

TEST_CASE("A kept program has the uniforms that it had")
{
    KeptPrograms kept;
    const char* const body =
        "uniform mat4 matrices[2];\n"
        "uniform vec3 kernel[5];\n"
        "uniform int count;\n"
        "uniform highp sampler2D depth;\n"
        "uniform float unused;\n"
        "in vec2 uv;\nout vec4 color;\n"
        "void main() { color = matrices[1] * matrices[0] * texture(depth, uv);\n"
        "    for (int i = 0; i < count; ++i) color.xyz += kernel[i]; }\n";
    using Uniform = std::tuple<std::string, GlslType, int>;
    std::vector<Uniform> uniforms[2];
    for (std::vector<Uniform>& list : uniforms) {
        GlFixture gl(kept.options());
        for (const UniformInfo& each : gl.device->uniforms(gl.program(body))) {
            list.push_back({each.name, each.type, each.count});
            CHECK(each.location >= 0);
        }
    }
    CHECK(uniforms[0].size() == 4);
    CHECK((uniforms[0] == uniforms[1]));
}

TEST_CASE("A shader that is wrong is reported as without kept programs, and never kept")
{
    const auto errors = [](const GlDeviceOptions& options, const std::string& body) {
        GlFixture gl(options);
        const auto made =
            gl.device->createProgram({"bad", stage(kFullscreenVertex), stage(fragment(body))});
        return toText(made.diagnostics());
    };
    for (const char* body :
         {"void main() { nonsense; }\n", "in vec3 uv;\nout vec3 c;\nvoid main() { c = uv; }\n"}) {
        const std::string plain = errors({}, body);
        CHECK(plain.find("error CV500") != std::string::npos);
        KeptPrograms kept;
        for (int run = 0; run < 2; ++run) CHECK(errors(kept.options(), body) == plain);
        CHECK((kept.stores == 0 || kept.stores == kOwn));
    }
}
