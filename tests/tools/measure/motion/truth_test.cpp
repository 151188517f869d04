// SPDX-License-Identifier: MIT
// The ray-traced truth of camera paths: its noise, its surfaces, and what it keeps.
#include "tools/measure/motion/truth.h"

#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/reference/tracer_shot.h"
#include "tools/measure/motion/flow.h"

using namespace crevice;

namespace {

constexpr Extent kSmall = {32, 18};

/// A slope in a corner, and a fence whose pale hides what is behind it from another place.
Scene cornerScene()
{
    return sceneOf({kFloor, kWall, makeQuad({-20, 0, 10}, {40, 0, 0}, {0, 20, -10}),
                    makeQuad({-8, 0, 25}, {16, 0, 0}, {0, 20, 0})});
}

MotionView viewOf(const Scene& scene)
{
    SceneCamera camera;
    camera.view_from_world =
        glm::lookAt(glm::dvec3(30, 40, 60), glm::dvec3(0, 5, 0), glm::dvec3(0, 1, 0));
    return {scene, scene.bounds(), {camera, kSmall, 70.0}, 10.0, ""};
}

/// Rms of what the truth's change along the path's last step has for noise, against many rays.
double noiseOf(const MotionView& view, const char* name)
{
    const CameraPath path = need(findCameraPath(name));
    const Camera first = view.camera(path, kMotionFrames - 2);
    const Camera last = view.camera(path, kMotionFrames - 1);
    const Image flow = flowTo(need(traceSurfaces(view.scene, first, kSmall)),
                              need(traceSurfaces(view.scene, last, kSmall)), last);
    const auto change = [&](int rays) {
        return changeAlong(flow, trace(view.scene, first, kSmall, view.radius, rays),
                           trace(view.scene, last, kSmall, view.radius, rays));
    };
    const Image few = change(kMotionRays);
    CHECK(std::count_if(few.pixels.begin(), few.pixels.end(),
                        [](float value) { return !std::isnan(value); }) > 300);
    return rmsDifference(few, change(8 * kMotionRays));
}

}  // namespace

TEST_CASE("the noise of the truth's change is below 0.002")
{
    const Scene scene = cornerScene();
    const MotionView view = viewOf(scene);
    for (const char* path : {"sub-pixel", "pan"}) {
        INFO(path);
        const double noise = noiseOf(view, path);
        CAPTURE(noise);
        CHECK(noise > 0.0);
        CHECK(noise < 0.002);
    }
}

TEST_CASE("the truth of all paths is traced once and then kept")
{
    const TemporaryFolder folder("motion_truth");
    const Scene scene = cornerScene();
    MotionView view = viewOf(scene);
    view.cache_folder = folder.path.string();
    const auto never = [] { return false; };
    const MotionTruth first = need(traceMotion(view, never));
    REQUIRE(first.paths.size() == std::size(kCameraPaths) - 1);
    for (const auto& [name, truth] : first.paths) {
        INFO(name);
        CHECK(truth.frames.size() == kMeasuredFrames);
        CHECK(truth.flows.size() == kMeasuredFrames - 1);
        CHECK(truth.frames.back().pixels.size() == first.rest.pixels.size());
    }
    const auto files = [&folder] {
        return std::distance(std::filesystem::directory_iterator(folder.path), {});
    };
    CHECK(files() ==
          1 + 3 * (kMeasuredFrames - 1));  // the end, and what sub-pixel, pan, strafe add
    need(traceMotion(view, never));
    CHECK(files() == 1 + 3 * (kMeasuredFrames - 1));
    CHECK(first.uncovered.extent == kSmall);
}
