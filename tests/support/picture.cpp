// SPDX-License-Identifier: MIT
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <utility>

namespace crevice {
namespace {

Description describePicture(const PictureRequest& request)
{
    const SourceSet& sources = request.sources ? *request.sources : shippedSources();
    const Node document = need(loadConfig(sources, {request.config, {}, request.overrides}));
    Description description = need(decode(document, sources));
    if (!request.target.empty()) {
        OutputDesc output;
        output.name = request.output;
        output.target.name = request.target;
        description.outputs = {output};
    }
    return description;
}

}  // namespace

Image picture(const PictureRequest& request, const Scene& scene)
{
    GlDeviceOptions options;
    options.ignore_extensions = request.ignore_extensions;
    GlFixture gl(options);
    UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    const double aspect = double(request.extent.width) / request.extent.height;
    const SceneCamera camera = need(chooseCamera(scene, uploaded.bounds(), request.camera, aspect));
    Frame frame = makeFrame(uploaded, camera, request.extent);
    if (request.change) request.change(frame);

    CompileOptions compile_options;
    compile_options.extent = request.extent;
    compile_options.outputs = {request.output};
    auto renderer = need(
        Renderer::create(*gl.device, describePicture(request), compile_options, traitsOf(frame)));
    need(renderer->render(frame));
    return gl.read(renderer->output(request.output));
}

Image picture(const PictureRequest& request)
{
    return picture(request, need(loadScene(request.scene)));
}

double mean(const Image& image)
{
    double sum = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x) sum += image.at(x, y);
    return sum / (double(image.extent.width) * image.extent.height);
}

double shareBelow(const Image& image, float limit, double share)
{
    const int border_x = int(image.extent.width * (1 - share) / 2);
    const int border_y = int(image.extent.height * (1 - share) / 2);
    int below = 0;
    int all = 0;
    for (int y = border_y; y < image.extent.height - border_y; ++y)
        for (int x = border_x; x < image.extent.width - border_x; ++x, ++all)
            below += image.at(x, y) < limit ? 1 : 0;
    return double(below) / all;
}

double meanChange(const Image& a, const Image& b)
{
    REQUIRE(a.pixels.size() == b.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::fabs(a.pixels[i] - b.pixels[i]);
    return sum / double(a.pixels.size());
}

bool allVisibility(const Image& image)
{
    for (float value : image.pixels)
        if (!(value >= 0.0f && value <= 1.0f)) return false;
    return true;
}

Scene mirrored(Scene scene)
{
    for (SceneInstance& instance : scene.instances)
        instance.world_from_model =
            glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)) * instance.world_from_model;
    return scene;
}

Image mirrored(Image image)
{
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width / 2; ++x)
            std::swap(image.pixels[y * image.extent.width + x],
                      image.pixels[(y + 1) * image.extent.width - 1 - x]);
    return image;
}

}  // namespace crevice
