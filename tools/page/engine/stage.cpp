// SPDX-License-Identifier: MIT
// Scenes and cameras of the page.
#include "tools/page/engine/stage.h"

#include "tools/render/view_depth.h"
#include "tools/scene/camera_framing.h"

#include <nlohmann/json.hpp>

#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace crevice::page {
namespace {

using Json = nlohmann::json;

Json listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json boundsJson(const glm::dvec3& corner, bool empty)
{
    return listOf(empty ? glm::dvec3(0.0) : corner);
}

bool sameCamera(const SceneCamera& a, const SceneCamera& b)
{
    return a.view_from_world == b.view_from_world && a.orthographic == b.orthographic &&
           a.fov_y_rad == b.fov_y_rad && a.half_height == b.half_height && a.shift == b.shift;
}

double aspectOf(Extent extent) { return double(extent.width) / extent.height; }

}  // namespace

Status Stage::show(Scene scene)
{
    const bool any = std::any_of(scene.instances.begin(), scene.instances.end(), [&](auto& each) {
        return !scene.meshes[each.mesh].indices.empty();
    });
    if (!any)
        return Diagnostic{Code::scene_empty, "the scene '" + scene.name + "' has no triangle",
                          "points and lines cast no occlusion; export the scene with its faces"};
    Result<UploadedScene> uploaded = UploadedScene::upload(*device_, scene);
    if (!uploaded) return uploaded.diagnostics();
    scene_ = std::move(scene);
    uploaded_ = std::move(*uploaded);
    path_.reset();
    return {};
}

Json Stage::state() const
{
    long long triangles = 0;
    for (const SceneInstance& instance : scene_.instances)
        triangles += static_cast<long long>(scene_.meshes[instance.mesh].indices.size() / 3);
    auto cameras = Json::array();
    for (const SceneCamera& camera : scene_.cameras) cameras.push_back(camera.name);
    const Bounds& bounds = uploaded_->bounds();
    return {{"name", scene_.name},
            {"triangles", triangles},
            {"min", boundsJson(bounds.min, bounds.empty())},
            {"max", boundsJson(bounds.max, bounds.empty())},
            {"diagonal", bounds.diagonal()},
            {"cameras", cameras}};
}

Result<SceneCamera> Stage::camera(const std::string& text, Extent extent) const
{
    return chooseCamera(scene_, uploaded_->bounds(), text, aspectOf(extent));
}

Frame Stage::frameOf(const SceneCamera& camera, Extent extent) const
{
    return makeFrame(*uploaded_, camera, extent);
}

Result<double> Stage::distanceOf(const SceneCamera& camera, Extent extent) const
{
    const Frame frame = frameOf(camera, extent);
    const Result<Image> depth = drawDepth(*device_, frame, extent);
    if (!depth) return depth.diagnostics();
    const double unseen = std::max(uploaded_->bounds().diagonal(), 1e-6);
    return medianDistance(*depth, frame.camera).value_or(unseen);
}

Result<Json> Stage::resolve(const std::string& text, Extent extent) const
{
    const Result<SceneCamera> camera = this->camera(text, extent);
    if (!camera) return camera.diagnostics();
    const Result<double> distance =
        distanceOf(*camera, {64, 64 * extent.height / extent.width + 1});
    if (!distance) return distance.diagnostics();
    const glm::dmat4 world_from_view = glm::inverse(camera->view_from_world);
    const glm::dvec3 eye(world_from_view[3]);
    Json json = {{"eye", listOf(eye)},
                 {"at", listOf(eye - glm::dvec3(world_from_view[2]) * *distance)},
                 {"up", listOf(glm::dvec3(world_from_view[1]))}};
    if (camera->orthographic)
        json["ortho_height"] = 2 * camera->half_height;
    else
        json["fov_deg"] = camera->fov_y_rad * 180.0 / glm::pi<double>();
    return json;
}

Result<SceneCamera> Stage::along(const std::string& path, const SceneCamera& camera, Extent extent,
                                 int frame, int frames)
{
    const Result<CameraPath> found = findCameraPath(path);
    if (!found) return found.diagnostics();
    if (!path_ || !sameCamera(path_->camera, camera) || path_->extent != extent) {
        const Result<double> distance = distanceOf(camera, extent);
        if (!distance) return distance.diagnostics();
        path_ = PathView{camera, extent, *distance};
    }
    return cameraAt(*found, *path_, frame, frames);
}

}  // namespace crevice::page
