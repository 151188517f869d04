// SPDX-License-Identifier: MIT
// Levels of quality, switched while a config runs: nothing compiles then.
#include "tests/support/catch.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

/// The rig with a feature `quality` of which each word compiles shaders of its own.
struct LevelRig : Rig {
    LevelRig()
    {
        auto made = Renderer::create(device, description(), {{64, 32}}, traitsOf(frame));
        if (!made) FAIL(toText(made.diagnostics()));
        CHECK(made.diagnostics().empty());
        renderer = std::move(*made);
    }

    static Description description(const std::string& high = R"({"samples": 64, "edge": 0.25})")
    {
        std::string config = kRigConfig;
        const std::string levels =
            R"("quality": {"type": "enum", "values": ["off", "low", "high"], "default": "low",
            "sets": {"off": {"intensity": 0}, "low": {"samples": 8, "soft": false}, "high": )" +
            high + "}}, ";
        config.insert(config.find("\"soft\""), levels);
        return describe(config, rigSources(""));
    }
};

}  // namespace

TEST_CASE("Switching between levels compiles no program, whichever they are")
{
    LevelRig rig;
    rig.draw();
    for (const char* level : {"off", "high", "low", "high", "off", "low"}) {
        INFO(level);
        rig.device.clearLog();
        const Status status = rig.renderer->setFeature("quality", level);
        REQUIRE(status.ok());
        CHECK(status.diagnostics().empty());
        CHECK_FALSE(rig.logged("createProgram"));
        rig.draw();
        CHECK_FALSE(rig.logged("createProgram"));
        CHECK(rig.ranPass("occlusion") == (std::string(level) != "off"));
        CHECK(rig.ranPass("filter") == (std::string(level) != "low"));
    }
    CHECK(rig.value("samples") == 8);
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("A level sets its values over what was set by hand, and leaves all else")
{
    LevelRig rig;
    REQUIRE(rig.renderer->setParam("samples", 5.0f).ok());
    REQUIRE(rig.renderer->setParam("intensity", 3.0f).ok());
    REQUIRE(rig.renderer->setParam("radius", 2.0f).ok());
    REQUIRE(rig.renderer->setFeature("quality", "high").ok());
    CHECK(rig.value("samples") == 64);
    CHECK(rig.value("edge") == 0.25f);
    CHECK(rig.value("intensity") == 1);
    CHECK(rig.value("radius") == 2);
    REQUIRE(rig.renderer->setFeature("quality", "off").ok());
    CHECK(rig.value("samples") == 4);
    CHECK(rig.value("edge") == 0.5f);
    CHECK(rig.value("radius") == 2);
}

TEST_CASE("What was set by hand after a level stands over it, after a reload too")
{
    LevelRig rig;
    REQUIRE(rig.renderer->setFeature("quality", "high").ok());
    REQUIRE(rig.renderer->setFeature("soft", "false").ok());
    REQUIRE(rig.renderer->setParam("samples", 5.0f).ok());
    REQUIRE(rig.renderer->reload(LevelRig::description(), {rig.renderer->plan().extent}).ok());
    CHECK(rig.feature("soft") == 0);
    CHECK(rig.value("samples") == 5);
    CHECK(rig.value("edge") == 0.25f);  // of the level
}

TEST_CASE("A level that the device cannot run is a warning first, and an error when it is set")
{
    Rig rig;
    rig.device.clearLog();
    Description description = LevelRig::description(R"({"resolution": 1})");
    for (FeatureDesc& feature : description.features)
        for (FeatureDesc::Level& level : feature.sets)
            for (FeatureDesc::Setting& each : level.settings)
                if (level.name == "high" && each.name == "resolution") each.value[0] = 1e6f;
    const auto made = Renderer::create(rig.device, description, {{64, 32}}, traitsOf(rig.frame));
    REQUIRE(made.ok());
    REQUIRE(made.diagnostics().size() == 1);
    CHECK(made.diagnostics()[0].severity == Severity::warning);
    CHECK(made.diagnostics()[0].message.find("quality 'high': ") == 0);
    CHECK((*made)->setFeature("quality", "off").ok());
    CHECK_FALSE((*made)->setFeature("quality", "high").ok());
    CHECK(findNamed((*made)->description().features, "quality")->value == 0);
}
