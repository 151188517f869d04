// SPDX-License-Identifier: MIT
// Built-in scenes and the shapes they are made of.
#include "tools/render/scene/builtin_scenes.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/render/scene/mesh_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979;

glm::dvec3 vec3From(const float* values) { return {values[0], values[1], values[2]}; }

// A triangle in world space with the normal of its first vertex.
struct Triangle {
    glm::dvec3 corners[3];
    glm::dvec3 normal;
    std::size_t instance;

    glm::dvec3 across() const
    {
        return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    }
};

std::vector<Triangle> trianglesOf(const Scene& scene)
{
    std::vector<Triangle> triangles;
    for (std::size_t index = 0; index < scene.instances.size(); ++index) {
        const SceneInstance& instance = scene.instances[index];
        const MeshDesc& mesh = scene.meshes[instance.mesh];
        const glm::dmat4 world = instance.world_from_model;
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
            Triangle triangle;
            triangle.instance = index;
            for (int k = 0; k < 3; ++k) {
                const Vertex& vertex = mesh.vertices[mesh.indices[first + k]];
                triangle.corners[k] = world * glm::dvec4(vec3From(vertex.position), 1);
            }
            const Vertex& vertex = mesh.vertices[mesh.indices[first]];
            triangle.normal = glm::normalize(glm::dmat3(world) * vec3From(vertex.normal));
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

// Of what the triangles enclose; negative when they face inwards.
double volumeOf(const MeshDesc& mesh)
{
    Scene scene;
    scene.meshes = {mesh};
    scene.instances = {{0}};
    double volume = 0;
    for (const Triangle& triangle : trianglesOf(scene))
        volume += glm::dot(triangle.corners[0], triangle.across()) / 6;
    return volume;
}

// Whether both lie in one plane, face the same way and cover some of the same ground.
bool fight(const Triangle& a, const Triangle& b)
{
    const glm::dvec3 normal = glm::normalize(a.across());
    if (glm::dot(normal, glm::normalize(b.across())) < 0.9999) return false;
    if (std::abs(glm::dot(normal, b.corners[0] - a.corners[0])) > 5e-4) return false;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(normal[axis]) > 0.9) continue;
        const auto range = [axis](const Triangle& t) {
            return std::minmax({t.corners[0][axis], t.corners[1][axis], t.corners[2][axis]});
        };
        if (range(a).second < range(b).first + 1e-3 || range(b).second < range(a).first + 1e-3)
            return false;
    }
    return true;
}

// With a model of a few triangles in the bunny's place, for tests of all else.
Result<Scene> roomWith(const std::string& bunny)
{
    const TemporaryFolder folder("builtin_room");
    folder.write("bunny.obj", bunny);
    ::setenv("CREVICE_MODELS", folder.path.c_str(), 1);
    Result<Scene> room = builtinScene("room");
    ::unsetenv("CREVICE_MODELS");
    return room;
}

const char* const kTetrahedron =
    "v -1 -1 -1\nv 1 -1 -1\nv 0 -1 1\nv 0 1 0\n"
    "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

Scene load(const std::string& name)
{
    return need(name == "room" ? roomWith(kTetrahedron) : builtinScene(name));
}

}  // namespace

TEST_CASE("boxes, spheres and stairs are closed and face outwards")
{
    CHECK(volumeOf(makeBox({-1, 0, 2}, {1, 3, 6})) == Approx(24));
    CHECK(volumeOf(makeSphere(2, 64)) == Approx(4.0 / 3 * kPi * 8).epsilon(0.005));
    CHECK(volumeOf(makeSphere(1, 2)) > 0);
    CHECK(volumeOf(makeStairs(4, 2, 0.5f, 0.25f)) == Approx(2 * 0.25 * 0.5 * (1 + 2 + 3 + 4)));
}

TEST_CASE("every built-in scene has a main camera that looks at it, a light and a weaker sky")
{
    for (const std::string& name : builtinSceneNames()) {
        const Scene scene = load(name);
        CHECK(scene.name == name);
        REQUIRE_FALSE(scene.cameras.empty());
        CHECK(scene.cameras[0].name == "main");
        for (const SceneCamera& camera : scene.cameras) {
            INFO(name << ": " << camera.name);
            const glm::dmat4 world_from_view = glm::inverse(glm::dmat4(camera.view_from_world));
            CHECK(world_from_view[3].y > 0.1);
            const glm::dvec3 middle = {0, 0.4, 0};
            CHECK((glm::dmat4(camera.view_from_world) * glm::dvec4(middle, 1)).z < 0);
        }
        REQUIRE(scene.lights.size() == 2);
        CHECK_FALSE(scene.lights[0].light.directional);
        CHECK(scene.lights[1].light.directional);
        CHECK(scene.lights[1].light.color.r < scene.lights[0].light.color.r);
    }
}

TEST_CASE("normals are on the side that is seen, and no two faces fight for the same plane")
{
    for (const std::string& name : builtinSceneNames()) {
        INFO(name);
        std::vector<Triangle> flat;
        for (const Triangle& triangle : trianglesOf(load(name))) {
            if (glm::dot(triangle.across(), triangle.normal) <= 0)
                FAIL_CHECK("instance " << triangle.instance);
            if (glm::length(triangle.across()) > 0.02) flat.push_back(triangle);  // not of a sphere
        }
        for (const Triangle& a : flat)
            for (const Triangle& b : flat)
                if (a.instance < b.instance && fight(a, b))
                    FAIL_CHECK("instances " << a.instance << " and " << b.instance);
    }
}

TEST_CASE("what stands in a built-in scene is sunk into the floor by a hair")
{
    for (const char* name : {"room", "spheres"}) {
        Scene scene = load(name);
        for (const SceneInstance& instance : scene.instances) {
            const std::string label = scene.meshes[instance.mesh].label;
            if (label == "floor") continue;
            INFO(name << ": " << label);
            Scene alone = scene;
            alone.instances = {instance};
            CHECK(alone.bounds().min.y < -0.0005);
            CHECK(alone.bounds().min.y > -0.005);
        }
    }
}

TEST_CASE("the room has the bunny of the glmark2 models, standing upright")
{
    Scene alone = need(builtinScene("room"));
    alone.instances = {alone.instances.back()};
    CHECK(alone.meshes[alone.instances[0].mesh].indices.size() / 3 > 60000);
    CHECK(alone.bounds().max.y == Approx(0.95).margin(0.05));
}

TEST_CASE("a bunny of one's own is taken first, and a broken one is reported")
{
    const Scene room = load("room");
    CHECK(room.meshes[room.instances.back().mesh].indices.size() == 12);
    const Result<Scene> broken = roomWith("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    REQUIRE_FALSE(broken.ok());
    CHECK(broken.diagnostics()[0].code == Code::scene_broken);
}

TEST_CASE("a built-in scene of no known name is missing")
{
    const Result<Scene> scene = builtinScene("plan");
    REQUIRE_FALSE(scene.ok());
    CHECK(scene.diagnostics()[0].code == Code::scene_missing);
    CHECK(scene.diagnostics()[0].help.find("'plane'") != std::string::npos);
}
