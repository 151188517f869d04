// SPDX-License-Identifier: MIT
#include "tools/render/scene/mesh_normals.h"

#include "core/gpu/mesh_edges.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crevice {

namespace {

constexpr double kDegreeInRadians = 3.14159265358979323846 / 180.0;
constexpr std::uint32_t kNone = ~0u;

glm::dvec3 positionOf(const Vertex& vertex) { return glm::make_vec3(vertex.position); }

// Along the normal of the triangle, and twice as long as its area is large.
glm::dvec3 areaOf(const Vertex& a, const Vertex& b, const Vertex& c)
{
    return glm::cross(positionOf(b) - positionOf(a), positionOf(c) - positionOf(a));
}

void setNormal(Vertex& vertex, const glm::dvec3& normal)
{
    for (int axis = 0; axis < 3; ++axis) vertex.normal[axis] = static_cast<float>(normal[axis]);
}

bool hasNormal(const Vertex& vertex) { return glm::make_vec3(vertex.normal) != glm::vec3(0); }

// Zero where it has no length.
glm::dvec3 unit(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

void separateVertices(MeshDesc& mesh)
{
    std::vector<Vertex> corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) corners.push_back(mesh.vertices[index]);
    mesh.vertices = std::move(corners);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

std::vector<glm::dvec3> faceNormals(const std::vector<Vertex>& corners)
{
    std::vector<glm::dvec3> normals;
    normals.reserve(corners.size() / 3);
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3)
        normals.push_back(unit(areaOf(corners[first], corners[first + 1], corners[first + 2])));
    return normals;
}

Groups smoothGroups(const std::vector<std::uint32_t>& positions,
                    const std::vector<glm::dvec3>& normals, double least_cosine)
{
    Groups groups(positions.size());
    const std::vector<MeshEdge> edges = sortedEdges(positions);
    for (std::size_t k = 1; k < edges.size(); ++k) {
        const std::uint32_t a = edges[k - 1].corner, b = edges[k].corner;
        if (edges[k - 1].ends != edges[k].ends) continue;
        if (glm::dot(normals[a / 3], normals[b / 3]) < least_cosine) continue;
        const bool same_way = positions[a] == positions[b];
        groups.join(a, same_way ? b : nextCorner(b));
        groups.join(nextCorner(a), same_way ? nextCorner(b) : b);
    }
    return groups;
}

// Between the two edges of the triangle that meet at the corner.
double cornerAngle(const std::vector<Vertex>& corners, std::uint32_t corner)
{
    const std::uint32_t next = nextCorner(corner);
    const glm::dvec3 at = positionOf(corners[corner]);
    const double cosine = glm::dot(unit(positionOf(corners[next]) - at),
                                   unit(positionOf(corners[nextCorner(next)]) - at));
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

void smoothNormals(MeshDesc& mesh, double crease_degrees)
{
    separateVertices(mesh);
    const std::vector<glm::dvec3> normals = faceNormals(mesh.vertices);
    const std::vector<std::uint32_t> positions =
        firstEqual(mesh.vertices, sizeof(Vertex::position));
    Groups groups = smoothGroups(positions, normals, std::cos(crease_degrees * kDegreeInRadians));
    std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0.0));
    for (std::uint32_t corner = 0; corner < sums.size(); ++corner)
        sums[groups.find(corner)] += normals[corner / 3] * cornerAngle(mesh.vertices, corner);
    for (std::uint32_t corner = 0; corner < sums.size(); ++corner)
        setNormal(mesh.vertices[corner], unit(sums[groups.find(corner)]));
}

void windByNormals(MeshDesc& mesh)
{
    double facing = 0;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const Vertex* corners[3];
        for (std::size_t k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[first + k]];
        const glm::dvec3 area = areaOf(*corners[0], *corners[1], *corners[2]);
        for (const Vertex* corner : corners)
            facing += glm::dot(area, glm::dvec3(glm::make_vec3(corner->normal)));
    }
    if (!(facing < 0)) return;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3)
        std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
}

void fillNormals(MeshDesc& mesh)
{
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Vertex* corners[3];
        for (int k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[first + k]];
        if (hasNormal(*corners[0]) && hasNormal(*corners[1]) && hasNormal(*corners[2])) continue;
        const glm::dvec3 normal = unit(areaOf(*corners[0], *corners[1], *corners[2]));
        for (Vertex* corner : corners)
            if (!hasNormal(*corner)) setNormal(*corner, normal);
    }
    for (Vertex& vertex : mesh.vertices)
        if (!hasNormal(vertex)) setNormal(vertex, {0, 0, 1});
}

void joinVertices(MeshDesc& mesh)
{
    const std::vector<std::uint32_t> first = firstEqual(mesh.vertices, sizeof(Vertex));
    std::vector<std::uint32_t> place(mesh.vertices.size(), kNone);
    std::vector<Vertex> joined;
    for (std::uint32_t& index : mesh.indices) {
        const std::uint32_t vertex = first[index];
        if (place[vertex] == kNone) {
            place[vertex] = static_cast<std::uint32_t>(joined.size());
            joined.push_back(mesh.vertices[vertex]);
        }
        index = place[vertex];
    }
    mesh.vertices = std::move(joined);
}

void finishMesh(MeshDesc& mesh, bool has_normals, double crease_degrees)
{
    if (has_normals)
        windByNormals(mesh);
    else
        smoothNormals(mesh, crease_degrees);
    fillNormals(mesh);
    joinVertices(mesh);
}

}  // namespace crevice
