// SPDX-License-Identifier: MIT
// The GL device's timers, on functions that are no GL at all: a GPU that can be disturbed.
#include "backends/gl/timers.h"
#include "tests/support/catch.h"

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

    void measure(GlTimer& timer, GLuint64 nanoseconds)
    {
        gpu.next_ns = nanoseconds;
        timers.begin(gl, timer);
        timers.end(gl);
    }

    double read(const GlTimer& timer) { return timers.read(gl, timer); }

    GlApi gl = makeApi();
    GlTimers timers;
    GlTimer one, two, idle;
};

}  // namespace

TEST_CASE("A disturbed GPU makes every result since the last reading void, and none before")
{
    Bench bench;
    gpu.disjoint = true;  // before the first timer
    bench.measure(bench.one, 1500000);
    bench.measure(bench.two, 250);
    CHECK(bench.read(bench.one) == Approx(1.5));
    CHECK(bench.read(bench.two) == Approx(0.00025));
    CHECK(bench.read(bench.idle) < 0);
    gpu.disjoint = true;
    CHECK(bench.read(bench.one) < 0);
    CHECK(bench.read(bench.two) < 0);  // though asking for the flag has reset it
    gpu.disjoint = true;
    bench.measure(bench.one, 3000);
    CHECK(bench.read(bench.one) == Approx(0.003));
    CHECK(bench.read(bench.two) < 0);  // measured before; forgotten
}

TEST_CASE("A context without timers, or with a clock of no bits, has none")
{
    CHECK(Bench().timers.exist());
    CHECK_FALSE(Bench({}, 0).timers.exist());
    CHECK_FALSE(GlTimers::make({}, {}).exist());
}

TEST_CASE("A timer's query is made once, when it is first to measure, and deleted once")
{
    {
        GlInfo desktop;  // which has no flag of a disturbance to ask for
        desktop.desktop = true;
        Bench bench(desktop);
        CHECK(bench.read(bench.one) < 0);
        CHECK(gpu.made == 0);
        for (GlTimer* each : {&bench.one, &bench.two, &bench.one}) bench.measure(*each, 1000);
        CHECK(bench.read(bench.one) == Approx(0.001));
        CHECK(gpu.disjoint_questions == 0);
        const GlTimer moved = std::move(bench.one);
        CHECK(bench.read(moved) == Approx(0.001));
        CHECK(gpu.made == 2);
        CHECK(gpu.deleted == 0);
    }
    CHECK(gpu.deleted == 2);
}

TEST_CASE("In WebGL, where waiting brings no result, one that is not in yet is void")
{
    for (const bool web : {false, true}) {
        GlInfo info;
        info.web = web;
        Bench bench(info);
        bench.measure(bench.one, 1000);
        gpu.behind = true;
        CHECK((bench.read(bench.one) < 0) == web);
    }
}

TEST_CASE("Timer functions are taken where the context promises them, under the name it has")
{
    struct Case {
        bool desktop, web;
        int version;
        const char* extension;
        const char* found;  ///< The name that results are read by; empty for none.
    };
    constexpr const char* kEs = "GL_EXT_disjoint_timer_query";
    constexpr const char* kWeb = "GL_EXT_disjoint_timer_query_webgl2";
    constexpr Case kCases[] = {
        {false, false, 320, kEs, "glGetQueryObjectui64vEXT"},
        {false, false, 320, "", ""},
        {true, false, 450, "", "glGetQueryObjectui64v"},
        {true, false, 320, "GL_ARB_timer_query", "glGetQueryObjectui64v"},
        {true, false, 320, "", ""},
        {false, true, 300, kEs, ""},  // of WebGL 1, whose queries WebGL 2 does not take
        {false, true, 300, kWeb, "glGetQueryObjectui64vEXT"},
    };
    for (const Case& each : kCases) {
        INFO(each.version << " " << each.extension);
        GlInfo info;
        info.desktop = each.desktop;
        info.web = each.web;
        info.native_version = each.version;
        info.version = 300;
        info.extensions = {each.extension};
        std::string found;
        GlApi gl;
        settleOptional(gl, info, [&](const char* name) {
            if (std::string(name).rfind("glGetQueryObjectui64v", 0) == 0) found = name;
            return reinterpret_cast<void*>(genQueries);
        });
        CHECK(found == each.found);
        CHECK((gl.BeginQuery != nullptr) == !found.empty());
    }
}

}  // namespace crevice
