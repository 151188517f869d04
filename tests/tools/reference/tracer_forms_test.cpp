// SPDX-License-Identifier: MIT
// The ray tracer against closed forms, at any radius, size, place and tilt.
#include "tests/tools/reference/tracer_shot.h"

#include <functional>

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979323846;

// The part of the cosine-weighted hemisphere about +y whose rays from `from` meet nothing, by even
// points on the unit disc. `distance` of a direction is that of the first occluder, below 0 none.
using Distance = std::function<double(const glm::dvec3& from, const glm::dvec3& along)>;
double visibilityAt(const glm::dvec3& from, double radius, const Distance& distance)
{
    constexpr int kSteps = 200;
    int open = 0;
    for (int ring = 0; ring < kSteps; ++ring) {
        for (int step = 0; step < kSteps; ++step) {
            const double squared = (ring + 0.5) / kSteps;
            const double angle = 2 * kPi * (step + (ring + 0.5) / kSteps) / kSteps;
            const double side = std::sqrt(squared);
            const double t = distance(
                from, {side * std::cos(angle), std::sqrt(1 - squared), side * std::sin(angle)});
            open += t < 0 || t > radius;
        }
    }
    return static_cast<double>(open) / (kSteps * kSteps);
}

// To kWall, moved to z.
double distanceToWall(const glm::dvec3& from, const glm::dvec3& along, double z)
{
    const double t = (z - from.z) / along.z;
    const glm::dvec3 at = from + along * t;
    return t > 0 && std::abs(at.x) <= 50 && at.y <= 50 ? t : -1.0;
}

// Sixteen points of floor on a line that is `length` long and begins at z = 0.
constexpr int kPoints = 16;

double tracedAlong(const Scene& scene, const Placement& placement, double length, double radius,
                   double height = 20)
{
    const Shot shot = shotOf(scene, placement, {0, 0, length / 2}, length / 2, height);
    return meanOf(trace(shot, {1, kPoints}, radius * placement.scale));
}

double expectedAlong(double length, double radius, const Distance& distance)
{
    double sum = 0;
    for (int k = 0; k < kPoints; ++k)
        sum += visibilityAt({0, 0, length * (k + 0.5) / kPoints}, radius, distance);
    return sum / kPoints;
}

double distanceInCorner(const glm::dvec3& from, const glm::dvec3& along)
{
    return distanceToWall(from, along, 0);
}

const Placement kTilted = {1, {0, 0, 0}, true};

Scene floorAndSphere()
{
    Scene scene = sceneOf({kFloor, makeSphere(0.5f, 64)});
    scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, 1, 0});
    return scene;
}

// Beside the sphere of `floorAndSphere`.
double biasBelowSphere(const Scene& scene, const Placement& placement, double radius)
{
    const Shot shot = shotOf(scene, placement, {2, 0, 0}, 1, 20);
    const Image image = trace(shot, {8, 8}, radius * placement.scale, 1024);
    double expected = 0;
    for (int k = 0; k < 64; ++k) {
        const double x = 1 + 2 * (k % 8 + 0.5) / 8, z = 2 * (k / 8 + 0.5) / 8 - 1;
        expected += (1 - 0.25 / std::pow(x * x + z * z + 1, 1.5)) / 64;
    }
    return meanOf(image) - expected;
}

}  // namespace

TEST_CASE("a corner has its closed form at any radius, size, place and tilt")
{
    const Scene scene = sceneOf({kFloor, kWall});
    for (const double part : kRadii) {
        const double radius = part * kSize, length = std::min(radius, 4.0);
        const double expected = expectedAlong(length, radius, distanceInCorner);
        for (const Placement& placement : kPlacements) {
            INFO(describe(placement, radius));
            const double bias = tracedAlong(scene, placement, length, radius) - expected;
            CHECK(std::abs(bias) <= kMaxBias);
        }
    }
}

TEST_CASE("an unbounded corner is half open beside its edge")
{
    const Shot shot = shotOf(sceneOf({kFloor, kWall}), {}, {0, 0, 1e-3}, 1e-3, 20);
    CHECK(meanOf(trace(shot, {4, 4}, 1e9 * kSize)) == Approx(0.5).margin(kMaxBias));
}

TEST_CASE("a trench has its closed form at any radius")
{
    Scene scene = sceneOf({kFloor, kWall, kWall});
    scene.instances[2].world_from_model = glm::translate(glm::dmat4(1), {0, 0, 2});
    const auto distance = [](const glm::dvec3& from, const glm::dvec3& along) {
        return distanceToWall(from, along, along.z < 0 ? 0 : 2);
    };
    for (const double radius : {0.5, 1.5, 10.0, 1e3, 1e11}) {
        const double expected = expectedAlong(2, radius, distance);
        for (const Placement& placement : kPlacements) {
            INFO(describe(placement, radius));
            CHECK(std::abs(tracedAlong(scene, placement, 2, radius) - expected) <= kMaxBias);
        }
    }
}

TEST_CASE("a sphere over a floor has its form factor however far rays reach")
{
    for (const Placement& placement : kPlacements) {
        for (const double radius : {50.0, 1e3, 1e6, 1e11}) {
            INFO(describe(placement, radius));
            CHECK(std::abs(biasBelowSphere(floorAndSphere(), placement, radius)) <= kMaxBias);
        }
    }
}

TEST_CASE("the inside of a closed box is dark where rays reach all walls, open where none")
{
    const Scene scene = sceneOf({makeBox({-50, 0, -50}, {50, 50, 50})});
    for (const Placement& placement : kPlacements) {
        const Shot shot = shotOf(scene, placement, {0, 0, 0}, 10, 20);
        for (const double radius : {1e-4, 1e-2, 1.0, 30.0}) {
            INFO(describe(placement, radius));
            CHECK(meanOf(trace(shot, {4, 4}, radius * placement.scale, 64)) == 1.0);
        }
        for (const double radius : {150.0, 1e3, 1e6, 1e11}) {
            INFO(describe(placement, radius));
            CHECK(meanOf(trace(shot, {4, 4}, radius * placement.scale, 64)) == 0.0);
        }
    }
}

TEST_CASE("floats resolve what lies near the eye in a world of any size")
{
    Scene world = floorAndSphere();
    world.instances.push_back(world.instances[1]);
    world.instances[2].world_from_model = glm::translate(glm::dmat4(1), {1e7, -1e7, 1e7});
    CHECK(std::abs(biasBelowSphere(world, kTilted, 50)) <= kMaxBias);
    CHECK(std::abs(biasBelowSphere(world, kTilted, 1e11)) <= kMaxBias);
}

TEST_CASE("the distance of the eye changes nothing")
{
    const Scene scene = sceneOf({kFloor, kWall});
    for (const double radius : {0.1, 1.0, 1e11}) {
        const double expected = expectedAlong(0.5, radius, distanceInCorner);
        for (const double height : {1.0, 1e3, 1e6, 1e10}) {
            INFO("height " + significant(height, 3) + ", radius " + significant(radius, 3));
            const double bias = tracedAlong(scene, kTilted, 0.5, radius, height) - expected;
            CHECK(std::abs(bias) <= kMaxBias);
        }
    }
}
