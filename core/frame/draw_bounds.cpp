// SPDX-License-Identifier: MIT
// Where draws lie in a view, by the spheres around them.
#include "core/frame/frame_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

/// How far a vertex in floats may lie from where it is, relative to its distance.
constexpr double kFloatMargin = 1e-5;

// Binary digits of a float past its first.
constexpr int kFloatDigits = 23;

// The most by which the matrix makes a length longer.
double stretchOf(const glm::dmat4& matrix)
{
    const glm::dmat3 axes(matrix);
    const glm::dmat3 squares = glm::transpose(axes) * axes;
    double stretch = 0;  // squared: at most the largest row sum (Gershgorin)
    for (int i = 0; i < 3; ++i)
        stretch = std::max(
            stretch, std::abs(squares[i][0]) + std::abs(squares[i][1]) + std::abs(squares[i][2]));
    return std::sqrt(stretch);
}

// How far apart floats are at the largest coordinate of an item with bounds, in scene units.
double vertexStep(const DrawItem& item)
{
    const glm::vec3 off = glm::abs(item.bounds_center);
    const double largest = std::max({off.x, off.y, off.z}) + double{item.bounds_radius};
    return std::exp2(std::floor(std::log2(largest)) - kFloatDigits) *
           stretchOf(item.world_from_model);
}

}  // namespace

ViewSphere boundsInView(const DrawItem& item, const glm::dmat4& view_from_model)
{
    if (item.bounds_radius < 0.0f) return {};
    const glm::dvec3 center(view_from_model * glm::dvec4(item.bounds_center, 1.0));
    // Shaders place vertices in floats.
    return {center, item.bounds_radius * stretchOf(view_from_model) * (1 + kFloatMargin) +
                        glm::length(center) * kFloatMargin};
}

ViewVolume viewVolume(const CameraMatrices& camera, double wider)
{
    ViewVolume volume;
    const glm::dmat4 rows = glm::transpose(camera.clip_from_view);
    const glm::dvec4 all[] = {rows[3] * wider + rows[0], rows[3] * wider - rows[0],
                              rows[3] * wider + rows[1], rows[3] * wider - rows[1],
                              rows[3] + rows[2],         rows[3] - rows[2]};
    for (int i = 0; i < 6; ++i) {
        volume.planes[i] = all[i];
        volume.lengths[i] = glm::length(glm::dvec3(all[i]));
    }
    return volume;
}

bool isOutside(const ViewSphere& sphere, const ViewVolume& volume)
{
    if (sphere.radius < 0.0) return false;
    const glm::dvec4 center(sphere.center, 1.0);
    for (int i = 0; i < 6; ++i)
        if (glm::dot(volume.planes[i], center) < -sphere.radius * volume.lengths[i]) return true;
    return false;
}

// As shaders count (effects/ssao/shaders/reach.glsl).
double pixelReach(const glm::dmat4& clip_from_view, const Extent& extent, double length)
{
    const double across = std::max(std::abs(clip_from_view[0][0]) * extent.width,
                                   std::abs(clip_from_view[1][1]) * extent.height);
    return 0.5 * length * across;
}

bool isBelowPixel(const ViewSphere& sphere, const glm::dmat4& clip_from_view, double reach)
{
    const bool perspective = clip_from_view[2][3] != 0.0;
    const double nearest = perspective ? -(sphere.center.z + sphere.radius) : 1.0;
    return sphere.radius >= 0.0 && nearest > 0.0 && reach < nearest * (1 - kFloatMargin);
}

ViewArea areaOf(const ViewSphere& sphere, const glm::dmat4& clip_from_view)
{
    ViewArea area = kNoArea;
    const glm::dvec4 center = clip_from_view * glm::dvec4(sphere.center, 1.0);
    const glm::dmat4 sides = clip_from_view * sphere.radius;
    for (int corner = 0; corner < 8; ++corner) {  // of a box about the sphere
        glm::dvec4 clip = center;
        for (int i = 0; i < 3; ++i) clip += corner >> i & 1 ? sides[i] : -sides[i];
        if (!(clip.w > 0.0)) return {};
        const glm::dvec2 at = glm::dvec2(clip) / clip.w * 0.5 + 0.5;
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
        area = united(area, {at.x, at.y, at.x, at.y});
    }
    return area;
}

ViewArea united(const ViewArea& area, const ViewArea& other)
{
    return {std::min(area.left, other.left), std::min(area.bottom, other.bottom),
            std::max(area.right, other.right), std::max(area.top, other.top)};
}

DrawRange rangeOf(const std::vector<DrawItem>& draws, const Camera& camera)
{
    const CameraMatrices matrices = cameraMatrices(camera);
    const ViewVolume volume = viewVolume(matrices, 1.0);
    const CameraRange planes = rangeOf(camera);
    const bool orthographic = camera.orthographic();
    DrawRange range;
    double covered = 0;
    for (const DrawItem& item : draws) {
        if (!drawsSomething(item)) continue;
        if (item.bounds_radius < 0.0f) return {};
        const ViewSphere sphere =
            boundsInView(item, matrices.view_from_world * item.world_from_model);
        const double depth = -sphere.center.z;
        if (!std::isfinite(depth + sphere.radius) || isOutside(sphere, volume)) continue;
        const double nearest = std::max(depth - sphere.radius, planes.near_distance);
        const double farthest = std::min(depth + sphere.radius, planes.far_distance);
        const double distance = orthographic ? std::abs(depth) : (nearest + farthest) / 2;
        const double size = sphere.radius * planes.zoom / (orthographic ? 1.0 : distance);
        const double share = std::min(size * size, 1.0);
        range.distance += share * distance;
        covered += share;
        range.vertex_step = std::max(range.vertex_step, vertexStep(item));
    }
    if (!(covered > 0.0)) return {};
    range.distance /= covered;
    return range;
}

PixelArea pixelsOf(const ViewArea& area, const Extent& extent)
{
    // A pixel more: one stands for the surface at its middle, or for one of several under it.
    const auto side = [](double from, double to, int size, int& first) {
        first = static_cast<int>(std::floor(std::clamp(from, 0.0, 1.0) * size)) - 1;
        const int last = static_cast<int>(std::ceil(std::clamp(to, 0.0, 1.0) * size)) + 1;
        first = std::clamp(first, 0, size);
        return std::clamp(last, 0, size) - first;
    };
    PixelArea pixels;
    if (area.right < area.left || area.top < area.bottom) return pixels;
    pixels.extent.width = side(area.left, area.right, extent.width, pixels.x);
    pixels.extent.height = side(area.bottom, area.top, extent.height, pixels.y);
    return pixels;
}

}  // namespace crevice
