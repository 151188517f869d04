// SPDX-License-Identifier: MIT
// Plans and frames that leave work out show, bit for bit, what those that run everything show.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <crevice/renderer.h>

#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <functional>
#include <map>
#include <optional>

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
    [](Frame& frame, Renderer&) {
        frame.ambient_light = {0.5f, 1, 1};
    },
    [](Frame& frame, Renderer&) {
        frame.camera.view_from_world[3][0] -= 2;
    },  // draws leave the view
};

/// A scene with its camera.
struct Stage {
    Stage(Device& device, const char* name, const char* camera_text = "")
        : Stage(device, need(loadScene(name)), camera_text)
    {
    }
    Stage(Device& device, Scene seen, const char* camera_text = "") : scene(std::move(seen))
    {
        uploaded = need(UploadedScene::upload(device, scene));
        camera = need(chooseCamera(scene, uploaded->bounds(), camera_text,
                                   double(kExtent.width) / kExtent.height));
    }
    Frame frame() const { return makeFrame(*uploaded, camera, kExtent); }

    Scene scene;
    std::optional<UploadedScene> uploaded;
    SceneCamera camera;
};

CompileOptions keeping(const std::vector<std::string>& optimizations)
{
    CompileOptions options;
    options.extent = kExtent;
    options.disable = optimizations;
    return options;
}

/// An output that a plan knows unrun is one texel, which stands for all.
bool isConstant(const Renderer& renderer, const std::string& output)
{
    return findNamed(renderer.plan().outputs, output)->constant >= 0;
}

/// The params of passes' no-ops, each with the value at which one holds.
std::map<std::string, float> noOpsOf(const Description& description)
{
    std::map<std::string, float> found;
    for (const PassDesc& pass : description.passes)
        for (const NoOpDesc& no_op : pass.no_op) found[no_op.param.name] = no_op.at;
    return found;
}

/// Without alpha, which says nothing in a picture of colours: a no-op gives one number for all
/// channels.
Image opaque(Image image)
{
    if (image.channels < 4) return image;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 1.0f;
    return image;
}

void checkSame(GlFixture& gl, const Renderer& lean, const Renderer& full,
               const std::vector<std::string>& outputs)
{
    for (const std::string& output : outputs) {
        INFO(output);
        Image picture = gl.read(lean.output(output));
        const Image whole = gl.read(full.output(output));
        if (isConstant(lean, output)) picture.pixels.assign(whole.pixels.size(), picture.pixels[0]);
        CHECK(opaque(std::move(picture)).pixels == opaque(whole).pixels);
    }
}

}  // namespace

TEST_CASE(
    "With all optimizations and with none the pictures of shipped configs are the same, whatever "
    "changes")
{
    GlFixture gl;
    const Stage stage(*gl.device, "spheres");
    for (const Subject& subject : subjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = descriptionOf(subject);
        Frame frame = stage.frame();
        const auto lean =
            need(Renderer::create(*gl.device, description, keeping({}), traitsOf(frame)));
        const auto full =
            need(Renderer::create(*gl.device, description, keeping({"all"}), traitsOf(frame)));
        Frame same = frame;
        for (std::size_t i = 0; i < std::size(kChanges); ++i) {
            INFO("change " << i);
            kChanges[i](frame, *lean);
            kChanges[i](same, *full);
            need(lean->render(frame));
            need(full->render(same));
            checkSame(gl, *lean, *full, namesOf(description.outputs));
        }
    }
}

TEST_CASE(
    "With all optimizations and with none the pictures are the same in every built-in scene, ao "
    "alone too")
{
    GlFixture gl;
    for (const char* name : {"corner", "plane", "room", "spheres"}) {
        const Stage stage(*gl.device, name);
        const Frame frame = stage.frame();
        for (const std::string& config : configNames(shippedSources())) {
            INFO(name << ' ' << config);
            const Description description = descriptionOf({config, ""});
            CompileOptions alone = keeping({});
            alone.outputs = {"ao"};
            const auto full =
                need(Renderer::create(*gl.device, description, keeping({"all"}), traitsOf(frame)));
            need(full->render(frame));
            for (const CompileOptions& options : {keeping({}), alone}) {
                const auto lean =
                    need(Renderer::create(*gl.device, description, options, traitsOf(frame)));
                need(lean->render(frame));
                checkSame(gl, *lean, *full,
                          options.outputs.empty() ? namesOf(description.outputs) : options.outputs);
            }
        }
    }
}

TEST_CASE("What a no-op gives is what its pass would have drawn, and so on down the filters")
{
    GlFixture gl;
    const Stage stage(*gl.device, "spheres");
    const Frame frame = stage.frame();
    for (const std::string& config : configNames(shippedSources())) {
        for (const auto& [param, at] : noOpsOf(descriptionOf({config, ""}))) {
            INFO(config << ", " << param << ' ' << at);
            Description description = descriptionOf({config, ""});
            for (ParamDesc& each : description.params)
                if (each.name == param) each.value.fill(at);
            const auto lean =
                need(Renderer::create(*gl.device, description, keeping({}), traitsOf(frame)));
            const auto full =
                need(Renderer::create(*gl.device, description, keeping({"all"}), traitsOf(frame)));
            need(lean->render(frame));
            need(full->render(frame));
            checkSame(gl, *lean, *full, namesOf(description.outputs));
            CHECK(lean->plan().passes.size() < full->plan().passes.size());
            if (param == "intensity")
                CHECK(lean->plan().passes.size() <= 2);  // geometry and lighting
        }
    }
}

TEST_CASE(
    "Masks and bounds change no pixel: half a background, draws off the middle, far away, none at "
    "all")
{
    GlFixture gl;
    for (const char* camera :
         {"eye=0,1.5,4;at=0,2.3,0", "eye=0,40,90;at=20,0,0", "eye=0,400,900;at=0,0,0",
          "eye=4,3,4;at=0,1,0;ortho=7;shift=0.2,0.1", "eye=0,2,9;at=0,4,20"}) {
        const Stage stage(*gl.device, "spheres", camera);
        const Frame frame = stage.frame();
        for (const std::string& config : configNames(shippedSources())) {
            INFO(camera << ' ' << config);
            const Description description = descriptionOf({config, ""});
            const auto full =
                need(Renderer::create(*gl.device, description, keeping({"all"}), traitsOf(frame)));
            need(full->render(frame));
            for (const char* kept : {"depth_mask", "scissor"}) {
                const auto lean = need(
                    Renderer::create(*gl.device, description, keeping({kept}), traitsOf(frame)));
                need(lean->render(frame));
                checkSame(gl, *lean, *full, namesOf(description.outputs));
            }
        }
    }
}
