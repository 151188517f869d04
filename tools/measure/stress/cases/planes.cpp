// SPDX-License-Identifier: MIT
// Stress cases on flat planes, of which the occlusion is known: none.
#include "tools/measure/stress/cases/all.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr double kPlaneRadius = 0.5;  // scene units
constexpr double kDistance = 5.0;     // from the eye to the plane

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

/// From as far as shows the plane as large as ever.
StressShot planeZoom(double degrees, Extent size)
{
    StressView view;
    view.fov_degrees = degrees;
    const double distance =
        kDistance * std::tan(glm::radians(22.5)) / std::tan(glm::radians(degrees / 2));
    view.near_distance = distance / 10;
    view.far_distance = distance * 10;
    return planeShot(view, size, distance, degrees > 120 ? 0 : 20);
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

StressShot planeRadius(double sizes, Extent size)
{
    StressShot shot = planeShot({}, size, kDistance, 40);
    shot.radius = sizes * kDistance;
    return shot;
}

StressShot planeRadiusPixels(double pixels, Extent size)
{
    StressShot shot = planeShot({}, size, kDistance, 40);
    shot.radius = pixels * 2 * kDistance * std::tan(glm::radians(22.5)) / size.height;
    return shot;
}

StressShot planeSamples(double samples, Extent size)
{
    StressShot shot = planeShot({}, sizeForTaps(samples, size), kDistance, 60);
    shot.samples = static_cast<int>(samples);
    return shot;
}

StressShot planeUnits(double scale, Extent size)
{
    StressView view;
    view.near_distance *= scale;
    view.far_distance *= scale;
    StressShot shot = planeShot(view, size, kDistance * scale, 40);
    shot.radius = kPlaneRadius * scale;
    return shot;
}

StressShot planeShape(double kind, Extent) { return planeShot({}, shapeOf(kind), kDistance, 40); }

/// Without strips of one pixel's width, whose fields of view leave no angle for an answer.
std::vector<StressStep> usualShapes()
{
    std::vector<StressStep> all;
    for (const StressStep& shape : shapes())
        if (const Extent size = shapeOf(shape.value); std::max(size.width, size.height) < 2048)
            all.push_back(shape);
    return all;
}

}  // namespace

std::vector<StressCase> planeCases()
{
    using E = Expectation;
    using L = Likelihood;
    using Q = Quantity;
    return {
        told({"plane_near_far", "A plane at distance 5 between ever farther near and far planes.",
              "near:far", nearFarSteps(), 1, E::open, 0, true, planeNearFar},
             {L::many, "near planes at centimetres and far ones at kilometres are common", "",
              kWideNearFar, kNarrowNearFar}),
        told({"plane_distance", "A plane at ever other distances, between 0.1 and 1e4.",
              "scene units", steps({0.2, 0.5, 1, 2, 5, 20, 100, 500, 2000}), 4, E::open, 0, true,
              planeDistance},
             {L::many,
              "landscapes reach thousands of radii away",
              "",
              {"farther than {} radii away", Q::value, 2},
              {"nearer than {} radii", Q::value, 2}}),
        told({"plane_fov", "A plane at distance 5, seen through other angles.", "degrees",
              steps({1, 5, 15, 45, 90, 120, 150, 170}), 3, E::open, 0, true, planeFieldOfView},
             {L::many, "players may set the field of view, and headsets need a wide one", "",
              kWideField, kNarrowField}),
        told({"plane_zoom", "The same, from as far as shows it equally large.", "degrees",
              steps({1, 5, 15, 45, 90, 120, 150, 170}), 3, E::open, 0, true, planeZoom},
             {L::few, "long lenses from far away are for scopes and films",
              "a plane of one size on screen", kWideField, kNarrowField}),
        told({"plane_grazing", "A plane turned away from the camera.", "degrees",
              steps({0, 30, 60, 75, 80, 85, 87, 89}), 1, E::open, 0, true, planeGrazing},
             {L::every,
              "floors run to the horizon",
              "",
              {"more than {} degrees off facing the camera"},
              {"less than {} degrees off facing the camera"}}),
        told({"plane_orthographic", "The same in an orthographic view.", "degrees",
              steps({0, 30, 60, 75, 80, 85, 89}), 1, E::open, 0, true, planeOrthographic},
             {L::few,
              "editors and strategy games have orthographic views",
              "a plane in an orthographic view",
              {"more than {} degrees off facing the camera"},
              {"less than {} degrees off facing the camera"}}),
        told({"plane_radius", "A plane under radii in sizes of the scene.", "scene sizes",
              decades(-9, 3), 8, E::open, 0, true, planeRadius},
             {L::few,
              "radii lie between a hundredth of the distance and all of it",
              "",
              kTallRadius,
              {"where the radius is shorter than {} of the distance"}}),
        told({"plane_radius_px", "A plane under radii in pixels.", "pixels",
              steps({0, 0.01, 0.1, 0.5, 1, 2, 5, 20, 100, 1000}), 7, E::open, 0, true,
              planeRadiusPixels},
             {L::every, "the same radius has few pixels far away and many close by", "",
              kTallRadius, kSmallRadius}),
        told({"plane_samples", "A plane by few and many depth taps a pixel; -1 is the most.",
              "taps", taps({1, 2, 4, 8, 16, 32, 64, 128, -1}), 4, E::open, 0, false, planeSamples},
             {L::many, "low levels of quality take few taps", "", kManyTaps, kFewTaps}),
        told({"plane_units", "A plane in other units: all lengths times a factor.", "units",
              decades(-6, 6), 6, E::open, 0, false, planeUnits},
             {L::many, "hosts count in centimetres, metres or kilometres", "", kLargeUnits,
              kSmallUnits}),
        told({"plane_sizes", "A plane in pictures of other sizes.", "", usualShapes(), 0, E::open,
              0, false, planeShape},
             {L::few, "windows are rarely that small", "", kPictureSize}),
    };
}

}  // namespace crevice
