// SPDX-License-Identifier: MIT
// Scenes and cameras of the page, and pictures in its canvas.
#include "tools/show/page/engine/parts.h"

#include "core/base/text.h"
#include "tools/commands/cli/load_config.h"
#include "tools/render/scene/camera_framing.h"

#include <crevice/shipped.h>

#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace crevice::page {

namespace {

Json listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

double aspectOf(Extent extent) { return double(extent.width) / extent.height; }

}  // namespace

Status Stage::show(Scene scene)
{
    const bool any = anyOf(scene.instances,
                           [&](auto& each) { return !scene.meshes[each.mesh].indices.empty(); });
    if (!any)
        return Diagnostic{Code::scene_empty, "the scene '" + scene.name + "' has no triangle",
                          "points and lines cast no occlusion; export the scene with its faces"};
    Result<UploadedScene> uploaded = UploadedScene::upload(*device_, scene);
    if (!uploaded) return uploaded.diagnostics();
    scene_ = std::move(scene);
    uploaded_ = std::move(*uploaded);
    return {};
}

Json Stage::state() const
{
    auto cameras = Json::array();
    for (const SceneCamera& camera : scene_.cameras) cameras.push_back(camera.name);
    return {
        {"name", scene_.name}, {"diagonal", uploaded_->bounds().diagonal()}, {"cameras", cameras}};
}

Result<SceneCamera> Stage::camera(const std::string& text, Extent extent) const
{
    return chooseCamera(scene_, uploaded_->bounds(), text, aspectOf(extent));
}

Frame Stage::frameOf(const SceneCamera& camera, Extent extent) const
{
    return makeFrame(*uploaded_, camera, extent);
}

Result<Json> Stage::resolve(const std::string& text, Extent extent) const
{
    const Result<SceneCamera> camera = this->camera(text, extent);
    if (!camera) return camera.diagnostics();
    const Extent small = {64, 64 * extent.height / extent.width + 1};
    const Frame frame = frameOf(*camera, small);
    const Result<Image> depth = drawDepth(*device_, frame, small);
    if (!depth) return depth.diagnostics();
    const double unseen = std::max(uploaded_->bounds().diagonal(), 1e-6);
    const double distance = medianDistance(*depth, frame.camera).value_or(unseen);
    const glm::dmat4 world_from_view = glm::inverse(camera->view_from_world);
    const glm::dvec3 eye(world_from_view[3]);
    Json json = {{"eye", listOf(eye)},
                 {"at", listOf(eye - glm::dvec3(world_from_view[2]) * distance)},
                 {"up", listOf(glm::dvec3(world_from_view[1]))}};
    if (camera->orthographic)
        json["ortho_height"] = 2 * camera->half_height;
    else
        json["fov_deg"] = camera->fov_y_rad * 180.0 / glm::pi<double>();
    return json;
}

Shown stretched(TextureId texture, const Image& image, bool depth)
{
    float least = 1e30f, most = -1e30f;
    for (const float value : image.pixels) {
        if (!std::isfinite(value) || (depth && value >= 1.0f)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    Shown shown = {texture};
    shown.grey = image.channels == 1;
    if (!(most > least)) return shown;
    shown.scale = 1.0f / (most - least);
    shown.offset = -least * shown.scale;
    return shown;
}

Display::Display(Device& device, std::unique_ptr<Renderer> renderer, Extent extent)
    : device_(&device),
      renderer_(std::move(renderer)),
      extent_(extent)
{
}

Result<Display> Display::create(Device& device, const std::string& config,
                                const std::string& shader, Extent extent)
{
    MemorySources own;
    own.add("configs/display.json", config);
    own.add("page/display.frag", shader);
    const LayeredSources sources({&own, &shippedSources()});
    Result<Description> description = loadDescription({"display", {}, {}, {}}, sources);
    if (!description) return description.diagnostics();
    auto renderer = Renderer::create(device, std::move(*description), {extent}, SceneTraits());
    if (!renderer) return renderer.diagnostics();
    return Display(device, std::move(*renderer), extent);
}

Status Display::draw(const Shown& left, const Shown& right, float split)
{
    const auto set = [this](const char* name, const Shown& shown) {
        const float view[] = {shown.scale, shown.offset,
                              shown.heat   ? 2.0f
                              : shown.grey ? 1.0f
                                           : 0.0f};
        return renderer_->setParam(name, view, 3);
    };
    Status status = renderer_->setParam("split", split);
    if (status) status = set("left_view", left);
    if (status) status = set("right_view", right);
    Frame frame;
    frame.textures = {{"left", left.texture}, {"right", right.texture}};
    if (status) status = renderer_->render(frame);
    if (!status) return status;
    return device_->present(renderer_->output("picture"), {0, 0, 0, extent_});
}

Status Display::resize(Extent extent)
{
    extent_ = extent;
    return renderer_->resize(extent);
}

}  // namespace crevice::page
