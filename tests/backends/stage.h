// SPDX-License-Identifier: MIT
// A built-in scene on a device, to be drawn with shipped configs.
#pragma once

#include <crevice/renderer.h>

#include "tests/support/shipped_subjects.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene_upload.h"

namespace crevice {

/// What each output of a renderer holds.
using Pixels = std::vector<std::vector<float>>;

struct Stage {
    explicit Stage(Device& on, Extent size = {32, 18}, const std::string& name = "spheres")
        : device(on),
          extent(size),
          scene(need(loadScene(name))),
          uploaded(need(UploadedScene::upload(on, scene)))
    {
        const double aspect = double(extent.width) / extent.height;
        frame =
            makeFrame(uploaded, need(chooseCamera(scene, uploaded.bounds(), "", aspect)), extent);
    }

    std::unique_ptr<Renderer> make(const Description& description,
                                   const std::vector<std::string>& outputs = {}) const
    {
        return need(Renderer::create(device, description, {extent, outputs, {}}, traitsOf(frame)));
    }
    std::unique_ptr<Renderer> make(const std::string& config) const
    {
        return make(descriptionOf({config}));
    }

    Pixels shown(const Renderer& renderer) const
    {
        Pixels all;
        for (const PlanOutput& output : renderer.plan().outputs)
            all.push_back(need(device.readTexture(renderer.output(output.name))).pixels);
        return all;
    }

    Pixels draw(Renderer& renderer) const
    {
        need(renderer.render(frame));
        return shown(renderer);
    }

    Device& device;
    Extent extent;
    Scene scene;
    UploadedScene uploaded;
    Frame frame;
};

}  // namespace crevice
