// SPDX-License-Identifier: MIT
#include "tests/support/picture.h"

#include "tools/render/read_output.h"
#include "tools/render/scene/camera_framing.h"

#include <algorithm>
#include <cmath>

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

Description showing(Description description, const std::string& target)
{
    OutputDesc output;
    output.name = "shown";
    output.target.name = target;
    description.outputs = {output};
    return description;
}

double mean(const Image& image) { return meanOfRows(image, 0, image.extent.height); }

double meanOfRows(const Image& image, int first, int last)
{
    double sum = 0;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < image.extent.width; ++x) sum += image.at(x, y);
    return sum / (double(image.extent.width) * (last - first));
}

float least(const Image& image)
{
    return *std::min_element(image.pixels.begin(), image.pixels.end());
}

double shareBelow(const Image& image, float limit)
{
    double below = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x) below += image.at(x, y) < limit;
    return below / (double(image.extent.width) * image.extent.height);
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

}  // namespace crevice
