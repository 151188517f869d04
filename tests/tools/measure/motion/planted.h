// SPDX-License-Identifier: MIT
// Surfaces and cameras that tests of motion know in closed form: a wall at z = 0, and perhaps a box
// in front of it, seen by orthographic cameras of one pixel a unit.
#pragma once

#include "tools/measure/motion/figures.h"
#include "tools/measure/motion/flow.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice {

constexpr Extent kPlanted = {40, 24};

/// Looks along -z at (x + 20, y + 12), pixels from the lower left corner.
inline Camera plantedCamera(double x, double y)
{
    Camera camera;
    camera.view_from_world = glm::translate(glm::dmat4(1.0), {-x - 20, -y - 12, -10});
    camera.clip_from_view =
        glm::ortho<float>(-20, 20, -12, 12, 1, 30);  // a pixel is a unit of the world
    return camera;
}

/// Left edge of the front of a box at z = 5, from there to the right; none by default.
inline SurfaceMap plantedSurfaces(double x, double y, double box = 1e9)
{
    SurfaceMap map{kPlanted, {}};
    for (int row = 0; row < kPlanted.height; ++row)
        for (int column = 0; column < kPlanted.width; ++column) {
            const double at = x + column + 0.5;
            map.points.push_back({{at, y + row + 0.5, at < box ? 0.0 : 5.0}, {0, 0, 1}, true});
        }
    return map;
}

/// A picture of what `value` has in each pixel.
inline Image plantedImage(const std::function<double(int x, int y)>& value)
{
    Image image(kPlanted, 1);
    for (int y = 0; y < kPlanted.height; ++y)
        for (int x = 0; x < kPlanted.width; ++x) image.at(x, y) = static_cast<float>(value(x, y));
    return image;
}

/// What the surfaces have at world coordinates.
inline Image plantedImage(const SurfaceMap& map, const std::function<double(glm::dvec3)>& value)
{
    return plantedImage([&](int x, int y) { return value(map.at(x, y).position); });
}

/// Of a walk along the wall by `step` a frame; the truth is `value` there.
inline PathTruth plantedTruth(int frames, double step,
                              const std::function<double(glm::dvec3)>& value)
{
    PathTruth truth;
    for (int frame = 0; frame < frames; ++frame) {
        const SurfaceMap map = plantedSurfaces(step * frame, 0);
        truth.frames.push_back(plantedImage(map, value));
        if (frame + 1 == frames) break;
        const double next = step * (frame + 1);
        truth.flows.push_back(flowTo(map, plantedSurfaces(next, 0), plantedCamera(next, 0)));
    }
    return truth;
}

}  // namespace crevice
