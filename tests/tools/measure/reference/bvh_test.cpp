// SPDX-License-Identifier: MIT
// Trees of boxes: what they hold, how deep they are, and boxes that cannot be told apart.
#include "tools/measure/reference/bvh.h"

#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace crevice;

namespace {

std::vector<BvhBox> randomBoxes(int count, float size)
{
    std::mt19937 random(7);
    const auto coordinate = [&random] {
        return static_cast<float>(random() >> 8) / (1 << 23) - 1.0f;
    };
    std::vector<BvhBox> boxes;
    for (int k = 0; k < count; ++k) {
        const float x = coordinate(), y = coordinate(), z = coordinate();
        boxes.push_back({{x, y, z}, {x + size, y + size, z + size}});
    }
    return boxes;
}

bool holds(const glm::vec3& low, const glm::vec3& high, const glm::vec3& inner_low,
           const glm::vec3& inner_high)
{
    return glm::min(low, inner_low) == low && glm::max(high, inner_high) == high;
}

// Walks all nodes and checks what a search relies on; gives the depth of the deepest.
int checkedDepth(const Bvh& bvh, const std::vector<BvhBox>& boxes)
{
    struct Visit {
        std::uint32_t node;
        int depth;
    };
    std::vector<Visit> visits = {{0, 0}};
    std::vector<int> seen(boxes.size(), 0);
    int deepest = 0, outside = 0;
    while (!visits.empty()) {
        const auto [index, depth] = visits.back();
        visits.pop_back();
        deepest = std::max(deepest, depth);
        const BvhNode& node = bvh.nodes[index];
        for (std::uint32_t k = 0; k < node.count; ++k) {
            const std::uint32_t item = bvh.order[node.first + k];
            ++seen[item];
            outside += !holds(node.low, node.high, boxes[item].low, boxes[item].high);
        }
        if (node.count > 0) continue;
        for (std::uint32_t child = node.first; child < node.first + 2; ++child) {
            outside += !holds(node.low, node.high, bvh.nodes[child].low, bvh.nodes[child].high);
            visits.push_back({child, depth + 1});
        }
    }
    CHECK(outside == 0);
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(seen.size()));
    return deepest;
}

}  // namespace

TEST_CASE("a tree holds each box once, inside of all nodes above it")
{
    for (const int count : {1, 2, 3, 9, 100, 5000}) {
        const std::vector<BvhBox> boxes = randomBoxes(count, 0.01f);
        CHECK(checkedDepth(buildBvh(boxes), boxes) <= 2 * std::log2(count) + 2);
    }
}

TEST_CASE("no tree is deeper than a walk has room for")
{
    // Rows along each axis, whose sizes fall by half: a cut takes a few boxes off their ends.
    std::vector<BvhBox> boxes;
    for (int axis = 0; axis < 3; ++axis) {
        for (int exponent = 60; exponent > -120; --exponent) {
            glm::vec3 place(0.0f);
            place[axis] = std::ldexp(1.0f, exponent);
            boxes.push_back({place, place * 1.25f});
        }
    }
    const int alone = checkedDepth(buildBvh(boxes), boxes);
    CHECK(alone > 32);  // it is a hard case
    boxes.insert(boxes.end(), 100000, boxes.back());
    CHECK(checkedDepth(buildBvh(boxes), boxes) < kMaxBvhDepth);
}
