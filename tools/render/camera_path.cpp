// SPDX-License-Identifier: MIT
#include "tools/render/camera_path.h"

#include "core/base/text.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace crevice {
namespace {

/// What a pixel in the middle of the picture covers at distance 1, or anywhere in an orthographic
/// view.
double pixelOf(const PathView& view)
{
    const SceneCamera& camera = view.camera;
    const double half = camera.orthographic ? camera.half_height : std::tan(camera.fov_y_rad / 2);
    return 2 * half / view.extent.height;
}

/// From view space to that of the camera after it has turned so often.
glm::dmat4 turned(const PathView& view, const CameraPath& path, int times)
{
    const double right = path.turn_px[0] * pixelOf(view), up = path.turn_px[1] * pixelOf(view);
    if (view.camera.orthographic)
        return glm::translate(glm::dmat4(1.0), {-right * times, -up * times, 0.0});
    const glm::dmat4 pitch = glm::rotate(glm::dmat4(1.0), -std::atan(up) * times, {1, 0, 0});
    return glm::rotate(pitch, std::atan(right) * times, {0, 1, 0});
}

glm::dmat4 moved(const PathView& view, double right_px)
{
    const double distance = view.camera.orthographic ? 1.0 : view.distance;
    return glm::translate(glm::dmat4(1.0), {-right_px * pixelOf(view) * distance, 0.0, 0.0});
}

}  // namespace

Result<CameraPath> findCameraPath(const std::string& name)
{
    std::vector<std::string> names;
    for (const CameraPath& path : kCameraPaths) {
        if (name == path.name) return path;
        names.push_back(path.name);
    }
    return Diagnostic{Code::usage, "there is no camera path '" + name + "'",
                      suggestName(name, names, "camera paths")};
}

SceneCamera cameraAt(const CameraPath& path, const PathView& view, int frame, int frames)
{
    const int left = frames - 1 - frame;
    const int after = std::clamp(frames / 2, 1, kFramesAfterJump);
    const double aside = left >= after ? path.aside_px : 0.0;
    SceneCamera camera = view.camera;
    camera.view_from_world = moved(view, -left * path.step_px - aside) * turned(view, path, -left) *
                             camera.view_from_world;
    return camera;
}

}  // namespace crevice
