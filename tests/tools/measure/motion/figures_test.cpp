// SPDX-License-Identifier: MIT
// The measure of motion against estimators whose flicker is known.
#include "tests/tools/measure/motion/planted.h"

#include "tests/support/catch.h"

#include <cmath>

using namespace crevice;

namespace {

constexpr int kFrames = 4;

double smooth(glm::dvec3 at) { return 0.6 + 0.3 * std::sin(0.7 * at.x) * std::cos(0.4 * at.y); }

/// The truth with something added to each frame.
ChangeFigures figuresWith(const PathTruth& truth,
                          const std::function<double(int frame, int x, int y)>& added)
{
    std::vector<Image> frames = truth.frames;
    for (int frame = 0; frame < kFrames; ++frame)
        for (int y = 0; y < kPlanted.height; ++y)
            for (int x = 0; x < kPlanted.width; ++x)
                frames[frame].at(x, y) += static_cast<float>(added(frame, x, y));
    return changeFigures(frames, truth);
}

}  // namespace

TEST_CASE("occlusion that stays on its surface does not change, however the camera moves")
{
    for (const double step : {0.0, 0.15, 0.5, 1.0, 5.0}) {
        const PathTruth truth = plantedTruth(kFrames, step, smooth);
        const ChangeFigures exact = figuresWith(truth, [](int, int, int) { return 0.0; });
        // The truth's own change is that of interpolation: none at whole pixels.
        if (step == std::floor(step)) CHECK(exact.truth == Approx(0).margin(1e-6));
        if (step == 0.5) CHECK(exact.truth > 0.005);
        CHECK(exact.rms == 0.0);
        CHECK(exact.p999 == 0.0);
        CHECK(exact.rmse == 0.0);
        CHECK(exact.changes > 3 * 30 * kPlanted.height);
        // Off by the same everywhere is no flicker.
        const ChangeFigures dark = figuresWith(truth, [](int, int, int) { return -0.25; });
        CHECK(dark.rms == Approx(0).margin(1e-6));
        CHECK(dark.rmse == Approx(0.25));
    }
}

TEST_CASE("flicker of a known size is measured as that, at rest and in motion")
{
    for (const double step : {0.0, 0.15, 5.0}) {
        const PathTruth truth = plantedTruth(kFrames, step, smooth);
        const ChangeFigures figures =
            figuresWith(truth, [](int frame, int, int) { return frame % 2 ? 0.03 : -0.03; });
        CHECK(figures.rms == Approx(0.06).margin(1e-5));
        CHECK(figures.p99 == Approx(0.06).margin(1e-5));
        CHECK(figures.rmse == Approx(0.03).margin(1e-5));
    }
}

TEST_CASE("the percentiles of change are those of rare pixels")
{
    const PathTruth truth = plantedTruth(kFrames, 0.0, smooth);
    // 10 of 960 pixels change in each pair, by 0.2, of which one by 0.5.
    const ChangeFigures figures = figuresWith(truth, [](int frame, int x, int y) {
        if (y > 0 || x >= 10 || frame % 2 == 0) return 0.0;
        return x == 0 ? 0.5 : 0.2;
    });
    CHECK(figures.changes == 3 * 960);
    CHECK(figures.p99 == Approx(0.2));
    CHECK(figures.p999 == Approx(0.5));
    CHECK(figures.rms == Approx(std::sqrt((9 * 0.04 + 0.25) / 960)));
}

TEST_CASE("what is uncovered has no part in the change")
{
    PathTruth truth;
    truth.frames.assign(2, plantedImage(plantedSurfaces(0, 0), smooth));
    truth.flows = {
        flowTo(plantedSurfaces(0, 0, 30), plantedSurfaces(0, 0, 20), plantedCamera(0, 0))};
    std::vector<Image> frames = truth.frames;
    for (int y = 0; y < kPlanted.height; ++y)
        for (int x = 20; x < 30; ++x) frames[1].at(x, y) = 0.0f;  // the box has come there
    const ChangeFigures figures = changeFigures(frames, truth);
    CHECK(figures.rms == 0.0);
    CHECK(figures.changes == 30 * kPlanted.height);
}

TEST_CASE("a picture has settled at the last frame that changed, and not when that is the last one")
{
    const auto settled = [](const std::vector<float>& values) {
        Settling settling;
        for (const float value : values) settling.add(Image(kPlanted, 1, value));
        return settling.frames();
    };
    CHECK(settled({0.5f, 0.5f, 0.5f}) == 1);
    CHECK(settled({0.1f, 0.3f, 0.5f, 0.5f}) == 3);
    CHECK(settled({0.1f, 0.3f, 0.1f}) == 0);
    CHECK(settled({0.5f, 0.501f, 0.502f}) == 1);  // each by less than half a step of 8 bits
    CHECK(settled({0.5f, 0.503f, 0.506f}) == 0);
    CHECK(settled({0.5f}) == 1);
}
