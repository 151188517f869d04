// SPDX-License-Identifier: MIT
// Frames that leave out what has not changed show, bit for bit, what frames that run everything show.
#include "tests/picture.h"
#include "tests/shipped_subjects.h"

#include "core/renderer.h"
#include "tools/camera_framing.h"
#include "tools/scene_upload.h"

#include <functional>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};

/// What a host may change from one frame to the next.
const std::function<void(Frame&, Renderer&)> kChanges[] = {
    [](Frame&, Renderer&) {},
    [](Frame& frame, Renderer&) { frame.lights[0].position += glm::dvec3(0.5, 0, 0.25); },
    [](Frame&, Renderer&) {},
    [](Frame& frame, Renderer&) { frame.camera.view_from_world[3][0] += 0.05; },
    [](Frame&, Renderer& renderer) { need(renderer.setParam("radius", 0.4f)); },
    [](Frame& frame, Renderer&) { frame.draws[0].world_from_model[3][1] += 0.1; },
    [](Frame& frame, Renderer&) { frame.materials[0].base_color.x = 0.25f; },
    [](Frame& frame, Renderer&) { frame.ambient_light = {0.5f, 1, 1}; },
};

}  // namespace

TEST_CASE("What has not changed may be left out: the pictures of shipped configs are the same, bit for bit")
{
    GlFixture gl;
    const Scene scene = need(loadScene("spheres"));
    const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    const SceneCamera camera =
        need(chooseCamera(scene, uploaded.bounds(), "", double(kExtent.width) / kExtent.height));
    for (const Subject& subject : subjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = descriptionOf(subject);
        Frame frame = makeFrame(uploaded, camera, kExtent);
        CompileOptions options;
        options.extent = kExtent;
        const auto lazy = need(Renderer::create(*gl.device, description, options, traitsOf(frame)));
        options.keep = {"unchanged"};
        const auto full = need(Renderer::create(*gl.device, description, options, traitsOf(frame)));
        Frame same = frame;
        for (std::size_t i = 0; i < std::size(kChanges); ++i) {
            INFO("change " << i);
            kChanges[i](frame, *lazy);
            kChanges[i](same, *full);
            need(lazy->render(frame));
            need(full->render(same));
            for (const OutputDesc& output : description.outputs) {
                INFO(output.name);
                CHECK(gl.read(lazy->output(output.name)).pixels ==
                      gl.read(full->output(output.name)).pixels);
            }
        }
    }
}
