// SPDX-License-Identifier: MIT
#include "tools/measure/cost/fetches.h"

#include "tools/measure/cost/counting_device.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"

#include <crevice/renderer.h>

#include <algorithm>

namespace crevice {

namespace {

/// Frames until a history holds what it does in every later one.
int warmUpFrames(const Plan& plan)
{
    return std::any_of(plan.targets.begin(), plan.targets.end(),
                       [](const PlanTarget& target) { return target.history_texture >= 0; })
               ? 2
               : 0;
}

}  // namespace

Result<std::map<std::string, double>> countFetches(Description description, const SceneView& view)
{
    const Result<OpenDevice> open = openDevice("");
    if (!open) return open.diagnostics();
    CountingDevice device(*open->device);
    const Result<UploadedScene> scene = UploadedScene::upload(*open->device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame drawn = makeFrame(*scene, view.camera, view.extent);
    Result<HostTextures> host = HostTextures::make(*open->device, description, view.extent, drawn);
    if (!host) return host.diagnostics();
    const Result<Frame> frame = host->frameOf(drawn);
    if (!frame) return frame.diagnostics();
    CompileOptions options;
    options.extent = view.extent;
    options.disable = {"cached"};  // a pass that does not run is not counted
    const Result<std::unique_ptr<Renderer>> renderer =
        Renderer::create(device, std::move(description), options, traitsOf(*frame));
    if (!renderer) return renderer.diagnostics();
    for (int warm_up = warmUpFrames((*renderer)->plan()); warm_up >= 0; --warm_up) {
        if (warm_up == 0) device.startCounting();
        if (const Status status = (*renderer)->render(*frame); !status) return status.diagnostics();
    }
    return device.fetches();
}

}  // namespace crevice
