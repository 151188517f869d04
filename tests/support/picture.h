// SPDX-License-Identifier: MIT
// Pictures for tests: a config drawn over a scene on the test's GL context.
#pragma once

#include "tests/support/scene_rig.h"

#include <functional>
#include <string>
#include <vector>

namespace crevice {

/// What to draw. The defaults are small, because software GL is slow.
struct PictureRequest {
    std::string config = "hemisphere_box";  ///< A shipped config or a file.
    std::string scene = "spheres";          ///< A built-in scene.
    std::string camera = {};                ///< As `--camera`.
    Extent extent = {128, 72};
    std::vector<std::string> overrides = {};  ///< As `--set`.
    std::string output = "ao";
    std::string target = {};                  ///< When set, this target instead of an output.
    const SourceSet* sources = nullptr;       ///< Null takes the shipped ones.
    bool ignore_extensions = false;           ///< Draw as on bare OpenGL ES 3.0.
    std::function<void(Frame&)> change = {};  ///< Of what a scene file cannot say.
};

/// Draws and reads back; any error fails the test.
Image picture(const PictureRequest& request);
Image picture(const PictureRequest& request, const Scene& scene);

/// The same with the scene of a rig, in its size and on its device.
Image picture(const PictureRequest& request, SceneRig& rig);

/// The mean over all pixels of the first channel.
double mean(const Image& image);

/// That of some rows or columns, from the first up to the last.
double meanOfRows(const Image& image, int first, int last);
double meanOfColumns(const Image& image, int first, int last);

float least(const Image& image);

/// The share of pixels, in the middle `share` of width and height, that are below `limit`.
double shareBelow(const Image& image, float limit, double share = 0.8);

/// The mean absolute difference of two pictures of one size.
double meanChange(const Image& a, const Image& b);

/// True when every value is finite and in [0, 1].
bool allVisibility(const Image& image);

/// Left and right swapped, in the world (triangles keep their front) and in a picture.
Scene mirrored(Scene scene);
Image mirrored(Image image);

}  // namespace crevice
