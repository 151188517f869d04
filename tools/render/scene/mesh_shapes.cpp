// SPDX-License-Identifier: MIT
#include "tools/render/scene/mesh_shapes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace crevice {

namespace {

void addVertex(MeshDesc& mesh, const glm::vec3& position, const glm::vec3& normal, float u, float v)
{
    mesh.vertices.push_back(
        {{position.x, position.y, position.z}, {normal.x, normal.y, normal.z}, {u, v}});
}

void addQuad(MeshDesc& mesh, const glm::vec3& origin, const glm::vec3& right, const glm::vec3& up)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec3 normal = glm::normalize(glm::cross(right, up));
    addVertex(mesh, origin, normal, 0, 0);
    addVertex(mesh, origin + right, normal, 1, 0);
    addVertex(mesh, origin + right + up, normal, 1, 1);
    addVertex(mesh, origin + up, normal, 0, 1);
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        mesh.indices.push_back(first + corner);
}

}  // namespace

MeshDesc makeQuad(const glm::vec3& origin, const glm::vec3& right, const glm::vec3& up)
{
    MeshDesc mesh;
    addQuad(mesh, origin, right, up);
    return mesh;
}

MeshDesc makeBox(const glm::vec3& low, const glm::vec3& high)
{
    MeshDesc mesh;
    const glm::vec3 x = {high.x - low.x, 0, 0};
    const glm::vec3 y = {0, high.y - low.y, 0};
    const glm::vec3 z = {0, 0, high.z - low.z};
    addQuad(mesh, low + z, x, y);       // front
    addQuad(mesh, low + x, -x, y);      // back
    addQuad(mesh, low + x + z, -z, y);  // right
    addQuad(mesh, low, z, y);           // left
    addQuad(mesh, low + y + z, x, -z);  // top
    addQuad(mesh, low, x, z);           // bottom
    return mesh;
}

MeshDesc makeSphere(float radius, int rings)
{
    MeshDesc mesh;
    const int segments = rings * 2;
    for (int ring = 0; ring <= rings; ++ring) {
        const double polar = glm::pi<double>() * ring / rings;
        for (int segment = 0; segment <= segments; ++segment) {
            const double around = 2.0 * glm::pi<double>() * segment / segments;
            const glm::vec3 normal = {std::sin(polar) * std::cos(around), std::cos(polar),
                                      -std::sin(polar) * std::sin(around)};
            addVertex(mesh, normal * radius, normal, static_cast<float>(segment) / segments,
                      1.0f - static_cast<float>(ring) / rings);
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const auto above = static_cast<std::uint32_t>(ring * (segments + 1) + segment);
            const std::uint32_t below = above + segments + 1;
            // At the poles one of the two triangles has no area.
            std::vector<std::uint32_t>& indices = mesh.indices;
            if (ring + 1 < rings) indices.insert(indices.end(), {above, below, below + 1});
            if (ring > 0) indices.insert(indices.end(), {above, below + 1, above + 1});
        }
    }
    return mesh;
}

MeshDesc makeStairs(int count, float width, float rise, float run)
{
    MeshDesc mesh;
    const glm::vec3 across = {width, 0, 0};
    const glm::vec3 left = {-width / 2, 0, 0};
    for (int step = 0; step < count; ++step) {
        const glm::vec3 foot = left + glm::vec3(0, step * rise, -step * run);
        const glm::vec3 edge = foot + glm::vec3(0, rise, 0);
        const glm::vec3 floor = left + glm::vec3(0, 0, -step * run);
        const glm::vec3 height = {0, (step + 1) * rise, 0};
        addQuad(mesh, foot, across, {0, rise, 0});
        addQuad(mesh, edge, across, {0, 0, -run});
        addQuad(mesh, floor - glm::vec3(0, 0, run), {0, 0, run}, height);
        addQuad(mesh, floor + across, {0, 0, -run}, height);
    }
    const glm::vec3 rear = left + glm::vec3(0, 0, -count * run);
    addQuad(mesh, rear + across, -across, {0, count * rise, 0});
    addQuad(mesh, rear, across, {0, 0, count * run});
    return mesh;
}

void append(MeshDesc& mesh, const MeshDesc& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

}  // namespace crevice
