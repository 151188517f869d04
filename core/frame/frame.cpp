// SPDX-License-Identifier: MIT
// What a plan may depend on, drawn from a frame.
#include <crevice/frame.h>

#include "core/frame/frame_math.h"
#include "core/frame/frame_values.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

namespace {

// Past this many near planes a far plane is lost in the rounding of a float matrix.
constexpr double kFarthestPlane = 1 << 20;

bool withinTwice(double a, double b) { return a <= 2 * b && b <= 2 * a; }

// The distance of the plane at which clip z is w times `side`; infinite where there is none in
// front.
double planeDistance(const glm::dmat4& clip_from_view, double side)
{
    const glm::dvec4 of_z = clip_from_view[2], of_1 = clip_from_view[3];
    const double distance = (of_1.z - side * of_1.w) / (of_z.z - side * of_z.w);
    return distance > 0 ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace

bool Material::operator==(const Material& other) const
{
    const auto same = [](TextureId a, TextureId b) { return a.value == b.value; };
    return base_color == other.base_color && same(base_color_map, other.base_color_map) &&
           specular == other.specular && shininess == other.shininess && ambient == other.ambient &&
           alpha_cutoff == other.alpha_cutoff && same(normal_map, other.normal_map) &&
           normal_scale == other.normal_scale && same(occlusion_map, other.occlusion_map) &&
           occlusion_strength == other.occlusion_strength;
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
    return camera == other.camera && std::all_of(std::begin(kTraits), std::end(kTraits), same);
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

SceneTraits steadyTraitsOf(const Frame& frame)
{
    SceneTraits traits;
    traits.lights = std::min(static_cast<int>(frame.lights.size()), kMaxLights);
    traits.orthographic = frame.camera.orthographic();
    traits.reversed_depth = frame.camera.reversedDepth();
    for (std::size_t view = 0; view <= frame.other_views.size(); ++view)
        traits.turned |= uprightTurn(cameraOf(frame, view)) != glm::dmat3(1.0);
    traits.camera = rangeOf(frame.camera);
    traits.views = 1 + static_cast<int>(frame.other_views.size());
    for (const DrawItem& draw : frame.draws) {
        if (draw.material < 0 || draw.material >= static_cast<int>(frame.materials.size()))
            continue;
        const Material& material = frame.materials[draw.material];
        traits.alpha_tested |= material.alpha_cutoff > 0.0f;
        traits.sheets |= isSheet(draw, material);
        traits.specular |= glm::any(glm::greaterThan(material.specular, glm::vec3(0.0f)));
        traits.textured |= bool(material.base_color_map);
        traits.normal_mapped |= bool(material.normal_map);
        traits.baked_occlusion |= bool(material.occlusion_map);
        traits.material_ambient |= material.ambient < 1.0f;
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
