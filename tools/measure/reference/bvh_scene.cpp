// SPDX-License-Identifier: MIT
// Walks of rays through a tree of triangles, in floats; doubles decide about what they find.
//
// Triangles are met as Embree's robust mode meets them: the sides of a ray on which the edges lie,
// which triangles that share an edge agree on, so that no ray slips through between them.
//
// Sources: Davidovic et al. 2012 - the edges; Ize 2013 - the boxes.
#include "tools/measure/reference/ray_scene.h"

#include "tools/measure/reference/bvh.h"
#include "tools/measure/reference/trace_bodies.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

// Of a coordinate: beyond it, products of lengths overflow a float. Embree's limit.
constexpr float kLargest = 1.844e18f;

// How far boxes reach beyond their triangles, as a part of their largest coordinate: the sides of
// edges are off by a few roundings, 6e-8 each.
constexpr float kBoxSlack = 5e-7f;

// The interval in which a ray is in a box grows by this part: three roundings [Ize 2013].
constexpr float kIntervalSlack = 4e-7f;

// A rounding of a float, as Embree takes it.
constexpr float kUlp = 1.1920929e-7f;

struct Triangle {
    glm::vec3 corners[3];
    std::uint32_t instance, index;
};

bool finite(const glm::vec3& place)
{
    return std::abs(place.x) < kLargest && std::abs(place.y) < kLargest &&
           std::abs(place.z) < kLargest;  // false for what is no number
}

BvhBox boxOf(const Triangle& triangle)
{
    BvhBox box;
    for (const glm::vec3& corner : triangle.corners) box.add(corner, corner);
    const glm::vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
    const float slack = kBoxSlack * std::max({reach.x, reach.y, reach.z});
    return {box.low - slack, box.high + slack};
}

// Unlike std::min() and std::max() these become one instruction, or two.
float smaller(float a, float b) { return a < b ? a : b; }
float larger(float a, float b) { return a > b ? a : b; }

// What a walk knows of a ray.
struct Walk {
    glm::vec3 origin, direction, inverse;
    float end;

    explicit Walk(const SearchRay& ray)
        : origin(ray.origin),
          direction(ray.direction),
          inverse(1.0f / ray.direction),  // of 0 infinity, which bounds nothing
          end(ray.end)
    {
    }

    /// Where the ray enters the box; infinity where it does not, or behind its end.
    float entry(const BvhNode& node) const
    {
        float enter = 0.0f, leave = end;
        for (int axis = 0; axis < 3; ++axis) {
            const float a = (node.low[axis] - origin[axis]) * inverse[axis];
            const float b = (node.high[axis] - origin[axis]) * inverse[axis];
            enter = larger(enter, smaller(a, b) * (1.0f - kIntervalSlack));
            leave = smaller(leave, larger(a, b) * (1.0f + kIntervalSlack));
        }
        return enter <= leave ? enter : std::numeric_limits<float>::infinity();
    }

    /// Whether the ray hits the triangle in floats; then the weights of its corners are given.
    bool hits(const Triangle& triangle, TraceCandidate& found) const
    {
        const glm::vec3 a = triangle.corners[0] - origin, b = triangle.corners[1] - origin,
                        c = triangle.corners[2] - origin;
        const glm::vec3 ca = c - a, ab = a - b, bc = b - c;
        const float u = glm::dot(glm::cross(ca, c + a), direction);
        const float v = glm::dot(glm::cross(ab, a + b), direction);
        const float w = glm::dot(glm::cross(bc, b + c), direction);
        const float sum = u + v + w, slack = kUlp * std::abs(sum);
        const float least = smaller(u, smaller(v, w)), most = larger(u, larger(v, w));
        if (least < -slack && most > slack) return false;
        const glm::vec3 normal = glm::cross(ca, ab);
        const float cosine = glm::dot(normal, direction);
        const float distance = glm::dot(a, normal) / cosine;
        if (!(distance >= 0.0f && distance <= end)) return false;  // or no number
        found.instance = triangle.instance;
        found.triangle = triangle.index;
        found.u = std::min(u / sum, 1.0f);
        found.v = std::min(v / sum, 1.0f);
        return true;
    }
};

class BvhScene : public RayScene {
public:
    BvhScene(const Scene& scene, const glm::dvec3& eye);

    bool intersect(const TraceRay& ray, TraceHit& hit) const override;
    int countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const override;
    const glm::dvec3& center() const override { return bodies_.center(); }

private:
    template <typename Visit>
    void walk(const Walk& ray, const Visit& visit) const;

    const TraceBodies bodies_;
    std::vector<BvhNode> nodes_;
    std::vector<Triangle> triangles_;  // leaf by leaf
};

std::vector<Triangle> trianglesOf(const TraceBodies& bodies)
{
    std::vector<Triangle> triangles;
    for (std::size_t instance = 0; instance < bodies.all().size(); ++instance) {
        const TraceBody& body = bodies.all()[instance];
        const MeshDesc& mesh = body.mesh();
        std::vector<glm::vec3> places;
        places.reserve(mesh.vertices.size());
        for (const Vertex& vertex : mesh.vertices) places.push_back(body.place(vertex));
        for (std::size_t k = 0; k < body.triangles(); ++k) {
            const std::uint32_t* corners = &mesh.indices[3 * k];
            const Triangle triangle = {{places[corners[0]], places[corners[1]], places[corners[2]]},
                                       static_cast<std::uint32_t>(instance),
                                       static_cast<std::uint32_t>(k)};
            if (finite(triangle.corners[0]) && finite(triangle.corners[1]) &&
                finite(triangle.corners[2]))
                triangles.push_back(triangle);
        }
    }
    return triangles;
}

BvhScene::BvhScene(const Scene& scene, const glm::dvec3& eye) : bodies_(scene, eye)
{
    const std::vector<Triangle> triangles = trianglesOf(bodies_);
    std::vector<BvhBox> boxes;
    boxes.reserve(triangles.size());
    for (const Triangle& triangle : triangles) boxes.push_back(boxOf(triangle));
    Bvh bvh = buildBvh(boxes);
    nodes_ = std::move(bvh.nodes);
    triangles_.reserve(triangles.size());
    for (const std::uint32_t index : bvh.order) triangles_.push_back(triangles[index]);
}

// Nearer children first. `visit` is given the triangles of each leaf that the ray may meet, and
// ends the walk with true.
template <typename Visit>
void BvhScene::walk(const Walk& ray, const Visit& visit) const
{
    struct Later {
        std::uint32_t node;
        float entry;
    };
    Later later[kMaxBvhDepth];
    int waiting = 0;
    if (nodes_.empty() || !(ray.entry(nodes_[0]) <= ray.end)) return;
    std::uint32_t at = 0;
    for (;;) {
        const BvhNode& node = nodes_[at];
        if (node.count > 0) {
            for (std::uint32_t k = 0; k < node.count; ++k)
                if (visit(triangles_[node.first + k])) return;
        } else {
            const float first = ray.entry(nodes_[node.first]);
            const float second = ray.entry(nodes_[node.first + 1]);
            const std::uint32_t nearer = second < first ? 1 : 0;
            const float near_entry = nearer ? second : first, far_entry = nearer ? first : second;
            if (far_entry <= ray.end) later[waiting++] = {node.first + 1 - nearer, far_entry};
            if (near_entry <= ray.end) {
                at = node.first + nearer;
                continue;
            }
        }
        do {
            if (waiting == 0) return;
            --waiting;
        } while (later[waiting].entry > ray.end);
        at = later[waiting].node;
    }
}

bool BvhScene::intersect(const TraceRay& ray, TraceHit& hit) const
{
    const TraceRay from_center = {ray.origin - center(), ray.direction, ray.limit};
    const SearchRay searched = bodies_.searched(from_center);
    TraceCandidate nearest, found;
    TraceQuery query(bodies_, from_center.origin, ray.limit, &nearest);
    Walk state(searched);
    walk(state, [&](const Triangle& triangle) {
        if (state.hits(triangle, found) && query.hits(found, ray.direction))
            state.end = std::min(state.end, bodies_.endOf(searched, nearest.distance));
        return false;
    });
    if (!nearest.found()) return false;
    hit = bodies_.all()[nearest.instance].hitAt(from_center, nearest);
    return true;
}

int BvhScene::countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const
{
    TraceQuery query(bodies_, origin, limit, nullptr);
    int open = 0;
    for (int k = 0; k < 8; ++k) {
        if (batch.valid[k] != -1) continue;
        const glm::dvec3 direction = batch.directions[k];
        const Walk state(bodies_.searched(origin, batch.directions[k], limit));
        TraceCandidate found;
        bool blocked = false;
        walk(state, [&](const Triangle& triangle) {
            blocked = state.hits(triangle, found) && query.hits(found, direction);
            return blocked;
        });
        open += !blocked;
    }
    return open;
}

}  // namespace

std::unique_ptr<RayScene> makeBvhScene(const Scene& scene, const glm::dvec3& eye)
{
    return std::make_unique<BvhScene>(scene, eye);
}

}  // namespace crevice
