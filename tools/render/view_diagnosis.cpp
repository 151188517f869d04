// SPDX-License-Identifier: MIT
#include "tools/render/view_diagnosis.h"

#include "core/base/text.h"
#include "core/config/values.h"
#include "core/plan/depth_precision.h"
#include "tools/commands/cli/output.h"
#include "tools/render/device/open_device.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene_upload.h"
#include "tools/render/target_diagnosis.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace crevice {
namespace {

// The radius to take: this part of the view's height, or 5% of the scene where that is less, since
// the rest of the view is empty then. About what radius 0.5 is in the scene 'room'.
constexpr double kShownShare = 0.08;

// Of the occlusion's own: with less, half the size errs by a third more than full size in the mean
// of scenes of tests/unseen; with 16, by a tenth.
constexpr double kLeastAoPixels = 5;

std::string figure(double value) { return shortest(static_cast<float>(value)); }

// To two digits.
double rounded(double value)
{
    if (value == 0) return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

// What the plan itself knows to be constant.
std::optional<Diagnostic> constantByPlan(const Plan& plan)
{
    const PlanOutput* output = findNamed(plan.outputs, "ao");
    if (!output || output->constant < 0) return std::nullopt;
    const float value = plan.constants[output->constant];
    return asWarning({Code::output_constant,
                      "the ambient occlusion is " + shortest(value) + " everywhere",
                      whyPlanned(plan)});
}

// Height of the occlusion, of the view's.
double aoShare(const Plan& plan)
{
    const PlanTarget* ao = findNamed(plan.targets, "ao");
    return ao && ao->texture >= 0
               ? double(plan.textures[ao->texture].extent.height) / plan.extent.height
               : 1.0;
}

bool isConstant(const Image& image)
{
    for (std::size_t i = image.channels; i < image.pixels.size(); i += image.channels)
        if (image.pixels[i] != image.pixels[0]) return false;
    return !image.pixels.empty();
}

// Flat scenes are open everywhere.
bool isFlat(const Bounds& bounds)
{
    const glm::dvec3 size = bounds.max - bounds.min;
    return std::min({size.x, size.y, size.z}) <= 1e-6 * bounds.diagonal();
}

Diagnostic nothingSeen(const Scene& scene, Extent extent)
{
    const SceneCamera framing = frameScene(scene, double(extent.width) / extent.height);
    const glm::dvec3 eye = glm::inverse(framing.view_from_world)[3];
    return asWarning({Code::nothing_seen,
                      "the camera sees no surface of the scene '" + scene.name + "'",
                      "try --camera 'eye=" + figure(eye.x) + "," + figure(eye.y) + "," +
                          figure(eye.z) + "', from where all of it is seen"});
}

Diagnostic nothingToMeasure()
{
    return {Code::nothing_seen, "the camera sees no surface to measure pixels at",
            "give the length in scene units or as a share of the scene, or move --camera"};
}

// What the scene's materials have and the plan's lighting does not show.
std::optional<Diagnostic> unlitMaterials(const Plan& plan, const Scene& scene)
{
    const auto reads = [&](const char* uniform) {
        return anyOf(plan.passes, [&](const PlanPass& pass) {
            return findNamed(pass.uniforms, uniform) != nullptr;
        });
    };
    if (!reads("ambient_light") || reads("emission")) return std::nullopt;
    std::vector<std::string> parts;
    const auto add = [&](const char* what, auto has) {
        if (anyOf(scene.materials, has)) parts.emplace_back(what);
    };
    using Each = const SceneMaterial&;
    add("metalness and roughness", [](Each m) {
        return m.metallic > 0 || m.metallic_roughness_texture >= 0 ||
               (m.roughness < 1 && m.specular == glm::vec3(0.0f));  // no highlight says so
    });
    add("emission", [](Each m) { return m.emission != glm::vec3(0.0f); });
    add("reflectance", [](Each m) { return m.reflectance != SceneMaterial().reflectance; });
    if (!findNamed(plan.targets, "baked_ao"))
        add("baked occlusion", [](Each m) { return m.occlusion_texture >= 0; });
    add("unlit materials", [](Each m) { return m.unlit; });
    if (parts.empty()) return std::nullopt;
    return asWarning(
        {Code::scene_features,
         "the lit picture of '" + scene.name + "' does not show " + joined(parts, " and "),
         "occlusion needs none of it; 'CONFIG+lighting/metallic_roughness' shows it"});
}

}  // namespace

Result<std::string> resolveLengths(Description& description, const Camera& camera, Extent extent,
                                   double diagonal, const std::function<Result<double>()>& distance)
{
    SceneTraits traits;
    traits.orthographic = camera.orthographic();
    traits.camera = rangeOf(camera);
    traits.scale.diagonal = diagonal;
    std::vector<std::string> said;
    for (ParamDesc& param : description.params) {
        if (!isRelative(param)) continue;
        const double percent = param.value[1], pixels = param.value[2];
        if (percent > 0 && diagonal == 0)
            return Diagnostic{Code::usage, param.name + " is a share of a scene, and there is none",
                              "give it in pixels, as 40px, or in the units of the depth"};
        const bool limited = param.value[3] > 0;
        const Result<double> seen = pixels > 0 || limited ? distance() : 0.0;
        if (!seen && !limited) return seen.diagnostics();
        if (seen) traits.scale.distance = *seen;
        param.value = sceneUnits(param, traits, extent.height);
        const bool less = param.value[0] < 0.01 * percent * diagonal * (1 - 1e-6);
        const std::string at = " at the median depth " + figure(rounded(traits.scale.distance));
        said.push_back(param.name + " " +
                       (less          ? "8 % of the view's height" + at
                        : percent > 0 ? figure(percent) + " % of the scene"
                                      : figure(pixels) + " pixels" + at) +
                       " = " + figure(rounded(param.value[0])));
    }
    return joined(said);
}

Result<double> medianDistance(Device& device, const Frame& frame, Extent extent)
{
    const Result<Image> depth = drawDepth(device, frame, extent);
    if (!depth) return depth.diagnostics();
    if (const auto distance = medianDistance(*depth, frame.camera)) return *distance;
    return nothingToMeasure();
}

double pixelsOf(double length, double distance, const Camera& camera, Extent extent)
{
    const double scale = 0.5 * extent.height * rangeOf(camera).zoom;
    return length * scale / (camera.orthographic() ? 1.0 : distance);
}

namespace {

Diagnostics checkOcclusion(const Description& description, const Plan& plan, const Scene& scene,
                           const Camera& camera, std::optional<double> distance, const Image* ao)
{
    if (!distance) return {nothingSeen(scene, plan.extent)};
    if (std::optional<Diagnostic> constant = constantByPlan(plan)) return {*constant};
    const ParamDesc* radius = resolvedLength(description);
    const Bounds bounds = scene.bounds();
    if (!radius || !findNamed(plan.params, radius->name)) return {};

    const double now = radius->value[0];
    const double unit_px = pixelsOf(1, *distance, camera, plan.extent);
    const std::string size = radius->name + " " + figure(now) + " is " +
                             figure(rounded(now * unit_px)) + " pixels at the median depth " +
                             figure(rounded(*distance));
    const double shown_px = std::max(kShownShare * plan.extent.height, 2 * kLeastRadiusPixels);
    const bool small = 0.05 * bounds.diagonal() * unit_px < shown_px;
    const std::string help =
        "try --set " + radius->name + "=" + (small ? "5%" : figure(rounded(shown_px)) + "px");
    const bool constant = ao && isConstant(*ao);
    const bool fits = now * unit_px >= kLeastRadiusPixels && now * unit_px < plan.extent.height;
    if (constant && !isFlat(bounds))
        return {asWarning(
            {Code::output_constant,
             "the ambient occlusion is " + shortest(ao->pixels[0]) + " everywhere: " + size,
             fits ? "no surface in view faces another one that near; take a larger radius, or "
                    "another --camera"
                  : help})};
    if (now * unit_px < kLeastRadiusPixels)
        return {asWarning({Code::out_of_range, size + ", where no ambient occlusion shows", help})};
    if (now * unit_px > plan.extent.height)
        return {asWarning({Code::out_of_range, size + ", more than the view is high", help})};
    const double share = aoShare(plan);
    if (share < 1 && now * unit_px * share < kLeastAoPixels)
        return {asWarning(
            {Code::out_of_range,
             size + ", too few for occlusion at " + figure(rounded(share)) + " of the resolution",
             "try --set ao_scale=1, or a config at full resolution such as gtao"})};
    return {};
}

}  // namespace

Diagnostics checkView(const Description& description, const Plan& plan, const Scene& scene,
                      const Camera& camera, std::optional<double> distance, const Image* ao)
{
    Diagnostics found = checkOcclusion(description, plan, scene, camera, distance, ao);
    if (std::optional<Diagnostic> unlit = unlitMaterials(plan, scene)) found.push_back(*unlit);
    return found;
}

Result<double> medianDistance(const Scene& shown, const SceneCamera& camera, Extent extent,
                              const std::string& backend)
{
    const Result<OpenDevice> open = openDevice(backend);
    if (!open) return open.diagnostics();
    const Result<UploadedScene> scene = UploadedScene::upload(*open->device, shown);
    if (!scene) return scene.diagnostics();
    return medianDistance(*open->device, makeFrame(*scene, camera, extent), extent);
}

Result<std::string> resolveLengths(Description& description, const SceneView& view,
                                   const std::string& backend)
{
    const auto& [scene, bounds, seen, extent] = view;
    const Camera camera = {seen.view_from_world, clipFromView(seen, extent, bounds)};
    return resolveLengths(description, camera, extent, bounds.diagonal(), [&] {
        return medianDistance(view.scene, view.camera, view.extent, backend);
    });
}

Result<std::string> resolveLengths(Description& description, const HostPictures& pictures)
{
    const auto distance = [&]() -> Result<double> {
        if (const auto median = pictures.medianDistance()) return *median;
        return nothingToMeasure();
    };
    return resolveLengths(description, pictures.camera(), pictures.extent(), 0, distance);
}

}  // namespace crevice
