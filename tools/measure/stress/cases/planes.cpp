// SPDX-License-Identifier: MIT
// Stress cases on flat planes, of which the occlusion is known: none.
#include "tools/measure/stress/cases/all.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace crevice {
namespace {

constexpr double kDistance = 5.0;  // from the eye to the plane

StressShot planeNearFar(double power, Extent size)
{
    return planeShot(nearFarView(power), size, kDistance, 40);
}

StressShot planeDistance(double distance, Extent size)
{
    StressView view;
    view.far_distance = 1e4;
    return planeShot(view, size, distance, 40);
}

StressShot planeFieldOfView(double degrees, Extent size)
{
    StressView view;
    view.fov_degrees = degrees;
    return planeShot(view, size, kDistance, 20);
}

StressShot planeGrazing(double degrees, Extent size)
{
    return planeShot({}, size, kDistance, degrees);
}

StressShot planeOrthographic(double degrees, Extent size)
{
    StressView view;
    view.half_height = 2;
    return planeShot(view, size, 20, degrees);
}

StressShot planeRadiusPixels(double pixels, Extent size)
{
    StressShot shot = planeShot({}, size, kDistance, 40);
    shot.radius = pixels * 2 * kDistance * std::tan(glm::radians(22.5)) / size.height;
    return shot;
}

StressShot planeSamples(double samples, Extent size)
{
    StressShot shot = planeShot({}, size, kDistance, 60);
    shot.samples = static_cast<int>(samples);
    return shot;
}

}  // namespace

std::vector<StressCase> planeCases()
{
    using E = Expectation;
    return {
        {"plane_near_far", "A plane at distance 5 between ever farther near and far planes.",
         "near:far", nearFarSteps(), 1, E::open, planeNearFar, kWideNearFar, kNarrowNearFar},
        {"plane_distance",
         "A plane at ever other distances, between 0.1 and 1e4, under a radius of 0.5.",
         "scene units", steps({0.2, 0.5, 1, 2, 5, 20, 100, 500, 2000}), 4, E::open, planeDistance,
         "farther than {} scene units away", "nearer than {} scene units"},
        {"plane_fov", "A plane at distance 5, seen through other angles.", "degrees",
         steps({1, 5, 15, 45, 90, 120, 150, 170}), 3, E::open, planeFieldOfView,
         "where the field of view is wider than {} degrees",
         "where the field of view is narrower than {} degrees"},
        {"plane_grazing", "A plane turned away from the camera.", "degrees",
         steps({0, 30, 60, 75, 80, 85, 87, 89}), 1, E::open, planeGrazing, kTurned, kFacing},
        {"plane_orthographic", "The same in an orthographic view.", "degrees",
         steps({0, 30, 60, 75, 80, 85, 89}), 1, E::open, planeOrthographic, kTurned, kFacing},
        {"plane_radius_px", "A plane under radii in pixels.", "pixels",
         steps({0, 0.01, 0.1, 0.5, 1, 2, 5, 20, 100, 1000}), 7, E::open, planeRadiusPixels,
         kTallRadius, kSmallRadius},
        {"plane_samples", "A plane by few and many depth taps a pixel.", "taps",
         steps({1, 2, 4, 8, 16, 32, 64, 128}), 4, E::open, planeSamples, kManyTaps, kFewTaps},
    };
}

}  // namespace crevice
