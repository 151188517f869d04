// SPDX-License-Identifier: MIT
// A few small pictures, compared with the approved ones in tests/data/golden.
//
// A failure writes what was drawn and the difference to the folder golden_failures below the
// current one. tools/scripts/approve.sh takes the new pictures as the approved ones.
#include "tests/support/picture.h"
#include "tools/image/image_file.h"
#include "tools/image/image_metrics.h"

#include <cstdlib>
#include <filesystem>

using namespace crevice;

namespace {

// Drivers round differently in the last bit; a wrong shader moves far more than this.
constexpr double kMaxStep = 3.0 / 255;           // Largest error of any pixel that is not an edge.
constexpr double kBadStep = 1.5 / 255;           // What counts as a bad pixel ...
constexpr double kMaxBadFraction = 0.001;        // ... and how many may be.
constexpr double kLargestEdgeStep = 64.0 / 255;  // A silhouette may move by a rounding.

std::string goldenPath(const std::string& name)
{
    return std::string(CREVICE_SOURCE_DIR) + "/tests/data/golden/" + name + ".png";
}

void reportFailure(const std::string& name, const Image& drawn, const Image& golden)
{
    std::filesystem::create_directories("golden_failures");
    const std::string stem = "golden_failures/" + testBackend() + "_" + name;
    need(writePng(stem + ".png", drawn));
    need(writePng(stem + "_difference.png", need(differencePicture(drawn, golden))));
    WARN("wrote " << stem << ".png and " << stem << "_difference.png");
}

void checkGolden(const std::string& name, const PictureRequest& request)
{
    const Image drawn = picture(request);
    if (std::getenv("CREVICE_APPROVE")) need(writePng(goldenPath(name), drawn));
    const Image golden = need(readImage(goldenPath(name)));
    const ImageDifference bad = need(compareImages(drawn, golden, nullptr, kBadStep));
    const ImageDifference far = need(compareImages(drawn, golden, nullptr, kMaxStep));
    const bool same = bad.non_finite == 0 && bad.bad_fraction <= kMaxBadFraction &&
                      far.bad_fraction <= kMaxBadFraction / 4 && bad.max <= kLargestEdgeStep;
    INFO(name << ": max " << bad.max << ", bad " << bad.bad_fraction);
    CHECK(same);
    if (!same) reportFailure(name, drawn, golden);
}

}  // namespace

TEST_CASE("learnopengl draws the approved picture of the room")
{
    PictureRequest request;
    request.config = "learnopengl";
    request.scene = "room";
    request.extent = {192, 108};
    request.output = "color";
    checkGolden("learnopengl_room", request);
}

TEST_CASE("hemisphere_bilateral draws the approved occlusion of the spheres")
{
    PictureRequest request;
    request.config = "hemisphere_bilateral";
    checkGolden("hemisphere_bilateral_spheres_ao", request);
}

TEST_CASE("ogldev45 draws the approved occlusion of the corner")
{
    PictureRequest request;
    request.config = "ogldev45";
    request.scene = "corner";
    checkGolden("ogldev45_corner_ao", request);
}
