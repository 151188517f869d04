// SPDX-License-Identifier: MIT
#include "tools/render/scene/mesh_normals.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace crevice {

namespace {

constexpr double kDegreeInRadians = 3.14159265358979323846 / 180.0;
constexpr std::uint32_t kNone = ~0u;

// A surface is open where its outline squared is more than this times its area. A square sheet has
// 16, half a sphere 6, a box without its lid 3, a pipe 0.4 at a length of 30 diameters, a sphere
// 0.03 with a round hole of a tenth of its width.
constexpr double kOpenOutline = 1.0;

// Of the mesh's size, from corner to corner: above what floats round, below what anyone models.
constexpr double kWeld = 1e-5;

using Indices = std::vector<std::uint32_t>;

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
    for (std::size_t first = 0; first + 2 < corners.size(); first += 3)
        normals.push_back(unit(areaOf(corners[first], corners[first + 1], corners[first + 2])));
    return normals;
}

std::uint32_t nextCorner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

// Disjoint sets: of corners that belong to one smooth surface, of positions that edges connect.
class Groups {
public:
    explicit Groups(std::size_t corners) : parent_(corners)
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

Groups smoothGroups(const Indices& positions, const std::vector<glm::dvec3>& normals,
                    double least_cosine)
{
    Groups groups(positions.size());
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

// For each vertex the first one at the same place, within a share of the mesh's size: the two sides
// of a seam round differently. A pair that rounding to the grid parts does no harm, as an outline
// has to be long.
Indices welded(std::vector<Vertex> vertices)
{
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const Vertex& vertex : vertices) {
        low = glm::min(low, positionOf(vertex));
        high = glm::max(high, positionOf(vertex));
    }
    const double cell = std::max(glm::length(high - low), 1e-30) * kWeld;
    for (Vertex& vertex : vertices)
        for (int axis = 0; axis < 3; ++axis)
            vertex.position[axis] =
                static_cast<float>(std::round((vertex.position[axis] - low[axis]) / cell));
    return firstEqual(vertices, sizeof(Vertex::position));
}

// Of one connected surface.
struct Surface {
    double area = 0;
    double outline = 0;  // length of the edges that one triangle has
};

// By the group of their positions. Triangles without area, such as those at poles, are no part of
// them.
std::vector<Surface> surfacesOf(const MeshDesc& mesh, const Indices& positions)
{
    Groups groups(mesh.vertices.size());
    std::vector<double> areas;
    Indices kept;
    for (std::size_t first = 0; first + 2 < positions.size(); first += 3) {
        const std::uint32_t* at = &positions[first];
        const double area = 0.5 * glm::length(areaOf(mesh.vertices[at[0]], mesh.vertices[at[1]],
                                                     mesh.vertices[at[2]]));
        if (!(area > 0.0)) continue;
        kept.insert(kept.end(), at, at + 3);
        areas.push_back(area);
        groups.join(at[0], at[1]);
        groups.join(at[1], at[2]);
    }
    std::vector<Surface> surfaces(mesh.vertices.size());
    for (std::size_t k = 0; k < areas.size(); ++k)
        surfaces[groups.find(kept[3 * k])].area += areas[k];
    const std::vector<Edge> edges = sortedEdges(kept);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (k > 0 && edges[k - 1].ends == edges[k].ends) continue;
        if (k + 1 < edges.size() && edges[k + 1].ends == edges[k].ends) continue;
        const std::uint32_t from = kept[edges[k].corner], to = kept[nextCorner(edges[k].corner)];
        surfaces[groups.find(from)].outline +=
            glm::length(positionOf(mesh.vertices[from]) - positionOf(mesh.vertices[to]));
    }
    return surfaces;
}

}  // namespace

void smoothNormals(MeshDesc& mesh, double crease_degrees)
{
    separateVertices(mesh);
    const std::vector<glm::dvec3> normals = faceNormals(mesh.vertices);
    const Indices positions = firstEqual(mesh.vertices, sizeof(Vertex::position));
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

void finishMesh(MeshDesc& mesh, bool has_normals, double crease_degrees)
{
    if (has_normals)
        windByNormals(mesh);
    else
        smoothNormals(mesh, crease_degrees);
    fillNormals(mesh);
    joinVertices(mesh);
}

bool isOpen(const MeshDesc& mesh)
{
    const Indices positions = welded(mesh.vertices);
    Indices corners;
    corners.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) corners.push_back(positions[index]);
    double area = 0, open = 0;
    for (const Surface& each : surfacesOf(mesh, corners)) {
        area += each.area;
        if (each.outline * each.outline > kOpenOutline * each.area) open += each.area;
    }
    return open > 0.5 * area;
}

}  // namespace crevice
