// SPDX-License-Identifier: MIT
// Reloading an edited config: all or nothing, with what was set at run time, and without compiling
// what is there.
// What is set at run time: which values compile shaders.
// Levels of quality, switched while a config runs: nothing compiles then.
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

CompileOptions options(const Rig& rig) { return {rig.renderer->plan().extent}; }

bool compiles(Rig& rig, const Status& status)
{
    const bool reported = findDiagnostic(status.diagnostics(), Code::recompiled) != nullptr;
    CHECK(status.ok());
    CHECK(rig.logged("createProgram") == reported);  // nothing in silence, nothing made up
    rig.device.clearLog();
    return reported;
}

bool setCompiles(Rig& rig, const char* name, float value)
{
    rig.device.clearLog();
    return compiles(rig, rig.renderer->setParam(name, value));
}

/// The rig with a feature `quality` of which each word compiles shaders of its own.
struct LevelRig : Rig {
    LevelRig() { use(description()); }

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

TEST_CASE("A reload of what cannot be planned leaves the old plan, its values and its pictures")
{
    Rig rig;
    const TextureId before = rig.renderer->output("color");
    Description broken = rigDescription();
    broken.outputs.clear();
    CHECK_FALSE(rig.renderer->reload(std::move(broken), options(rig)).ok());
    CHECK(rig.renderer->output("color").value == before.value);
    CHECK(rig.renderer->description().outputs.size() == 2);
}

TEST_CASE("What was set at run time outlives a reload, and what was not follows the file")
{
    Rig rig;
    REQUIRE(rig.renderer->setParam("radius", 2.0f).ok());
    REQUIRE(rig.renderer->setFeature("look", "flat").ok());
    Description edited = rigDescription();
    for (ParamDesc& param : edited.params) {
        if (param.name == "radius") param.value[0] = 9;
        if (param.name == "taps") param.value[0] = 5;
    }
    const Status status = rig.renderer->reload(edited, options(rig));
    REQUIRE(status.ok());
    CHECK(status.diagnostics().empty());
    CHECK(rig.value("radius") == 2);
    CHECK(rig.value("taps") == 5);
    CHECK(rig.feature("look") == 1);

    // Against the file as it is now: back at its value is no change.
    REQUIRE(rig.renderer->setParam("radius", 9.0f).ok());
    REQUIRE(rig.renderer->setFeature("look", "lit").ok());
    REQUIRE(rig.renderer->reload(rigDescription(), options(rig)).ok());
    CHECK(rig.value("radius") == Rig().value("radius"));
}

TEST_CASE("A value that the edited config has no place for is reported, and the rest is kept")
{
    Rig rig;
    REQUIRE(rig.renderer->setParam("radius", 50.0f).ok());
    REQUIRE(rig.renderer->setParam("taps", 7.0f).ok());
    REQUIRE(rig.renderer->setFeature("look", "flat").ok());
    Description edited = rigDescription();
    for (ParamDesc& param : edited.params)
        if (param.name == "radius") param.max = 10;
    for (FeatureDesc& feature : edited.features)
        if (feature.name == "look") feature.values[1] = "wire";
    const Status status = rig.renderer->reload(edited, options(rig));
    REQUIRE(status.ok());
    REQUIRE(status.diagnostics().size() == 2);
    for (const Diagnostic& each : status.diagnostics()) {
        CHECK(each.code == Code::value_dropped);
        CHECK(each.severity == Severity::warning);
    }
    CHECK(rig.value("radius") == 0.5f);
    CHECK(rig.value("taps") == 7);
}

TEST_CASE("A config that ran before comes back without compiling a shader")
{
    Rig rig;
    Description other = rigDescription();
    for (FeatureDesc& feature : other.features)
        if (feature.name == "look") feature.value = 1;
    rig.device.clearLog();
    REQUIRE(rig.renderer->reload(other, options(rig)).ok());
    CHECK(rig.logged("createProgram"));
    rig.device.clearLog();
    REQUIRE(rig.renderer->reload(rigDescription(), options(rig)).ok());
    REQUIRE(rig.renderer->reload(other, options(rig)).ok());
    CHECK_FALSE(rig.logged("createProgram"));
}

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

TEST_CASE("Programs that nobody needs are kept only so long")
{
    Rig rig;
    for (int samples = 1; samples <= 64; ++samples)
        REQUIRE(rig.renderer->setParam("samples", static_cast<float>(samples)).ok());
    CHECK(rig.device.live(ObjectId::Kind::program) <= 4 + 32);
    CHECK(setCompiles(rig, "samples", 1.0f));
    rig.renderer.reset();
    CHECK(rig.device.live(ObjectId::Kind::program) == 0);
}

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
    REQUIRE(made.diagnostics().size() == 1);
    CHECK(made.diagnostics()[0].severity == Severity::warning);
    CHECK(made.diagnostics()[0].message.find("quality 'high': ") == 0);
    CHECK((*made)->setFeature("quality", "off").ok());
    CHECK_FALSE((*made)->setFeature("quality", "high").ok());
    CHECK(findNamed((*made)->description().features, "quality")->value == 0);
}
