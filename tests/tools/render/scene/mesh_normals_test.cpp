// SPDX-License-Identifier: MIT
// Normals, shared vertices and open edges of imported meshes.
#include "tools/render/scene/mesh_normals.h"

#include "tests/support/catch.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>

using namespace crevice;

namespace {

glm::vec3 normalOf(const Vertex& vertex)
{
    return {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
}

MeshDesc joined(MeshDesc mesh, const MeshDesc& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(index + first);
    return mesh;
}

// Two unit squares that share the edge x = 0, the right one turned up by `height` per unit.
MeshDesc roof(float height)
{
    MeshDesc mesh = joined(makeQuad({-1, 0, 1}, {1, 0, 0}, {0, 0, -2}),
                           makeQuad({0, 0, 1}, {1, height, 0}, {0, 0, -2}));
    for (Vertex& vertex : mesh.vertices) {
        std::fill_n(vertex.normal, 3, 0.0f);
        std::fill_n(vertex.uv, 2, 0.0f);
    }
    return mesh;
}

}  // namespace

TEST_CASE("faces that meet at less than the crease share a normal, others do not")
{
    MeshDesc gentle = roof(0.5f), sharp = roof(3.0f);
    for (MeshDesc* mesh : {&gentle, &sharp}) {
        smoothNormals(*mesh, 60);
        joinVertices(*mesh);
        for (const Vertex& vertex : mesh->vertices)
            CHECK(glm::length(normalOf(vertex)) == Approx(1));
    }
    CHECK(gentle.vertices.size() == 6);
    CHECK(sharp.vertices.size() == 8);
}

TEST_CASE("A mesh is wound as its normals face")
{
    const MeshDesc box = makeBox({0, 0, 0}, {1, 2, 3});
    MeshDesc reversed = box;
    for (std::size_t i = 0; i < reversed.indices.size(); i += 3)
        std::swap(reversed.indices[i + 1], reversed.indices[i + 2]);
    windByNormals(reversed);
    CHECK(reversed.indices == box.indices);
    MeshDesc same = box;
    windByNormals(same);
    CHECK(same.indices == box.indices);
}

TEST_CASE("missing normals become those of the face, beside one that is there")
{
    const MeshDesc quad = [] {
        MeshDesc mesh = makeQuad({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
        for (Vertex& vertex : mesh.vertices) std::fill_n(vertex.normal, 3, 0.0f);
        return mesh;
    }();
    MeshDesc mesh = quad;
    fillNormals(mesh);
    for (const Vertex& vertex : mesh.vertices) CHECK(normalOf(vertex) == glm::vec3(-1, 0, 0));
    mesh = quad;
    mesh.vertices[mesh.indices[0]].normal[1] = 1;
    fillNormals(mesh);
    CHECK(normalOf(mesh.vertices[mesh.indices[0]]) == glm::vec3(0, 1, 0));
    CHECK(normalOf(mesh.vertices[mesh.indices[1]]) == glm::vec3(-1, 0, 0));
    mesh = quad;
    mesh.indices = {0, 0, 0};  // a face without an area
    fillNormals(mesh);
    CHECK(normalOf(mesh.vertices[0]) == glm::vec3(0, 0, 1));
}
