// SPDX-License-Identifier: MIT
// The measure of motion against estimators whose flicker is known.
// The ray-traced truth of camera paths: its noise, its surfaces, and what it keeps.
// Which surface points two frames share, and where.
#include "tools/measure/motion/figures.h"

#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/reference/tracer_shot.h"
#include "tools/measure/motion/measure.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

// Surfaces and cameras known in closed form: a wall at z = 0, and perhaps a box in front of it,
// seen by orthographic cameras of one pixel a unit.
constexpr Extent kPlanted = {40, 24};

/// Looks along -z at (x + 20, y + 12), pixels from the lower left corner.
Camera plantedCamera(double x, double y)
{
    Camera camera;
    camera.view_from_world = glm::translate(glm::dmat4(1.0), {-x - 20, -y - 12, -10});
    camera.clip_from_view =
        glm::ortho<float>(-20, 20, -12, 12, 1, 30);  // a pixel is a unit of the world
    return camera;
}

/// Left edge of the front of a box at z = 5, from there to the right; none by default.
SurfaceMap plantedSurfaces(double x, double y, double box = 1e9)
{
    SurfaceMap map{kPlanted, {}};
    for (int row = 0; row < kPlanted.height; ++row)
        for (int column = 0; column < kPlanted.width; ++column) {
            const double at = x + column + 0.5;
            map.points.push_back({{at, y + row + 0.5, at < box ? 0.0 : 5.0}, {0, 0, 1}, true});
        }
    return map;
}

/// A picture of what `value` has in each pixel.
Image plantedImage(const std::function<double(int x, int y)>& value)
{
    Image image(kPlanted, 1);
    for (int y = 0; y < kPlanted.height; ++y)
        for (int x = 0; x < kPlanted.width; ++x) image.at(x, y) = static_cast<float>(value(x, y));
    return image;
}

/// What the surfaces have at world coordinates.
Image plantedImage(const SurfaceMap& map, const std::function<double(glm::dvec3)>& value)
{
    return plantedImage([&](int x, int y) { return value(map.at(x, y).position); });
}

/// Of a walk along the wall by `step` a frame; the truth is `value` there.
PathTruth plantedTruth(int frames, double step, const std::function<double(glm::dvec3)>& value)
{
    PathTruth truth;
    for (int frame = 0; frame < frames; ++frame) {
        const SurfaceMap map = plantedSurfaces(step * frame, 0);
        truth.frames.push_back(plantedImage(map, value));
        if (frame + 1 == frames) break;
        const double next = step * (frame + 1);
        truth.flows.push_back(flowTo(map, plantedSurfaces(next, 0), plantedCamera(next, 0)));
    }
    return truth;
}

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

constexpr Extent kSmall = {32, 18};

/// A slope in a corner, and a fence whose pale hides what is behind it from another place.
Scene cornerScene()
{
    return sceneOf({kFloor, kWall, makeQuad({-20, 0, 10}, {40, 0, 0}, {0, 20, -10}),
                    makeQuad({-8, 0, 25}, {16, 0, 0}, {0, 20, 0})});
}

MotionView viewOf(const Scene& scene)
{
    SceneCamera camera;
    camera.view_from_world =
        glm::lookAt(glm::dvec3(30, 40, 60), glm::dvec3(0, 5, 0), glm::dvec3(0, 1, 0));
    return {scene, scene.bounds(), {camera, kSmall, 70.0}, 10.0, ""};
}

/// Rms of what the truth's change along the path's last step has for noise, against many rays.
double noiseOf(const MotionView& view, const char* name)
{
    const CameraPath path = need(findCameraPath(name));
    const Camera first = view.camera(path, kMotionFrames - 2);
    const Camera last = view.camera(path, kMotionFrames - 1);
    const Image flow = flowTo(need(traceSurfaces(view.scene, first, kSmall)),
                              need(traceSurfaces(view.scene, last, kSmall)), last);
    const auto change = [&](int rays) {
        return changeAlong(flow, trace(view.scene, first, kSmall, view.radius, rays),
                           trace(view.scene, last, kSmall, view.radius, rays));
    };
    const Image few = change(kMotionRays);
    CHECK(std::count_if(few.pixels.begin(), few.pixels.end(),
                        [](float value) { return !std::isnan(value); }) > 300);
    return rmsDifference(few, change(8 * kMotionRays));
}

/// A box that ends at x = 20 and has moved to begin at `to`, with the camera where it was.
Image boxFlow(double from, double to)
{
    return flowTo(plantedSurfaces(0, 0, from), plantedSurfaces(0, 0, to), plantedCamera(0, 0));
}

bool counts(const Image& flow, int x) { return !std::isnan(flow.at(x, 12)); }

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

TEST_CASE("the noise of the truth's change is below 0.002")
{
    const Scene scene = cornerScene();
    const MotionView view = viewOf(scene);
    for (const char* path : {"sub-pixel", "pan"}) {
        INFO(path);
        const double noise = noiseOf(view, path);
        CAPTURE(noise);
        CHECK(noise > 0.0);
        CHECK(noise < 0.002);
    }
}

TEST_CASE("the truth of all paths is traced once and then kept")
{
    const TemporaryFolder folder("motion_truth");
    const Scene scene = cornerScene();
    MotionView view = viewOf(scene);
    view.cache_folder = folder.path.string();
    const auto never = [] { return false; };
    const MotionTruth first = need(traceMotion(view, never));
    REQUIRE(first.paths.size() == std::size(kCameraPaths) - 1);
    for (const auto& [name, truth] : first.paths) {
        INFO(name);
        CHECK(truth.frames.size() == kMeasuredFrames);
        CHECK(truth.flows.size() == kMeasuredFrames - 1);
        CHECK(truth.frames.back().pixels.size() == first.rest.pixels.size());
    }
    const auto files = [&folder] {
        return std::distance(std::filesystem::directory_iterator(folder.path), {});
    };
    CHECK(files() ==
          1 + 3 * (kMeasuredFrames - 1));  // the end, and what sub-pixel, pan, strafe add
    need(traceMotion(view, never));
    CHECK(files() == 1 + 3 * (kMeasuredFrames - 1));
    CHECK(first.uncovered.extent == kSmall);
}

TEST_CASE("a point is found where the next frame sees it, up to the last pixel that it has")
{
    for (const auto& [right, up] : {std::pair(0.0, 0.0), {2.25, 0.5}}) {
        const Image flow =
            flowTo(plantedSurfaces(0, 0), plantedSurfaces(right, up), plantedCamera(right, up));
        for (int y = 0; y < kPlanted.height; ++y)
            for (int x = 0; x < kPlanted.width; ++x) {
                INFO(x << ", " << y);
                const bool inside = x >= std::ceil(right) && y >= std::ceil(up);  // four texels
                CHECK(std::isnan(flow.at(x, y, 0)) == !inside);
                if (!inside) continue;
                CHECK(flow.at(x, y, 0) == Approx(x - right));
                CHECK(flow.at(x, y, 1) == Approx(y - up));
            }
    }
}

TEST_CASE("what is hidden in the next frame does not count, nor does what was uncovered")
{
    const Image hidden = boxFlow(1e9, 20), uncovered = boxFlow(20, 1e9);
    for (int x = 0; x < kPlanted.width; ++x) {
        INFO(x);
        CHECK(counts(hidden, x) == (x < 20));
        CHECK(counts(uncovered, x) == (x < 20));
    }
}

TEST_CASE("a crease counts, and the background does not")
{
    SurfaceMap crease = plantedSurfaces(0, 0);
    for (SurfacePoint& point : crease.points)
        if (point.position.x > 20) {
            point.position.z = point.position.x - 20;
            point.normal = glm::normalize(glm::dvec3(-1, 0, 1));
        }
    SurfaceMap moved = crease;
    for (SurfacePoint& point : moved.points) {
        point.position.x += 0.25;
        point.position.z = std::max(point.position.x - 20, 0.0);
    }
    const Image flow = flowTo(crease, moved, plantedCamera(0.25, 0));
    for (int x = 1; x < kPlanted.width; ++x) CHECK(counts(flow, x));

    SurfaceMap open = plantedSurfaces(0, 0);
    open.points[12 * kPlanted.width + 7].seen = false;
    CHECK_FALSE(counts(flowTo(open, plantedSurfaces(0, 0), plantedCamera(0, 0)), 7));
    CHECK_FALSE(counts(flowTo(plantedSurfaces(0, 0), open, plantedCamera(0, 0)), 7));
}

TEST_CASE("what a box hid and shows now is uncovered, and what lay off the picture is not")
{
    const Image mask =
        uncoveredSince(plantedSurfaces(3, 0, 20), plantedCamera(3, 0), plantedSurfaces(0, 0, 30));
    for (int x = 0; x < kPlanted.width; ++x) {
        INFO(x);
        CHECK(mask.at(x, 12) == (x >= 20 && x < 30 ? 1.0f : 0.0f));
    }
}
