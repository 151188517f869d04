// SPDX-License-Identifier: MIT
// The tree's search against trying every triangle in doubles, and against nonsense.
#include "tools/reference/bvh_scene.h"

#include "tests/tools/reference/tracer_shot.h"
#include "tools/reference/trace_bodies.h"
#include "tools/scene/builtin_scenes.h"

#include <algorithm>
#include <limits>
#include <random>

using namespace crevice;

namespace {

constexpr double kTests = 2e6;  // of a ray and a triangle, in each scene
constexpr double kEnd = std::numeric_limits<double>::infinity();

const Camera kAhead = {glm::lookAt(glm::vec3(0, 0, 5), glm::vec3(0), glm::vec3(0, 1, 0)),
                       glm::perspective(0.9f, 4.0f / 3.0f, 0.1f, 100.0f)};

class Numbers {
public:
    explicit Numbers(unsigned seed) : random_(seed) {}

    /// In [-scale, scale).
    double next(double scale) { return scale * ((random_() >> 8) / double(1 << 23) - 1.0); }

    std::size_t index(std::size_t count) { return random_() % count; }

    glm::dvec3 direction()
    {
        for (;;) {
            const glm::dvec3 at(next(1), next(1), next(1));
            if (glm::dot(at, at) < 1) return glm::normalize(at);
        }
    }

private:
    std::mt19937 random_;
};

/// Every triangle of a scene, in doubles and relative to the center.
class AllTriangles {
public:
    AllTriangles(const Scene& scene, const glm::dvec3& eye) : bodies_(scene, eye)
    {
        for (const TraceBody& body : bodies_.all()) {
            places_.emplace_back();
            for (const Vertex& vertex : body.mesh().vertices)
                places_.back().push_back(body.place(vertex));
            count_ += body.triangles();
        }
    }

    double count() const { return static_cast<double>(count_); }

    /// A corner of a mesh, so that rays may aim at something.
    glm::dvec3 corner(Numbers& numbers) const
    {
        const std::vector<glm::dvec3>& mesh = places_[numbers.index(places_.size())];
        return mesh[numbers.index(mesh.size())];
    }

    /// How far the ray goes to the first triangle; kEnd where it meets none.
    double distance(const TraceRay& ray) const
    {
        double nearest = kEnd;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const TraceBody& body = bodies_.all()[i];
            for (unsigned k = 0; k < body.triangles(); ++k) {
                const std::uint32_t* corners = &body.mesh().indices[3 * k];
                const glm::dvec3 a = places_[i][corners[0]] - ray.origin;
                const glm::dvec3 b = places_[i][corners[1]] - ray.origin;
                const glm::dvec3 c = places_[i][corners[2]] - ray.origin;
                const double u = glm::dot(glm::cross(c, a), ray.direction);
                const double v = glm::dot(glm::cross(a, b), ray.direction);
                const double w = glm::dot(glm::cross(b, c), ray.direction);
                if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) continue;
                const glm::dvec3 across = glm::cross(b - a, c - a);
                const double distance = glm::dot(a, across) / glm::dot(ray.direction, across);
                if (!(distance >= 0 && distance <= ray.limit) || distance >= nearest) continue;
                if (!body.hole(k, u / (u + v + w), v / (u + v + w))) nearest = distance;
            }
        }
        return nearest;
    }

private:
    TraceBodies bodies_;
    std::vector<std::vector<glm::dvec3>> places_;
    std::size_t count_ = 0;
};

/// Rays from all over the scene, and eight from where each of them ends.
void checkByTrying(const Scene& scene, std::initializer_list<double> radii)
{
    const Bounds bounds = scene.bounds();
    const AllTriangles triangles(scene, bounds.center());
    const auto tree = makeBvhScene(scene, bounds.center());
    const double size = bounds.diagonal() / 2;
    const int rays = static_cast<int>(std::clamp(kTests / (9 * triangles.count()), 10.0, 1000.0));
    Numbers numbers(7);
    int met = 0, probed = 0, wrong = 0, wrong_probes = 0;
    for (int k = 0; k < rays; ++k) {
        const glm::dvec3 from(numbers.next(size), numbers.next(size), numbers.next(size));
        const double radius = radii.begin()[k % radii.size()];
        const glm::dvec3 at = triangles.corner(numbers) + 0.01 * size * numbers.direction();
        const TraceRay ray = {from, glm::normalize(at - from), k % 2 ? kEnd : size};
        const double expected = triangles.distance(ray);
        TraceHit hit;
        const bool found = tree->intersect({from + tree->center(), ray.direction, ray.limit}, hit);
        met += found;
        const double distance = found ? glm::distance(hit.position, from) : kEnd;
        wrong += !(distance == expected || std::abs(distance - expected) <= 1e-9 * size);
        if (!found || distance != distance) continue;
        TraceBatch batch;
        int open = 0;
        const glm::dvec3 origin = hit.position + hit.geometric_normal * hit.rounding;
        for (int j = 0; j < 8; ++j) {
            const glm::vec3 along = numbers.direction();
            batch.directions[j] = along;
            batch.valid[j] = glm::dot(glm::dvec3(along), hit.geometric_normal) > 0 ? -1 : 0;
            if (batch.valid[j] == 0) continue;
            ++probed;
            open += triangles.distance({origin, along, radius}) == kEnd;
        }
        wrong_probes += std::abs(tree->countOpen(origin, batch, radius) - open);
    }
    CHECK(met > rays / 8);
    CHECK(wrong <= 0.001 * rays);
    CHECK(wrong_probes <= 0.001 * probed + 1);
}

// In a cube of 2 to each side.
MeshDesc soup(int triangles, double size, unsigned seed)
{
    Numbers numbers(seed);
    MeshDesc mesh;
    for (int k = 0; k < triangles; ++k) {
        const double center[3] = {numbers.next(1), numbers.next(1), numbers.next(1)};
        for (int corner = 0; corner < 3; ++corner) {
            Vertex vertex = {};
            for (int axis = 0; axis < 3; ++axis)
                vertex.position[axis] = static_cast<float>(center[axis] + numbers.next(size));
            vertex.normal[2] = 1;
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        }
    }
    return mesh;
}

int pixelsSeen(const Scene& scene)
{
    const Image image = trace({scene, kAhead}, {64, 48}, 1.0, 8);
    return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(),
                                          [](float value) { return value >= 0.0f; }));
}

}  // namespace

TEST_CASE("the search finds what trying every triangle finds, in scenes of any kind and place")
{
    for (const std::string& name : builtinSceneNames()) {
        const Result<Scene> scene = builtinScene(name);
        if (!scene) continue;  // the room's bunny is not everywhere
        INFO(name);
        checkByTrying(*scene, {0.1, 1.0, 1e3});
    }
    for (const double size : {0.03, 0.1, 0.3, 1.0}) {
        INFO("triangles of " << size);
        checkByTrying(sceneOf({soup(static_cast<int>(60 / (size * size)), size, 3)}),
                      {0.05, 0.5, 10.0});
    }
    Scene scene = sceneOf({kFloor, kWall, makeSphere(5, 16), soup(300, 0.3, 5)});
    scene.instances[2].world_from_model = glm::translate(glm::dmat4(1), {0, 4, 8});
    scene.instances[3].world_from_model =
        glm::scale(glm::translate(glm::dmat4(1), {9, 9, 9}), glm::dvec3(8));
    for (const Placement& placement : kPlacements) {
        INFO(describe(placement, 0));
        const double s = placement.scale;
        checkByTrying(shotOf(scene, placement, {0, 0, 10}, 20, 60).scene, {s, 10 * s, 1e6 * s});
    }
}

TEST_CASE("the search passes through holes and nowhere else")
{
    Scene scene = sceneOf({makeQuad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), soup(500, 0.3, 11)});
    scene.materials.emplace_back();
    scene.materials[1].alpha_cutoff = 0.5f;
    scene.materials[1].base_color_texture = 0;
    scene.instances[0].material = 1;
    scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, 0, -1.5});
    scene.textures.push_back({"holes", Image({8, 8}, 4, 1.0f)});
    for (int k = 0; k < 64; k += 3) scene.textures[0].image.at(k % 8, k / 8, 3) = 0.0f;
    checkByTrying(scene, {0.5, 3.0});
    Scene whole = scene;
    whole.materials[1].alpha_cutoff = 0.0f;
    CHECK(pixelsSeen(whole) > pixelsSeen(scene));
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
    for (const int axis : {1, 2, 0}) {  // seen edge on, a line, a point
        for (Vertex& vertex : flat.vertices) vertex.position[axis] = 0;
        CHECK(pixelsSeen(sceneOf({flat})) == 0);
    }
}

TEST_CASE("a corner that is no number or beyond all of them loses its triangles and no others")
{
    const MeshDesc sphere = makeSphere(1, 16);
    const int whole = pixelsSeen(sceneOf({sphere}));
    for (const float value : {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(), -3e38f, 2e18f}) {
        for (const int axis : {0, 1, 2}) {
            INFO(value << " on axis " << axis);
            MeshDesc broken = sphere;
            broken.vertices[sphere.vertices.size() / 2].position[axis] = value;
            const int left = pixelsSeen(sceneOf({broken}));
            CHECK(left <= whole);
            if (std::isnan(value)) CHECK(left > whole / 2);
        }
    }
}

TEST_CASE("many triangles in one place are seen as one")
{
    MeshDesc pile = soup(1, 1.0, 2);
    const int one = pixelsSeen(sceneOf({pile}));
    CHECK(one > 0);
    const std::vector<std::uint32_t> corners = pile.indices;
    for (int k = 0; k < 999; ++k)
        pile.indices.insert(pile.indices.end(), corners.begin(), corners.end());
    CHECK(pixelsSeen(sceneOf({pile})) == one);
}

TEST_CASE("a ray without an end that meets nothing sees the background")
{
    Camera camera = kAhead;
    camera.clip_from_view = glm::infinitePerspective(0.9f, 4.0f / 3.0f, 0.1f);
    const Image image = trace({sceneOf({makeSphere(1, 16)}), camera}, {64, 48}, 0.0, 8);
    CHECK(std::isnan(image.at(0, 0)));
    CHECK(image.at(32, 24) == 1.0f);
}
