// SPDX-License-Identifier: MIT
#include "tools/measure/motion/flow.h"

#include "tools/render/view_diagnosis.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace crevice {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Of a texel. Places nearer to a centre are that centre: a still camera compares pixels with
/// themselves, and a neighbour of which nothing shows does not have to be on the surface.
constexpr double kSnap = 1e-3;

/// The four texels about a place, and their shares.
struct Texels {
    int x, y;
    double shares[4];

    explicit Texels(const glm::dvec2& place)
        : x(static_cast<int>(std::floor(place.x))),
          y(static_cast<int>(std::floor(place.y)))
    {
        const double right = place.x - x, up = place.y - y;
        for (int k = 0; k < 4; ++k) shares[k] = (k & 1 ? right : 1 - right) * (k & 2 ? up : 1 - up);
    }

    /// Calls `visit(x, y, share)` for each that has a share, until it gives false.
    template <class Visit>
    bool all(Visit&& visit) const
    {
        for (int k = 0; k < 4; ++k)
            if (shares[k] > 0.0 && !visit(x + (k & 1), y + (k >> 1), shares[k])) return false;
        return true;
    }
};

double snapped(double place)
{
    const double whole = std::round(place);
    return std::abs(place - whole) < kSnap ? whole : place;
}

/// A point in another picture.
class Projected {
public:
    Projected(const SurfacePoint& point, const SurfaceMap& map, const Camera& camera)
        : point_(point),
          map_(map)
    {
        const glm::dvec4 view = camera.view_from_world * glm::dvec4(point.position, 1.0);
        const glm::dvec4 clip = glm::dmat4(camera.clip_from_view) * view;
        if (!point.seen || !(clip.w > 0.0)) return;
        place_.x = snapped((clip.x / clip.w * 0.5 + 0.5) * map.extent.width - 0.5);
        place_.y = snapped((clip.y / clip.w * 0.5 + 0.5) * map.extent.height - 0.5);
        // Also false for NaN.
        inside_ = place_.x >= 0 && place_.y >= 0 && place_.x <= map.extent.width - 1 &&
                  place_.y <= map.extent.height - 1;
        pixel_ = 1.0 / pixelsOf(1.0, std::abs(view.z), camera, map.extent);
    }

    bool inside() const { return inside_; }
    const glm::dvec2& place() const { return place_; }

    /// Whether the texel shows the point's own surface.
    bool isShownAt(int x, int y) const
    {
        const SurfacePoint& other = map_.at(x, y);
        return other.seen &&
               std::abs(glm::dot(other.position - point_.position, point_.normal)) <= pixel_;
    }

private:
    const SurfacePoint& point_;
    const SurfaceMap& map_;
    glm::dvec2 place_ = glm::dvec2(-1.0);
    double pixel_ = 0;
    bool inside_ = false;
};

}  // namespace

Image flowTo(const SurfaceMap& from, const SurfaceMap& to, const Camera& camera)
{
    Image flow(from.extent, 2, kNone);
    for (int y = 0; y < from.extent.height; ++y)
        for (int x = 0; x < from.extent.width; ++x) {
            const Projected point(from.at(x, y), to, camera);
            if (!point.inside()) continue;
            const bool shown = Texels(point.place()).all([&point](int tx, int ty, double) {
                return point.isShownAt(tx, ty);
            });
            for (int axis = 0; axis < 2 && shown; ++axis)
                flow.at(x, y, axis) = static_cast<float>(point.place()[axis]);
        }
    return flow;
}

Image uncoveredSince(const SurfaceMap& before, const Camera& camera, const SurfaceMap& now)
{
    Image mask(now.extent, 1);
    for (int y = 0; y < now.extent.height; ++y)
        for (int x = 0; x < now.extent.width; ++x) {
            const Projected point(now.at(x, y), before, camera);
            if (!point.inside()) continue;
            const bool hidden = Texels(point.place()).all([&point](int tx, int ty, double) {
                return !point.isShownAt(tx, ty);
            });
            mask.at(x, y) = hidden ? 1.0f : 0.0f;
        }
    return mask;
}

Image changeAlong(const Image& flow, const Image& from, const Image& to)
{
    Image change(flow.extent, 1, kNone);
    for (int y = 0; y < flow.extent.height; ++y)
        for (int x = 0; x < flow.extent.width; ++x) {
            const glm::dvec2 place(flow.at(x, y, 0), flow.at(x, y, 1));
            if (std::isnan(place.x)) continue;
            double sum = 0;
            Texels(place).all([&sum, &to](int tx, int ty, double share) {
                sum += share * to.at(tx, ty);
                return true;
            });
            change.at(x, y) = static_cast<float>(sum - from.at(x, y));
        }
    return change;
}

}  // namespace crevice
