// SPDX-License-Identifier: MIT
// Hosts in random states live with crevice from first to last: after each step they find their
// state as it was, and they get the pictures of a fresh context. CREVICE_HOST_STATES is how many,
// and has the figures told; CREVICE_FIRST_HOST_STATE picks the first.
#include "tests/backends/host/states/host_life.h"

#include <cstdlib>
#include <map>

namespace crevice {

namespace {

int numberOf(const char* variable, int otherwise)
{
    const char* const text = std::getenv(variable);
    return text ? std::atoi(text) : otherwise;
}

/// By kind, each from a fresh context when it is first asked for.
class FreshPictures {
public:
    const std::vector<Image>& operator[](int kind)
    {
        if (std::vector<Image>& found = by_kind_[kind]; !found.empty()) return found;
        const auto fresh = need(makeContext(testBackend()));
        HostLife life(*fresh);
        return by_kind_[kind] = life.live(kind, [](const char*) {});
    }

private:
    std::map<int, std::vector<Image>> by_kind_;
};

struct Figures {
    std::size_t values = 0, changes = 0, pictures = 0, different = 0;
};

void compareState(RandomHost& host, const Snapshot& before, const char* step, Figures& figures)
{
    INFO("after " << step);
    const Snapshot after = host.snapshot();
    const std::string told = difference(before, after);
    CHECK(told == "");
    figures.values += after.size();
    figures.changes += told.empty() ? 0 : 1;
}

void comparePictures(const std::vector<Image>& got, const std::vector<Image>& wanted,
                     Figures& figures)
{
    REQUIRE(got.size() == wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        INFO("picture " << i);
        const bool same = got[i].pixels == wanted[i].pixels;
        CHECK(same);
        figures.different += same ? 0 : 1;
    }
    figures.pictures += got.size();
}

/// What was once not kept, or changed a picture.
struct Strange {
    const char* name;
    void (*set)(const GlCalls& gl);
};

constexpr Strange kStrange[] = {
    {"a second viewport",
     [](const GlCalls& gl) {
         gl("glViewportIndexedf", GLuint(1), 0.5f, 0.25f, 3.0f, 2.0f);
         gl("glScissorIndexed", GLuint(1), GLint(1), GLint(1), GLsizei(2), GLsizei(2));
         gl("glDepthRangeIndexed", GLuint(1), 0.25, 0.75);
     }},
    {"a viewport of fractions",
     [](const GlCalls& gl) { gl("glViewportIndexedf", GLuint(0), 0.5f, 0.25f, 3.5f, 2.5f); }},
    {"the scissor test of a second viewport",
     [](const GlCalls& gl) { gl("glEnablei", GLenum(GL_SCISSOR_TEST), GLuint(1)); }},
    {"rows read from the top, of Mesa",
     [](const GlCalls& gl) { gl("glPixelStorei", GLenum(0x8758), GLint(1)); }},
    {"rows read from the top, of ANGLE",
     [](const GlCalls& gl) { gl("glPixelStorei", GLenum(0x93A4), GLint(1)); }},
    {"shading of samples",
     [](const GlCalls& gl) {
         gl("glEnable", GLenum(GL_SAMPLE_SHADING));
         gl("glMinSampleShading", 1.0f);
     }},
    {"depth clamp", [](const GlCalls& gl) { gl("glEnable", GLenum(GL_DEPTH_CLAMP_EXT)); }},
    {"sRGB framebuffers", [](const GlCalls& gl) { gl("glEnable", GLenum(0x8DB9)); }},
    {"no sRGB framebuffers", [](const GlCalls& gl) { gl("glDisable", GLenum(0x8DB9)); }},
    {"an offset of points",
     [](const GlCalls& gl) {
         gl("glEnable", GLenum(0x2A01));
         gl("glPolygonOffset", 2.0f, 2.0f);
     }},
    {"an offset of lines",
     [](const GlCalls& gl) {
         gl("glEnable", GLenum(0x2A02));
         gl("glPolygonOffset", 2.0f, 2.0f);
     }},
    {"colours clamped", [](const GlCalls& gl) { gl("glClampColor", GLenum(0x891B), GLenum(1)); }},
    {"red halved on its way",
     [](const GlCalls& gl) { gl("glPixelTransferf", GLenum(0x0D14), 0.5f); }},
};

constexpr int kDrawn = 1;  // a kind that draws the scene, into several samples too
constexpr std::uint32_t kSeeds = 6;

/// A loader that knows nothing of several draw buffers or viewports.
GlLoader withoutIndices(const GlLoader& load)
{
    return [load](const char* name) -> void* {
        const std::string text = name;
        const bool indexed = text.find("Indexed") != text.npos || text == "glColorMaski" ||
                             text == "glBlendEquationi" ||
                             (text.find("glBlend") == 0 && text.back() == 'i');
        return indexed ? nullptr : load(name);
    };
}

}  // namespace

TEST_CASE("Hosts with one strange setting keep it, and get the pictures of a fresh context")
{
    const std::vector<Image> wanted = FreshPictures()[kDrawn];
    for (const Strange& strange : kStrange) {
        INFO(strange.name);
        const auto own = need(makeContext(testBackend()));
        HostLife life(*own);
        strange.set(GlCalls(own->loader()));
        if (quiet(life.gl) != GL_NO_ERROR) continue;  // the context has no such setting
        RandomHost host(life.gl, own->loader());
        Figures figures;
        const Snapshot before = host.snapshot();
        const auto after = [&](const char* step) { compareState(host, before, step, figures); };
        comparePictures(life.live(kDrawn, after), wanted, figures);
    }
}

TEST_CASE("Hosts in random states keep them, and get the pictures of a fresh context")
{
    constexpr int kFew = 16;
    const int count = numberOf("CREVICE_HOST_STATES", 0);
    const int first = numberOf("CREVICE_FIRST_HOST_STATE", 0);
    FreshPictures wanted;
    const auto own = need(makeContext(testBackend()));
    HostLife life(*own);
    RandomHost host(life.gl, own->loader());
    life.watch(host);
    Figures figures;
    for (int seed = first; seed < first + (count > 0 ? count : kFew); ++seed) {
        // Steps of 7 come by every kind in the end, and by all depths and configs in the first few.
        const int kind = (7 * seed + life.kinds() - 1) % life.kinds();
        INFO("state " << seed << ", kind " << kind);
        host.randomize(static_cast<std::uint32_t>(seed));
        const Snapshot before = host.snapshot();
        const auto after = [&](const char* step) { compareState(host, before, step, figures); };
        const std::vector<Image> pictures = life.live(kind, after);
        comparePictures(pictures, wanted[kind], figures);
        need(own->makeCurrent());
    }
    if (count > 0)
        WARN(count << " states: " << figures.values << " values read after steps, "
                   << figures.changes << " steps changed some; " << figures.pictures
                   << " pictures, " << figures.different << " differ");
}

TEST_CASE("A context without state per draw buffer has the host's put back too")
{
    GlDeviceOptions options;
    options.ignore_extensions = true;
    const auto own = need(makeContext(testBackend()));
    GlFixture bare(options, *own);
    settleOptional(bare.gl, need(readInfo(bare.gl, true)), own->loader());
    RandomHost host(bare.gl, withoutIndices(own->loader()));
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        host.randomize(seed);
        const Snapshot before = host.snapshot();
        bare.texture(Format::r8);
        need(bare.device->beginFrame());
        need(bare.device->endFrame());
        CHECK(difference(before, host.snapshot()) == "");
    }
}

TEST_CASE("Hosts that want no restoring get the pictures of a fresh context all the same")
{
    const std::vector<Image> wanted = FreshPictures()[kDrawn];
    GlDeviceOptions options;
    options.restore_state = false;
    options.check_errors = false;
    const auto own = need(makeContext(testBackend()));
    HostLife life(*own, options);
    RandomHost host(life.gl, own->loader());
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        INFO(seed);
        host.randomize(seed);
        GLboolean feedback = GL_FALSE;  // nothing pauses it then, and drawing is refused
        life.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &feedback);
        Figures figures;
        if (!feedback) comparePictures(life.live(kDrawn, [](const char*) {}), wanted, figures);
    }
}

}  // namespace crevice
