// SPDX-License-Identifier: MIT
// The ray tracer against closed forms, at any radius, size, place and tilt; and, sentence by
// sentence of tools/measure/reference/tracer.h, what it sees and counts as an occluder.
#include "tests/tools/measure/reference/tracer_shot.h"

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kReach = 40;  // Rays of that length do not see where kWall ends.

/// Ambient visibility of a point of the model for a radius, both in the model's units.
using Visibility = std::function<double(const glm::dvec3& point, double radius)>;

/// A picture whose pixels are known. The camera is that of shotOf.
struct Form {
    const char* name;
    Scene scene;
    std::vector<double> radii;
    Visibility expected;  ///< Not finite where it says nothing.
    double half = 10;
    glm::dvec3 center = glm::dvec3(0);
    double height = 20;
    Extent extent = {4, 4};
    int rays = 4096;
    double bias = kMaxBias;  ///< Of the mean.
    double margin = 0.004;   ///< Of each pixel.
};

Form exactly(Form form)
{
    form.extent = {8, 8};
    form.rays = 64;
    form.bias = form.margin = 0;
    return form;
}

Visibility always(double visibility)
{
    return [visibility](const glm::dvec3&, double) { return visibility; };
}

// Looks at the floor from above, or from below where `height` is less than 0: its pictures have
// the same rows.
std::vector<double> expectedOf(const Form& form, double radius)
{
    std::vector<double> pixels;
    for (int y = 0; y < form.extent.height; ++y) {
        for (int x = 0; x < form.extent.width; ++x) {
            const double right = 2 * (x + 0.5) / form.extent.width - 1;
            const double up = 2 * (y + 0.5) / form.extent.height - 1;
            pixels.push_back(
                form.expected(form.center + form.half * glm::dvec3(right, 0, -up), radius));
        }
    }
    return pixels;
}

template <class Placements>
void check(const Form& form, const Placements& placements)
{
    for (const double radius : form.radii) {
        const std::vector<double> expected = expectedOf(form, radius);
        for (const Placement& placement : placements) {
            const Shot shot = shotOf(form.scene, placement, form.center, form.half, form.height);
            const Image image = trace(shot, form.extent, radius * placement.scale, form.rays);
            double sum = 0, worst = 0;
            for (std::size_t k = 0; k < expected.size(); ++k) {
                if (!std::isfinite(expected[k])) continue;
                sum += image.pixels[k] - expected[k];
                worst = std::max(worst, std::abs(image.pixels[k] - expected[k]));
            }
            INFO(form.name << ", height " << form.height << ", " << describe(placement, radius));
            CHECK(std::abs(sum) <= form.bias * static_cast<double>(expected.size()));
            CHECK(worst <= form.margin);
        }
    }
}

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

// Cosine-weighted directions are even on the unit disc; those that reach an endless wall within the
// radius are the segment beyond distance / radius.
double inCorner(const glm::dvec3& point, double radius)
{
    if (radius > kReach)
        return visibilityAt(point, radius, [](const glm::dvec3& from, const glm::dvec3& along) {
            return distanceToWall(from, along, 0);
        });
    const double part = std::min(point.z / radius, 1.0);
    return 1.0 - (std::acos(part) - part * std::sqrt(1 - part * part)) / kPi;
}

double inTrench(const glm::dvec3& point, double radius)
{
    return visibilityAt(point, radius, [](const glm::dvec3& from, const glm::dvec3& along) {
        return distanceToWall(from, along, along.z < 0 ? 0 : 2);
    });
}

// The form factor of floorAndSphere's sphere; not below it.
double belowSphere(const glm::dvec3& point, double)
{
    const double squared = point.x * point.x + point.z * point.z + 1;
    return squared < 1 + 0.6 * 0.6 ? NAN : 1 - 0.25 / std::pow(squared, 1.5);
}

Scene floorAndSphere(int segments)
{
    Scene scene = sceneOf({kFloor, makeSphere(0.5f, segments)});
    scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, 1, 0});
    return scene;
}

// The last mesh moved.
Scene movedBy(Scene scene, const glm::dvec3& offset)
{
    scene.instances.back().world_from_model = glm::translate(glm::dmat4(1), offset);
    return scene;
}

MeshDesc turned(MeshDesc quad)
{
    std::swap(quad.indices[1], quad.indices[2]);
    std::swap(quad.indices[4], quad.indices[5]);
    for (Vertex& vertex : quad.vertices)
        for (float& each : vertex.normal) each = -each;
    return quad;
}

// Sixteen points of floor on a line that is `length` long and begins at the wall.
Form corner(double length, std::vector<double> radii, double height = 20)
{
    return {"corner",   sceneOf({kFloor, kWall}), std::move(radii), inCorner,
            length / 2, {0, 0, length / 2},       height,           {1, 16}};
}

std::vector<double> allRadii()
{
    std::vector<double> radii;
    for (const double part : kRadii) radii.push_back(part * kSize);
    return radii;
}

}  // namespace

TEST_CASE("corners, trenches and spheres over a floor have their closed forms in any place")
{
    for (const double radius : allRadii())
        check(corner(std::min(radius, 4.0), {radius}), kPlacements);
    Form edge = corner(2e-3, {1e9 * kSize});  // an endless corner is half open there
    edge.expected = always(0.5);
    check(edge, kPlacements);
    Form trench = corner(2, {0.5, 1.5, 10.0, 1e3, 1e11});
    trench.scene = movedBy(sceneOf({kFloor, kWall, kWall}), {0, 0, 2});
    trench.expected = inTrench;
    check(trench, kPlacements);
    Form sphere = {"sphere", floorAndSphere(64), {50.0, 1e3, 1e6, 1e11}, belowSphere, 1, {2, 0, 0}};
    sphere.extent = {8, 8};
    check(sphere, kPlacements);
    check(Form{"around it", floorAndSphere(128), {20}, belowSphere, 3, {}, 20, {33, 33}},
          std::vector<Placement>{{}});
}

TEST_CASE("the inside of a closed box is dark where rays reach all walls, open where none")
{
    const Scene box = sceneOf({makeBox({-50, 0, -50}, {50, 50, 50})});
    check(exactly({"open", box, {1e-4, 1e-2, 1.0, 30.0}, always(1)}), kPlacements);
    check(exactly({"dark", box, {150.0, 1e3, 1e6, 1e11}, always(0)}), kPlacements);
}

TEST_CASE("sheets are open on both sides, mirrored and beside others in their plane too")
{
    MeshDesc triangle = kFloor;
    triangle.indices.resize(3);
    Scene mirrored = sceneOf({kFloor});
    mirrored.instances[0].world_from_model = glm::scale(glm::dmat4(1), {1, -1, 1});
    const MeshDesc shorter = makeQuad({-31, 0, 31}, {69, 0, 0}, {0, 0, -83});
    const Scene many = sceneOf({kFloor, turned(kFloor), shorter});
    for (const double height : {20.0, -20.0}) {
        check(
            exactly(
                {"triangle", sceneOf({triangle}), allRadii(), always(1), 10, {20, 0, 20}, height}),
            kPlacements);
        check(exactly({"mirrored", mirrored, {10}, always(1), 10, {}, height}), kPlacements);
        check(exactly({"many", many, {1e-4, 1e9}, always(1), 10, {}, height}), kPlacements);
    }
}

TEST_CASE("of two sheets each hides the other however thin the gap, and the upper one is seen")
{
    const Scene two = sceneOf({kFloor, kFloor});
    for (const double gap : {1e-4, 1e-2, 1.0}) {
        // Rays at a cosine below gap / radius end in the gap: (gap / radius)^2 of them.
        const auto expected = [gap](const glm::dvec3&, double radius) {
            return radius < gap ? 1 : gap * gap / (radius * radius);
        };
        const std::vector<double> radii = {0.5 * gap, 1.25 * gap, 2 * gap, 20 * gap};
        check(Form{"gap", movedBy(two, {0, gap, 0}), radii, expected, 10, {}, gap / 2},
              kPlacements);
    }
    check(exactly({"upper", movedBy(two, {0, 1e-7, 0}), {1}, always(1)}), kPlacements);
}

TEST_CASE("directions below the geometric surface do not count, however the normal leans")
{
    for (const double angle : {0.1, 0.5, 1.2}) {
        MeshDesc floor = kFloor;
        for (Vertex& vertex : floor.vertices) {
            vertex.normal[0] = static_cast<float>(std::sin(angle));
            vertex.normal[1] = static_cast<float>(std::cos(angle));
        }
        check(exactly({"lean", sceneOf({floor}), {1e-4, 1.0, 1e9}, always(1)}), kPlacements);
    }
}

TEST_CASE("a surface occludes from both sides and is shaded on the side that is seen")
{
    Form behind = corner(2, {2});
    behind.scene = sceneOf({kFloor, turned(kWall)});
    check(behind, kPlacements);
    // A wall hangs below the floor, so it is the underside that has the corner.
    Form below = corner(2, {2}, -20);
    below.scene = movedBy(sceneOf({kFloor, kWall}), {0, -50, 0});
    check(below, kPlacements);
    check(exactly({"above", below.scene, {2}, always(1), 1, {0, 0, 1}}), kPlacements);
}
