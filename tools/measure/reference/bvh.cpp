// SPDX-License-Identifier: MIT
// Building a tree from the root: each time the cut that lets a ray test the fewest boxes and items.
#include "tools/measure/reference/bvh.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr int kBins = 16;
constexpr std::size_t kMaxLeafItems = 8;
constexpr double kNodeCost = 1.0;  // of testing two boxes, where an item's test costs 1

// Beyond this depth nodes are halved, so that 2^31 items end within kMaxBvhDepth.
constexpr int kMaxCutDepth = kMaxBvhDepth - 32;

double halfArea(const BvhBox& box)
{
    const glm::dvec3 size = glm::dvec3(box.high) - glm::dvec3(box.low);
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Item {
    glm::vec3 low;
    std::uint32_t index;
    glm::vec3 high;

    glm::vec3 twiceCenter() const { return low + high; }
};

struct Bin {
    BvhBox box;
    std::size_t count = 0;
};

// Maps centres along an axis to bins.
struct Binning {
    float begin, scale;

    int of(float twice_center) const
    {
        return std::min(static_cast<int>((twice_center - begin) * scale), kBins - 1);
    }
};

struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    int bins = 0;  // in front of it
    Binning binning = {};
};

struct Task {
    std::size_t node, begin, end;
    int depth;
};

class Builder {
public:
    explicit Builder(const std::vector<BvhBox>& boxes)
    {
        items_.reserve(boxes.size());
        for (std::size_t k = 0; k < boxes.size(); ++k)
            items_.push_back({boxes[k].low, static_cast<std::uint32_t>(k), boxes[k].high});
    }

    Bvh build()
    {
        if (items_.empty()) return {};
        bvh_.nodes.reserve(items_.size());
        bvh_.nodes.emplace_back();
        std::vector<Task> tasks = {{0, 0, items_.size(), 0}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            const std::size_t middle = divide(task);
            if (middle == task.end) continue;
            const std::size_t child = bvh_.nodes.size();
            bvh_.nodes[task.node].first = static_cast<std::uint32_t>(child);
            bvh_.nodes.resize(child + 2);
            tasks.push_back({child + 1, middle, task.end, task.depth + 1});
            tasks.push_back({child, task.begin, middle, task.depth + 1});
        }
        bvh_.order.reserve(items_.size());
        for (const Item& item : items_) bvh_.order.push_back(item.index);
        return std::move(bvh_);
    }

private:
    // Where the second child's items begin; the end for a leaf.
    std::size_t divide(const Task& task)
    {
        BvhBox box, centers;
        for (std::size_t k = task.begin; k < task.end; ++k) {
            const Item& item = items_[k];
            box.add(item.low, item.high);
            centers.add(item.twiceCenter(), item.twiceCenter());
        }
        const std::size_t count = task.end - task.begin;
        bvh_.nodes[task.node] = {box.low, static_cast<std::uint32_t>(task.begin), box.high, 0};
        const Cut cut = task.depth < kMaxCutDepth ? bestCut(task, centers) : Cut();
        const double area = halfArea(box);
        if (count == 1 ||
            (count <= kMaxLeafItems && !(kNodeCost * area + cut.cost < area * count))) {
            bvh_.nodes[task.node].count = static_cast<std::uint32_t>(count);
            return task.end;
        }
        return cut.axis < 0 ? halve(task, centers) : partition(task, cut);
    }

    Cut bestCut(const Task& task, const BvhBox& centers) const
    {
        Cut best;
        for (int axis = 0; axis < 3; ++axis) {
            const float scale = kBins / (centers.high[axis] - centers.low[axis]);
            if (!std::isfinite(scale)) continue;  // all in one place
            considerAxis(task, axis, {centers.low[axis], scale}, best);
        }
        return best;
    }

    void considerAxis(const Task& task, int axis, const Binning& binning, Cut& best) const
    {
        Bin bins[kBins];
        for (std::size_t k = task.begin; k < task.end; ++k) {
            Bin& bin = bins[binning.of(items_[k].twiceCenter()[axis])];
            bin.box.add(items_[k].low, items_[k].high);
            ++bin.count;
        }
        double behind[kBins];  // cost of this bin and all after it
        Bin sum;
        for (int k = kBins - 1; k > 0; --k) {
            sum.box.add(bins[k].box.low, bins[k].box.high);
            sum.count += bins[k].count;
            behind[k] = sum.count > 0 ? halfArea(sum.box) * sum.count : -1.0;
        }
        sum = {};
        for (int k = 1; k < kBins; ++k) {
            sum.box.add(bins[k - 1].box.low, bins[k - 1].box.high);
            sum.count += bins[k - 1].count;
            if (sum.count == 0 || behind[k] < 0.0) continue;
            const double cost = halfArea(sum.box) * sum.count + behind[k];
            if (cost < best.cost) best = {cost, axis, k, binning};
        }
    }

    std::size_t partition(const Task& task, const Cut& cut)
    {
        const auto first = items_.begin() + task.begin, last = items_.begin() + task.end;
        const auto middle = std::partition(first, last, [&cut](const Item& item) {
            return cut.binning.of(item.twiceCenter()[cut.axis]) < cut.bins;
        });
        return static_cast<std::size_t>(middle - items_.begin());
    }

    std::size_t halve(const Task& task, const BvhBox& centers)
    {
        const glm::vec3 size = centers.high - centers.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = task.begin + (task.end - task.begin) / 2;
        std::nth_element(items_.begin() + task.begin, items_.begin() + middle,
                         items_.begin() + task.end, [axis](const Item& a, const Item& b) {
                             const float place = a.twiceCenter()[axis];
                             const float other = b.twiceCenter()[axis];
                             return place != other ? place < other : a.index < b.index;
                         });
        return middle;
    }

    std::vector<Item> items_;
    Bvh bvh_;
};

}  // namespace

Bvh buildBvh(const std::vector<BvhBox>& boxes) { return Builder(boxes).build(); }

}  // namespace crevice
