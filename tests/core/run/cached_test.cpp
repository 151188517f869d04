// SPDX-License-Identifier: MIT
// Frames that change little: which passes the renderer runs again, on the recording device.
#include "tests/support/need.h"
#include "tests/support/renderer_rig.h"

#include <functional>

using namespace crevice;

namespace {

std::string passesOf(Rig& rig)
{
    rig.draw();
    std::string passes;
    for (const char* name : {"geometry", "occlusion", "filter", "lighting"})
        if (rig.ranPass(name)) passes += std::string(passes.empty() ? "" : " ") + name;
    return passes;
}

const char* const kAll = "geometry occlusion filter lighting";

}  // namespace

TEST_CASE("A moving light runs the lighting alone")
{
    Rig rig;
    rig.draw();
    for (int i = 0; i < 3; ++i) {
        rig.frame.lights[0].position.x += 1;
        CHECK(passesOf(rig) == "lighting");
    }
    rig.frame.ambient_light.x = 0.5f;
    CHECK(passesOf(rig) == "lighting");
}

TEST_CASE("Another camera, draw or material, or other contents of them, runs all")
{
    Rig rig;
    const auto after = [&rig](const std::function<void(Frame&)>& change) {
        rig.draw();
        change(rig.frame);
        return passesOf(rig);
    };
    CHECK(after([](Frame& frame) { frame.camera.view_from_world[3][0] = 1; }) == kAll);
    CHECK(after([](Frame& frame) { frame.camera.clip_from_view[0][0] = 2; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws[0].world_from_model[3][1] = 1; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws[0].count = 3; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws.push_back(frame.draws[0]); }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].base_color.y = 0.5f; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].shininess = 3; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].ambient = 0.5f; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].ambient = 0.25f; }) == kAll);
    CHECK(after([](Frame& frame) { ++frame.revision; }) == kAll);
    CHECK(after([](Frame&) {}).empty());
}

TEST_CASE(
    "A host's texture runs its readers when it or its revision is another, and without one always")
{
    Rig rig;
    const TextureId decal = rig.device.createTexture({"decal", Format::rgba8, {4, 4}}).value();
    REQUIRE(rig.device.writeTexture(decal, Image({4, 4}, 4, 1.0f)));
    rig.draw();
    rig.frame.textures = {{"decal", decal, 7}};
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
    rig.frame.textures[0].revision = 8;
    CHECK(passesOf(rig) == "lighting");
    const TextureId other = rig.device.createTexture({"decal", Format::rgba8, {4, 4}}).value();
    REQUIRE(rig.device.writeTexture(other, Image({4, 4}, 4, 0.5f)));
    rig.frame.textures[0].texture = other;
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
    rig.frame.textures[0].revision = 0;
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig) == "lighting");
    rig.frame.textures.clear();
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
}

TEST_CASE("A new size, a new plan and a frame that failed run all")
{
    Rig rig;
    rig.draw();
    REQUIRE(rig.renderer->resize({32, 32}));
    CHECK(passesOf(rig) == kAll);
    rig.frame.lights[0].position.x += 1;
    rig.device.failFrame();
    CHECK_FALSE(rig.renderer->render(rig.frame));
    CHECK(passesOf(rig) == kAll);
    REQUIRE(rig.renderer->setParam("samples", 9));
    CHECK(passesOf(rig) == kAll);
}

TEST_CASE("Timed frames and those of a plan that keeps the optimization off run every pass")
{
    Rig rig;
    rig.draw();
    rig.device.clearLog();
    REQUIRE(rig.renderer->renderTimed(rig.frame));
    CHECK(rig.ranPass("geometry"));
    CHECK(passesOf(rig).empty());
    CompileOptions options{{64, 32}};
    options.disable = {"cached"};
    auto kept = Renderer::create(rig.device, rigDescription(), options, traitsOf(rig.frame));
    REQUIRE(kept);
    rig.renderer = std::move(*kept);
    CHECK(passesOf(rig) == kAll);
    CHECK(passesOf(rig) == kAll);
}
