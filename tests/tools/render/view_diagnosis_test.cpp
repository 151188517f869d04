// SPDX-License-Identifier: MIT
// What `render` says about a picture that shows no ambient occlusion.
#include "tools/render/view_diagnosis.h"

#include "core/base/text.h"
#include "core/config/values.h"
#include "tests/support/need.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/show/plan/planning.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cstdlib>

using namespace crevice;

namespace {

constexpr Extent kExtent = {960, 540};

// A square of side `size` that faces the camera from `distance` away.
Scene square(double size, double distance)
{
    Scene scene;
    const float s = static_cast<float>(size / 2);
    MeshDesc mesh;
    mesh.vertices = {{{-s, -s, 0}}, {{s, -s, 0}}, {{s, s, 0}}, {{-s, s, 0}}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes = {mesh};
    scene.instances = {{0, glm::translate(glm::dmat4(1), {0, 0, -distance}), 0}};
    return scene;
}

Camera cameraOf(const Scene& scene, const SceneCamera& camera = {})
{
    return {camera.view_from_world, clipFromView(camera, kExtent, scene.bounds())};
}

Scene scaled(Scene scene, double scale)
{
    for (SceneInstance& instance : scene.instances)
        instance.world_from_model =
            glm::scale(glm::dmat4(1), glm::dvec3(scale)) * instance.world_from_model;
    return scene;
}

// What is said of the config in the scene, framed, at that radius; 0 leaves the config's own.
Diagnostics saidOf(const Scene& scene, const std::string& set, const Image* ao = nullptr,
                   const char* config = "gtao")
{
    LoadRequest request = {config};
    if (!set.empty()) request.overrides = {set};
    Description description =
        need(decode(need(loadConfig(shippedSources(), request)), shippedSources()));
    CompileOptions options;
    options.extent = kExtent;
    const Plan plan = need(compile(description, usualTraits(), usualCaps(), options));
    const SceneCamera camera = frameScene(scene, double(kExtent.width) / kExtent.height);
    const glm::dvec3 eye = glm::inverse(camera.view_from_world)[3];
    const double distance = glm::length(eye - scene.bounds().center());
    Frame frame;
    frame.camera = cameraOf(scene, camera);
    frame.scale = {scene.bounds().diagonal(), distance};
    for (ParamDesc& param : description.params)
        param.value = sceneUnits(param, traitsOf(frame), kExtent.height);
    return checkView(description, plan, scene, cameraOf(scene, camera), distance, ao);
}

// The one thing of them.
Diagnostic only(const Diagnostics& said, Code code)
{
    const Diagnostic warning = onlyWarning(said, code);
    CHECK_FALSE(warning.help.empty());
    return warning;
}

Scene spheres() { return need(loadScene("spheres")); }

}  // namespace

TEST_CASE(
    "a radius for another scale is reported with one that fits, which then is not remarked on")
{
    CHECK(saidOf(spheres(), "").empty());
    for (const double scale : {1e-3, 1e-2, 1e2, 1e3}) {
        const Scene scene = scaled(spheres(), scale);
        const Diagnostic warning = only(saidOf(scene, ""), Code::out_of_range);
        const std::size_t at = warning.help.find("radius=");
        REQUIRE(at != std::string::npos);
        CHECK(saidOf(scene, warning.help.substr(at)).empty());
    }
}

TEST_CASE("ambient occlusion that is 1 everywhere is reported with its cause, unless all is flat")
{
    const Image open(kExtent, 1, 1.0f);
    only(saidOf(spheres(), "", &open), Code::output_constant);
    only(saidOf(scaled(spheres(), 1e3), "", &open), Code::output_constant);
    const Diagnostics off = saidOf(spheres(), "intensity=0", &open);
    CHECK(has(only(off, Code::output_constant).help, "intensity"));
    CHECK(saidOf(square(10, 0), "", &open).empty());
    Image some = open;
    some.pixels.back() = 0.5f;
    CHECK(saidOf(spheres(), "", &some).empty());
}

TEST_CASE("a radius of few pixels of occlusion at half the size is reported, with the full size")
{
    CHECK(saidOf(spheres(), "radius=0.2", nullptr, "gtao").empty());
    CHECK(saidOf(spheres(), "", nullptr, "balanced").empty());
    const Diagnostics said = saidOf(spheres(), "radius=0.2", nullptr, "balanced");
    CHECK(has(only(said, Code::out_of_range).help, "ao_scale=1"));
}

TEST_CASE("a radius of 0 is 0 pixels")
{
    CHECK_FALSE(has(only(saidOf(spheres(), "radius=0"), Code::output_constant).message, "nan"));
}

TEST_CASE("a camera that sees nothing is reported with one that does")
{
    const Scene scene = square(1, -5);
    Plan plan;
    plan.extent = kExtent;
    const auto found = checkView(Description(), plan, scene, cameraOf(scene), {}, nullptr);
    CHECK(has(only(found, Code::nothing_seen).help, "eye="));
}
