// SPDX-License-Identifier: MIT
#include "tests/support/picture.h"

#include "tests/support/shipped_subjects.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crevice {

Image picture(const PictureRequest& request, SceneRig& rig)
{
    const SourceSet& sources = request.sources ? *request.sources : shippedSources();
    Description description = descriptionOf({request.config}, request.overrides, sources);
    if (!request.target.empty()) {
        OutputDesc output;
        output.name = request.output;
        output.target.name = request.target;
        description.outputs = {output};
    }
    Frame frame = rig.frame(request.camera);
    if (request.change) request.change(frame);
    return rig.draw(description, frame, request.output);
}

Image picture(const PictureRequest& request, const Scene& scene)
{
    GlDeviceOptions options;
    options.ignore_extensions = request.ignore_extensions;
    SceneRig rig(scene, request.extent, options);
    return picture(request, rig);
}

Image picture(const PictureRequest& request)
{
    return picture(request, need(loadScene(request.scene)));
}

namespace {

double meanOf(const Image& image, int left, int right, int low, int high)
{
    double sum = 0;
    for (int y = low; y < high; ++y)
        for (int x = left; x < right; ++x) sum += image.at(x, y);
    return sum / (double(right - left) * (high - low));
}

}  // namespace

double mean(const Image& image)
{
    return meanOf(image, 0, image.extent.width, 0, image.extent.height);
}

double meanOfRows(const Image& image, int first, int last)
{
    return meanOf(image, 0, image.extent.width, first, last);
}

double meanOfColumns(const Image& image, int first, int last)
{
    return meanOf(image, first, last, 0, image.extent.height);
}

float least(const Image& image)
{
    return *std::min_element(image.pixels.begin(), image.pixels.end());
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
