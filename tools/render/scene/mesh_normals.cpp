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

// A normal leans up to 90 degrees from its face's, and as far beyond as normals in bytes are off.
constexpr double kFacesAway = -0.02;  // cosine

// Area, of the distance from the origin squared, of triangles too thin for floats to say where they
// face.
constexpr double kThin = 1e-7;

// Of the largest triangle: area of those that rounding alone gives one, such as those at poles.
constexpr double kNoArea = 1e-9;

glm::dvec3 positionOf(const Vertex& vertex) { return glm::make_vec3(vertex.position); }

// Along the normal of the triangle, and twice as long as its area is large.
glm::dvec3 areaOf(const Vertex& a, const Vertex& b, const Vertex& c)
{
    return glm::cross(positionOf(b) - positionOf(a), positionOf(c) - positionOf(a));
}

glm::dvec3 areaOf(const MeshDesc& mesh, std::size_t triangle)
{
    const std::uint32_t* const at = &mesh.indices[3 * triangle];
    return areaOf(mesh.vertices[at[0]], mesh.vertices[at[1]], mesh.vertices[at[2]]);
}

glm::dvec3 normalOf(const Vertex& vertex) { return glm::make_vec3(vertex.normal); }

void setNormal(Vertex& vertex, const glm::dvec3& normal)
{
    for (int axis = 0; axis < 3; ++axis) vertex.normal[axis] = static_cast<float>(normal[axis]);
}

bool hasNormal(const Vertex& vertex) { return normalOf(vertex) != glm::dvec3(0.0); }

// Zero where it has no length.
glm::dvec3 unit(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

// Of each corner, by number.
std::vector<std::uint32_t> positionsOf(const MeshDesc& mesh)
{
    std::vector<std::uint32_t> positions = mesh.indices;
    const std::vector<std::uint32_t> first = firstEqual(mesh.vertices, sizeof(Vertex::position));
    for (std::uint32_t& each : positions) each = first[each];
    return positions;
}

// Of triangles: those that share an edge with one other, and pass along it in opposite directions.
Groups woundAlike(const MeshDesc& mesh)
{
    const std::vector<std::uint32_t> positions = positionsOf(mesh);
    const std::vector<MeshEdge> edges = sortedEdges(positions);
    Groups groups(positions.size() / 3);
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
        const std::uint32_t a = edges[begin].corner, b = edges[end - 1].corner;
        if (end - begin == 2 && positions[a] != positions[b]) groups.join(a / 3, b / 3);
    }
    return groups;
}

// Of corners: those at one place, of faces that join smoothly there.
Groups smoothGroups(const MeshDesc& mesh, const std::vector<glm::dvec3>& normals,
                    double least_cosine)
{
    const std::vector<std::uint32_t> positions = positionsOf(mesh);
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
double cornerAngle(const MeshDesc& mesh, std::uint32_t corner)
{
    const auto place = [&](std::uint32_t of) {
        return positionOf(mesh.vertices[mesh.indices[of]]);
    };
    const std::uint32_t next = nextCorner(corner);
    const glm::dvec3 at = place(corner);
    const double cosine = glm::dot(unit(place(next) - at), unit(place(nextCorner(next)) - at));
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

void smoothNormals(MeshDesc& mesh, double crease_degrees)
{
    mesh.indices.resize(mesh.indices.size() / 3 * 3);
    const auto corners = static_cast<std::uint32_t>(mesh.indices.size());
    std::vector<glm::dvec3> normals(corners / 3);
    for (std::size_t k = 0; k < normals.size(); ++k) normals[k] = unit(areaOf(mesh, k));
    Groups groups = smoothGroups(mesh, normals, std::cos(crease_degrees * kDegreeInRadians));
    struct Sum {
        glm::dvec3 normal = glm::dvec3(0.0);
        std::uint32_t from = kNone, made = kNone;  // the group's last vertex
    };
    std::uint32_t count = 0;
    std::vector<std::uint32_t> numbers(corners, kNone);
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        std::uint32_t& number = numbers[groups.find(corner)];
        if (number == kNone) number = count++;
    }
    std::vector<Sum> sums(count);
    for (std::uint32_t corner = 0; corner < corners; ++corner)
        sums[numbers[groups.find(corner)]].normal +=
            normals[corner / 3] * cornerAngle(mesh, corner);
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.vertices.size());
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
        Sum& sum = sums[numbers[groups.find(corner)]];
        std::uint32_t& index = mesh.indices[corner];
        if (sum.from != index) {
            sum.from = index;
            sum.made = static_cast<std::uint32_t>(vertices.size());
            setNormal(vertices.emplace_back(mesh.vertices[index]), unit(sum.normal));
        }
        index = sum.made;
    }
    mesh.vertices = std::move(vertices);
}

void windByNormals(MeshDesc& mesh)
{
    std::vector<double> facing(mesh.indices.size() / 3);
    double largest = 0;
    for (std::size_t k = 0; k < facing.size(); ++k) {
        const std::uint32_t* const at = &mesh.indices[3 * k];
        glm::dvec3 normals = normalOf(mesh.vertices[at[0]]);
        for (int corner : {1, 2}) normals += normalOf(mesh.vertices[at[corner]]);
        facing[k] = glm::dot(areaOf(mesh, k), normals);
        largest = std::max(largest, facing[k]);
    }
    const auto against = [&](double each) { return each < -kNoArea * largest; };
    if (std::none_of(facing.begin(), facing.end(), against)) return;
    Groups groups = woundAlike(mesh);
    std::vector<double> sums(facing.size());
    for (std::uint32_t k = 0; k < facing.size(); ++k) sums[groups.find(k)] += facing[k];
    for (std::uint32_t k = 0; k < facing.size(); ++k)
        if (sums[groups.find(k)] < 0) std::swap(mesh.indices[3 * k + 1], mesh.indices[3 * k + 2]);
}

std::size_t turnNormals(MeshDesc& mesh)
{
    std::size_t triangles = 0;
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        const glm::dvec3 area = areaOf(mesh, k / 3);
        const double least = kFacesAway * glm::length(area);
        int turned = 0;
        for (std::size_t corner = k; corner < k + 3; ++corner) {
            Vertex vertex = mesh.vertices[mesh.indices[corner]];
            const glm::dvec3 place = positionOf(vertex);
            if (!(glm::dot(area, normalOf(vertex)) < least)) continue;
            if (glm::length(area) < kThin * glm::dot(place, place)) continue;
            ++turned;
            setNormal(vertex, unit(area));
            mesh.indices[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(vertex);
        }
        triangles += turned > 1;
    }
    return triangles;
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
    joined.reserve(mesh.vertices.size());
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

std::size_t finishMesh(MeshDesc& mesh, bool has_normals, double crease_degrees)
{
    std::size_t turned = 0;
    if (has_normals) {
        windByNormals(mesh);
        turned = turnNormals(mesh);
        fillNormals(mesh);
    } else if (crease_degrees > 0) {
        smoothNormals(mesh, crease_degrees);
        fillNormals(mesh);
    }
    joinVertices(mesh);
    return turned;
}

}  // namespace crevice
