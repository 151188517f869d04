// SPDX-License-Identifier: MIT
// Which vertices of a mesh are the same, and which triangles its edges connect, in time that grows
// with n log n whatever the mesh looks like.
#pragma once

#include <crevice/device.h>

namespace crevice {

/// For each vertex the first one whose leading `bytes` are the same: 12 compares positions.
std::vector<std::uint32_t> firstEqual(const std::vector<Vertex>& vertices, std::size_t bytes);

/// The one that follows in its triangle.
inline std::uint32_t nextCorner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Disjoint sets of 0 to count - 1.
class Groups {
public:
    explicit Groups(std::size_t count);
    std::uint32_t find(std::uint32_t each);
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> parent_;
};

constexpr std::uint32_t kNoSurface = ~0u;

/// For each triangle the number of its connected surface, from 0 on; kNoSurface for one without
/// area, such as those at poles. Vertices within a hair of the mesh's size are one.
std::vector<std::uint32_t> surfacesOf(const MeshDesc& mesh);

/// A triangle's edge, by the positions of its ends, and the corner that it begins at.
struct MeshEdge {
    std::pair<std::uint32_t, std::uint32_t> ends;  ///< The lesser first.
    std::uint32_t corner;

    bool operator<(const MeshEdge& other) const
    {
        return ends != other.ends ? ends < other.ends : corner < other.corner;
    }
};

/// Of triangles, three corners each, by the numbers of their positions: those between the same ends
/// in a row.
std::vector<MeshEdge> sortedEdges(const std::vector<std::uint32_t>& positions);

}  // namespace crevice
