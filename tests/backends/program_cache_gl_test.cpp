// SPDX-License-Identifier: MIT
// Programs that a host keeps between runs, on a real driver: they draw the same bits, and what the
// driver refuses is compiled in silence.
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

/// What a run of an application came to.
struct Run {
    Pixels pixels;
    int compiled = 0;  ///< Programs.
};

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
Run draw(const GlDeviceOptions& options, PFNGLPROGRAMBINARYPROC tamper = nullptr)
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
    const auto renderer = stage.make("balanced");
    Run run;
    run.pixels = stage.draw(*renderer);
    run.compiled = gl.compiles() / 2;
    return run;
}

}  // namespace

TEST_CASE("Kept programs draw the same bits, and what the driver refuses is compiled and stored")
{
    const GlFixture fixture;
    GLint formats = 0;
    fixture.gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    if (formats == 0) {
        WARN("this driver has no program binaries: nothing is kept");
        return;
    }
    KeptPrograms kept;
    const Run plain = draw({});
    const Run first = draw(kept.options());
    CHECK(kept.stores == first.compiled);
    for (const auto tamper : {garbled, truncated, ofAnotherFormat}) {
        kept.stores = 0;
        const Run run = draw(kept.options(), tamper);
        CHECK(run.compiled == first.compiled);
        CHECK(kept.stores == first.compiled);
        CHECK((run.pixels == plain.pixels));
    }
    const Run second = draw(kept.options());
    CHECK(second.compiled == 0);
    CHECK((first.pixels == plain.pixels));
    CHECK((second.pixels == plain.pixels));
}
