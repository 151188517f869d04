// SPDX-License-Identifier: MIT
// Reloading an edited config: all or nothing, with what was set at run time, and without compiling
// what is there.
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

CompileOptions options(const Rig& rig) { return {rig.renderer->plan().extent}; }

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
    CHECK(rig.device.misuse().empty());
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
    CHECK(rig.device.misuse().empty());
}
