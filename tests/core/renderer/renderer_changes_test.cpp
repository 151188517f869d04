// SPDX-License-Identifier: MIT
// What is set at run time: which values compile shaders.
#include "tests/support/catch.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

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
