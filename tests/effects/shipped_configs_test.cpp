// SPDX-License-Identifier: MIT
// What holds for every shipped config before any GL: it loads, plans, and stays short.
#include <crevice/compile.h>
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tools/plan/print.h"

#include <algorithm>

using namespace crevice;

namespace {

Description describe(const LoadRequest& request)
{
    const Result<Node> document = loadConfig(shippedSources(), request);
    INFO(toText(document.diagnostics()));
    REQUIRE(document.ok());
    Result<Description> description = decode(*document, shippedSources());
    INFO(toText(description.diagnostics()));
    REQUIRE(description.ok());
    return *description;
}

Plan plan(const LoadRequest& request, std::vector<std::string> outputs = {},
          bool material_ambient = false)
{
    SceneTraits traits;
    traits.lights = 1;
    traits.material_ambient = material_ambient;
    const Result<Plan> result = compile(describe(request), traits, RecordingDevice().caps(),
                                        {{256, 144}, std::move(outputs), {}});
    INFO(toText(result.diagnostics()));
    REQUIRE(result.ok());
    return *result;
}

std::vector<std::string> passNames(const Plan& plan)
{
    std::vector<std::string> names;
    for (const PlanPass& pass : plan.passes) names.push_back(pass.name);
    return names;
}

bool hasAttachment(const Plan& plan, const std::string& name)
{
    for (const PlanTarget& target : plan.targets)
        if (target.name == name) return true;
    return false;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("Every shipped config plans on a full and on a bare device")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        CHECK(!plan({name}).passes.empty());

        DeviceCaps bare = minimumCaps();
        const bool float_positions = findNamed(describe({name}).targets, "position") != nullptr;
        const Result<Plan> result = compile(describe({name}), {}, bare, {{64, 64}, {}, {}});
        CHECK(result.ok() == !float_positions);
        if (!result.ok()) CHECK(result.diagnostics().front().code == Code::no_format);
    }
}

TEST_CASE(
    "Every attachment of a shipped config is as large as its pass, on a device that wants it so")
{
    DeviceCaps caps = RecordingDevice().caps();
    caps.equal_attachments = true;
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Result<Plan> plan = compile(describe({name}), {}, caps, {{256, 144}, {}, {}});
        REQUIRE(plan.ok());
        for (const PlanPass& pass : plan->passes) {
            std::vector<PlanAttachment> attachments = pass.color;
            if (pass.has_depth) attachments.push_back(pass.depth);
            for (const PlanAttachment& each : attachments) {
                if (each.target < 0) continue;
                const PlanTarget& target = plan->targets[each.target];
                CHECK(plan->textures[target.texture].extent == pass.extent);
                CHECK(plan->textures[target.drawn_texture].extent == pass.extent);
            }
        }
    }
}

TEST_CASE("250 offsets without rotation plan on a device that holds them, and say so on others")
{
    const LoadRequest request{
        "hemisphere_box", "", {"samples=250", "/generated/rotation_noise/count=1"}};
    CHECK(!plan(request).passes.empty());

    Description description = describe(request);
    const auto planned = [&] {
        return compile(description, {}, minimumCaps(), {{64, 64}, {}, {}});
    };
    const Result<Plan> refused = planned();
    REQUIRE(refused.diagnostics().size() == 1);
    const Diagnostic& error = refused.diagnostics()[0];
    CHECK(error.code == Code::too_many);
    CHECK(error.pointer == "/params/samples");
    int most = 250;
    for (ParamDesc& param : description.params)
        while (param.name == "samples" && most > 1 && !planned().ok())
            param.value[0] = static_cast<float>(--most);
    const std::string vectors = std::to_string(250 - most + 224);
    CHECK_THAT(error.message, Catch::Contains(vectors) && Catch::Contains("224"));
    CHECK_THAT(error.help, Catch::Contains("to " + std::to_string(most)));
}

TEST_CASE("Every shipped config has at most 25 lines")
{
    for (const std::string& path : shippedSources().list()) {
        if (path.rfind("configs/", 0) != 0) continue;
        const std::string& text = shippedSources().find(path)->text;
        INFO(path);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 25);
    }
}

TEST_CASE("Every config and variant says what it is and every param what it does")
{
    for (const std::string& name : configNames(shippedSources())) {
        const Description description = describe({name});
        INFO(name);
        CHECK(description.name == name);
        CHECK(!description.text.empty());
        for (const ParamDesc& param : description.params) {
            INFO(param.name);
            CHECK(!param.tooltip.empty());
            CHECK(!param.unit.empty());
        }
    }
}

TEST_CASE(
    "learnopengl runs geometry, the mask of its pixels, ssao, filter and lighting in this order")
{
    CHECK(passNames(plan({"learnopengl"})) ==
          Names{"geometry", "foreground", "ssao", "filter", "lighting"});
}

TEST_CASE("Asking for the occlusion alone leaves lighting and albedo out")
{
    const Plan ao = plan({"learnopengl"}, {"ao"});
    CHECK(passNames(ao) == Names{"geometry", "foreground", "ssao", "filter"});
    CHECK(!hasAttachment(ao, "albedo"));
    CHECK(hasAttachment(ao, "normal"));
}

TEST_CASE("A target for the materials' ambient is there in scenes that need it alone")
{
    for (const char* name : {"learnopengl", "gtao", "baked", "mobile"}) {
        INFO(name);
        CHECK(toText(plan({name})).find("ambient_factor") == std::string::npos);
        const bool forward = name == std::string("mobile");
        CHECK(hasAttachment(plan({name}, {}, true), "ambient_factor") != forward);
        CHECK_FALSE(hasAttachment(plan({name}, {"ao"}, true), "ambient_factor"));
    }
}

TEST_CASE("The sphere kernel leaves normals out when nothing else reads them")
{
    CHECK(!hasAttachment(plan({"sphere_box"}, {"ao"}), "normal"));
    CHECK(hasAttachment(plan({"sphere_box"}, {"color"}), "normal"));
}

TEST_CASE("Showing no occlusion leaves its whole chain out")
{
    const LoadRequest request = {"learnopengl", {}, {"display=no_ao"}};
    CHECK(passNames(plan(request, {"color"})) == Names{"geometry", "lighting"});
}

TEST_CASE("Intensity 0 and radius 0 leave the occlusion pass out")
{
    for (const char* off : {"intensity=0", "radius=0"}) {
        const Plan without = plan({"learnopengl", {}, {off}}, {"color"});
        const Names names = passNames(without);
        INFO(off);
        CHECK(std::find(names.begin(), names.end(), "ssao") == names.end());
        CHECK(!without.elided.empty());
    }
}

TEST_CASE("The four combinations of kernel and filter differ in one line of extends")
{
    CHECK(passNames(plan({"hemisphere_bilateral"})) ==
          Names{"geometry", "foreground", "ssao", "filter_x", "filter_y", "lighting"});
    CHECK(passNames(plan({"sphere_box"})) ==
          Names{"geometry", "foreground", "ssao", "filter", "lighting"});
}

TEST_CASE("A device's own variant of a config takes a few lines")
{
    // Half resolution, fewer taps, a smaller G-buffer, for any shipped config.
    MemorySources mine;
    mine.add("configs/phone.json", R"({
  "format": 1,
  "name": "phone",
  "extends": ["learnopengl"],
  "params": { "samples": { "default": 8 } },
  "targets": {
    "ao": { "size": { "scale": 0.5 } },
    "normal": { "format": ["rgb10_a2"] }
  }
})");
    const LayeredSources sources({&mine, &shippedSources()});
    const Result<Node> document = loadConfig(sources, {"phone"});
    REQUIRE(document.ok());
    const Result<Description> description = decode(*document, sources);
    REQUIRE(description.ok());
    const Result<Plan> plan =
        compile(*description, {}, RecordingDevice().caps(), {{101, 51}, {}, {}});
    REQUIRE(plan.ok());
    CHECK(findNamed(plan->passes, "ssao")->extent == Extent{51, 26});
    CHECK(findNamed(plan->passes, "filter")->extent == Extent{101, 51});
}

TEST_CASE("thesis dims everything, and its variant the ambient light alone")
{
    const Description whole = describe({"thesis"});
    const Description ambient = describe({"thesis", "ambient_only"});
    CHECK(findNamed(whole.features, "ao_on")->value == 1);
    CHECK(findNamed(ambient.features, "ao_on")->value == 0);
}
