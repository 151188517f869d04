// SPDX-License-Identifier: MIT
#include "core/run/view_draws.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice {

void ViewDraws::begin(const CameraMatrices& camera)
{
    camera_ = &camera;
    is_placed_ = false;
    reached_.clear();
}

const std::vector<PlacedDraw>& ViewDraws::placed()
{
    if (std::exchange(is_placed_, true)) return placed_;
    const std::size_t count = drawn_.draws.size();
    placed_.resize(count);
    areas_.clear();
    areas_.reserve(count);
    volume_ = viewVolume(*camera_, 1.0);
    const bool view_mirrors = mirrors(camera_->view_from_world);
    for (std::size_t i = 0; i < count; ++i) {
        const DrawItem& item = drawn_.draws[i];
        if (!drawsSomething(item)) continue;
        PlacedDraw& placed = placed_[i];
        placed.view_from_model = camera_->view_from_world * item.world_from_model;
        placed.sphere = boundsInView(item, placed.view_from_model);
        placed.mirrored = mirrors(item.world_from_model) != view_mirrors;
        placed.valued = false;
    }
    return placed_;
}

const std::uint32_t* ViewDraws::values(std::size_t draw, ValueTable& table)
{
    const std::size_t words = table.drawWords();
    values_.resize(drawn_.draws.size() * words);
    std::uint32_t* const own = &values_[draw * words];
    if (placed_[draw].valued) return own;
    const DrawItem& item = drawn_.draws[draw];
    const MeshOrigin& origin = drawn_.origins[draw];
    table.setDraw(
        glm::translate(placed_[draw].view_from_model, glm::dvec3(origin.x, origin.y, origin.z)),
        drawn_.materials[item.material], *camera_, normals_ || item.callback);
    table.keepDraw(own);
    placed_[draw].valued = true;
    return own;
}

ViewArea ViewDraws::area(const Extent& extent, double length)
{
    const double reach = pixelReach(camera_->clip_from_view, extent, length);
    for (const auto& [known, area] : reached_)
        if (known == reach) return area;
    return reached_.emplace_back(reach, areaWithin(reach)).second;
}

ViewArea ViewDraws::areaWithin(double reach)
{
    ViewArea area = kNoArea;
    const std::vector<PlacedDraw>& all = placed();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ViewArea& own = areaOfDraw(i);
        if (isBelowPixel(all[i].sphere, camera_->clip_from_view, reach)) continue;
        area = united(area, own);
        if (area.left <= 0 && area.bottom <= 0 && area.right >= 1 && area.top >= 1) return {};
    }
    return area;
}

/// Requires that those before it were asked for.
const ViewArea& ViewDraws::areaOfDraw(std::size_t draw)
{
    if (draw < areas_.size()) return areas_[draw];
    const ViewSphere& sphere = placed_[draw].sphere;
    if (!drawsSomething(drawn_.draws[draw]) || isOutside(sphere, volume_))
        return areas_.emplace_back(kNoArea);
    return areas_.emplace_back(sphere.radius < 0.0 ? ViewArea()
                                                   : areaOf(sphere, camera_->clip_from_view));
}

}  // namespace crevice
