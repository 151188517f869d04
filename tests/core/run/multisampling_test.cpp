// SPDX-License-Identifier: MIT
// Multisampled targets: what a plan makes of them, and what a device is asked to do.
#include <crevice/recording_device.h>

#include "tests/support/plan_rig.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

std::string target(const std::string& format, const std::string& keys)
{
    return R"({"format": [")" + format + "\"], " + keys + "}";
}

/// A draw into colour and depth, and a pass that reads the colour.
Sketch sketched(const std::string& samples, const std::string& extra = "")
{
    const std::string keys = "\"samples\": " + samples;
    return {{R"(paint: -> color | "type": "draw", "depth": "d")", "grade: color -> graded"},
            {{"out", "graded"}},
            {{"color", target("rgba8", keys)}, {"d", target("depth24", keys)}},
            extra};
}

Plan planWith(const DeviceCaps& caps, const std::string& samples)
{
    return need(compile(describe(sketched(samples)), {}, caps, sized()));
}

DeviceCaps capsWith(const std::vector<int>& counts)
{
    DeviceCaps caps = ampleCaps();
    for (std::uint32_t& bits : caps.sample_counts) {
        bits = 0;
        for (const int count : counts) bits |= 1u << (count - 1);
    }
    return caps;
}

}  // namespace

TEST_CASE("A plan draws several samples into a texture apart and resolves what is read")
{
    const Plan plan = planOf(describe(sketched("4")));
    CHECK(toText(plan) ==
          R"(plan sketch 64x32: 2 passes, 4 textures, 74.0 KiB
passes
  paint: draw 64x32, 4 samples, program paint, 32.0 KiB read, 40.0 KiB written
    writes  color: rgba8 texture 1 resolved from 0, clear to 0, store
    writes  d: depth24 texture 2, clear to 1, discard
  grade: fullscreen 64x32, program grade, 8.0 KiB read, 2.0 KiB written
    reads   color (nearest, clamp)
    writes  graded: r8 texture 3, discard, store
textures
  0: rgba8 64x32, 4 samples, 32.0 KiB: color
  1: rgba8 64x32, 8.0 KiB: color
  2: depth24 64x32, 4 samples, 32.0 KiB: d
  3: r8 64x32, 2.0 KiB: graded
outputs
  out: target graded
imports
  scene: draw_list
left out
  passes (cached): per frame, those whose inputs have not changed
)");
    CHECK(toJson(plan).find("\"samples\": 4") != std::string::npos);
    CHECK(toDot(plan).find("64x32, 4 samples") != std::string::npos);
}

TEST_CASE("Samples are drawn into one texture by passes that follow each other")
{
    const std::string keys = target("r8", R"("samples": 4)");
    const Sketch sketch{{"a: -> x", "b: x -> y"}, {{"out", "y"}}, {{"x", keys}, {"y", keys}}};
    const Plan plan = planOf(describe(sketch));
    CHECK(plan.targets[0].drawn_texture == plan.targets[1].drawn_texture);
    CHECK(plan.targets[0].texture != plan.targets[1].texture);
    CHECK(plan.textures.size() == 3);
}

TEST_CASE("A device draws the samples, resolves what is stored, and nobody samples the rest")
{
    RecordingDevice device;
    const auto renderer = need(Renderer::create(device, describe(sketched("4")), sized(), {}));
    need(renderer->render({}));
    for (const char* line :
         {"createTexture 'color' rgba8 64x32 4 samples\n",
          "createTexture 'd' depth24 64x32 4 samples\n",
          "createFramebuffer 'paint' color 'color' depth 'd' resolve 'color'\n",
          "beginPass paint 64x32 color0 clear 0 0 0 0 store depth clear 1 discard\n"})
        CHECK_THAT(device.log(), Catch::Contains(line));
    CHECK(device.misuse().empty());
}

TEST_CASE("A pass that goes on draws on what was resolved, of one sample")
{
    RecordingDevice device;
    Sketch sketch = sketched("4");
    sketch.passes = {R"(paint: -> color | "type": "draw", "depth": "d")",
                     R"(more: -> color | "type": "draw", "over": "paint")"};
    sketch.outputs = {{"out", "color"}};
    const auto renderer = need(Renderer::create(device, describe(sketch), sized(), {}));
    need(renderer->render({}));
    CHECK(renderer->plan().passes[1].samples == 1);
    for (const char* line : {"createFramebuffer 'paint' color 'color' depth 'd' resolve 'color'\n",
                             "createFramebuffer 'more' color 'color'\n"})
        CHECK_THAT(device.log(), Catch::Contains(line));
    CHECK(device.misuse().empty());
}

TEST_CASE(
    "A device draws the next count that all formats of a pass have, or says that it has fewer")
{
    CHECK(planWith(capsWith({2, 4, 8}), "3").passes[0].samples == 4);
    CHECK(planWith(capsWith({4}), "2").passes[0].samples == 4);
    DeviceCaps caps = capsWith({2, 4, 8});
    caps.sample_counts[static_cast<int>(Format::depth24)] = 1u << 1 | 1u << 7;
    CHECK(planWith(caps, "4").passes[0].samples == 8);

    CHECK(compile(describe(sketched("3")), {}, capsWith({4}), sized()).diagnostics().empty());

    const bool any = GENERATE(true, false);
    const Result<Plan> plan =
        compile(describe(sketched("16")), {},
                capsWith(any ? std::vector<int>{2, 4} : std::vector<int>{}), sized());
    CHECK(onlyWarning(plan, Code::no_samples).pointer == "/passes/paint");
    CHECK(plan->passes[0].samples == (any ? 4 : 1));
}

namespace {

/// A pass that declares `first`, and one that declares `second` and reads the target of the first.
Description reading(const std::string& import, const std::string& target, const std::string& first,
                    const std::string& second)
{
    const std::string version = "#version 310 es\n", out = "out highp vec4 c;\n";
    return describe(
        R"({"format": 1, "imports": {"host": )" + import + R"(},
        "targets": {"x": )" +
            target + R"(, "y": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "v", "fragment": "f"}, "t": {"vertex": "v", "fragment": "g"}},
        "passes": {"p": {"shader": "s", "color": "x"}, "q": {"shader": "t", "color": "y"}},
        "outputs": {"y": "y"}})",
        {{"v", kFullVertex}, {"f", version + first + out}, {"g", version + second + out}});
}

/// A pass that reads what `import` says one sample at a time.
Description readingHost(const std::string& import, const std::string& sampler = "sampler2DMS")
{
    return reading(import, R"({"format": ["r8"]})", "uniform highp " + sampler + " host;\n",
                   "uniform highp sampler2D x;\n");
}

const char* const kHostTexture = R"({"type": "texture"})";

Result<Plan> compiledByNewer(const Description& description)
{
    DeviceCaps caps = ampleCaps();
    caps.version = 310;
    return compile(description, {}, caps, sized());
}

/// The diagnostics of a frame whose texture has that many samples.
Status drawnWith(int samples, const std::string& sampler)
{
    RecordingDevice device;
    const auto renderer =
        need(Renderer::create(device, readingHost(kHostTexture, sampler), sized(), {}));
    Frame frame;
    frame.textures = {{"host", *device.adoptTexture({7, "host", Format::r8, {64, 32}, samples})}};
    const Status status = renderer->render(frame);
    CHECK(device.misuse().empty());
    return status;
}

}  // namespace

TEST_CASE("Samples of the host want OpenGL ES 3.1, and a device without it names the way out")
{
    need(compiledByNewer(readingHost(kHostTexture)));
    const Diagnostic error =
        onlyError(tryCompile(readingHost(kHostTexture)), Code::sampler_version);
    CHECK(textAt(error.notes.at(0).place) == "host");
    CHECK(has(error.help, "geometry/host_depth"));
}

TEST_CASE("Samples are read of the host's textures alone, and of such as are there for certain")
{
    const auto optional = compiledByNewer(readingHost(R"({"type": "texture", "optional": true})"));
    CHECK(onlyError(optional, Code::uniform_type).pointer == "/imports/host");
    const auto resolved = compiledByNewer(reading(kHostTexture, target("r8", R"("samples": 4)"), "",
                                                  "uniform highp sampler2DMS x;\n"));
    CHECK(textAt(onlyError(resolved, Code::uniform_type).place) == "x");
}

TEST_CASE("A host's texture with other samples than its sampler reads is refused")
{
    CHECK(drawnWith(4, "sampler2DMS").ok());
    CHECK(drawnWith(1, "sampler2D").ok());
    for (const Status& status : {drawnWith(1, "sampler2DMS"), drawnWith(4, "sampler2D")}) {
        CHECK(codeOf(status) == Code::bad_input);
        CHECK(status.diagnostics().front().pointer == "/imports/host");
    }
}
