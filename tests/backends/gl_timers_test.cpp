// SPDX-License-Identifier: MIT
// The GL device's timers, on functions that are no GL at all: a GPU that can be disturbed.
#include "backends/gl/timers.h"
#include "tests/support/catch.h"

#include <map>

namespace crevice {

namespace {

/// What the functions below see and do.
struct Gpu {
    GLint counter_bits = 64;
    bool disjoint = false;
    int disjoint_questions = 0;
    GLuint made = 0;
    int deleted = 0;
    bool behind = false;  // no result is in yet
    GLuint running = 0;
    GLuint64 next_ns = 0;
    std::map<GLuint, GLuint64> results_ns;
};
Gpu gpu;

void GL_APIENTRY genQueries(GLsizei, GLuint* names) { *names = ++gpu.made; }
void GL_APIENTRY deleteQueries(GLsizei count, const GLuint*) { gpu.deleted += count; }
void GL_APIENTRY beginQuery(GLenum target, GLuint name)
{
    CHECK(target == GL_TIME_ELAPSED_EXT);
    CHECK(gpu.running == 0);
    gpu.running = name;
}
void GL_APIENTRY endQuery(GLenum)
{
    gpu.results_ns[gpu.running] = gpu.next_ns;
    gpu.running = 0;
}
void GL_APIENTRY getQueryiv(GLenum, GLenum, GLint* bits) { *bits = gpu.counter_bits; }
void GL_APIENTRY getQueryObject(GLuint name, GLenum, GLuint64* result)
{
    *result = gpu.results_ns.at(name);
}
void GL_APIENTRY getReady(GLuint, GLenum name, GLuint* ready)
{
    CHECK(name == GL_QUERY_RESULT_AVAILABLE);
    *ready = gpu.behind ? GL_FALSE : GL_TRUE;
}
void GL_APIENTRY getIntegerv(GLenum name, GLint* value)
{
    CHECK(name == GL_GPU_DISJOINT_EXT);
    ++gpu.disjoint_questions;
    *value = std::exchange(gpu.disjoint, false);
}

GlApi makeApi()
{
    GlApi gl;
    gl.GenQueries = genQueries;
    gl.DeleteQueries = deleteQueries;
    gl.BeginQuery = beginQuery;
    gl.EndQuery = endQuery;
    gl.GetQueryiv = getQueryiv;
    gl.GetQueryObjectui64v = getQueryObject;
    gl.GetQueryObjectuiv = getReady;
    gl.GetIntegerv = getIntegerv;
    return gl;
}

/// A fresh GPU with timers on it.
struct Bench {
    explicit Bench(const GlInfo& info = {}, GLint counter_bits = 64)
    {
        gpu = Gpu();
        gpu.counter_bits = counter_bits;
        timers = GlTimers::make(gl, info);
    }

    void measure(int slot, GLuint64 nanoseconds)
    {
        gpu.next_ns = nanoseconds;
        REQUIRE(timers.begin(gl, slot));
        timers.end(gl);
    }

    double read(int slot) { return timers.read(gl, slot); }

    GlApi gl = makeApi();
    GlTimers timers;
};

GlInfo contextInfo(bool desktop, int version, std::vector<std::string> extensions)
{
    GlInfo info;
    info.desktop = desktop;
    info.native_version = version;
    info.version = 300;
    info.extensions = std::move(extensions);
    return info;
}

/// The name under which such a function of the context's timers is found; empty for none.
std::string timerFunction(const GlInfo& info, const std::string& function = "glGetQueryObjectui64v")
{
    std::string found;
    GlApi gl;
    settleOptional(gl, info, [&](const char* name) {
        if (std::string(name).rfind(function, 0) == 0) found = name;
        return reinterpret_cast<void*>(genQueries);
    });
    CHECK((gl.GetQueryObjectui64v != nullptr) == !found.empty());
    CHECK((gl.BeginQuery != nullptr) == !found.empty());
    return found;
}

}  // namespace

TEST_CASE("GL timers give milliseconds, each slot its own")
{
    Bench bench;
    bench.measure(0, 1500000);
    bench.measure(kMaxTimers - 1, 250);
    CHECK(bench.read(0) == Approx(1.5));
    CHECK(bench.read(kMaxTimers - 1) == Approx(0.00025));
    CHECK(bench.read(0) == Approx(1.5));
    CHECK(bench.read(1) < 0);
}

TEST_CASE("A disturbed GPU makes every result since the last reading void")
{
    Bench bench;
    bench.measure(0, 1000);
    bench.measure(1, 2000);
    gpu.disjoint = true;
    CHECK(bench.read(0) < 0);
    CHECK(bench.read(1) < 0);  // though asking for the flag has reset it
    bench.measure(0, 3000);
    CHECK(bench.read(0) == Approx(0.003));
    CHECK(bench.read(1) < 0);  // measured before; forgotten
}

TEST_CASE("What disturbed the GPU before the first timer does not count")
{
    Bench bench;
    gpu.disjoint = true;
    bench.measure(0, 1000);
    CHECK(bench.read(0) == Approx(0.001));
}

TEST_CASE("A context without timers, or with a clock of no bits, refuses")
{
    Bench none({}, 0);
    CHECK_FALSE(none.timers.begin(none.gl, 0));
    CHECK(none.read(0) < 0);
    CHECK(gpu.made == 0);

    GlApi gl;
    GlTimers timers = GlTimers::make(gl, {});
    CHECK_FALSE(timers.begin(gl, 0));
    CHECK(timers.read(gl, 0) < 0);
}

TEST_CASE("Desktop GL, which has no such flag, is not asked whether it was disturbed")
{
    GlInfo desktop;
    desktop.desktop = true;
    Bench bench(desktop);
    bench.measure(0, 1000);
    CHECK(bench.read(0) == Approx(0.001));
    CHECK(gpu.disjoint_questions == 0);
}

TEST_CASE("Queries are made once, when there is first something to measure, and deleted once")
{
    {
        Bench bench;
        CHECK(bench.timers.exist());
        CHECK(bench.read(0) < 0);
        CHECK(gpu.made == 0);
        for (int i = 0; i < 3; ++i) bench.measure(i, 1);
        const GlTimers moved = std::move(bench.timers);
        CHECK(gpu.made == kMaxTimers);
        CHECK(gpu.deleted == 0);
    }
    CHECK(gpu.deleted == kMaxTimers);
}

TEST_CASE("In WebGL, where waiting brings no result, one that is not in yet is void")
{
    GlInfo web;
    web.web = true;
    Bench bench(web);
    bench.measure(0, 1000);
    bench.measure(1, 2000);
    CHECK(bench.read(0) == Approx(0.001));
    gpu.behind = true;
    CHECK_FALSE(bench.timers.isReady(bench.gl, 1));
    CHECK(bench.read(1) < 0);
    Bench native;
    gpu.behind = true;
    native.measure(0, 1000);
    CHECK(native.read(0) == Approx(0.001));
}

TEST_CASE("Timer functions are taken where the context promises them, under the name it has")
{
    const std::vector<std::string> es = {"GL_EXT_disjoint_timer_query"};
    CHECK(timerFunction(contextInfo(false, 320, es)) == "glGetQueryObjectui64vEXT");
    CHECK(timerFunction(contextInfo(false, 320, {})).empty());
    CHECK(timerFunction(contextInfo(true, 450, {})) == "glGetQueryObjectui64v");
    CHECK(timerFunction(contextInfo(true, 320, {"GL_ARB_timer_query"})) == "glGetQueryObjectui64v");
    CHECK(timerFunction(contextInfo(true, 320, {})).empty());
    GlInfo web = contextInfo(false, 300, es);  // of WebGL 1, whose queries WebGL 2 does not take
    web.web = true;
    CHECK(timerFunction(web).empty());
    web.extensions = {"GL_EXT_disjoint_timer_query_webgl2"};
    CHECK(timerFunction(web) == "glGetQueryObjectui64vEXT");
    CHECK(timerFunction(web, "glBeginQuery") == "glBeginQuery");
    GlInfo bare = contextInfo(true, 450, {});
    bare.bare = true;
    CHECK(timerFunction(bare).empty());
}

}  // namespace crevice
