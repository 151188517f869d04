// SPDX-License-Identifier: MIT
// Meshes that no device takes, refused before any memory is asked for.
#include <crevice/device.h>

#include "tests/support/catch.h"

using namespace crevice;

namespace {

constexpr std::uint64_t kVertices = 67108863;  // of 32 bytes in 2^31 - 1
constexpr std::uint64_t kIndices = 536870911;  // of 4

Code codeOf(const Status& status)
{
    return status.diagnostics().size() == 1 ? status.diagnostics()[0].code : Code::internal;
}

MeshDesc mesh(std::size_t vertices, std::vector<std::uint32_t> indices)
{
    return {"broken", std::vector<Vertex>(vertices), std::move(indices)};
}

}  // namespace

TEST_CASE("A mesh of 2 GiB or more is refused, whether by its vertices or by its indices")
{
    static_assert(sizeof(Vertex) == 32);
    CHECK(checkMeshSize("most", kVertices, kIndices).ok());
    CHECK(codeOf(checkMeshSize("mesh", kVertices + 1, 3)) == Code::too_big_for_device);
    CHECK(codeOf(checkMeshSize("mesh", 3, kIndices + 1)) == Code::too_big_for_device);
    for (const int shift : {27, 32, 59, 60, 63}) {  // bytes that wrap around to few, too
        const std::uint64_t many = std::uint64_t(1) << shift;
        CHECK(codeOf(checkMeshSize("mesh", many, 0)) == Code::too_big_for_device);
    }
    for (const int shift : {30, 62, 63})
        CHECK(codeOf(checkMeshSize("mesh", 0, std::uint64_t(1) << shift)) ==
              Code::too_big_for_device);
    const Diagnostic error = checkMeshSize("bunny", 1u << 27, 0).diagnostics().front();
    CHECK(error.message ==
          "mesh 'bunny' has 134217728 vertices and 0 indices; one mesh holds "
          "67108863 and 536870911");
}

TEST_CASE("A mesh without triangles is fine, and one with an index past its vertices is refused")
{
    CHECK(checkMesh(mesh(0, {})).ok());
    CHECK(checkMesh(mesh(3, {})).ok());
    CHECK(checkMesh(mesh(3, {0, 1, 2})).ok());
    CHECK(codeOf(checkMesh(mesh(0, {0, 0, 0}))) == Code::bad_input);
    CHECK(codeOf(checkMesh(mesh(3, {0, 3, 2}))) == Code::bad_input);
    CHECK(codeOf(checkMesh(mesh(3, {0, 1, 0xffffffff}))) == Code::bad_input);
}
