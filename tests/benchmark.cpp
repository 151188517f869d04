// SPDX-License-Identifier: MIT
// CPU time of a frame: a plan of ten passes on the recording device, in microseconds, and a
// thousand draws through a shipped config. And of what comes before it: reading a mebibyte of JSON,
// and the slowest shipped config from text to plan.
#include <crevice/compile.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/render/device/forwarding_device.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace crevice;

namespace {

constexpr int kPasses = 10;
constexpr int kFrames = 5000;

/// What fails ends the benchmark.
void need(const Status& status)
{
    if (status) return;
    std::fputs(toText(status.diagnostics()).c_str(), stderr);
    std::exit(1);
}

template <class T>
T need(Result<T> result)
{
    need(Status(result.diagnostics()));
    return std::move(*result);
}

std::string join(const std::vector<std::string>& members)
{
    std::string text;
    for (const std::string& member : members) text += (text.empty() ? "" : ", ") + member;
    return "{" + text + "}";
}

/// A chain of passes, each reading the one before it, with the uniforms of an occlusion shader.
Description chain()
{
    MemorySources files;
    files.add("v", "#version 300 es\nvoid main() {}\n");
    std::vector<std::string> targets, shaders, passes;
    std::string previous = "noise";
    for (int i = 0; i < kPasses; ++i) {
        const std::string n = std::to_string(i), target = "t" + n;
        targets.push_back("\"" + target + R"(": {"format": ["rgba8"]})");
        shaders.push_back("\"s" + n + R"(": {"vertex": "v", "fragment": "f)" + n + "\"}");
        passes.push_back("\"p" + n + R"(": {"shader": "s)" + n + R"(", "color": ")" + target +
                         "\"}");
        files.add("f" + n,
                  "#version 300 es\nprecision highp float;\n"
                  "uniform mat4 clip_from_view, view_from_clip, view_from_world;\n"
                  "uniform vec3 kernel[64];\nuniform vec2 viewport_size;\n"
                  "uniform float radius, bias, intensity, power;\n"
                  "uniform sampler2D " +
                      previous + ";\nout vec4 " + target + ";\n");
        previous = target;
    }
    const std::string json = R"({"format": 1, "name": "chain",
        "params": {"radius": {"default": 1}, "bias": {"default": 1},
                   "intensity": {"default": 1}, "power": {"default": 1}},
        "imports": {"camera": {"type": "camera"}},
        "generated": {"kernel": {"generator": "hemisphere_kernel", "count": 64},
                      "noise": {"generator": "rotation_noise", "count": 4}},
        "outputs": {"ao": ")" +
                             previous + R"("},
        "targets": )" + join(targets) +
                             R"(, "shaders": )" + join(shaders) + R"(, "passes": )" + join(passes) +
                             "}";
    const Node document =
        need(parseDocument(std::make_shared<const SourceText>(SourceText{"chain.json", json})));
    return need(decode(document, files));
}

double milliseconds(std::chrono::steady_clock::time_point begin)
{
    const auto end = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// The least of some runs: what others do on the machine only adds.
template <class F>
double fastest(F&& run)
{
    constexpr int kRuns = 20;
    double least = 1e30;
    for (int i = 0; i < kRuns; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        run();
        least = std::min(least, milliseconds(begin));
    }
    return least;
}

/// A text of as many bytes as are read at most.
void printParsing()
{
    const auto source = std::make_shared<SourceText>(SourceText{"tiny.json", "{\"a\": [0"});
    while (source->text.size() + 4 < kMaxDocumentBytes) source->text += ",0";
    source->text += "]}";
    const double time_ms = fastest([&] { need(parseDocument(source)); });
    std::printf("1 MiB of JSON in half a million values: %.1f ms\n", time_ms);
}

void printPlanning()
{
    const DeviceCaps caps = generousCaps();
    double slowest_ms = 0;
    std::string slowest;
    for (const std::string& name : configNames(shippedSources())) {
        const double time_ms = fastest([&] {
            const Result<Node> document = loadConfig(shippedSources(), {name});
            const Result<Description> description = decode(*document, shippedSources());
            (void)compile(*description, {}, caps, {{1920, 1080}, {}, {}}).ok();
        });
        if (time_ms <= slowest_ms) continue;
        slowest_ms = time_ms;
        slowest = name;
    }
    std::printf("from text to plan: at most %.2f ms (%s)\n", slowest_ms, slowest.c_str());
}

/// Keeps no log of draws: what is left is the time of the renderer itself.
class IdleDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    ObjectInfo info(ObjectId id) const override
    {
        if (id.value != known_) info_ = ForwardingDevice::info(id);
        known_ = id.value;
        return info_;
    }
    void setProgram(ProgramId, const StateDesc&) override { ++calls; }
    void setTexture(int, int, TextureId, const SamplerDesc&) override { ++calls; }
    void setUniform(int, GlslType, int, const void*) override { ++calls; }
    void draw(MeshId, std::uint32_t, std::uint32_t) override { ++calls; }
    void drawFullscreen() override { ++calls; }

    long calls = 0;

private:
    mutable std::uint32_t known_ = 0;
    mutable ObjectInfo info_;
};

/// Processor time of this thread: unlike the clock, the same on a machine that others work on.
double processorMs()
{
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Boxes in rows before the camera, of which all show, in turn of one of eight materials.
Frame manyDraws(MeshId mesh, int draws)
{
    constexpr int kMaterials = 8;
    Frame frame;
    frame.camera.clip_from_view = glm::perspective(0.9f, 1.78f, 0.1f, 200.0f);
    frame.materials.resize(kMaterials);
    frame.lights.resize(1);
    for (int i = 0; i < draws; ++i) {
        const glm::dvec3 at(i % 10 - 4.5, i / 10 % 10 - 4.5, -20 - i / 100 % 10);
        DrawItem item = {mesh, 0, 36, glm::translate(glm::dmat4(1), at), i % kMaterials};
        item.bounds_radius = 1;
        frame.draws.push_back(item);
    }
    return frame;
}

/// Milliseconds a frame, the median of some. The camera may move, so that all is drawn again.
double drawFrames(Renderer& renderer, Frame& frame, RecordingDevice& log, bool moves)
{
    constexpr int kMeasured = 300;
    std::vector<double> times_ms;
    for (int i = 0; i < kMeasured; ++i) {
        if (moves) frame.camera.view_from_world[3][0] = 0.01 * (i % 7);
        const double begin = processorMs();
        const Status status = renderer.render(frame);
        times_ms.push_back(processorMs() - begin);
        need(status);
        log.clearLog();
    }
    std::sort(times_ms.begin(), times_ms.end());
    return times_ms[kMeasured / 2];
}

void printDraws(const char* config, int draws, bool moves, bool counted = false)
{
    RecordingDevice recording;
    IdleDevice device(recording);
    MeshDesc desc;
    desc.label = "box";
    desc.vertices.resize(36);
    for (std::uint32_t i = 0; i < 36; ++i) desc.indices.push_back(i);
    Frame frame = manyDraws(need(device.createMesh(desc)), draws);
    if (counted) frame.draws_revision = 1;
    const Description description =
        need(decode(need(loadConfig(shippedSources(), {config})), shippedSources()));
    const auto renderer =
        need(Renderer::create(device, description, {{1920, 1080}}, traitsOf(frame)));
    const long calls = device.calls;
    const double time_ms = drawFrames(*renderer, frame, recording, moves);
    std::printf("%d draws through %s, %s: %.3f ms of CPU a frame, %ld calls\n", draws, config,
                moves     ? "moving"
                : counted ? "still by draws_revision"
                          : "still",
                time_ms, (device.calls - calls) / 300);
}

}  // namespace

int main()
{
    RecordingDevice device;
    const Frame frame;
    const auto renderer = need(Renderer::create(device, chain(), {{1920, 1080}}, traitsOf(frame)));
    std::vector<double> times_us;
    for (int i = 0; i < kFrames; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const Status status = renderer->render(frame);
        const auto end = std::chrono::steady_clock::now();
        need(status);
        device.clearLog();
        times_us.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }
    std::sort(times_us.begin(), times_us.end());
    std::printf("%zu passes: median %.2f us of CPU a frame, 99th percentile %.2f us\n",
                renderer->plan().passes.size(), times_us[kFrames / 2],
                times_us[kFrames * 99 / 100]);
    for (const char* config : {"high", "mobile"}) printDraws(config, 1000, true);
    for (const bool counted : {false, true}) printDraws("high", 100000, false, counted);
    printParsing();
    printPlanning();
}
