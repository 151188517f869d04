// SPDX-License-Identifier: MIT
#include "tests/support/scene_rig.h"

#include "tools/render/read_output.h"
#include "tools/render/scene/camera_framing.h"

namespace crevice {

std::unique_ptr<Renderer> DrawRig::renderer(const Description& description, const Frame& frame,
                                            std::vector<std::string> outputs) const
{
    const CompileOptions options = {extent, std::move(outputs), {}};
    return need(Renderer::create(*device, description, options, traitsOf(frame)));
}

Renderer& DrawRig::reloaded(const Description& description, const Frame& frame,
                            const CompileOptions& options, int index)
{
    std::unique_ptr<Renderer>& kept = kept_[index];
    if (!kept || !kept->reload(description, options))
        kept = need(Renderer::create(*device, description, options, traitsOf(frame)));
    return *kept;
}

Image DrawRig::draw(const Description& description, const Frame& frame, const std::string& output,
                    int frames)
{
    Renderer& drawn = reloaded(description, frame, {extent, {output}, {}});
    if (frames == 0) return need(drawSettled(*device, drawn, frame, output));
    for (int i = 0; i < frames; ++i) need(drawn.render(frame));
    return need(readOutput(*device, drawn, output));
}

SceneRig::SceneRig(Scene shown, Extent size, const GlDeviceOptions& options)
    : DrawRig(options),
      scene(std::move(shown)),
      uploaded(need(UploadedScene::upload(*device, scene)))
{
    extent = size;
}

SceneRig::SceneRig(const std::string& built_in, Extent size)
    : SceneRig(need(loadScene(built_in)), size)
{
}

void SceneRig::show(Scene shown)
{
    scene = std::move(shown);
    uploaded = need(UploadedScene::upload(*device, scene));
}

Frame SceneRig::frame(const std::string& camera) const
{
    const double aspect = double(extent.width) / extent.height;
    return makeFrame(uploaded, need(chooseCamera(scene, uploaded.bounds(), camera, aspect)),
                     extent);
}

}  // namespace crevice
