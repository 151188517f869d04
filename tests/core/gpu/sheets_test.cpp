// SPDX-License-Identifier: MIT
// Which triangles of a mesh are sheets.
#include <crevice/device.h>

#include "tests/support/catch.h"
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
