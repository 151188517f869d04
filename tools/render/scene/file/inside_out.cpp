// SPDX-License-Identifier: MIT
#include "core/gpu/mesh_edges.h"
#include "tools/render/scene/file/import.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

// Of the area to the power of 3/2: a sphere has 0.09, a plate of a thickness of 1/300 has 0.001.
constexpr double kLeastVolume = 1e-5;

// What only touches a box, as the floor below it, is not in it.
constexpr double kInset = 1e-3;

// Comparisons for each surface, in the mean; what would take more stays as it is.
constexpr std::size_t kMostSteps = 256;

struct Surface {
    Bounds box = {};
    double area = 0, volume = 0;
    glm::dvec3 sum = {};  // of areas along their normals; 0 where it is closed
    bool inside_out = false;
};

struct Surfaces {
    std::vector<std::uint32_t> of_triangle;
    std::vector<Surface> all = {};

    explicit Surfaces(const MeshDesc& mesh);
    bool insideOut(std::size_t triangle) const
    {
        return of_triangle[triangle] != kNoSurface && all[of_triangle[triangle]].inside_out;
    }
};

Surfaces::Surfaces(const MeshDesc& mesh) : of_triangle(surfacesOf(mesh))
{
    const auto place = [&](std::size_t k) -> glm::dvec3 {
        return glm::make_vec3(mesh.vertices[mesh.indices[k]].position);
    };
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        if (of_triangle[k / 3] == kNoSurface) continue;
        if (of_triangle[k / 3] == all.size()) all.emplace_back();
        Surface& surface = all[of_triangle[k / 3]];
        const glm::dvec3 a = place(k), b = place(k + 1), c = place(k + 2);
        const glm::dvec3 area = glm::cross(b - a, c - a) * 0.5;
        for (const glm::dvec3& corner : {a, b, c}) surface.box.add(corner);
        surface.area += glm::length(area);
        surface.sum += area;
        surface.volume += glm::dot(area, a) / 3.0;
    }
    bool any = false;
    for (Surface& each : all) {
        const double volume = each.volume - glm::dot(each.sum, each.box.center()) / 3.0;
        each.inside_out = 2.0 * glm::length(each.sum) < each.area &&
                          volume < -kLeastVolume * std::pow(each.area, 1.5);
        any |= each.inside_out;
    }
    if (!any) return;
    for (const std::uint32_t first : sheetsOf(mesh)) all[of_triangle[first / 3]].inside_out = false;
}

// A surface of an instance, or the eye of a camera.
struct Placed {
    Bounds box;
    Surface* surface = nullptr;
};

std::vector<Placed> placedIn(const Scene& scene, std::vector<Surfaces>& surfaces)
{
    std::vector<Placed> placed;
    for (const SceneInstance& instance : scene.instances)
        for (Surface& surface : surfaces[static_cast<std::size_t>(instance.mesh)].all) {
            Placed& each = placed.emplace_back(Placed{{}, &surface});
            for (int k = 0; k < 8; ++k) each.box.add(instance.place(surface.box.corner(k)));
        }
    for (const SceneCamera& camera : scene.cameras)
        placed.emplace_back().box.add(glm::inverse(camera.view_from_world)[3]);
    std::sort(placed.begin(), placed.end(),
              [](const Placed& a, const Placed& b) { return a.box.center().x < b.box.center().x; });
    return placed;
}

// Who is in a room sees it from inside.
void leaveRooms(const std::vector<Placed>& placed)
{
    std::size_t steps = kMostSteps * placed.size();
    for (const Placed& room : placed) {
        if (!room.surface || !room.surface->inside_out) continue;
        const glm::dvec3 inset = (room.box.max - room.box.min) * kInset;
        const glm::dvec3 low = room.box.min + inset, high = room.box.max - inset;
        auto other = std::partition_point(placed.begin(), placed.end(), [&](const Placed& each) {
            return each.box.center().x < low.x;
        });
        bool empty = true;
        for (; empty && other != placed.end() && other->box.center().x < high.x; ++other) {
            const glm::dvec3 at = other->box.center();
            empty = steps > 0 && (&*other == &room || at != glm::clamp(at, low, high));
            steps -= empty;
        }
        room.surface->inside_out = empty;
    }
}

void turn(MeshDesc& mesh, const Surfaces& surfaces)
{
    std::vector<bool> turned(mesh.vertices.size());
    for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
        if (!surfaces.insideOut(k / 3)) continue;
        const std::uint32_t vertex = mesh.indices[k];
        for (float& axis : mesh.vertices[vertex].normal) axis = turned[vertex] ? axis : 0.0f - axis;
        turned[vertex] = true;
        if (k % 3 == 2) std::swap(mesh.indices[k - 1], mesh.indices[k]);
    }
}

std::size_t countOf(const std::vector<Surfaces>& surfaces)
{
    std::size_t count = 0;
    for (const Surfaces& mesh : surfaces)
        for (const Surface& each : mesh.all) count += each.inside_out;
    return count;
}

}  // namespace

std::size_t turnInsideOut(Scene& scene)
{
    std::vector<Surfaces> surfaces(scene.meshes.begin(), scene.meshes.end());
    if (countOf(surfaces) > 0) leaveRooms(placedIn(scene, surfaces));
    for (std::size_t k = 0; k < surfaces.size(); ++k) turn(scene.meshes[k], surfaces[k]);
    return countOf(surfaces);
}

}  // namespace crevice
