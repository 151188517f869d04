// SPDX-License-Identifier: MIT
// A tree of boxes: each holds the boxes of its two children, each leaf some items that lie close
// together.
//
// Source: Wald 2007.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace crevice {

/// Deepest leaf of any tree, the root at 0: a walk never has more nodes in store.
constexpr int kMaxBvhDepth = 64;

/// An axis-aligned box, which holds nothing at first.
struct BvhBox {
    glm::vec3 low = glm::vec3(std::numeric_limits<float>::infinity());
    glm::vec3 high = -low;

    void add(const glm::vec3& lowest, const glm::vec3& highest)
    {
        low = glm::min(low, lowest);
        high = glm::max(high, highest);
    }
};

/// Two children lie side by side.
struct BvhNode {
    glm::vec3 low;
    std::uint32_t first;  ///< Its first child, or the first place in Bvh::order of a leaf.
    glm::vec3 high;
    std::uint32_t count;  ///< Items of a leaf; 0 in a node that has children.
};
static_assert(sizeof(BvhNode) == 32, "two children fill a cache line");

struct Bvh {
    std::vector<BvhNode> nodes;        ///< The root first; none where there are no items.
    std::vector<std::uint32_t> order;  ///< Items, leaf by leaf.
};

/// The same boxes, of finite numbers, give the same tree. Takes at most 2^31 boxes.
Bvh buildBvh(const std::vector<BvhBox>& boxes);

}  // namespace crevice
