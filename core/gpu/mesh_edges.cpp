// SPDX-License-Identifier: MIT
#include "core/gpu/mesh_edges.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace crevice {

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
    std::vector<MeshEdge> edges;
    edges.reserve(positions.size());
    for (std::uint32_t corner = 0; corner < positions.size(); ++corner) {
        const std::uint64_t a = positions[corner], b = positions[nextCorner(corner)];
        edges.push_back({std::min(a, b) << 32 | std::max(a, b), corner});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace crevice
