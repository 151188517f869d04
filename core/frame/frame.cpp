// SPDX-License-Identifier: MIT
// Checks of a frame, what a plan may depend on in it, and how lights and normals reach view space.
#include <crevice/frame.h>

#include "core/frame/frame_math.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>

namespace crevice {
namespace {

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

glm::dvec3 towardsLight(const Light& light, const glm::dmat4& view_from_world)
{
    const glm::dvec3 towards = -(glm::dmat3(view_from_world) * glm::dvec3(light.direction));
    const double length = glm::length(towards);
    return length > 0.0 ? towards / length : towards;
}

Diagnostic elided(std::string what, std::string help)
{
    return asWarning({Code::bad_input, std::move(what), std::move(help)});
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

// Why an item cannot be drawn; nothing where it can. Allocates only to say something.
std::optional<Diagnostic> faultOf(const Frame& frame, const DrawItem& item, const Device& device)
{
    if (std::optional<Diagnostic> fault = meshFault(item, device)) return fault;
    if (!isFinite(item.world_from_model)) return elided("its matrix is not finite", kNotFiniteHelp);
    if (!isFinite(item.bounds_center) || !std::isfinite(item.bounds_radius))
        return elided("its bounds are not finite", "a radius below 0 means that none are known");
    return materialFault(frame, item, device);
}

// Past this many near planes a far plane is lost in the rounding of a float matrix.
constexpr double kFarthestPlane = 1 << 20;

bool withinTwice(double a, double b) { return a <= 2 * b && b <= 2 * a; }

// The distance of the plane at which clip z is w times `side`; infinite where none is in front.
double planeDistance(const glm::dmat4& clip_from_view, double side)
{
    const glm::dvec4 of_z = clip_from_view[2], of_1 = clip_from_view[3];
    const double distance = (of_1.z - side * of_1.w) / (of_z.z - side * of_z.w);
    return distance > 0 ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace

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
            return badInput("view " + std::to_string(view) + (is ? " is " : " is not ") + what +
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

bool isFinite(const glm::dmat4& matrix) { return finite(&matrix[0][0], 16); }
bool isFinite(const glm::dvec3& vector) { return finite(&vector[0], 3); }

bool isFinite(const Material& material)
{
    const float numbers[] = {material.shininess,          material.ambient,
                             material.alpha_cutoff,       material.normal_scale,
                             material.occlusion_strength, material.metallic,
                             material.roughness,          material.reflectance};
    return finite(&material.base_color[0], 4) && isFinite(material.specular) &&
           isFinite(material.emission) && finite(numbers, int{std::size(numbers)});
}

bool isFinite(const Light& light)
{
    return isFinite(light.position) && isFinite(light.direction) && isFinite(light.color) &&
           isFinite(light.attenuation) && std::isfinite(light.inner_angle_rad) &&
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

bool Material::operator==(const Material& other) const
{
    const auto same = [](TextureId a, TextureId b) { return a.value == b.value; };
    return base_color == other.base_color && same(base_color_map, other.base_color_map) &&
           specular == other.specular && shininess == other.shininess && ambient == other.ambient &&
           alpha_cutoff == other.alpha_cutoff && same(normal_map, other.normal_map) &&
           normal_scale == other.normal_scale && same(occlusion_map, other.occlusion_map) &&
           occlusion_strength == other.occlusion_strength && blended == other.blended &&
           metallic == other.metallic && roughness == other.roughness &&
           reflectance == other.reflectance && emission == other.emission &&
           same(metallic_roughness_map, other.metallic_roughness_map) &&
           same(emission_map, other.emission_map) && unlit == other.unlit;
}

bool DrawItem::operator==(const DrawItem& other) const
{
    return mesh.value == other.mesh.value && first == other.first && count == other.count &&
           world_from_model == other.world_from_model && material == other.material &&
           bounds_center == other.bounds_center && bounds_radius == other.bounds_radius &&
           sheet == other.sheet && callback == other.callback && host == other.host &&
           revision == other.revision;
}

const Camera& cameraOf(const Frame& frame, std::size_t view)
{
    return view == 0 ? frame.camera : frame.other_views[view - 1].camera;
}

bool SceneTraits::operator==(const SceneTraits& other) const
{
    const auto same = [&](const TraitInfo& t) { return t.value(*this) == t.value(other); };
    return camera == other.camera && allOf(kTraits, same);
}

bool CameraRange::operator==(const CameraRange& other) const
{
    const auto endless = [](const CameraRange& range) {
        return range.far_distance > kFarthestPlane * range.near_distance;
    };
    const bool both_endless = near_distance > 0 && endless(*this) && endless(other);
    return withinTwice(near_distance, other.near_distance) && withinTwice(zoom, other.zoom) &&
           withinTwice(depth_share, other.depth_share) &&
           (both_endless || withinTwice(far_distance, other.far_distance));
}

CameraRange rangeOf(const Camera& camera)
{
    const glm::dmat4 m = uprightClip(camera);
    const double zoom = std::abs(m[1][1]);
    const DepthRange range = camera.depth_range.value_or(DepthRange());
    const double share = std::abs(double{range.far_depth} - range.near_depth);
    if (camera.orthographic()) return {0, 2 / std::abs(m[2][2]), zoom, share};
    const double one = planeDistance(m, -1), other = planeDistance(m, 1);
    return {std::min(one, other), std::max(one, other), zoom, share};
}

SceneTraits steadyTraitsOf(const Frame& frame, const SceneTraits* known)
{
    SceneTraits traits = known ? *known : SceneTraits();
    traits.lights = std::min(static_cast<int>(frame.lights.size()), kMaxLights);
    traits.orthographic = frame.camera.orthographic();
    traits.reversed_depth = frame.camera.reversedDepth();
    traits.turned = false;
    for (std::size_t view = 0; view <= frame.other_views.size(); ++view)
        traits.turned |= uprightTurn(cameraOf(frame, view)) != glm::dmat3(1.0);
    traits.camera = rangeOf(frame.camera);
    traits.scale = frame.scale;
    traits.views = 1 + static_cast<int>(frame.other_views.size());
    if (known) return traits;
    for (const DrawItem& draw : frame.draws) {
        if (draw.material < 0 || draw.material >= static_cast<int>(frame.materials.size()))
            continue;
        const Material& material = frame.materials[draw.material];
        traits.alpha_tested |= material.alpha_cutoff > 0.0f;
        traits.specular |= glm::any(glm::greaterThan(material.specular, glm::vec3(0.0f)));
        traits.textured |= bool(material.base_color_map);
        traits.normal_mapped |= bool(material.normal_map);
        traits.baked_occlusion |= bool(material.occlusion_map);
        traits.material_ambient |= material.ambient < 1.0f;
        traits.blended |= material.blended;
        traits.metal_mapped |= bool(material.metallic_roughness_map);
        traits.emission_mapped |= bool(material.emission_map);
    }
    return traits;
}

SceneTraits traitsOf(const Frame& frame)
{
    SceneTraits traits = steadyTraitsOf(frame);
    traits.draws = rangeOf(frame.draws, frame.camera);
    return traits;
}

}  // namespace crevice
