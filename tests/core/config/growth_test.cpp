// SPDX-License-Identifier: MIT
// What a file holds many of: twice as many take little more than twice the time, and more than any
// config needs is refused in one message.
#include <crevice/compile.h>
#include <crevice/recording_device.h>

#include "core/base/text.h"
#include "tests/core/config/decode_fixture.h"

#include <ctime>
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace crevice;

namespace {

/// `count` texts with their number in place of each '@', and the one after it of each '$'.
std::string many(int count, std::string_view text, std::string_view between = ", ")
{
    std::string all;
    for (int i = 0; i < count; ++i) {
        if (i > 0) all += between;
        for (const char c : text)
            all += c == '@'   ? std::to_string(i)
                   : c == '$' ? std::to_string(i + 1)
                              : std::string(1, c);
    }
    return all;
}

/// What each section of a config has beside the pass that makes its output, that pass beside its
/// shader, the config beside its sections, and its GLSL before and in `main`.
struct Grown {
    std::string params = {}, features = {}, targets = {}, shaders = {}, passes = {}, outputs = {};
    std::string pass = {}, top = {}, head = {}, body = {};
};

/// One thing of which a config may have many.
struct Kind {
    const char* name;
    int most;
    Grown (*make)(int count);
};

constexpr int kMost = int(kMaxMembers) - 8;
const int kMostPasses = Limits().passes - 8;
constexpr const char* kParams = R"("p@": {"type": "float", "default": 1})";
constexpr const char* kTargets = R"("t@": {"format": "r8"})";

const Kind kKinds[] = {
    {"unused params", kMost, [](int n) { return Grown{many(n, kParams)}; }},
    {"unused features", kMost,
     [](int n) {
         return Grown{{}, many(n, R"("f@": {"type": "bool"})")};
     }},
    {"targets that follow each other", kMostPasses,
     [](int n) {
         const std::string last = ", \"t" + std::to_string(n) + R"(": {"format": "r8"})";
         return Grown{{}, {}, many(n, R"("t@": {"format": "r8", "size": {"of": "t$"}})") + last};
     }},
    {"passes", kMostPasses,
     [](int n) {
         Grown grown{{}, {}, many(n, kTargets)};
         grown.passes = many(n, R"("p@": {"shader": "s", "color": ["t@"]})");
         return grown;
     }},
    {"shaders", kMostPasses,
     [](int n) {
         Grown grown{{}, {}, many(n, kTargets)};
         grown.shaders = many(n, R"("s@": {"vertex": "v.vert", "fragment": "s.frag"})");
         grown.passes = many(n, R"("p@": {"shader": "s@", "color": ["t@"]})");
         grown.outputs = many(n, R"("o@": "t@")");
         return grown;
     }},
    {"inputs of what there is not", kMost,
     [](int n) {
         Grown grown{{}, {}, many(kMostPasses, kTargets)};
         grown.pass = R"(, "inputs": {)" + many(n, R"("a@": "none@")") + "}";
         return grown;
     }},
    {"keys of what there is not", kMost,
     [](int n) {
         Grown grown;
         grown.top = many(n, ", \"k@\": 1", "");
         return grown;
     }},
    {"words that set a value", kMost,
     [](int n) {
         return Grown{R"("r": {"type": "float", "default": 1, "bind": "define"})",
                      R"("q": {"type": "enum", "values": [)" + many(n, "\"w@\"") +
                          R"(], "sets": {)" + many(n, R"("w@": {"r": @})") + "}}"};
     }},
    {"uniforms of nothing", kMost,
     [](int n) {
         Grown grown{many(kMost, kParams)};
         grown.head = many(n, "uniform float u@;\n", "");
         return grown;
     }},
    {"conditions of nothing", 4000,
     [](int n) {
         Grown grown;
         grown.head = many(n, "#if Q@\n#endif\n", "");
         return grown;
     }},
    {"macros", 8000,
     [](int n) {
         Grown grown;
         grown.head = many(n, "#define D@ 1.0\n", "");
         grown.body = many(n, "o += D@;\n", "");
         return grown;
     }},
};

std::string section(const char* name, const std::string& own, const std::string& more)
{
    return std::string(", \"") + name + "\": {" + own + (own.empty() || more.empty() ? "" : ", ") +
           more + "}";
}

MemorySources sourcesOf(const Grown& grown)
{
    MemorySources sources;
    sources.add("v.vert", "#version 300 es\nvoid main() { gl_Position = vec4(0.0); }\n");
    sources.add("s.frag", "#version 300 es\nprecision highp float;\n" + grown.head +
                              "layout(location = 0) out vec4 o;\nvoid main() {\n" + grown.body +
                              "}\n");
    sources.add(
        "configs/grown.json",
        "{\"format\": 1" + section("params", "", grown.params) +
            section("features", "", grown.features) +
            section("targets", R"("out": {"format": "r8"})", grown.targets) +
            section("shaders", R"("s": {"vertex": "v.vert", "fragment": "s.frag"})",
                    grown.shaders) +
            section("passes", R"("main": {"shader": "s", "color": ["out"])" + grown.pass + "}",
                    grown.passes) +
            section("outputs", R"("ao": "out")", grown.outputs) + grown.top + "}");
    return sources;
}

/// CPU seconds of reading, decoding and planning it, and what is said of it.
double timeOf(const MemorySources& sources, Diagnostics& found)
{
    const std::clock_t start = std::clock();
    const Result<Node> document = loadConfig(sources, {"grown"});
    found = document.diagnostics();
    if (document) {
        const Result<Description> description = decode(*document, sources);
        found = description.diagnostics();
        if (description)
            found = compile(*description, {}, RecordingDevice().caps(), {{64, 36}}).diagnostics();
    }
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// The address sanitizer makes comparisons of names slow, and all else less so.
bool timesCount()
{
#ifdef __has_feature
    return !__has_feature(address_sanitizer);
#else
    return true;
#endif
}

}  // namespace

TEST_CASE("twice as much of anything takes little more than twice the time", "[decode]")
{
    constexpr double kNoise = 0.01;  // seconds
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 30);  // the system's pages, which cost much on some machines,
    mallopt(M_TRIM_THRESHOLD, 1 << 30);  // are taken in the first round and kept
#endif
    for (const Kind& kind : kKinds) {
        INFO(kind.name);
        const MemorySources smaller = sourcesOf(kind.make(kind.most / 2));
        const MemorySources larger = sourcesOf(kind.make(kind.most));
        Diagnostics found;
        double half = 1e9, whole = 1e9;
        for (int round = 0; round < 20 && (round < 2 || whole > 2.5 * half + kNoise); ++round) {
            half = std::min(half, timeOf(smaller, found));
            whole = std::min(whole, timeOf(larger, found));
        }
        if (timesCount()) CHECK(whole <= 2.5 * half + kNoise);
        CHECK(found.size() <= kMaxDiagnostics);
    }
}

TEST_CASE("more of anything than a config needs is refused in one message", "[decode]")
{
    const auto first = [](const Grown& grown) {
        Diagnostics found;
        timeOf(sourcesOf(grown), found);
        return found.empty() ? std::string() : codeName(found[0].code) + " " + found[0].pointer;
    };
    CHECK(first({many(5000, kParams)}) == "CV1009 /params");
    CHECK(first({{}, {}, many(600, kTargets)}) == "CV1209 /targets");
    Grown grown;
    grown.passes = many(600, R"("p@": {"shader": "s", "color": ["out"]})");
    CHECK(first(grown) == "CV1209 /passes");
    grown = {many(20, kParams)};
    std::string sets;
    for (int i = 0; i < 20; ++i) sets += (i ? ", \"p" : "\"p") + std::to_string(i) + "\": 1";
    grown.features = R"("q": {"type": "enum", "values": [)" + many(1000, "\"w@\"") +
                     R"(], "sets": {"w0": {)" + sets + "}}}";
    CHECK(first(grown) == "CV1209 /features/q");
}

TEST_CASE("textures that take more than Limits allow are refused", "[compile]")
{
    const MemorySources sources = sourcesOf({});
    const Result<Node> document = loadConfig(sources, {"grown"});
    Limits limits;
    limits.bytes = 64 * 36;
    const Result<Description> fits = decode(*document, sources, limits);
    CHECK(compile(*fits, {}, RecordingDevice().caps(), {{64, 36}}).ok());
    const auto larger = compile(*fits, {}, RecordingDevice().caps(), {{65, 36}});
    CHECK(has(onlyError(larger, Code::over_limit).message, "for out"));
}
