// SPDX-License-Identifier: MIT
// Cameras: those that can be drawn with, their matrices for shaders, where spheres lie in views.
#include "core/frame/frame_math.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace crevice {
namespace {

// Volume of the columns over the product of their lengths: below this a double's rounding is all
// that keeps the matrix from being singular. Near and far planes do not matter to it.
constexpr double kLeastVolume = 1e-14;

bool invertible(const glm::dmat4& columns)
{
    double lengths = 1.0;
    for (int i = 0; i < 4; ++i) lengths *= glm::length(columns[i]);
    return std::abs(glm::determinant(columns)) > kLeastVolume * lengths &&
           isFinite(glm::inverse(columns));
}

// `clip_from_view` as it would be under OpenGL's own clip control, with w the distance or 1, as
// shaders count on. In double: numbers from 0 to 1 keep of a far plane what -1 to 1 round away.
glm::dmat4 plainClip(const Camera& camera)
{
    const ClipControl control = camera.clip_control.value_or(ClipControl());
    glm::dmat4 rows = glm::transpose(glm::dmat4(camera.clip_from_view));
    const double scale = std::abs(camera.orthographic() ? rows[3].w : rows[3].z);
    if (scale > 0.0) rows = rows / scale;
    if (control.zero_to_one) rows[2] = 2.0 * rows[2] - rows[3];
    if (control.upper_left) rows[1] = -rows[1];
    return glm::transpose(rows);
}

// Whether the camera looks along +z.
bool isLeftHanded(const Camera& camera)
{
    return camera.leftHanded() && (!camera.orthographic() || mirrors(camera.view_from_world));
}

// Whether w is that of a pinhole at the origin, or of parallel rays, along z. Of anything else,
// such as a product with the view, the view space of which it is one is not known.
bool isAlongZ(const glm::dmat4& clip_from_view)
{
    constexpr double kRounding = 1e-6;
    const glm::dmat4 rows = glm::transpose(clip_from_view);
    const glm::dvec4 of_w = glm::abs(rows[3]);
    if (of_w.z > 0.0) return std::max({of_w.x, of_w.y, of_w.w}) <= kRounding * of_w.z;
    const auto leans = [&](const glm::dvec4& row) {
        return std::abs(row.z) > kRounding * (std::abs(row.x) + std::abs(row.y));
    };
    return of_w.x == 0.0 && of_w.y == 0.0 && !leans(rows[0]) && !leans(rows[1]);
}

// Whether w is above 0 far along the axis that the view looks along.
bool looksForward(const Camera& camera)
{
    const glm::vec4 of_z = camera.clip_from_view[2], of_1 = camera.clip_from_view[3];
    if (of_z.w == 0.0f) return of_1.w > 0.0f;
    return of_z.w < 0.0f || mirrors(camera.view_from_world);
}

// Whether a box lies along +z, as depth grows, under a view along -z: all is behind the eye.
bool liesBehind(const Camera& camera)
{
    return camera.orthographic() && camera.leftHanded() && !isLeftHanded(camera) &&
           plainClip(camera)[2].z > 0.0;
}

std::string ownedBy(std::size_t view, const char* matrix)
{
    return (view == 0 ? "the camera" : "view " + std::to_string(view)) + "'s " + matrix;
}

/// How far a vertex in floats may lie from where it is, relative to its distance.
constexpr double kFloatMargin = 1e-5;

constexpr int kFloatDigits = 23;  // binary digits of a float past its first

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

Diagnostic badInput(std::string what, std::string help)
{
    return {Code::bad_input, std::move(what), std::move(help)};
}

bool mirrors(const glm::dmat4& columns) { return glm::determinant(glm::dmat3(columns)) < 0.0; }

Status checkCamera(const Camera& camera, std::size_t view)
{
    const auto check = [view](const auto& matrix, const char* name, const char* way_out) -> Status {
        if (!isFinite(matrix))
            return badInput(ownedBy(view, name) + " is not finite",
                            "look for a zero aspect ratio, near plane or up vector");
        if (!invertible(matrix)) return badInput(ownedBy(view, name) + " has no inverse", way_out);
        return {};
    };
    const char* const lens = "near and far plane must differ, and neither width nor height be 0";
    if (Status status = check(camera.clip_from_view, "clip_from_view", lens); !status)
        return status;
    if (!isAlongZ(glm::dmat4(camera.clip_from_view)))
        return badInput(
            ownedBy(view, "clip_from_view") + " does not project along its z axis",
            "give the projection alone, without the view: its last row is (0, 0, -1, 0), or "
            "(0, 0, 0, 1) of parallel rays, which must not lean");
    const char* const along =
        "negate its third column, or, where the view is to look along +z, the third row of "
        "view_from_world";
    if (liesBehind(camera))
        return badInput(ownedBy(view, "clip_from_view") + " shows a box that lies along +z, behind",
                        along);
    if (!looksForward(camera))
        return badInput(
            ownedBy(view, "clip_from_view") +
                " has w below 0 for what lies in front, along -z: nothing would be seen",
            along);
    const DepthRange range = camera.depth_range.value_or(DepthRange());
    if (!(std::abs(range.far_depth - range.near_depth) <= 1) ||
        range == DepthRange{range.far_depth, range.near_depth})
        return badInput(ownedBy(view, "depth range") + " has no extent, or more than from 0 to 1",
                        "set Camera::depth_range to what glDepthRange was when depth was drawn");
    return check(camera.view_from_world, "view_from_world",
                 "its three axes must be independent and not 0");
}

bool Camera::orthographic() const
{
    const glm::mat4& m = clip_from_view;  // GLM indexes by column
    return m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] != 0.0f;
}

bool Camera::reversedDepth() const
{
    // The sign of how depth changes with view z, which falls with distance.
    const glm::dmat4 m = uprightClip(*this);
    const DepthRange range = depth_range.value_or(DepthRange());
    return (m[2][2] * m[3][3] - m[3][2] * m[2][3] > 0.0) != (range.far_depth < range.near_depth);
}

bool Camera::leftHanded() const
{
    constexpr double kRounding = 1e-6;  // of a near plane at 0
    const glm::dmat4 clip = plainClip(*this);
    const glm::dvec4 of_z = clip[2], of_1 = clip[3];
    if (!orthographic()) return of_z.w > 0.0;
    return -of_1.z * (of_z.z < 0.0 ? -1 : 1) >= 1 - kRounding;
}

glm::dmat3 uprightTurn(const Camera& camera)
{
    constexpr double kRightAngle = 1e-6;  // cosine of what rounding in floats makes of one
    const glm::dmat4 clip = plainClip(camera);
    const glm::dvec2 right(clip[0][0], clip[1][0]), up(clip[0][1], clip[1][1]);
    glm::dvec2 x = right / glm::length(right), y = up / glm::length(up);
    if (!(std::abs(glm::dot(x, y)) <= kRightAngle)) {  // sheared as well: the nearest right angles
        const bool upright = std::abs(x.x * y.y) >= std::abs(x.y * y.x);
        x = upright ? glm::dvec2(std::copysign(1.0, x.x), 0)
                    : glm::dvec2(0, std::copysign(1.0, x.y));
        y = upright ? glm::dvec2(0, std::copysign(1.0, y.y))
                    : glm::dvec2(std::copysign(1.0, y.x), 0);
    }
    return {x.x, y.x, 0, x.y, y.y, 0, 0, 0, isLeftHanded(camera) ? -1 : 1};
}

glm::dmat4 uprightClip(const Camera& camera)
{
    return plainClip(camera) * glm::dmat4(glm::transpose(uprightTurn(camera)));
}

CameraMatrices cameraMatrices(const Camera& camera)
{
    const glm::dmat3 turn = uprightTurn(camera);
    glm::dmat4 rows = glm::transpose(uprightClip(camera));
    const DepthRange range = camera.depth_range.value_or(DepthRange());
    const double near = range.near_depth, far = range.far_depth;
    rows[2] = (far - near) * rows[2] + (far + near - 1) * rows[3];
    const glm::dmat4 clip_from_view = glm::transpose(rows);
    const glm::dmat4 view_from_world = glm::dmat4(turn) * camera.view_from_world;
    return {clip_from_view, glm::inverse(clip_from_view), view_from_world,
            glm::inverse(view_from_world), turn};
}

CameraMatrices boxMatrices(const glm::dvec3& center, double edge)
{
    const glm::dmat4 clip = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 / edge));
    const glm::dmat4 view = glm::translate(glm::dmat4(1.0), -center);
    return {clip, glm::inverse(clip), view, glm::inverse(view)};
}

glm::dvec3 snappedTo(const glm::dvec3& at, double step) { return glm::round(at / step) * step; }

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
