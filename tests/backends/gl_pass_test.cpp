// SPDX-License-Identifier: MIT
// What the GL device calls at both ends of a pass. No pixel shows it, and on a GPU with tile memory
// each call is a picture that is neither loaded nor stored.
// What contexts say when there are none, without needing one.
// The GL function table, formats and object classes, on functions that are no GL at all.
#include <crevice/context.h>
#include <crevice/gl_device.h>

#include "backends/context/dynamic_library.h"
#include "backends/gl/formats.h"
#include "backends/gl/objects.h"
#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/watched_gl.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace crevice;

namespace {

/// A framebuffer of two colours and depth on a driver that does nothing.
struct Drawn {
    explicit Drawn(int samples = 1)
    {
        gl.logPasses();
        const auto texture = [&](Format format, int count) {
            return need(device->createTexture({"texture", format, {4, 4}, count}));
        };
        FramebufferDesc desc{"framebuffer",
                             {texture(Format::rgba8, samples), texture(Format::rgba8, samples)},
                             texture(Format::depth24, samples)};
        if (samples > 1) {
            desc.resolve_color = {texture(Format::rgba8, 1), texture(Format::rgba8, 1)};
            desc.resolve_depth = texture(Format::depth24, 1);
        }
        pass.framebuffer = need(device->createFramebuffer(desc));
        pass.extent = {4, 4};
        pass.color_count = 2;
        pass.has_depth = true;
        pass.depth_load = LoadOp::load;
        pass.depth_store = StoreOp::store;
    }

    /// The calls of a frame of that pass.
    std::string calls()
    {
        gl.takePassLog();
        need(device->beginFrame());
        device->beginPass(pass);
        device->drawFullscreen();
        device->endPass();
        need(device->endFrame());
        return gl.takePassLog();
    }

    WatchedGl gl;
    std::unique_ptr<Device> device = need(makeGlDevice(gl.loader()));
    PassInfo pass;
};

const char* version = nullptr;

const GLubyte* GL_APIENTRY getString(GLenum) { return reinterpret_cast<const GLubyte*>(version); }

GLenum GL_APIENTRY getError() { return GL_NO_ERROR; }

/// A loader that has every function but `missing`; only glGetString and glGetError may be called.
GlLoader loaderWithout(const std::string& missing)
{
    return [missing](const char* name) -> void* {
        if (missing == name) return nullptr;
        if (std::string("glGetError") == name) return reinterpret_cast<void*>(getError);
        return reinterpret_cast<void*>(getString);
    };
}

std::string refusalOf(const char* gl_version, Code code, const std::string& missing = "")
{
    version = gl_version;
    return onlyError(makeGlDevice(loaderWithout(missing)), code).message;
}

template <class T>
T valueAt(const std::vector<std::uint8_t>& bytes, std::size_t index)
{
    T value;
    REQUIRE(bytes.size() >= (index + 1) * sizeof(T));
    std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
    return value;
}

}  // namespace

TEST_CASE("A pass clears and invalidates what it does not load, and what it does not store")
{
    constexpr LoadOp kLoad = LoadOp::load, kClear = LoadOp::clear, kDrop = LoadOp::discard;
    constexpr StoreOp kStore = StoreOp::store, kLose = StoreOp::discard;
    const struct {
        LoadOp load[3];  ///< Of both colours, and depth.
        StoreOp store[3];
        const char* calls;
    } cases[] = {
        {{kLoad, kLoad, kLoad}, {kStore, kStore, kStore}, "draw"},
        {{kClear, kDrop, kDrop},
         {kStore, kStore, kStore},
         "invalidate color1 depth, clear color0, draw"},
        {{kLoad, kClear, kClear}, {kStore, kStore, kStore}, "clear color1, clear depth, draw"},
        {{kLoad, kLoad, kLoad}, {kStore, kStore, kLose}, "draw, invalidate depth"},
        {{kLoad, kLoad, kLoad}, {kStore, kLose, kLose}, "draw, invalidate color1 depth"},
        {{kLoad, kLoad, kLoad}, {kLose, kLose, kStore}, "draw, invalidate color0 color1"},
    };
    Drawn drawn;
    for (const auto& each : cases) {
        std::copy_n(each.load, 2, drawn.pass.color_load);
        std::copy_n(each.store, 2, drawn.pass.color_store);
        drawn.pass.depth_load = each.load[2];
        drawn.pass.depth_store = each.store[2];
        CHECK(drawn.calls() == each.calls);
    }
}

TEST_CASE("Of several samples a pixel nothing is stored but what they resolve to")
{
    CHECK(Drawn(4).calls() == "draw, invalidate color0 color1 depth");
}

TEST_CASE("a backend that does not exist is refused with the nearest name")
{
    const Diagnostic error = onlyError(makeContext("elg"), Code::no_backend);
    for (const char* name : {"egl", "osmesa"}) CHECK(has(error.help, name));
}

TEST_CASE("a library that is missing is an error with every name tried and a way out")
{
    const auto library = openLibrary({"libno_such_1.so", "libno_such_2.so"}, Code::no_egl, "help");
    const Diagnostic error = onlyError(library, Code::no_egl);
    CHECK(error.help == "help");
    REQUIRE(error.notes.size() == 2);
    CHECK(has(error.notes[0].text, "libno_such_1.so"));
    CHECK(has(error.notes[1].text, "libno_such_2.so"));
}

TEST_CASE("the first library of a list that exists is opened")
{
    const auto library = need(openLibrary({"libno_such_1.so", "libc.so.6"}, Code::no_egl, "help"));
    CHECK(findSymbol(library, "strlen"));
    CHECK_FALSE(findSymbol(library, "no_such_function"));
}

TEST_CASE("ids that were freed are given out again, and a new one is found at once")
{
    GlPool<int> pool;
    for (std::uint32_t id = 1; id <= 200000; ++id)
        REQUIRE(pool.add(0) == id);  // not in squared time
    pool.retire(7);
    pool.retire(7);
    CHECK(pool.find(7) == nullptr);
    CHECK(pool.add(42) == 7);
    CHECK(pool.at(7) == 42);
    CHECK(pool.add(0) == 200001);
}

TEST_CASE("a context that lacks a function is refused by the function's name")
{
    CHECK(has(refusalOf("OpenGL ES 3.0", Code::gl_function, "glTexStorage2D"), "glTexStorage2D"));
}

TEST_CASE("a loader is made of a window system's function as it is, whatever pointers that gives")
{
    using Function = void (*)();
    struct Found {
        static void* asData(const char*) { return reinterpret_cast<void*>(getString); }
        static Function asFunction(const char*) { return reinterpret_cast<Function>(getString); }
        static int (*asOther(const char* name))()
        {
            return reinterpret_cast<int (*)()>(asFunction(name));
        }
    };
    const std::function<void*(const char*)> wrapped = Found::asData;
    const GlLoader loaders[] = {Found::asData, Found::asFunction, Found::asOther, wrapped,
                                [](const char* name) { return Found::asFunction(name); }};
    for (const GlLoader& load : loaders) {
        REQUIRE(load);
        CHECK(load("glGetString") == reinterpret_cast<void*>(getString));
    }
    Function (*const none)(const char*) = nullptr;
    for (const GlLoader& load : {GlLoader(), GlLoader(none), GlLoader(decltype(wrapped)())}) {
        CHECK_FALSE(load);
        CHECK(makeGlDevice(load).diagnostics()[0].code == Code::gl_function);
    }
}

TEST_CASE("a loader that finds nothing is told that no context is current")
{
    const Result<GlApi> gl = loadGlApi([](const char*) -> void* { return nullptr; });
    CHECK(has(onlyError(gl, Code::gl_version).message, "no GL context is current"));
}

TEST_CASE("a context that is too old, or not there, is refused")
{
    const char* const old = "OpenGL ES 2.0 of a phone";
    CHECK(has(refusalOf(old, Code::gl_version), old));
    for (const char* other : {"2.1 Mesa", "", static_cast<const char*>(nullptr)})
        refusalOf(other, Code::gl_version);
}

TEST_CASE("pixels are clamped and rounded to normalised formats")
{
    Image image({4, 1}, 1);
    image.pixels = {-1.0f, 0.5f, 2.0f, NAN};
    CHECK(packPixels(image, Format::r8) == std::vector<std::uint8_t>{0, 128, 255, 0});
    const auto depth = packPixels(image, Format::depth24);
    CHECK(valueAt<std::uint32_t>(depth, 0) == 0);
    CHECK(valueAt<std::uint32_t>(depth, 1) >> 8 == 0x800000);
    CHECK(valueAt<std::uint32_t>(depth, 2) == 0xFFFFFFFF);
    CHECK(valueAt<std::uint16_t>(packPixels(image, Format::depth16), 1) == 32768);
}

TEST_CASE("pixels gain and lose channels on the way to a format")
{
    Image image({1, 1}, 2);
    image.pixels = {1.0f, 0.0f};
    CHECK(packPixels(image, Format::rgba8) == std::vector<std::uint8_t>{255, 0, 0, 255});
    CHECK(packPixels(image, Format::r8) == std::vector<std::uint8_t>{255});
    CHECK(valueAt<std::uint32_t>(packPixels(image, Format::rgb10_a2), 0) == 0xC00003FF);
    CHECK(valueAt<float>(packPixels(image, Format::rgba32f), 3) == 1.0f);
}
