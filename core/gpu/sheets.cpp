// SPDX-License-Identifier: MIT
// Which triangles of a mesh are sheets: surfaces with open edges, such as leaves and cloth.
#include "core/gpu/mesh_edges.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <utility>

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

}  // namespace

std::vector<std::uint32_t> sheetsOf(const MeshDesc& mesh)
{
    const std::vector<std::uint32_t> positions = welded(mesh.vertices);
    // Triangles without area, such as those at poles, are no part of a surface.
    std::vector<std::uint32_t> corners, firsts;
    std::vector<double> areas;
    Groups groups(mesh.vertices.size());
    std::vector<Surface> surfaces(mesh.vertices.size());
    for (std::uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const double area = areaOf(mesh, &mesh.indices[first]);
        if (!(area > 0.0)) continue;
        firsts.push_back(first);
        areas.push_back(area);
        for (std::uint32_t k = first; k < first + 3; ++k)
            corners.push_back(positions[mesh.indices[k]]);
        groups.join(corners.end()[-3], corners.end()[-2]);
        groups.join(corners.end()[-2], corners.end()[-1]);
    }
    for (std::size_t k = 0; k < firsts.size(); ++k)
        surfaces[groups.find(corners[3 * k])].area += areas[k];
    const std::vector<MeshEdge> edges = sortedEdges(corners);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (k > 0 && edges[k - 1].ends == edges[k].ends) continue;
        if (k + 1 < edges.size() && edges[k + 1].ends == edges[k].ends) continue;
        const std::uint32_t from = corners[edges[k].corner];
        const std::uint32_t to = corners[nextCorner(edges[k].corner)];
        surfaces[groups.find(from)].outline +=
            glm::length(positionOf(mesh.vertices[from]) - positionOf(mesh.vertices[to]));
    }
    std::vector<std::uint32_t> sheets;
    for (std::size_t k = 0; k < firsts.size(); ++k)
        if (surfaces[groups.find(corners[3 * k])].open()) sheets.push_back(firsts[k]);
    return sheets;
}

}  // namespace crevice
