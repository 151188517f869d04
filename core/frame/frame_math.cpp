// SPDX-License-Identifier: MIT
// Checks of a frame and the matrices made of it.
#include "core/frame/frame_math.h"

#include "core/frame/frame_values.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace crevice {
namespace {

// Volume of the columns over the product of their lengths: below this a double's rounding is all
// that keeps the matrix from being singular. Near and far planes do not matter to it.
constexpr double kLeastVolume = 1e-14;

// Least difference of a spot's cosines: its edge is then as sharp as a float shows.
constexpr double kLeastConeRamp = 1e-4;

/// How far a vertex in floats may lie from where it is, relative to its distance.
constexpr double kFloatMargin = 1e-5;

// As floats, which is what shaders get.
template <typename T>
bool finite(const T* values, int count)
{
    return std::all_of(values, values + count, [](T value) {
        return std::abs(value) <= std::numeric_limits<float>::max();
    });
}

template <typename T>
bool finite(const glm::mat<4, 4, T>& matrix)
{
    return finite(&matrix[0][0], 16);
}

template <typename T>
bool finite(const glm::vec<3, T>& vector)
{
    return finite(&vector[0], 3);
}

glm::dvec3 towardsLight(const Light& light, const glm::dmat4& view_from_world)
{
    const glm::dvec3 towards = -(glm::dmat3(view_from_world) * glm::dvec3(light.direction));
    const double length = glm::length(towards);
    return length > 0.0 ? towards / length : towards;
}

bool invertible(const glm::dmat4& columns)
{
    double lengths = 1.0;
    for (int i = 0; i < 4; ++i) lengths *= glm::length(columns[i]);
    return std::abs(glm::determinant(columns)) > kLeastVolume * lengths &&
           finite(glm::mat4(glm::inverse(columns)));
}

Diagnostic bad(std::string what, std::string help)
{
    return {Code::bad_input, std::move(what), std::move(help)};
}

std::string ownedBy(std::size_t view, const char* matrix)
{
    return (view == 0 ? "the camera" : "view " + std::to_string(view)) + "'s " + matrix;
}

Status checkCamera(const Camera& camera, std::size_t view)
{
    const auto check = [view](const auto& matrix, const char* name, const char* way_out) -> Status {
        if (!finite(matrix))
            return bad(ownedBy(view, name) + " is not finite",
                       "look for a zero aspect ratio, near plane or up vector");
        if (!invertible(matrix)) return bad(ownedBy(view, name) + " has no inverse", way_out);
        return {};
    };
    const char* const lens = "near and far plane must differ, and neither width nor height be 0";
    if (Status status = check(camera.clip_from_view, "clip_from_view", lens); !status)
        return status;
    return check(camera.view_from_world, "view_from_world",
                 "its three axes must be independent and not 0");
}

Diagnostic elided(std::string what, std::string help)
{
    return {Code::bad_input, std::move(what), std::move(help), {}, {}, {}, Severity::warning};
}

constexpr const char* kUnknownIdHelp =
    "take an id that this device gave and that is not destroyed yet, or set its count to 0";
constexpr const char* kNotFiniteHelp = "look for a division by zero where it is made";

// Why an item cannot be drawn for its material; nothing where it can.
std::optional<Diagnostic> materialFault(const Frame& frame, const DrawItem& item,
                                        const Device& device)
{
    const auto named = [&item] { return "material " + std::to_string(item.material); };
    if (item.material < 0 || static_cast<std::size_t>(item.material) >= frame.materials.size())
        return elided("it has " + named() + ", and the frame has " +
                          std::to_string(frame.materials.size()) + " materials",
                      "materials count from 0");
    const Material& material = frame.materials[item.material];
    if (!isFinite(material)) return elided(named() + " is not finite", kNotFiniteHelp);
    for (const MaterialMapInfo& map : kMaterialMaps) {
        const TextureId id = material.*map.texture;
        const ObjectInfo texture = id ? device.info(id) : ObjectInfo{};
        if (!id || (texture.exists && texture.samples == 1)) continue;
        const std::string has =
            named() + " has texture " + std::to_string(id.value) + " as " + map.name;
        if (!texture.exists) return elided(has + ", which is none of this device", kUnknownIdHelp);
        return elided(has + ", which has several samples a pixel",
                      "resolve it to a texture of one sample");
    }
    return std::nullopt;
}

// Why an item cannot be drawn; nothing where it can. Allocates only where there is something to
// say.
std::optional<Diagnostic> faultOf(const Frame& frame, const DrawItem& item, const Device& device)
{
    if (!item.mesh) return elided("it has no mesh", kUnknownIdHelp);
    const ObjectInfo mesh = device.info(item.mesh);
    const auto named = [&item] { return "mesh " + std::to_string(item.mesh.value); };
    if (!mesh.exists) return elided(named() + " is none of this device", kUnknownIdHelp);
    if (std::uint64_t{item.first} + item.count > mesh.index_count)
        return elided(named() + " has fewer indices than it draws",
                      "first and count are indices, not triangles");
    if (!finite(item.world_from_model)) return elided("its matrix is not finite", kNotFiniteHelp);
    if (!finite(item.bounds_center) || !std::isfinite(item.bounds_radius))
        return elided("its bounds are not finite", "a radius below 0 means that none are known");
    return materialFault(frame, item, device);
}

struct Sphere {
    glm::dvec3 center;
    double radius;
};

// Requires bounds.
Sphere boundsInView(const DrawItem& item, const CameraMatrices& camera)
{
    const glm::dmat4 view_from_model = camera.view_from_world * item.world_from_model;
    const glm::dmat3 axes(view_from_model);
    const glm::dmat3 squares = glm::transpose(axes) * axes;
    double stretch = 0;  // of lengths, squared: at most the largest row sum (Gershgorin)
    for (int i = 0; i < 3; ++i)
        stretch = std::max(
            stretch, std::abs(squares[i][0]) + std::abs(squares[i][1]) + std::abs(squares[i][2]));
    const glm::dvec3 center(view_from_model * glm::dvec4(item.bounds_center, 1.0));
    // Shaders place vertices in floats.
    return {center, item.bounds_radius * std::sqrt(stretch) * (1 + kFloatMargin) +
                        glm::length(center) * kFloatMargin};
}

bool isOutside(const Sphere& sphere, const CameraMatrices& camera, double wider)
{
    const glm::dvec4 center(sphere.center, 1.0);
    const glm::dmat4 rows = glm::transpose(camera.clip_from_view);
    const glm::dvec4 planes[] = {rows[3] * wider + rows[0], rows[3] * wider - rows[0],
                                 rows[3] * wider + rows[1], rows[3] * wider - rows[1],
                                 rows[3] + rows[2],         rows[3] - rows[2]};
    for (const glm::dvec4& plane : planes)
        if (glm::dot(plane, center) < -sphere.radius * glm::length(glm::dvec3(plane))) return true;
    return false;
}

// Whether at no point of the sphere a length comes to a pixel, as shaders count
// (effects/ssao/shaders/reach.glsl).
bool isBelowPixel(const Sphere& sphere, const glm::dmat4& clip_from_view, const Extent& extent,
                  double length)
{
    const bool perspective = clip_from_view[2][3] != 0.0;
    const double nearest = perspective ? -(sphere.center.z + sphere.radius) : 1.0;
    const double across = std::max(std::abs(clip_from_view[0][0]) * extent.width,
                                   std::abs(clip_from_view[1][1]) * extent.height);
    return nearest > 0.0 && 0.5 * length * across < nearest * (1 - kFloatMargin);
}

// The corners of a box about the sphere, on the screen; all of it where one lies behind the camera.
ViewArea areaOf(const Sphere& sphere, const glm::dmat4& clip_from_view)
{
    ViewArea area = {1, 1, 0, 0};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sides(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::dvec4 clip =
            clip_from_view * glm::dvec4(sphere.center + sphere.radius * sides, 1.0);
        if (!(clip.w > 0.0)) return {};
        const glm::dvec2 at = glm::dvec2(clip) / clip.w * 0.5 + 0.5;
        if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
        area = {std::min(area.left, at.x), std::min(area.bottom, at.y), std::max(area.right, at.x),
                std::max(area.top, at.y)};
    }
    return area;
}

}  // namespace

CameraMatrices cameraMatrices(const Camera& camera)
{
    const glm::dmat4 clip_from_view(camera.clip_from_view);
    return {clip_from_view, glm::inverse(clip_from_view), camera.view_from_world,
            glm::inverse(camera.view_from_world)};
}

glm::mat3 normalMatrix(const glm::dmat4& matrix)
{
    const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    const double size =
        std::sqrt((glm::dot(cofactors[0], cofactors[0]) + glm::dot(cofactors[1], cofactors[1]) +
                   glm::dot(cofactors[2], cofactors[2])) /
                  3.0);
    if (!(size > 0.0)) return glm::mat3(1.0f);
    const double sign = glm::dot(x, cofactors[0]) < 0.0 ? -1.0 : 1.0;  // of the determinant
    return glm::mat3(cofactors * (sign / size));
}

bool isMirrored(const DrawItem& item, const CameraMatrices& camera)
{
    const glm::dmat4& clip = camera.clip_from_view;
    const double upright = clip[0][0] * clip[1][1] - clip[0][1] * clip[1][0];
    const bool item_mirrors = glm::determinant(glm::dmat3(item.world_from_model)) < 0.0;
    const bool view_mirrors = glm::determinant(glm::dmat3(camera.view_from_world)) < 0.0;
    return (item_mirrors != view_mirrors) != (upright < 0.0);
}

bool isOutside(const DrawItem& item, const CameraMatrices& camera, double wider)
{
    return item.bounds_radius >= 0.0f && isOutside(boundsInView(item, camera), camera, wider);
}

ViewArea areaOfDraws(const std::vector<DrawItem>& draws, const CameraMatrices& camera,
                     const Extent& extent, double length)
{
    ViewArea area = {1, 1, 0, 0};
    for (const DrawItem& item : draws) {
        if (item.count == 0) continue;
        if (item.bounds_radius < 0.0f) return {};
        const Sphere sphere = boundsInView(item, camera);
        if (isOutside(sphere, camera, 1.0) ||
            isBelowPixel(sphere, camera.clip_from_view, extent, length))
            continue;
        const ViewArea own = areaOf(sphere, camera.clip_from_view);
        area = {std::min(area.left, own.left), std::min(area.bottom, own.bottom),
                std::max(area.right, own.right), std::max(area.top, own.top)};
        if (area.left <= 0 && area.bottom <= 0 && area.right >= 1 && area.top >= 1) return {};
    }
    return area;
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

glm::vec4 lightInView(const Light& light, const glm::dmat4& view_from_world)
{
    if (!light.directional) return glm::vec4(view_from_world * glm::dvec4(light.position, 1.0));
    return glm::vec4(towardsLight(light, view_from_world), 0.0);
}

glm::vec4 coneInView(const Light& light, const glm::dmat4& view_from_world)
{
    if (!light.spot || light.directional) return {0, 0, 0, 1};
    // glTF's KHR_lights_punctual: a straight ramp between the cosines, squared in the shader.
    const double outer = std::cos(double(light.outer_angle_rad));
    const double inner = std::cos(double(light.inner_angle_rad));
    const double scale = 1.0 / std::max(inner - outer, kLeastConeRamp);
    return glm::vec4(towardsLight(light, view_from_world) * scale, -outer * scale);
}

Status checkFrame(const Frame& frame)
{
    const bool orthographic = frame.camera.orthographic();
    const bool reversed = frame.camera.reversedDepth();
    for (std::size_t view = 0; view <= frame.other_views.size(); ++view) {
        const Camera& camera = cameraOf(frame, view);
        if (Status status = checkCamera(camera, view); !status) return status;
        const auto unlike = [view](bool is, const char* what) {
            return bad("view " + std::to_string(view) + (is ? " is " : " is not ") + what +
                           ", and the camera is" + (is ? " not" : ""),
                       "draw it as a frame of its own, by another renderer");
        };
        if (camera.orthographic() != orthographic)
            return unlike(camera.orthographic(), "orthographic");
        if (camera.reversedDepth() != reversed)
            return unlike(camera.reversedDepth(), "reversed in depth");
    }
    return {};
}

bool isFinite(const glm::vec3& vector) { return finite(vector); }

bool isFinite(const Material& material)
{
    const float numbers[] = {material.shininess, material.ambient, material.alpha_cutoff,
                             material.normal_scale, material.occlusion_strength};
    return finite(&material.base_color[0], 4) && finite(material.specular) && finite(numbers, 5);
}

bool isFinite(const Light& light)
{
    return finite(light.position) && finite(light.direction) && finite(light.color) &&
           finite(light.attenuation) && std::isfinite(light.inner_angle_rad) &&
           std::isfinite(light.outer_angle_rad);
}

bool isDrawable(const Frame& frame, const DrawItem& item, const Device& device)
{
    return !faultOf(frame, item, device);
}

Diagnostics warnElided(const Frame& frame, const Device& device)
{
    constexpr std::size_t kMostDraws = 8;
    Diagnostics warnings;
    std::size_t more = 0;
    for (std::size_t i = 0; i < frame.draws.size(); ++i) {
        const DrawItem& item = frame.draws[i];
        std::optional<Diagnostic> fault;
        if (item.count > 0) fault = faultOf(frame, item, device);
        if (!fault) continue;
        if (warnings.size() == kMostDraws) {
            ++more;
            continue;
        }
        fault->message = "draw " + std::to_string(i) + " is left out: " + fault->message;
        warnings.push_back(std::move(*fault));
    }
    if (more > 0)
        warnings.back().notes.push_back({{}, std::to_string(more) + " more draws are left out"});
    for (std::size_t i = 0; i < frame.lights.size() && i < kMaxLights; ++i)
        if (!isFinite(frame.lights[i]))
            warnings.push_back(elided(
                "light " + std::to_string(i) + " is left out: it is not finite", kNotFiniteHelp));
    if (!isFinite(frame.ambient_light))
        warnings.push_back(elided("ambient_light is left out: it is not finite", "0 is no light"));
    return warnings;
}

}  // namespace crevice
