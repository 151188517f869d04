// SPDX-License-Identifier: MIT
// What is set at run time: which values compile shaders, and all of them as the smallest patch.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "core/config/values.h"
#include "core/json/merge.h"
#include "tests/support/catch.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

bool compiles(Rig& rig, const Status& status)
{
    const bool logged = rig.device.log().find("createProgram") != std::string::npos;
    const bool told = findDiagnostic(status.diagnostics(), Code::recompiled) != nullptr;
    CHECK(status.ok());
    CHECK(logged == told);  // nothing compiles in silence, nothing is told that did not happen
    rig.device.clearLog();
    return told;
}

bool setCompiles(Rig& rig, const char* name, float value)
{
    rig.device.clearLog();
    return compiles(rig, rig.renderer->setParam(name, value));
}

Node parsed(const std::string& text)
{
    auto node = parseDocument(std::make_shared<SourceText>(SourceText{"patch.json", text}));
    REQUIRE(node.ok());
    return *node;
}

}  // namespace

TEST_CASE("A param that is no define never compiles a shader, whatever its value")
{
    Rig rig;
    for (const char* param : {"radius", "intensity", "taps", "resolution", "tile"})
        for (const float part : {0.0f, 0.3f, 1.0f, 0.5f}) {
            const ParamDesc& desc = *findNamed(rig.renderer->description().params, param);
            const double value = desc.min + (desc.max - desc.min) * part;
            INFO(param << " " << value);
            CHECK_FALSE(setCompiles(
                rig, param,
                static_cast<float>(desc.type == ParamType::int_ ? std::floor(value) : value)));
        }
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("A define compiles once for each value, and says which shader and which param")
{
    Rig rig;
    rig.device.clearLog();
    const Status status = rig.renderer->setParam("samples", 16.0f);
    const Diagnostic* warning = findDiagnostic(status.diagnostics(), Code::recompiled);
    REQUIRE(warning);
    CHECK(warning->severity == Severity::warning);
    CHECK(warning->message ==
          "param 'samples' is bound as a define, so setting it compiled 'occlusion'");
    CHECK(warning->pointer == "/params/samples");
    CHECK(warning->place.line > 0);
    CHECK(compiles(rig, status) == true);
    CHECK_FALSE(setCompiles(rig, "samples", 4.0f));
    CHECK_FALSE(setCompiles(rig, "samples", 16.0f));
    CHECK(setCompiles(rig, "edge", 0.25f));
    CHECK_FALSE(setCompiles(rig, "edge", 0.5f));
}

TEST_CASE("A feature that comes back costs no compiling, and neither does a pass")
{
    Rig rig;
    rig.device.clearLog();
    CHECK_FALSE(compiles(rig, rig.renderer->setFeature("soft", "false")));
    CHECK_FALSE(compiles(rig, rig.renderer->setFeature("soft", "true")));
    CHECK(compiles(rig, rig.renderer->setFeature("look", "flat")));
    CHECK_FALSE(compiles(rig, rig.renderer->setFeature("look", "lit")));
}

TEST_CASE("A pass that never ran compiles as it comes, and that is told")
{
    Rig rig;
    Description description = rigDescription();
    for (ParamDesc& param : description.params)
        if (param.name == "intensity") param.value[0] = 0.0f;
    auto made = Renderer::create(rig.device, description, {{64, 32}}, traitsOf(rig.frame));
    REQUIRE(made.ok());
    rig.renderer = std::move(*made);
    CHECK(setCompiles(rig, "intensity", 1.0f));
    CHECK_FALSE(setCompiles(rig, "intensity", 0.0f));
    CHECK_FALSE(setCompiles(rig, "intensity", 2.0f));
}

TEST_CASE("Programs that nobody needs are kept only so long")
{
    Rig rig;
    for (int samples = 1; samples <= 64; ++samples)
        REQUIRE(rig.renderer->setParam("samples", static_cast<float>(samples)).ok());
    CHECK(rig.device.live(ObjectId::Kind::program) <= 4 + 32);
    CHECK(setCompiles(rig, "samples", 1.0f));
    rig.renderer.reset();
    CHECK(rig.device.live(ObjectId::Kind::program) == 0);
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("Changes are the smallest patch, and what is set back is none")
{
    Rig rig;
    Renderer& renderer = *rig.renderer;
    CHECK(renderer.changes() == "{}");
    const float tint[3] = {0.1f, 0.5f, 0.25f};
    REQUIRE(renderer.setParam("tint", tint, 3).ok());
    REQUIRE(renderer.setParam("radius", 0.8f).ok());
    REQUIRE(renderer.setParam("samples", 16.0f).ok());
    REQUIRE(renderer.setFeature("soft", "false").ok());
    REQUIRE(renderer.setFeature("look", "flat").ok());
    CHECK(renderer.changes() == R"({"params": {"radius": 0.8, "samples": 16, )"
                                R"("tint": [0.1, 0.5, 0.25]}, )"
                                R"("features": {"soft": false, "look": "flat"}})");
    REQUIRE(renderer.setParam("radius", 0.5f).ok());
    REQUIRE(renderer.setParam("samples", 4.0f).ok());
    REQUIRE(renderer.setFeature("soft", "true").ok());
    REQUIRE(renderer.setFeature("look", "lit").ok());
    CHECK(renderer.changes() == R"({"params": {"tint": [0.1, 0.5, 0.25]}})");
    CHECK_FALSE(renderer.setParam("radius", -1.0f).ok());
    CHECK(renderer.changes() == R"({"params": {"tint": [0.1, 0.5, 0.25]}})");
}

TEST_CASE("A patch of changes over the config gives back the same values")
{
    const Result<Node> document = loadConfig(shippedSources(), {"gtao"});
    REQUIRE(document.ok());
    const Result<Description> loaded = decode(*document, shippedSources());
    REQUIRE(loaded.ok());
    Description now = *loaded;
    for (ParamDesc& param : now.params)
        for (int i = 0; i < componentCount(param.type); ++i)
            if (param.type != ParamType::int_ && param.max > 1.0)
                param.value[i] = static_cast<float>(std::max(param.min, 0.1) + 1.0 / 3.0);
    for (FeatureDesc& feature : now.features)
        feature.value = static_cast<int>(feature.values.size()) - 1;
    const std::string patch = valuesPatch(valuesOf(*loaded), now);
    CHECK(patch.size() > 2);

    Node merged = *document;
    Diagnostics errors;
    mergePatch(merged, parsed(patch), errors);
    CHECK(errors.empty());
    const Result<Description> again = decode(merged, shippedSources());
    INFO(toText(again.diagnostics()));
    REQUIRE(again.ok());
    CHECK(valuesOf(*again).params == valuesOf(now).params);
    CHECK(valuesOf(*again).features == valuesOf(now).features);
    CHECK(valuesPatch(valuesOf(now), *again) == "{}");
}

TEST_CASE("An int of many digits is written as an int")
{
    Description description = describe(
        R"({"format": 1, "name": "big", "params": {"count": {"type": "int", "default": 1}},
            "outputs": {}})",
        {});
    const Values loaded = valuesOf(description);
    description.params[0].value[0] = 1000000.0f;
    CHECK(valuesPatch(loaded, description) == R"({"params": {"count": 1000000}})");
}
