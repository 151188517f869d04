// SPDX-License-Identifier: MIT
// Several effects in a context, contexts that share, and threads with a context each: all draw what
// an effect draws alone.
#include <crevice/effect.h>

#include "tests/support/gl_fixture.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <dlfcn.h>

#include <atomic>
#include <thread>

using namespace crevice;

namespace {

/// Displays, configs and contexts: no header of EGL or OSMesa is needed, which may be missing.
using Handle = void*;

/// A function of the backend's library, which is loaded already.
template <class Function>
Function* find(const char* name)
{
    const char* const library = testBackend() == "osmesa" ? "libOSMesa.so.8" : "libEGL.so.1";
    return reinterpret_cast<Function*>(dlsym(dlopen(library, RTLD_LAZY), name));
}

/// A context of the host's own that shares textures with the one that is current.
class SharedContext {
public:
    SharedContext()
    {
        osmesa_ ? makeOsmesa() : makeEgl();
        REQUIRE(handle_);
    }
    ~SharedContext()
    {
        if (osmesa_)
            find<void(Handle)>("OSMesaDestroyContext")(handle_);
        else
            find<unsigned(Handle, Handle)>("eglDestroyContext")(display_, handle_);
    }

    /// Makes it current on this thread; false where that fails.
    bool makeCurrent()
    {
        constexpr unsigned kUnsignedByte = 0x1401;
        if (osmesa_)
            return find<unsigned char(Handle, void*, unsigned, int, int)>("OSMesaMakeCurrent")(
                       handle_, pixel_, kUnsignedByte, 1, 1) == 1;
        return find<unsigned(Handle, Handle, Handle, Handle)>("eglMakeCurrent")(
                   display_, nullptr, nullptr, handle_) == 1;
    }

private:
    void makeEgl()
    {
        constexpr int kNone = 0x3038, kConfigId = 0x3028, kMajorVersion = 0x3098;
        display_ = find<Handle()>("eglGetCurrentDisplay")();
        const Handle other = find<Handle()>("eglGetCurrentContext")();
        int config_id = 0, count = 0;
        find<unsigned(Handle, Handle, int, int*)>("eglQueryContext")(display_, other, kConfigId,
                                                                     &config_id);
        const int wanted[] = {kConfigId, config_id, kNone};
        Handle config = nullptr;
        find<unsigned(Handle, const int*, Handle*, int, int*)>("eglChooseConfig")(
            display_, wanted, &config, 1, &count);
        const int attributes[] = {kMajorVersion, 3, kNone};
        handle_ = find<Handle(Handle, Handle, Handle, const int*)>("eglCreateContext")(
            display_, config, other, attributes);
    }

    void makeOsmesa()
    {
        constexpr int kFormat = 0x22, kRgba = 0x1908, kProfile = 0x33, kCore = 0x34;
        constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37;
        const int attributes[] = {kFormat, kRgba,         kProfile, kCore, kMajorVersion,
                                  4,       kMinorVersion, 5,        0};
        handle_ = find<Handle(const int*, Handle)>("OSMesaCreateContextAttribs")(
            attributes, find<Handle()>("OSMesaGetCurrentContext")());
    }

    const bool osmesa_ = testBackend() == "osmesa";
    Handle display_ = nullptr, handle_ = nullptr;
    unsigned char pixel_[4] = {};  // OSMesa wants a framebuffer
};

constexpr Extent kExtent = {64, 36};
constexpr int kFrames = 3;

const char* const kGtao = R"({ "format": 1, "name": "ao",
    "extends": ["geometry/host_depth", "ssao/gtao", "filter/bilateral_normal"] })";
const char* const kMobile = R"({ "format": 1, "name": "ao",
    "extends": ["mobile", "geometry/host_depth"] })";
const char* const kBalanced = R"({ "format": 1, "name": "ao",
    "extends": ["balanced", "geometry/host_depth"] })";

using Pixels = std::vector<float>;

/// Steps of depth, each `wide` pixels.
GLuint makeDepth(const GlApi& gl, int wide)
{
    Pixels steps;
    for (int i = 0; i < kExtent.width * kExtent.height; ++i)
        steps.push_back(0.95f + 0.005f * static_cast<float>(i / wide % 5));
    const GLuint name = depthTexture(gl, kExtent, steps);
    gl.Finish();  // before another context reads it
    return name;
}

Result<Effect> makeEffect(Device& device, const char* config, GLuint depth)
{
    Result<Effect> effect = Effect::create(device, config, kExtent, {"ao"});
    if (!effect) return effect;
    const auto projection = glm::perspective(glm::radians(60.0f), 16.0f / 9.0f, 0.1f, 100.0f);
    effect->setProjection(glm::value_ptr(projection));
    Status set = effect->setTexture("depth", depth, Format::depth32f, kExtent);
    if (set) set = effect->setParam("radius", 1);
    return set ? std::move(effect) : set.diagnostics();
}

Result<Pixels> draw(Device& device, Effect& effect)
{
    if (Status status = effect.render(); !status) return status.diagnostics();
    Result<Image> image = device.readTexture(effect.output("ao"));
    if (!image) return image.diagnostics();
    return image->pixels;
}

/// All frames of an effect of its own in the context that is current; Catch is for one thread.
Result<Pixels> drawFrames(Device& device, const char* config, GLuint depth)
{
    Result<Effect> effect = makeEffect(device, config, depth);
    if (!effect) return effect.diagnostics();
    Pixels all;
    for (int frame = 0; frame < kFrames; ++frame) {
        const Result<Pixels> pixels = draw(device, *effect);
        if (!pixels) return pixels;
        all.insert(all.end(), pixels->begin(), pixels->end());
    }
    return all;
}

/// The same in a context of this thread's own, of a depth of that width.
Result<Pixels> drawInOwnContext(const char* config, int wide)
{
    const auto context = makeContext(testBackend());
    if (!context) return context.diagnostics();
    const Result<GlApi> gl = loadGlApi((*context)->loader());
    if (!gl) return gl.diagnostics();
    const auto device = makeGlDevice((*context)->loader());
    if (!device) return device.diagnostics();
    return drawFrames(**device, config, makeDepth(*gl, wide));
}

/// A picture that an effect draws alone; it is neither white nor black.
Pixels alone(const char* config, int wide)
{
    GlFixture host;
    GLuint depth = makeDepth(host.gl, wide);
    Effect effect = need(makeEffect(*host.device, config, depth));
    Pixels pixels = need(draw(*host.device, effect));
    host.gl.DeleteTextures(1, &depth);
    CHECK(*std::min_element(pixels.begin(), pixels.end()) < 0.9f);
    CHECK(*std::max_element(pixels.begin(), pixels.end()) > 0.5f);
    return pixels;
}

/// A frame of each in turns, then the second without the first.
void takeTurns(Device& first_device, Device& second_device, const GlApi& gl)
{
    GLuint depths[] = {makeDepth(gl, 8), makeDepth(gl, 5)};
    const Pixels first_alone = alone(kGtao, 8), second_alone = alone(kMobile, 5);
    Effect second = need(makeEffect(second_device, kMobile, depths[1]));
    {
        Effect first = need(makeEffect(first_device, kGtao, depths[0]));
        for (int frame = 0; frame < kFrames; ++frame) {
            CHECK((need(draw(first_device, first)) == first_alone));
            CHECK((need(draw(second_device, second)) == second_alone));
        }
    }
    CHECK((need(draw(second_device, second)) == second_alone));
    gl.DeleteTextures(2, depths);
}

/// Runs `call(i)` in that many threads, which all begin at once, and waits for them.
template <class Call>
void inThreads(int count, const Call& call)
{
    std::atomic<int> waiting{count};
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i)
        threads.emplace_back([&, i] {
            for (--waiting; waiting > 0;) std::this_thread::yield();
            call(i);
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace

TEST_CASE("Two effects of one device draw in turns what each draws alone")
{
    GlFixture host;
    takeTurns(*host.device, *host.device, host.gl);
}

TEST_CASE("Two effects of two devices in one context draw in turns what each draws alone")
{
    GlFixture host, other;
    takeTurns(*host.device, *other.device, host.gl);
}

TEST_CASE("Effects in two contexts that share textures draw one depth, and each reads the other's")
{
    const Pixels wanted = alone(kGtao, 8);
    GlFixture host;
    GLuint depth = makeDepth(host.gl, 8);
    SharedContext shared;
    Effect first = need(makeEffect(*host.device, kGtao, depth));
    REQUIRE(shared.makeCurrent());
    auto other = need(makeGlDevice(testContext().loader()));
    {
        Effect second = need(makeEffect(*other, kGtao, depth));
        for (int frame = 0; frame < kFrames; ++frame) {
            need(testContext().makeCurrent());
            CHECK((need(draw(*host.device, first)) == wanted));
            REQUIRE(shared.makeCurrent());
            CHECK((need(draw(*other, second)) == wanted));
        }
        HostTexture ao;
        ao.name = first.nativeName("ao");
        ao.format = Format::r8;
        ao.extent = kExtent;
        const TextureId adopted = need(other->adoptTexture(ao));
        CHECK((need(other->readTexture(adopted)).pixels == wanted));
        other->destroy(adopted);
    }
    other.reset();
    need(testContext().makeCurrent());
    CHECK((need(draw(*host.device, first)) == wanted));
    host.gl.DeleteTextures(1, &depth);
}

TEST_CASE("Two threads, each with one of two contexts that share, draw one depth at once")
{
    const Pixels wanted = alone(kBalanced, 8);
    GlFixture host;
    GLuint depth = makeDepth(host.gl, 8);
    SharedContext shared;
    Result<Pixels> theirs = Pixels();
    std::thread thread([&] {
        if (!shared.makeCurrent()) return;
        const auto device = makeGlDevice(testContext().loader());
        theirs = device ? drawFrames(**device, kBalanced, depth) : device.diagnostics();
    });
    const Result<Pixels> ours = drawFrames(*host.device, kBalanced, depth);
    thread.join();
    host.gl.DeleteTextures(1, &depth);
    CHECK((need(ours) == need(theirs)));
    CHECK((need(ours).size() == kFrames * wanted.size()));
    CHECK(std::equal(wanted.begin(), wanted.end(), ours->begin()));
}

TEST_CASE("Threads, each with a context and effects of its own, draw what one thread draws")
{
    constexpr int kThreads = 6;
    constexpr const char* kConfigs[] = {kGtao, kMobile, kBalanced};
    const auto work = [&](int i) { return drawInOwnContext(kConfigs[i % 3], 5 + i); };
    std::vector<Result<Pixels>> at_once(kThreads, Pixels()), one_by_one;
    inThreads(kThreads, [&](int i) { at_once[i] = work(i); });
    for (int i = 0; i < kThreads; ++i) one_by_one.push_back(work(i));
    need(testContext().makeCurrent());
    for (int i = 0; i < kThreads; ++i) {
        INFO("thread " << i);
        const Pixels pixels = need(at_once[i]);
        CHECK((pixels == need(one_by_one[i])));
        CHECK(pixels.size() == std::size_t{kFrames} * kExtent.width * kExtent.height);
        CHECK(*std::min_element(pixels.begin(), pixels.end()) < 0.9f);
    }
}
