// SPDX-License-Identifier: MIT
#include "tools/render/stereo.h"

#include <CLI/CLI.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

void addStereoOptions(CLI::App& app, StereoOptions& options)
{
    CLI::Option* stereo = app.add_option("--stereo", options.separation,
                                         "Draw two eyes this far apart, in scene units, and write "
                                         "them side by side, left eye first")
                              ->type_name("SEPARATION")
                              ->check(CLI::PositiveNumber);
    app.add_option(
           "--convergence", options.convergence,
           "Distance at which both eyes see the same picture, in scene units. Default: infinite")
        ->type_name("DISTANCE")
        ->check(CLI::PositiveNumber)
        ->needs(stereo);
}

SceneCamera eyeCamera(const SceneCamera& camera, double offset, double convergence, double aspect)
{
    SceneCamera eye = camera;
    const glm::dmat4 eye_from_view = glm::translate(glm::dmat4(1.0), {-offset, 0.0, 0.0});
    eye.view_from_world = eye_from_view * camera.view_from_world;
    // The window that the camera sees at that distance is the one that the eye sees.
    const double width = 2.0 * convergence * std::tan(camera.fov_y_rad / 2.0) * aspect;
    if (convergence > 0.0) eye.shift.x -= offset / width;
    return eye;
}

Result<std::vector<SceneCamera>> eyeCameras(const SceneCamera& camera, const StereoOptions& options,
                                            double aspect)
{
    if (options.separation <= 0.0) return std::vector<SceneCamera>{camera};
    if (camera.orthographic) {
        Diagnostic error{
            Code::usage,
            "--stereo needs a perspective camera: in an orthographic one both eyes see "
            "the same"};
        error.help = "choose a perspective --camera, such as 'eye=4,2,6;fov=50'";
        return error;
    }
    std::vector<SceneCamera> eyes;
    for (const double side : {-0.5, 0.5})
        eyes.push_back(eyeCamera(camera, side * options.separation, options.convergence, aspect));
    return eyes;
}

Image sideBySide(const Image& left, const Image& right)
{
    Image both({2 * left.extent.width, left.extent.height}, left.channels);
    const auto row = static_cast<std::ptrdiff_t>(left.extent.width) * left.channels;
    auto to = both.pixels.begin();
    for (int y = 0; y < left.extent.height; ++y)
        for (const Image* eye : {&left, &right})
            to = std::copy_n(eye->pixels.begin() + y * row, row, to);
    return both;
}

}  // namespace crevice
