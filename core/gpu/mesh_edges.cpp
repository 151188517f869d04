// SPDX-License-Identifier: MIT
// Edges of a mesh; and its sheets: surfaces with open edges, such as leaves and cloth.
#include "core/gpu/mesh_edges.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace crevice {
namespace {

// A surface is open where its outline squared is more than this times its area. A square sheet has
// 16, half a sphere 6, a box without its lid 3, a pipe 0.4 at a length of 30 diameters, a sphere
// 0.03 with a round hole of a tenth of its width.
constexpr double kOpenOutline = 1.0;

// Of the mesh's size, from corner to corner: above what floats round, below what anyone models.
constexpr double kWeld = 1e-5;

glm::dvec3 positionOf(const Vertex& vertex)
{
    return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

// For each vertex the first one at the same place, within a share of the mesh's size: the two sides
// of a seam round differently. A pair that rounding to the grid parts does no harm, as an outline
// has to be long.
std::vector<std::uint32_t> welded(std::vector<Vertex> vertices)
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

// A connected surface.
struct Surface {
    double area = 0;
    double outline = 0;  // length of the edges that one triangle has

    bool open() const { return outline * outline > kOpenOutline * area; }
};

double areaOf(const MeshDesc& mesh, const std::uint32_t* corners)
{
    const glm::dvec3 a = positionOf(mesh.vertices[corners[0]]);
    return 0.5 * glm::length(glm::cross(positionOf(mesh.vertices[corners[1]]) - a,
                                        positionOf(mesh.vertices[corners[2]]) - a));
}

// As the public one, by the numbers of the vertices' places; and the triangles' areas.
std::vector<std::uint32_t> surfacesOf(const MeshDesc& mesh,
                                      const std::vector<std::uint32_t>& positions,
                                      std::vector<double>& areas)
{
    std::vector<std::uint32_t> surfaces, numbers(mesh.vertices.size(), kNoSurface);
    surfaces.reserve(mesh.indices.size() / 3);
    areas.reserve(mesh.indices.size() / 3);
    Groups groups(mesh.vertices.size());
    const auto place = [&](std::size_t corner) { return positions[mesh.indices[corner]]; };
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        areas.push_back(areaOf(mesh, &mesh.indices[first]));
        if (!(areas.back() > 0.0)) continue;
        groups.join(place(first), place(first + 1));
        groups.join(place(first + 1), place(first + 2));
    }
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < areas.size(); ++k) {
        surfaces.push_back(kNoSurface);
        if (!(areas[k] > 0.0)) continue;
        std::uint32_t& number = numbers[groups.find(place(3 * k))];
        if (number == kNoSurface) number = count++;
        surfaces[k] = number;
    }
    return surfaces;
}

}  // namespace

std::vector<std::uint32_t> firstEqual(const std::vector<Vertex>& vertices, std::size_t bytes)
{
    constexpr std::uint32_t kNone = ~0u;
    std::size_t size = 16;
    while (size < vertices.size() * 2) size *= 2;
    std::vector<std::uint32_t> table(size, kNone), first(vertices.size());
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

Groups::Groups(std::size_t count) : parent_(count)
{
    std::iota(parent_.begin(), parent_.end(), 0u);
}

std::uint32_t Groups::find(std::uint32_t each)
{
    while (parent_[each] != each) each = parent_[each] = parent_[parent_[each]];
    return each;
}

std::vector<MeshEdge> sortedEdges(const std::vector<std::uint32_t>& positions)
{
    const auto edgeAt = [&](std::uint32_t corner) -> MeshEdge {
        return {std::minmax(positions[corner], positions[nextCorner(corner)]), corner};
    };
    // First by the lesser end: where its edges begin, and after they are placed, where they end.
    std::vector<std::uint32_t> at;
    for (std::uint32_t corner = 0; corner < positions.size(); ++corner) {
        const std::size_t end = edgeAt(corner).ends.first;
        if (at.size() < end + 2) at.resize(end + 2);
        ++at[end + 1];
    }
    std::partial_sum(at.begin(), at.end(), at.begin());
    std::vector<MeshEdge> edges(positions.size());
    for (std::uint32_t corner = 0; corner < positions.size(); ++corner) {
        const MeshEdge edge = edgeAt(corner);
        edges[at[edge.ends.first]++] = edge;
    }
    std::uint32_t begin = 0;
    for (const std::uint32_t end : at) {
        std::sort(edges.begin() + begin, edges.begin() + end);
        begin = end;
    }
    return edges;
}

std::vector<std::uint32_t> surfacesOf(const MeshDesc& mesh)
{
    std::vector<double> areas;
    return surfacesOf(mesh, welded(mesh.vertices), areas);
}

std::vector<std::uint32_t> sheetsOf(const MeshDesc& mesh)
{
    const std::vector<std::uint32_t> positions = welded(mesh.vertices);
    std::vector<double> areas;
    const std::vector<std::uint32_t> numbers = surfacesOf(mesh, positions, areas);
    // Triangles without area, such as those at poles, are no part of a surface.
    std::vector<std::uint32_t> corners, firsts;
    corners.reserve(mesh.indices.size());
    firsts.reserve(numbers.size());
    std::vector<Surface> surfaces;
    for (std::uint32_t k = 0; k < numbers.size(); ++k) {
        if (numbers[k] == kNoSurface) continue;
        if (numbers[k] == surfaces.size()) surfaces.emplace_back();
        surfaces[numbers[k]].area += areas[k];
        firsts.push_back(3 * k);
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(positions[mesh.indices[3 * k + corner]]);
    }
    const std::vector<MeshEdge> edges = sortedEdges(corners);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (k > 0 && edges[k - 1].ends == edges[k].ends) continue;
        if (k + 1 < edges.size() && edges[k + 1].ends == edges[k].ends) continue;
        const std::uint32_t from = edges[k].corner;
        surfaces[numbers[firsts[from / 3] / 3]].outline +=
            glm::length(positionOf(mesh.vertices[corners[from]]) -
                        positionOf(mesh.vertices[corners[nextCorner(from)]]));
    }
    std::vector<std::uint32_t> sheets;
    for (const std::uint32_t first : firsts)
        if (surfaces[numbers[first / 3]].open()) sheets.push_back(first);
    return sheets;
}

}  // namespace crevice
