// SPDX-License-Identifier: MIT
// Normals, winding and shared vertices of imported meshes.
#include "tools/render/scene/mesh_normals.h"

#include "tests/support/catch.h"
#include "tools/render/scene/file/import.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

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

TEST_CASE("A surface is wound as its normals face, and so is a lone triangle of it")
{
    const MeshDesc right = joined(makeBox({0, 0, 0}, {1, 2, 3}), makeBox({5, 0, 0}, {6, 1, 1}));
    MeshDesc wrong = right;
    for (std::size_t i = 36; i < 72; i += 3) std::swap(wrong.indices[i + 1], wrong.indices[i + 2]);
    std::swap(wrong.indices[1], wrong.indices[2]);
    windByNormals(wrong);
    CHECK(wrong.indices == right.indices);
}

TEST_CASE("normals that face away from a triangle become its own, and those that lean stay")
{
    MeshDesc box = makeBox({0, 0, 0}, {1, 2, 3}), sphere = makeSphere(1, 3);
    const MeshDesc right = box;
    for (std::size_t k = 3; k < 6; ++k)  // one triangle's, of which two are another's too
        for (float& axis : box.vertices[box.indices[k]].normal) axis = -axis;
    windByNormals(box);
    CHECK(turnNormals(box) == 2);
    CHECK(box.vertices.size() == right.vertices.size() + 5);  // a corner each
    for (std::size_t k = 0; k < right.indices.size(); ++k)
        CHECK(normalOf(box.vertices[box.indices[k]]) == normalOf(right.vertices[right.indices[k]]));
    CHECK(turnNormals(sphere) == 0);
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

TEST_CASE("a closed surface that is inside out is turned, a room is not")
{
    const glm::dmat4 here(1.0), aside = glm::translate(here, {3, 0, 0});
    const MeshDesc box = makeBox({0, 0, 0}, {1, 1, 1}),
                   crate = makeBox({0.4f, 0, 0.4f}, {0.6f, 0.2f, 0.6f});
    MeshDesc inward = box;
    for (std::size_t k = 0; k < 36; k += 3) std::swap(inward.indices[k + 1], inward.indices[k + 2]);
    for (Vertex& vertex : inward.vertices)
        for (float& axis : vertex.normal) axis = -axis;
    MeshDesc lidless = inward;
    lidless.indices.resize(30);
    const std::vector<SceneInstance> once = {{0, here}}, twice = {{0, here}, {0, aside}};
    const struct {
        MeshDesc mesh;
        std::vector<SceneInstance> instances;
        double eye;
        bool turned;
    } rows[] = {
        {inward, once, 4, true},
        {inward, once, 0.5, false},
        {inward, twice, 0.5, false},
        {inward, twice, 4, true},
        {inward, {{0, glm::scale(here, {-1, 2, 1})}}, 4, true},
        {inward, {{0, here}, {1, here}}, 4, false},
        {inward, {{0, aside}, {1, here}}, 4, true},
        {joined(inward, crate), once, 4, false},
        {joined(inward, makeQuad({-3, 0, 3}, {7, 0, 0}, {0, 0, -5})), once, 4, true},
        {lidless, once, 4, false},
        {box, once, 4, false},
    };
    for (const auto& [mesh, instances, eye, turned] : rows) {
        CAPTURE(&instances - &rows[0].instances);
        Scene scene;
        scene.meshes = {mesh, crate};
        scene.instances = instances;
        scene.cameras.emplace_back().view_from_world = glm::translate(here, {-0.5, -0.5, -eye});
        CHECK(turnInsideOut(scene) == (turned ? 1 : 0));
        CHECK((scene.meshes[0].indices != mesh.indices) == turned);
        if (turned) CHECK(normalOf(scene.meshes[0].vertices[0]) == normalOf(box.vertices[0]));
    }
}
