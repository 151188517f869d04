// SPDX-License-Identifier: MIT
// Which triangles of a mesh are sheets.
// Meshes that no device takes, refused before any memory is asked for.
#include <crevice/device.h>

#include "tests/support/need.h"
#include "tools/render/scene/mesh_shapes.h"

#include <limits>

using namespace crevice;

namespace {

/// Whether all of the mesh is sheets, or nothing.
bool isOpen(const MeshDesc& mesh)
{
    const std::size_t sheets = sheetsOf(mesh).size();
    CHECK((sheets == 0 || 3 * sheets == mesh.indices.size()));
    return sheets > 0;
}

constexpr std::uint64_t kVertices = 67108863;  // of 32 bytes in 2^31 - 1
constexpr std::uint64_t kIndices = 536870911;  // of 4

MeshDesc mesh(std::size_t vertices, std::vector<std::uint32_t> indices)
{
    return {"broken", std::vector<Vertex>(vertices), std::move(indices)};
}

}  // namespace

TEST_CASE("a surface with a long outline is open, a body with seams and small holes is not")
{
    const MeshDesc box = makeBox({-1, -1, -1}, {1, 2, 3});
    MeshDesc without_face = box;
    without_face.indices.resize(box.indices.size() - 6);
    MeshDesc sphere = makeSphere(2.0f, 24);  // its two sides meet at a seam, where they round apart
    for (Vertex& vertex : sphere.vertices) vertex.position[0] += 7.0f;
    MeshDesc half = sphere;
    half.indices.resize(half.indices.size() / 2);
    MeshDesc far_away = half;
    for (Vertex& vertex : far_away.vertices) vertex.position[1] += 1e6f;
    for (const MeshDesc& mesh : {box, MeshDesc()}) CHECK_FALSE(isOpen(mesh));
    MeshDesc holed = sphere;
    holed.indices.erase(holed.indices.begin() + 600, holed.indices.begin() + 606);
    for (const MeshDesc& mesh : {sphere, holed}) CHECK(sheetsOf(mesh).empty());
    for (const MeshDesc& mesh : {makeQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), without_face})
        CHECK(isOpen(mesh));
    for (const MeshDesc& mesh : {half, far_away}) CHECK(sheetsOf(mesh).size() > 500);
}

TEST_CASE("of a mesh that was merged those surfaces are sheets that would be alone")
{
    MeshDesc merged = makeBox({0, 0, 0}, {1, 1, 1});
    const auto first = static_cast<std::uint32_t>(merged.indices.size());
    append(merged, makeQuad({3, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    append(merged, makeBox({0, 4, 0}, {1, 5, 1}));
    CHECK(sheetsOf(merged) == std::vector<std::uint32_t>{first, first + 3});
}

TEST_CASE("what is no number and what has no area is no sheet")
{
    MeshDesc mesh = makeQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.vertices[0].position[0] = std::numeric_limits<float>::quiet_NaN();
    mesh.indices = {0, 1, 2, 1, 1, 2};
    CHECK(sheetsOf(mesh).empty());
}

TEST_CASE("A mesh of 2 GiB or more is refused, whether by its vertices or by its indices")
{
    static_assert(sizeof(Vertex) == 32);
    CHECK(checkMeshSize("most", kVertices, kIndices).ok());
    const auto refusal = [](std::uint64_t vertices, std::uint64_t indices) {
        return onlyError(checkMeshSize("bunny", vertices, indices), Code::too_big_for_device);
    };
    refusal(kVertices + 1, 3);
    refusal(3, kIndices + 1);
    constexpr std::uint64_t one = 1;  // shifted to bytes that wrap around to few, too
    for (const int shift : {32, 59, 60, 63}) refusal(one << shift, 0);
    for (const int shift : {30, 62, 63}) refusal(0, one << shift);
    CHECK(refusal(one << 27, 0).message ==
          "mesh 'bunny' has 134217728 vertices and 0 indices; one mesh holds "
          "67108863 and 536870911");
}

TEST_CASE("A mesh without triangles is fine, and one with an index past its vertices is refused")
{
    need(checkMesh(mesh(0, {})));
    need(checkMesh(mesh(3, {})));
    need(checkMesh(mesh(3, {0, 1, 2})));
    onlyError(checkMesh(mesh(0, {0, 0, 0})), Code::bad_input);
    for (const std::uint32_t past : {3u, 0xffffffffu})
        onlyError(checkMesh(mesh(3, {0, 1, past})), Code::bad_input);
}
