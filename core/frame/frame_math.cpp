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

bool mirrors(const glm::dmat4& columns) { return glm::determinant(glm::dmat3(columns)) < 0.0; }

// `clip_from_view` as it would be under OpenGL's own clip control. In double: of a far plane the
// numbers from 0 to 1 keep what those from -1 to 1 round away.
glm::dmat4 plainClip(const Camera& camera)
{
    const ClipControl control = camera.clip_control.value_or(ClipControl());
    glm::dmat4 rows = glm::transpose(glm::dmat4(camera.clip_from_view));
    if (control.zero_to_one) rows[2] = 2.0 * rows[2] - rows[3];
    if (control.upper_left) rows[1] = -rows[1];
    return glm::transpose(rows);
}

// Whether the camera looks along +z: with perspective, where w grows with z; else where the view
// mirrors and all of the box lies there.
bool isLeftHanded(const Camera& camera)
{
    constexpr double kRounding = 1e-6;  // of a near plane at 0
    const glm::dmat4 clip = plainClip(camera);
    const glm::dvec4 of_z = clip[2], of_1 = clip[3];
    if (!camera.orthographic()) return of_z.w > 0.0;
    return mirrors(camera.view_from_world) && -of_1.z * (of_z.z < 0.0 ? -1 : 1) >= 1 - kRounding;
}

// Whether w is above 0 far along the axis that the view looks along.
bool looksForward(const Camera& camera)
{
    const glm::vec4 of_z = camera.clip_from_view[2], of_1 = camera.clip_from_view[3];
    if (of_z.w == 0.0f) return of_1.w > 0.0f;
    return of_z.w < 0.0f || mirrors(camera.view_from_world);
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
    if (!looksForward(camera))
        return bad(ownedBy(view, "clip_from_view") +
                       " has w below 0 for what lies in front, along -z: nothing would be seen",
                   "negate its third column, or, where the view is to look along +z, the third row "
                   "of view_from_world");
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

// Why an item's mesh cannot be drawn; nothing where it can, or where the host draws.
std::optional<Diagnostic> meshFault(const DrawItem& item, const Device& device)
{
    if (item.callback) return std::nullopt;
    if (!item.mesh) return elided("it has no mesh", kUnknownIdHelp);
    const ObjectInfo mesh = device.info(item.mesh);
    const auto named = [&item] { return "mesh " + std::to_string(item.mesh.value); };
    if (!mesh.exists) return elided(named() + " is none of this device", kUnknownIdHelp);
    if (std::uint64_t{item.first} + item.count > mesh.index_count)
        return elided(named() + " has fewer indices than it draws",
                      "first and count are indices, not triangles");
    return std::nullopt;
}

// Why an item cannot be drawn; nothing where it can. Allocates only where there is something to
// say.
std::optional<Diagnostic> faultOf(const Frame& frame, const DrawItem& item, const Device& device)
{
    if (std::optional<Diagnostic> fault = meshFault(item, device)) return fault;
    if (!finite(item.world_from_model)) return elided("its matrix is not finite", kNotFiniteHelp);
    if (!finite(item.bounds_center) || !std::isfinite(item.bounds_radius))
        return elided("its bounds are not finite", "a radius below 0 means that none are known");
    return materialFault(frame, item, device);
}

}  // namespace

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
    const glm::dmat4 clip_from_view = uprightClip(camera);
    const glm::dmat4 view_from_world = glm::dmat4(turn) * camera.view_from_world;
    return {clip_from_view, glm::inverse(clip_from_view), view_from_world,
            glm::inverse(view_from_world), turn};
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
    return mirrors(item.world_from_model) != mirrors(camera.view_from_world);
}

bool isSheet(const DrawItem& item, const Material& material)
{
    return item.sheet || material.alpha_cutoff > 0.0f;
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
bool isFinite(const glm::dvec3& vector) { return finite(vector); }

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

bool drawsSomething(const DrawItem& item) { return item.count > 0 || item.callback; }

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
        if (drawsSomething(item)) fault = faultOf(frame, item, device);
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
