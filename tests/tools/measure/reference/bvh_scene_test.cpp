// SPDX-License-Identifier: MIT
// The tree's search against Embree's, where crevice was built with Embree, and against nonsense.
// Trees of boxes: what they hold, how deep they are, and boxes that cannot be told apart.
#include "tools/measure/reference/ray_scene.h"

#include "tests/support/need.h"
#include "tests/tools/measure/reference/tracer_shot.h"
#include "tools/measure/reference/bvh.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 48};
constexpr int kRays = 64;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

const Camera kAhead = {glm::lookAt(glm::vec3(0, 0, 5), glm::vec3(0), glm::vec3(0, 1, 0)),
                       glm::perspective(0.9f, 4.0f / 3.0f, 0.1f, 100.0f)};

glm::dvec3 eyeOf(const Camera& camera) { return glm::inverse(camera.view_from_world)[3]; }

// How two pictures of the surfaces and of the occlusion differ.
struct Differences {
    int surfaces = 0, occlusion = 0;  // pixels
    float most_rays = 0;
    int seen = 0;
};

Image occlusion(const RayScene& scene, const Camera& camera, double radius)
{
    return trace(scene, camera, kExtent, radius, kRays);
}

void compareSurfaces(const RayScene& a, const RayScene& b, const Camera& camera, Differences& found)
{
    const SurfaceMap one = need(traceSurfaces(a, camera, kExtent));
    const SurfaceMap other = need(traceSurfaces(b, camera, kExtent));
    for (std::size_t k = 0; k < one.points.size(); ++k) {
        const SurfacePoint& p = one.points[k];
        const SurfacePoint& q = other.points[k];
        found.seen += p.seen;
        const bool same =
            p.seen ? q.seen && p.position == q.position && p.normal == q.normal : !q.seen;
        found.surfaces += !same;
    }
}

void checkAlike(const Scene& scene, const Camera& camera, const std::vector<double>& radii)
{
    const auto chosen = need(makeRayScene(scene, eyeOf(camera)));
    const auto tree = makeBvhScene(scene, eyeOf(camera));
    Differences found;
    compareSurfaces(*chosen, *tree, camera, found);
    for (const double radius : radii) {
        const Image one = occlusion(*chosen, camera, radius);
        const Image other = occlusion(*tree, camera, radius);
        for (std::size_t k = 0; k < one.pixels.size(); ++k) {
            const float a = one.pixels[k], b = other.pixels[k];
            if (a == b || (std::isnan(a) && std::isnan(b))) continue;
            ++found.occlusion;
            found.most_rays = std::max(found.most_rays, std::abs(a - b) * kRays);
        }
    }
    CHECK(found.seen > 100);
    CHECK(found.surfaces == 0);
    CHECK(found.occlusion <= 0.001 * found.seen * static_cast<double>(radii.size()));
    CHECK(found.most_rays <= 3.0f);
}

// In a cube of 2 to each side.
MeshDesc soup(int triangles, float size, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&random](float scale) {
        return scale * (static_cast<float>(random() >> 8) / (1 << 23) - 1.0f);
    };
    MeshDesc mesh;
    for (int k = 0; k < triangles; ++k) {
        const float x = number(1), y = number(1), z = number(1);
        for (int corner = 0; corner < 3; ++corner) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            const float right = x + number(size), up = y + number(size);
            mesh.vertices.push_back({{right, up, z + number(size)}, {0, 0, 1}});
        }
    }
    return mesh;
}

int pixelsSeen(const Scene& scene)
{
    const Image image = occlusion(*makeBvhScene(scene, eyeOf(kAhead)), kAhead, 1.0);
    return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(),
                                          [](float value) { return value >= 0.0f; }));
}

std::vector<BvhBox> randomBoxes(int count, float size)
{
    std::mt19937 random(7);
    const auto coordinate = [&random] {
        return static_cast<float>(random() >> 8) / (1 << 23) - 1.0f;
    };
    std::vector<BvhBox> boxes;
    for (int k = 0; k < count; ++k) {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        boxes.push_back({{x, y, z}, {x + size, y + size, z + size}});
    }
    return boxes;
}

bool holds(const glm::vec3& low, const glm::vec3& high, const glm::vec3& inner_low,
           const glm::vec3& inner_high)
{
    return glm::min(low, inner_low) == low && glm::max(high, inner_high) == high;
}

// Walks all nodes and checks what a search relies on; gives the depth of the deepest.
int checkedDepth(const Bvh& bvh, const std::vector<BvhBox>& boxes)
{
    struct Visit {
        std::uint32_t node;
        int depth;
    };
    std::vector<Visit> visits = {{0, 0}};
    std::vector<int> seen(boxes.size(), 0);
    int deepest = 0, outside = 0;
    while (!visits.empty()) {
        const auto [index, depth] = visits.back();
        visits.pop_back();
        deepest = std::max(deepest, depth);
        const BvhNode& node = bvh.nodes[index];
        for (std::uint32_t k = 0; k < node.count; ++k) {
            const std::uint32_t item = bvh.order[node.first + k];
            ++seen[item];
            outside += !holds(node.low, node.high, boxes[item].low, boxes[item].high);
        }
        if (node.count > 0) continue;
        for (std::uint32_t child = node.first; child < node.first + 2; ++child) {
            outside += !holds(node.low, node.high, bvh.nodes[child].low, bvh.nodes[child].high);
            visits.push_back({child, depth + 1});
        }
    }
    CHECK(outside == 0);
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(seen.size()));
    return deepest;
}

}  // namespace

TEST_CASE("both searches find the same in the built-in scenes")
{
    for (const std::string& name : builtinSceneNames()) {
        const Result<Scene> scene = builtinScene(name);
        if (!scene) continue;  // the room's bunny is not everywhere
        INFO(name);
        const Bounds bounds = scene->bounds();
        const auto camera = need(chooseCamera(*scene, bounds, "", 4.0 / 3.0));
        checkAlike(*scene, {camera.view_from_world, clipFromView(camera, kExtent, bounds)},
                   {0.1, 1.0, 1e3});
    }
}

TEST_CASE("both searches find the same among triangles of any size and through any lens")
{
    for (const float size : {0.03f, 0.1f, 0.3f, 1.0f}) {
        INFO(size);
        const Scene scene = sceneOf({soup(static_cast<int>(60 / (size * size)), size, 3)});
        checkAlike(scene, kAhead, {0.05, 0.5, 10.0});
    }
    const Scene scene = sceneOf({soup(2000, 0.1f, 9), makeSphere(0.5f, 12)});
    const glm::mat4 endless = glm::infinitePerspective(0.9f, 4.0f / 3.0f, 0.1f);
    for (const float sign : {1.0f, -1.0f}) {  // -1 reverses depth
        const glm::mat4 lens = glm::scale(glm::mat4(1), {1, 1, sign}) * endless;
        checkAlike(scene, {kAhead.view_from_world, lens}, {0.2, 2.0});
    }
}

TEST_CASE("both searches find the same at any place, size and tilt, from above and from below")
{
    Scene scene = sceneOf({kFloor, kWall, makeSphere(5, 16), soup(300, 0.3f, 5)});
    scene.instances[2].world_from_model = glm::translate(glm::dmat4(1), {0, 4, 8});
    scene.instances[3].world_from_model =
        glm::scale(glm::translate(glm::dmat4(1), {9, 9, 9}), glm::dvec3(8));
    for (const Placement& placement : kPlacements) {
        INFO(describe(placement, 0));
        const double s = placement.scale;
        const Shot shot = shotOf(scene, placement, {0, 0, 10}, 20, 60);
        checkAlike(shot.scene, shot.camera, {s, 10 * s, 1e6 * s});
    }
}

TEST_CASE("no ray slips through between triangles that share an edge")
{
    // From within, through the edges and corners of a sphere around the origin.
    Scene scene = sceneOf({makeSphere(1, 40)});
    const auto tree = makeBvhScene(scene, glm::dvec3(0));
    const MeshDesc& mesh = scene.meshes[0];
    int slipped = 0;
    for (std::size_t k = 0; k + 1 < mesh.indices.size(); ++k) {
        const float* a = mesh.vertices[mesh.indices[k]].position;
        const float* b = mesh.vertices[mesh.indices[k + 1]].position;
        for (const double part : {0.0, 0.3, 0.5}) {
            const glm::dvec3 from(a[0], a[1], a[2]), to(b[0], b[1], b[2]);
            TraceHit hit;
            const glm::dvec3 along = glm::normalize(from * (1 - part) + to * part);
            slipped += !tree->intersect({glm::dvec3(0), along, 10.0}, hit);
        }
    }
    CHECK(slipped == 0);
}

TEST_CASE("rays along the axes meet boxes that have no thickness")
{
    const Scene scene = sceneOf({makeQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}),
                                 makeQuad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}),
                                 makeQuad({0, -1, 1}, {0, 2, 0}, {0, 0, -2})});
    const auto tree = makeBvhScene(scene, glm::dvec3(0.5, 0.5, 5));
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 direction(0.0), origin(0.25, 0.5, 0.125);
            direction[axis] = sign;
            origin[axis] = -3 * sign;
            TraceHit hit;
            REQUIRE(tree->intersect({origin, direction, 10.0}, hit));
            CHECK((hit.position + tree->center())[axis] == Approx(0).margin(1e-12));
        }
    }
}

TEST_CASE("scenes of nothing, of points and of lines are not seen, and are no crash")
{
    Scene nothing;
    nothing.materials.emplace_back();
    CHECK(pixelsSeen(nothing) == 0);
    CHECK(pixelsSeen(sceneOf({MeshDesc()})) == 0);
    MeshDesc flat = makeSphere(1, 16);
    for (const int axis : {1, 2, 0}) {  // a disc seen edge on, a line, a point
        for (Vertex& vertex : flat.vertices) vertex.position[axis] = 0;
        CHECK(pixelsSeen(sceneOf({flat})) == 0);
    }
}

TEST_CASE("a corner that is no number loses its triangles, and one beyond all numbers is no crash")
{
    const MeshDesc sphere = makeSphere(1, 16);
    const auto seenWith = [&sphere](std::size_t corner, int axis, float value) {
        MeshDesc broken = sphere;
        broken.vertices[corner].position[axis] = value;
        return pixelsSeen(sceneOf({broken}));
    };
    const int whole = pixelsSeen(sceneOf({sphere}));
    for (const int axis : {0, 1, 2}) {
        const int left = seenWith(sphere.vertices.size() / 2, axis, kNaN);
        CHECK(left > whole / 2);
        CHECK(left <= whole);
    }
    for (const float far_away : {kInfinity, -kInfinity, 3e38f, 2e18f})
        CHECK(seenWith(5, 1, far_away) >= 0);
}

TEST_CASE("a tree holds each box once, inside of all nodes above it")
{
    for (const int count : {1, 2, 3, 9, 100, 5000}) {
        const std::vector<BvhBox> boxes = randomBoxes(count, 0.01f);
        CHECK(checkedDepth(buildBvh(boxes), boxes) <= 2 * std::log2(count) + 2);
    }
}

TEST_CASE("no tree is deeper than a walk has room for")
{
    // Rows along each axis, whose sizes fall by half: a cut takes a few boxes off their ends.
    std::vector<BvhBox> boxes;
    for (int axis = 0; axis < 3; ++axis) {
        for (int exponent = 60; exponent > -120; --exponent) {
            glm::vec3 place(0.0f);
            place[axis] = std::ldexp(1.0f, exponent);
            boxes.push_back({place, place * 1.25f});
        }
    }
    const int alone = checkedDepth(buildBvh(boxes), boxes);
    CHECK(alone > 32);  // it is a hard case
    boxes.insert(boxes.end(), 100000, boxes.back());
    CHECK(checkedDepth(buildBvh(boxes), boxes) < kMaxBvhDepth);
}
