// SPDX-License-Identifier: MIT
// What a plan says of formats that are too coarse for camera and radius, and which it chooses.
#include <crevice/config.h>

#include "core/base/text.h"
#include "tests/support/renderer_rig.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

struct Setup {
    std::string config = "hemisphere_box";
    std::vector<std::string> overrides = {};
    double near_distance = 0.1, far_distance = 1000;
    int height = 540;
    bool reversed = false;
    std::vector<Format> depth = {};  // what the target `depth` may be stored in, where that is set
};

Description described(const Setup& setup, const SourceSet& sources = shippedSources())
{
    ConfigOptions options;
    options.config = setup.config;
    options.overrides = setup.overrides;
    Description description = need(loadDescription(options, sources));
    for (TargetDesc& target : description.targets)
        if (target.name == "depth" && !setup.depth.empty()) target.formats = setup.depth;
    return description;
}

Setup depthIn(std::vector<Format> formats, double near_distance, double far_distance = 20)
{
    return {"hemisphere_box", {}, near_distance, far_distance, 540, false, std::move(formats)};
}

SceneTraits traitsFor(const Setup& setup)
{
    Frame frame;
    glm::dmat4 lens =
        glm::perspective(glm::radians(60.0), 16.0 / 9, setup.near_distance, setup.far_distance);
    for (int column = 0; setup.reversed && column < 4; ++column) lens[column].z *= -1;
    frame.camera.clip_from_view = glm::mat4(lens);
    frame.lights.resize(1);
    return traitsOf(frame);
}

Result<Plan> planFor(const Setup& setup, const SourceSet& sources = shippedSources())
{
    DeviceCaps caps = usualCaps();
    caps.max_texture_size = 8192;
    Result<Plan> plan = compile(described(setup, sources), traitsFor(setup), caps,
                                {{setup.height * 16 / 9, setup.height}, {}, {}});
    INFO(toText(plan.diagnostics()));
    REQUIRE(plan.ok());
    return plan;
}

Format formatOf(const Plan& plan, const std::string& name)
{
    const PlanTarget* target = findNamed(plan.targets, name);
    return target ? plan.textures[target->texture].format : Format::none;
}

int warnings(const Result<Plan>& plan)
{
    int count = 0;
    for (const Diagnostic& each : plan.diagnostics()) count += each.code == Code::too_coarse;
    return count;
}

}  // namespace

TEST_CASE("Ordinary cameras get no warning about formats, and the first ones")
{
    for (const std::string& config : configNames(shippedSources()))
        for (const double far_distance : {50.0, 1000.0})
            for (const int height : {270, 1080}) {
                const Description description = described({config});
                const bool stored = findNamed(description.targets, "position") != nullptr;
                const Result<Plan> plan = planFor({config, {}, 0.1, far_distance, height});
                CAPTURE(config, far_distance, height, toText(plan.diagnostics()));
                CHECK(warnings(plan) == 0);
                if (stored && far_distance > 50) continue;
                for (const PlanTarget& target : plan->targets) {
                    const TargetDesc* desc = findNamed(description.targets, target.name);
                    CHECK(formatOf(*plan, target.name) == desc->formats.front());
                }
            }
}

TEST_CASE("A near plane that leaves depth too coarse is reported once, with figures and ways out")
{
    const Result<Plan> plan = planFor(depthIn({Format::depth16}, 0.001));
    REQUIRE(warnings(plan) == 1);
    const Diagnostic& warning = *findDiagnostic(plan.diagnostics(), Code::too_coarse);
    CHECK(warning.severity == Severity::warning);
    CHECK(warning.message ==
          "depth16 of 'depth' resolves 6.1 at distance 20, and the radius 0.5 wants 0.05, "
          "as it has up to 1.81");
    CHECK(warning.pointer == "/targets/depth/format");
    CHECK_THAT(warning.help, Catch::Contains("move the near plane out"));
}

TEST_CASE("Nothing is said where no pass looks about within a radius, or no camera is known")
{
    CHECK(warnings(planFor({"hemisphere_box", {}, 1e-5, 1e4})) == 1);
    CHECK(warnings(planFor({"hemisphere_box", {"intensity=0"}, 1e-5, 1e4})) == 0);
    CHECK(warnings(planFor({"hemisphere_box", {"radius=0"}, 1e-5, 1e4})) == 0);
    const Description description = described({"hemisphere_box"});
    const Result<Plan> unknown = compile(description, {}, usualCaps(), {{960, 540}, {}, {}});
    CHECK(warnings(unknown) == 0);
}

TEST_CASE("A format further down the list is taken where it serves farther")
{
    const Setup setup = depthIn({Format::depth16, Format::depth24}, 0.02);
    const Result<Plan> plan = planFor(setup);
    CHECK(formatOf(*plan, "depth") == Format::depth24);
    CHECK(plan.diagnostics().empty());

    Setup ordinary = setup;
    ordinary.near_distance = 0.2;
    CHECK(formatOf(*planFor(ordinary), "depth") == Format::depth16);
}

TEST_CASE("Positions are stored in 32 bits where halves do not hold the units")
{
    for (const char* config : {"learnopengl", "thesis"})
        for (const double unit : {1e-6, 1e-5, 1e-3, 1.0, 1e3, 1e5, 1e6}) {
            CAPTURE(config, unit);
            Setup setup = {
                config, {"radius=" + shortest(float(0.5 * unit))}, 0.1 * unit, 50 * unit};
            const Result<Plan> plan = planFor(setup);
            CHECK(warnings(plan) == 0);
            const bool half = unit > 1.3e-3 && unit < 5e3;
            CHECK(formatOf(*plan, "position") == (half ? Format::rgba16f : Format::rgba32f));
        }
}

TEST_CASE("A host that reverses its float depth needs no warning")
{
    const auto plan = [](const std::string& format, bool reversed) {
        MemorySources mine;
        mine.add("configs/hosted.json", R"({
  "format": 1, "name": "hosted", "extends": ["geometry/host_depth", "ssao/hemisphere", "filter/box"],
  "imports": { "depth": { "format": ")" + format +
                                            R"(" } } })");
        const LayeredSources sources({&mine, &shippedSources()});
        Setup setup = {"hosted", {}, 0.001, 1000};
        setup.reversed = reversed;
        return planFor(setup, sources);
    };
    CHECK(warnings(plan("depth32f", true)) == 0);
    const Result<Plan> straight = plan("depth32f", false);
    REQUIRE(warnings(straight) == 1);
    CHECK(has(findDiagnostic(straight.diagnostics(), Code::too_coarse)->help, "reversed depth"));
    CHECK(warnings(plan("depth24", true)) == 1);
}

TEST_CASE("A frame that is planned again reports the new plan's warnings once")
{
    RecordingDevice device;
    const Setup setup = depthIn({Format::depth16}, 1);
    Frame frame;
    frame.camera.clip_from_view = glm::mat4(glm::perspective(1.0, 1.5, 1.0, 10.0));
    auto renderer =
        Renderer::create(device, described(setup), {{960, 540}, {}, {}}, traitsOf(frame));
    REQUIRE(renderer.ok());
    CHECK(findDiagnostic(renderer.diagnostics(), Code::too_coarse) == nullptr);
    frame.camera.clip_from_view = glm::mat4(glm::perspective(1.0, 1.5, 1e-3, 10.0));
    const Status stiff = (*renderer)->render(frame);
    CHECK(stiff.ok());
    CHECK(findDiagnostic(stiff.diagnostics(), Code::too_coarse) != nullptr);
    CHECK((*renderer)->render(frame).diagnostics().empty());
}

TEST_CASE("A radius set at run time plans again only where other formats serve it")
{
    RecordingDevice device;
    Frame frame;
    frame.camera.clip_from_view = glm::mat4(glm::perspective(1.0, 1.5, 0.1, 20.0));
    auto renderer = need(Renderer::create(device, described({"learnopengl"}), {{960, 540}, {}, {}},
                                          traitsOf(frame)));
    const auto stored = [&] { return formatOf(renderer->plan(), "position"); };
    CHECK(stored() == Format::rgba16f);
    device.clearLog();
    CHECK(renderer->setParam("radius", 0.4f).ok());
    CHECK_FALSE(has(device.log(), "createTexture"));
    CHECK(renderer->setParam("radius", 0.05f).ok());
    CHECK(stored() == Format::rgba32f);
    CHECK(renderer->setParam("radius", 0.5f).ok());
    CHECK(stored() == Format::rgba16f);
}

namespace {

// Of a config whose draws lie in such a range.
Diagnostics saidOfDraws(const Setup& setup, const DrawRange& draws)
{
    SceneTraits traits = traitsFor(setup);
    traits.draws = draws;
    const Result<Plan> plan = compile(described(setup), traits, usualCaps(), {{960, 540}, {}, {}});
    REQUIRE(plan.ok());
    return plan.diagnostics();
}

}  // namespace

TEST_CASE("Where draws are known to lie, warnings go by that and not by the far plane")
{
    const Setup far = {"gtao", {}, 0.01, 1e6};
    CHECK_FALSE(saidOfDraws(far, {}).empty());
    CHECK(saidOfDraws(far, {1, 0}).empty());
    CHECK_FALSE(saidOfDraws(far, {50, 0}).empty());
}

TEST_CASE("A kernel's margin hides steps, and one all round the point sees finer ones")
{
    // Steps of depth24 at the draws' distance: 0.015 radii behind the first near plane.
    const double coarse = 2e-4;
    const auto said = [](const std::string& config, double near_distance,
                         std::vector<std::string> overrides) {
        return !saidOfDraws({config, std::move(overrides), near_distance, 1e4}, {5, 0}).empty();
    };
    CHECK_FALSE(said("hemisphere_box", coarse, {}));
    CHECK(said("hemisphere_box", coarse, {"bias=0.005"}));
    CHECK(said("hemisphere_box", coarse / 2, {}));
    CHECK_FALSE(said("hemisphere_box", 3 * coarse, {"bias=0"}));
    CHECK(said("sphere_box", 3 * coarse, {}));
    CHECK_FALSE(said("sphere_box", 6 * coarse, {}));
}

TEST_CASE("Vertices far from their origin are reported")
{
    CHECK(saidOfDraws({"gtao"}, {5, 0.001}).empty());
    const Diagnostics far = saidOfDraws({"gtao"}, {5, 0.01});
    REQUIRE(far.size() == 1);
    CHECK(far[0].code == Code::too_coarse);
    CHECK(far[0].pointer == "/params/radius");
    CHECK(saidOfDraws({"gtao", {"radius=50"}}, {5, 0}).empty());  // reaches off the screen
}
