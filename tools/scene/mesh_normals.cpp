// SPDX-License-Identifier: MIT
// Normals and shared vertices of imported meshes.
#include "tools/scene/mesh_normals.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace crevice {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr std::uint32_t kNone = ~0u;

using Indices = std::vector<std::uint32_t>;

glm::dvec3 positionOf(const Vertex& vertex)
{
    return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

void setNormal(Vertex& vertex, const glm::dvec3& normal)
{
    for (int axis = 0; axis < 3; ++axis) vertex.normal[axis] = static_cast<float>(normal[axis]);
}

bool hasNormal(const Vertex& vertex)
{
    return vertex.normal[0] != 0 || vertex.normal[1] != 0 || vertex.normal[2] != 0;
}

// Zero where it has no length.
glm::dvec3 unit(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

// For each vertex the first one whose leading `bytes` are the same: 12 compares positions.
Indices firstEqual(const std::vector<Vertex>& vertices, std::size_t bytes)
{
    std::size_t size = 16;
    while (size < vertices.size() * 2) size *= 2;
    Indices table(size, kNone), first(vertices.size());
    for (std::uint32_t index = 0; index < vertices.size(); ++index) {
        std::uint32_t words[sizeof(Vertex) / 4] = {};
        std::memcpy(words, &vertices[index], bytes);
        std::uint64_t hash = 0;
        for (const std::uint32_t word : words) {
            hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 29;
        }
        std::size_t slot = hash & (size - 1);
        while (table[slot] != kNone &&
               std::memcmp(&vertices[table[slot]], &vertices[index], bytes) != 0)
            slot = (slot + 1) & (size - 1);
        if (table[slot] == kNone) table[slot] = index;
        first[index] = table[slot];
    }
    return first;
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
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
        const glm::dvec3 origin = positionOf(corners[first]);
        normals.push_back(unit(glm::cross(positionOf(corners[first + 1]) - origin,
                                          positionOf(corners[first + 2]) - origin)));
    }
    return normals;
}

std::uint32_t nextCorner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

// Sets of corners at one position that belong to one smooth surface.
class SmoothGroups {
public:
    explicit SmoothGroups(std::size_t corners) : parent_(corners)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t find(std::uint32_t corner)
    {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }

    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    Indices parent_;
};

// A triangle's edge, by the positions of its ends, and the corner that it begins at.
struct Edge {
    std::uint64_t ends;
    std::uint32_t corner;

    bool operator<(const Edge& other) const
    {
        return ends != other.ends ? ends < other.ends : corner < other.corner;
    }
};

std::vector<Edge> sortedEdges(const Indices& positions)
{
    std::vector<Edge> edges;
    edges.reserve(positions.size());
    for (std::uint32_t corner = 0; corner < positions.size(); ++corner) {
        const std::uint64_t a = positions[corner], b = positions[nextCorner(corner)];
        edges.push_back({std::min(a, b) << 32 | std::max(a, b), corner});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

SmoothGroups smoothGroups(const Indices& positions, const std::vector<glm::dvec3>& normals,
                          double least_cosine)
{
    SmoothGroups groups(positions.size());
    const std::vector<Edge> edges = sortedEdges(positions);
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
    const Indices positions = firstEqual(mesh.vertices, sizeof(Vertex::position));
    SmoothGroups groups = smoothGroups(positions, normals, std::cos(crease_degrees * kDegree));
    std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0.0));
    for (std::uint32_t corner = 0; corner < sums.size(); ++corner)
        sums[groups.find(corner)] += normals[corner / 3] * cornerAngle(mesh.vertices, corner);
    for (std::uint32_t corner = 0; corner < sums.size(); ++corner)
        setNormal(mesh.vertices[corner], unit(sums[groups.find(corner)]));
}

void fillNormals(MeshDesc& mesh)
{
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Vertex* corners[3];
        for (int k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[first + k]];
        if (hasNormal(*corners[0]) && hasNormal(*corners[1]) && hasNormal(*corners[2])) continue;
        const glm::dvec3 origin = positionOf(*corners[0]);
        const glm::dvec3 normal =
            unit(glm::cross(positionOf(*corners[1]) - origin, positionOf(*corners[2]) - origin));
        for (Vertex* corner : corners)
            if (!hasNormal(*corner)) setNormal(*corner, normal);
    }
    for (Vertex& vertex : mesh.vertices)
        if (!hasNormal(vertex)) setNormal(vertex, {0, 0, 1});
}

void joinVertices(MeshDesc& mesh)
{
    const Indices first = firstEqual(mesh.vertices, sizeof(Vertex));
    Indices place(mesh.vertices.size(), kNone);
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

}  // namespace crevice
