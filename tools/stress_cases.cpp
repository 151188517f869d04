// SPDX-License-Identifier: MIT
// The table of stress cases.
#include "tools/stress_case.h"

#include "tools/stress_scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr double kRadius = 0.5;    // of most cases, scene units
constexpr double kDistance = 5.0;  // from the eye to the plane
constexpr double kYardFarthest = 9.0;
const glm::dvec3 kYardEye = {0, 1, 5};

std::string text(double value)
{
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.6g", value);
    return buffer;
}

std::vector<StressStep> steps(std::initializer_list<double> values)
{
    std::vector<StressStep> all;
    for (const double value : values) all.push_back({value, text(value)});
    return all;
}

/// 10^first, 10^(first + stride) and so on to 10^last.
std::vector<StressStep> decades(int first, int last, int stride = 1)
{
    std::vector<StressStep> all;
    for (int power = first; power <= last; power += stride)
        all.push_back({std::pow(10.0, power), "1e" + std::to_string(power)});
    return all;
}

/// Kinds, counted from 0.
std::vector<StressStep> kinds(std::initializer_list<const char*> labels)
{
    std::vector<StressStep> all;
    for (const char* label : labels) all.push_back({static_cast<double>(all.size()), label});
    return all;
}

// Planes

StressShot planeShot(const StressView& view, Extent size, double distance, double tilt_degrees)
{
    PlaneView plane = planeView(view, size, distance, tilt_degrees);
    StressShot shot;
    shot.scene = std::move(plane.scene);
    shot.distances = std::move(plane.distances);
    shot.camera = cameraOf(view, size);
    shot.extent = size;
    shot.radius = kRadius;
    shot.near_distance = view.near_distance;
    shot.far_distance = view.far_distance;
    return shot;
}

StressView nearFar(double power)
{
    StressView view;
    view.near_distance = std::pow(10.0, -power);
    view.far_distance = std::pow(10.0, 1.0 + 1.5 * power);
    return view;
}

const std::vector<StressStep> kNearFar = {
    {0, "1:1e1"}, {1, "0.1:316"}, {2, "0.01:1e4"}, {3, "1e-3:3e5"}, {4, "1e-4:1e7"}};

StressShot planeNearFar(double power, Extent size)
{
    return planeShot(nearFar(power), size, kDistance, 40);
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
    StressShot shot = planeShot({}, size, kDistance, 60);
    shot.samples = static_cast<int>(samples);
    return shot;
}

StressShot planeUnits(double scale, Extent size)
{
    StressView view;
    view.near_distance *= scale;
    view.far_distance *= scale;
    StressShot shot = planeShot(view, size, kDistance * scale, 40);
    shot.radius = kRadius * scale;
    return shot;
}

// A yard with walls, boxes and a sphere

StressShot yardShot(const StressView& view, Extent size, Scene scene = yardScene())
{
    StressShot shot;
    shot.scene = std::move(scene);
    shot.camera = cameraOf(view, size);
    shot.extent = size;
    shot.radius = kRadius;
    shot.farthest = view.eye.z + 4;
    shot.near_distance = view.near_distance;
    shot.far_distance = view.far_distance;
    return shot;
}

StressView yardView()
{
    StressView view;
    view.eye = kYardEye;
    return view;
}

StressShot yardScaled(double scale, Extent size, bool in_vertices)
{
    StressView view = yardView();
    view.eye *= scale;
    view.near_distance *= scale;
    view.far_distance *= scale;
    Scene scene = placed(yardScene(), glm::scale(glm::dmat4(1.0), glm::dvec3(scale)));
    StressShot shot = yardShot(view, size, in_vertices ? baked(scene) : scene);
    shot.radius = kRadius * scale;
    shot.farthest = kYardFarthest * scale;
    return shot;
}

StressShot yardUnits(double scale, Extent size) { return yardScaled(scale, size, false); }
StressShot yardUnitsInVertices(double scale, Extent size) { return yardScaled(scale, size, true); }

/// To a place of whole units, so that a float matrix holds it exactly as long as that can be.
StressShot yardMoved(double radii, Extent size, bool in_vertices)
{
    const double far = radii * kRadius;
    const glm::dvec3 offset = {far, 0, -far};
    StressView view = yardView();
    view.eye += offset;
    Scene scene = placed(yardScene(), glm::translate(glm::dmat4(1.0), offset));
    StressShot shot = yardShot(view, size, in_vertices ? baked(scene) : scene);
    shot.farthest = kYardFarthest;
    return shot;
}

StressShot yardOffset(double radii, Extent size) { return yardMoved(radii, size, false); }
StressShot yardOffsetInVertices(double radii, Extent size) { return yardMoved(radii, size, true); }

StressShot yardNearFar(double power, Extent size)
{
    StressView view = nearFar(power);
    view.eye = kYardEye;
    return yardShot(view, size);
}

StressShot yardProjection(double kind, Extent size)
{
    StressView view = yardView();
    view.reversed = kind == 1 || kind == 3;
    view.infinite = kind >= 2;
    return yardShot(view, size);
}

StressShot yardShift(double pixels, Extent size)
{
    StressView view = yardView();
    view.shift_px = static_cast<int>(pixels) * size.width / 256;
    StressShot shot = yardShot(view, size);
    shot.shift_px = view.shift_px;
    return shot;
}

StressShot yardMirrored(double kind, Extent size)
{
    StressShot shot = yardShot(yardView(), size);
    if (kind == 0) return shot;
    shot.scene = placed(shot.scene, glm::scale(glm::dmat4(1.0), {-1, 1, 1}));
    if (kind == 2) shot.scene = baked(shot.scene);
    shot.mirrored = true;
    return shot;
}

/// From ever farther, with ever less perspective; 0 is the orthographic view.
StressShot yardNarrow(double degrees, Extent size)
{
    constexpr double kHalfHeight = 2;
    StressView view = yardView();
    const double away =
        degrees > 0 ? kHalfHeight / std::tan(glm::radians(degrees / 2)) : 20.0;
    view.eye.z = away;
    view.near_distance = away - 4.5;
    view.far_distance = away + 4.5;
    if (degrees > 0) view.fov_degrees = degrees;
    else view.half_height = kHalfHeight;
    return yardShot(view, size);
}

StressShot yardRadius(double radius, Extent size)
{
    StressShot shot = yardShot(yardView(), size);
    shot.radius = radius;
    return shot;
}

StressShot cornerRadius(double radius, Extent size)
{
    StressView view = yardView();
    view.eye = {0, 1, 4};
    StressShot shot = yardShot(view, size, cornerScene());
    shot.radius = radius;
    return shot;
}

StressShot yardSamples(double samples, Extent size)
{
    StressShot shot = yardShot(yardView(), size);
    shot.samples = static_cast<int>(samples);
    return shot;
}

// Identities, sizes, what is empty

StressShot identity(double kind, Extent size)
{
    StressShot shot = yardShot(yardView(), size);
    const bool no_radius = kind >= 2;
    if (no_radius) shot.radius = 0;
    else shot.settings = {"intensity=0"};
    shot.keep_identities = kind == 1 || kind == 3;
    return shot;
}

struct Shape {
    const char* label;
    Extent size;
};

const Shape kShapes[] = {{"256x144", {256, 144}}, {"1x1", {1, 1}},       {"1x64", {1, 64}},
                         {"64x1", {64, 1}},       {"3x2", {3, 2}},       {"127x93", {127, 93}},
                         {"2048x1", {2048, 1}},   {"1x2048", {1, 2048}}, {"255x144", {255, 144}}};

std::vector<StressStep> shapes()
{
    std::vector<StressStep> all;
    for (const Shape& shape : kShapes) all.push_back({static_cast<double>(all.size()), shape.label});
    return all;
}

StressShot yardShape(double kind, Extent)
{
    return yardShot(yardView(), kShapes[static_cast<int>(kind)].size);
}

StressShot emptyShape(double kind, Extent)
{
    Scene nothing = yardScene();
    nothing.instances.clear();
    nothing.meshes.clear();
    return yardShot(yardView(), kShapes[static_cast<int>(kind)].size, nothing);
}

StressShot planeShape(double kind, Extent)
{
    return planeShot({}, kShapes[static_cast<int>(kind)].size, kDistance, 40);
}

std::vector<StressCase> makeCases()
{
    using E = Expectation;
    return {
        {"plane_near_far", "A plane at distance 5 between ever farther near and far planes.",
         "near:far", kNearFar, 1, E::open, 0, true, planeNearFar},
        {"plane_distance", "A plane at ever other distances, between 0.1 and 1e4.", "scene units",
         steps({0.2, 0.5, 1, 2, 5, 20, 100, 500, 2000}), 4, E::open, 0, true, planeDistance},
        {"plane_fov", "A plane at distance 5, seen through other angles.", "degrees",
         steps({1, 5, 15, 45, 90, 120, 150, 170}), 3, E::open, 0, false, planeFieldOfView},
        {"plane_zoom", "The same, from as far as shows it equally large.", "degrees",
         steps({1, 5, 15, 45, 90, 120, 150, 170}), 3, E::open, 0, false, planeZoom},
        {"plane_grazing", "A plane turned away from the camera.", "degrees",
         steps({0, 30, 60, 75, 80, 85, 87, 89}), 1, E::open, 0, false, planeGrazing},
        {"plane_orthographic", "The same in an orthographic view.", "degrees",
         steps({0, 30, 60, 75, 80, 85, 89}), 1, E::open, 0, false, planeOrthographic},
        {"plane_radius", "A plane under radii in sizes of the scene.", "scene sizes",
         decades(-9, 3), 8, E::open, 0, false, planeRadius},
        {"plane_radius_px", "A plane under radii in pixels.", "pixels",
         steps({0, 0.01, 0.1, 0.5, 1, 2, 5, 20, 100, 1000}), 7, E::open, 0, false,
         planeRadiusPixels},
        {"plane_samples", "A plane by few and many depth taps a pixel; -1 is the most.", "taps",
         steps({1, 2, 4, 8, 16, 32, 64, 128, -1}), 4, E::open, 0, false, planeSamples},
        {"plane_units", "A plane in other units: all lengths times a factor.", "units",
         decades(-6, 6), 6, E::open, 0, false, planeUnits},
        {"plane_sizes", "A plane in pictures of other sizes.", "", shapes(), 0, E::open, 0, false,
         planeShape},
        {"units", "The yard in other units, by its model matrices.", "units", decades(-6, 6), 6,
         E::same, 0.002, false, yardUnits},
        {"units_in_vertices", "The yard in other units, in its vertices.", "units", decades(-6, 6),
         6, E::same, 0.002, false, yardUnitsInVertices},
        {"offset", "The yard far from the origin, by its model matrices.", "radii",
         steps({0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}), 0, E::same, 0.002, false, yardOffset},
        {"offset_in_vertices", "The same in its vertices, where floats round it.", "radii",
         steps({0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}), 0, E::same, 0.002, false,
         yardOffsetInVertices},
        {"near_far", "The yard between ever farther near and far planes.", "near:far", kNearFar, 1,
         E::same, 0.002, true, yardNearFar},
        {"projection", "The yard through other projections of depth.", "",
         kinds({"ordinary", "reversed", "infinite", "reversed and infinite"}), 0, E::same, 0.002,
         true, yardProjection},
        {"off_centre", "The yard through an off-centre frustum, over what both show.",
         "pixels of 256", steps({-64, -32, 0, 32, 64}), 2, E::same, 0.01, false, yardShift},
        {"mirrored", "The yard mirrored; noise is not, so the limit is wider.", "",
         kinds({"ordinary", "by a matrix", "in the vertices"}), 0, E::same, 0.015, false,
         yardMirrored},
        {"narrow", "The yard from ever farther through ever less of an angle; 0 is orthographic.",
         "degrees", steps({0, 0.1, 0.3, 1}), 0, E::same, 0.01, false, yardNarrow},
        {"radius_to_zero", "The yard under ever smaller radii.", "scene units",
         {{1e-9, "1e-9"}, {1e-6, "1e-6"}, {1e-4, "1e-4"}, {1e-3, "1e-3"}, {1e-2, "0.01"},
          {0.05, "0.05"}, {0.1, "0.1"}, {0.25, "0.25"}, {0.5, "0.5"}},
         8, E::opens, 0.002, false, yardRadius},
        {"radius_growing", "The yard under ever larger radii.", "scene units",
         steps({0.5, 2, 10, 100, 1e4, 1e6, 1e9}), 0, E::sound, 0, false, yardRadius},
        {"corner_radius", "An inner corner under larger radii.", "scene units",
         steps({0.05, 0.1, 0.2, 0.4, 0.8, 1.6}), 0, E::darkens, 0.002, false, cornerRadius},
        {"samples", "The yard by few and many depth taps a pixel; -1 is the most.", "taps",
         steps({1, 2, 4, 16, -1}), 3, E::sound, 0, false, yardSamples},
        {"identity", "No intensity, no radius: planned away, and drawn all the same.", "",
         kinds({"intensity 0", "intensity 0, drawn", "radius 0", "radius 0, drawn"}), 0, E::one, 0,
         false, identity},
        {"sizes", "The yard in pictures of other sizes.", "", shapes(), 0, E::sound, 0, false,
         yardShape},
        {"empty", "Nothing but background, in pictures of other sizes.", "", shapes(), 0, E::one, 0,
         false, emptyShape},
    };
}

}  // namespace

const std::vector<StressCase>& stressCases()
{
    static const std::vector<StressCase> cases = makeCases();
    return cases;
}

double formatStep(Format format, double distance, const StressShot& shot)
{
    const double near = shot.near_distance, far = shot.far_distance;
    const auto floatStep = [distance](int bits) {
        return std::exp2(std::floor(std::log2(distance)) - bits);
    };
    if (format == Format::rgba16f) return floatStep(10);
    if (format == Format::rgba32f) return floatStep(23);
    // Depths near 1, where most of them lie, are as fine in single float as in 24 bits.
    const double depths = format == Format::depth16 ? 65536.0 : 16777216.0;
    if (shot.camera.orthographic()) return (far - near) / depths;
    return distance * distance * (far - near) / (near * far * depths);
}

}  // namespace crevice
