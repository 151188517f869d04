// SPDX-License-Identifier: MIT
// Built-in camera paths: where they end, and how far what is seen moves from frame to frame.
#include "tools/render/camera_path.h"

#include "tests/support/need.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

constexpr int kFrames = 32;

PathView view(bool orthographic)
{
    PathView view;
    view.extent = {200, 100};
    view.distance = 6.0;
    view.camera.view_from_world =
        glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0));
    view.camera.orthographic = orthographic;
    view.camera.half_height = 2.0;
    view.camera.near_distance = 0.1;
    view.camera.far_distance = 100.0;
    return view;
}

/// The pixel at which a frame sees a point that the last one has in its view space.
glm::dvec2 seen(const PathView& view, const CameraPath& path, int frame, const glm::dvec3& point,
                int frames = kFrames)
{
    const SceneCamera camera = cameraAt(path, view, frame, frames);
    const glm::dvec4 clip = glm::dmat4(clipFromView(camera, view.extent, {})) *
                            camera.view_from_world * glm::inverse(view.camera.view_from_world) *
                            glm::dvec4(point, 1.0);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) *
           glm::dvec2(view.extent.width, view.extent.height);
}

/// Pixels that the point has moved in the last frame.
glm::dvec2 movedBy(const PathView& view, const char* path, const glm::dvec3& point)
{
    const CameraPath found = need(findCameraPath(path));
    return seen(view, found, kFrames - 1, point) - seen(view, found, kFrames - 2, point);
}

void checkMoved(const glm::dvec2& moved, double right, double up)
{
    CHECK(moved.x == Approx(right).margin(0.02));
    CHECK(moved.y == Approx(up).margin(0.002));
}

}  // namespace

TEST_CASE("camera paths move the middle of the picture by their pixels a frame")
{
    for (const bool orthographic : {false, true}) {
        const PathView end = view(orthographic);
        const glm::dvec3 middle(0, 0, -6), near(0, 0, -3);
        checkMoved(movedBy(end, "still", middle), 0, 0);
        checkMoved(movedBy(end, "pan", middle), -5, 0);
        checkMoved(movedBy(end, "pan", near), -5, 0);
        checkMoved(movedBy(end, "strafe", middle), -3, 0);
        checkMoved(movedBy(end, "strafe", near), orthographic ? -3 : -6, 0);
        CHECK(glm::length(movedBy(end, "sub-pixel", middle)) == Approx(0.15).margin(0.001));
        CHECK(movedBy(end, "sub-pixel", middle).y < -0.05);
    }
}

TEST_CASE("the path that uncovers jumps once, sixteen frames before its end or halfway")
{
    const PathView end = view(false);
    const CameraPath path = need(findCameraPath("disocclusion"));
    const glm::dvec3 middle(0, 0, -6);
    for (const auto& [frames, jump] : {std::pair(32, 16), {100, 84}, {10, 5}, {2, 1}})
        for (int frame = 0; frame < frames; ++frame) {
            INFO(frame << " of " << frames);
            const double at = seen(end, path, frame, middle, frames).x;
            CHECK(at == Approx(frame < jump ? 132 : 100).margin(0.01));
        }
}
