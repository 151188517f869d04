// SPDX-License-Identifier: MIT
// Stress cases of what was drawn in the frames before.
#include "tools/measure/stress/cases/all.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice {
namespace {

constexpr int kFrames = 16;

/// After a cut that nobody told as many of what is seen then: their mean has half of the noise of
/// one, and wrong history would still have three quarters of the weight.
constexpr int kFramesAfterCut = 4;

/// Takes the test scene's ball, at (0.3, 0.59, -1.1), to a unit before the camera: it hides all.
constexpr glm::dvec3 kBeforeCamera = {-0.3, 0.41, 5.1};

StressShot framesShot(Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    shot.radius = 0.5;
    shot.block_px = noiseBlock(size);
    return shot;
}

/// From where the wall covers nearly all that is seen otherwise.
Camera elsewhere(Extent size)
{
    StressView view = testView();
    view.eye = {-1, 3, 0};
    return cameraOf(view, size);
}

/// Part 0 to 1 of a pixel: base 2 and base 3 [Halton 1964].
glm::dvec2 jitterOf(int frame)
{
    glm::dvec2 at(0.0);
    for (int axis = 0; axis < 2; ++axis) {
        const int base = 2 + axis;
        double digit = 1.0 / base;
        for (int rest = frame + 1; rest > 0; rest /= base, digit /= base)
            at[axis] += (rest % base) * digit;
    }
    return at;
}

/// How the camera stood, or what was moved, `left` frames before the last.
StressFrame frameBefore(int kind, int left, const StressShot& shot)
{
    StressFrame frame;
    frame.camera = shot.camera;
    glm::dmat4& view = frame.camera.view_from_world;
    glm::mat4& clip = frame.camera.clip_from_view;
    const double pixel = 2.0 / shot.extent.height / clip[1][1];  // at distance 1
    switch (kind) {
    case 1: frame.camera = elsewhere(shot.extent); break;
    case 2:
        for (int axis = 0; axis < 2; ++axis)
            clip[2][axis] +=
                static_cast<float>((jitterOf(left)[axis] - 0.5) * 2.0 /
                                   (axis == 0 ? shot.extent.width : shot.extent.height));
        break;
    case 3: view = glm::rotate(glm::dmat4(1.0), 5 * pixel * left, {0, 1, 0}) * view; break;
    case 4: view = glm::translate(view, glm::dvec3(0.05, 0, 0) * double(left)); break;
    case 5:
        for (int axis = 0; axis < 2; ++axis)
            clip[axis][axis] *= static_cast<float>(1 - 0.01 * left);
        break;
    case 6: frame.origin = {1000, 0, 0}; break;
    case 7: frame.moved = glm::dvec3(0.1, 0, 0.05) * double(left); break;
    case 8: frame.moved = kBeforeCamera; break;
    default: break;
    }
    return frame;
}

StressShot afterFrames(double value, Extent size)
{
    const int kind = static_cast<int>(value);
    StressShot shot = framesShot(size);
    const bool at_once = kind == 1 || kind == 6 || kind == 8;
    for (int left = kFrames; left > 0; --left)
        shot.before.push_back(
            frameBefore(at_once && left < kFramesAfterCut ? 0 : kind, left, shot));
    return shot;
}

/// The ordinary step is the first frame of all. Sixteen frames are whole cycles of the noise
/// (effects/common/noise_cycle.glsl), so the frame after them has the noise of that one.
StressShot afterCut(double kind, Extent size)
{
    StressShot shot = framesShot(size);
    shot.block_px = 1;
    shot.cut = true;
    for (int left = kFrames; left > 0 && kind > 0; --left) {
        shot.before.push_back(frameBefore(kind == 2 ? 1 : 0, left, shot));
        if (kind == 3) shot.before.back().moved = {0, 0, 2};
    }
    return shot;
}

StressShot stillFrames(double frames, Extent size)
{
    StressShot shot = framesShot(size);
    StressFrame same;
    same.camera = shot.camera;
    same.times = static_cast<int>(frames) - 1;
    shot.before = {same};
    return shot;
}

}  // namespace

std::vector<StressCase> frameCases()
{
    using E = Expectation;
    return {
        {"history",
         "The test scene after sixteen frames of something else: means over blocks, since noise "
         "differs from frame to frame.",
         "",
         kinds({"the same", "a cut that nobody told", "jitter", "a pan", "a walk", "a zoom",
                "another origin", "an object moved", "an object before the camera"}),
         0, E::same, afterFrames, "after frames with {}"},
        {"cut", "The first frame after a cut that is told is that of a fresh start.", "",
         kinds({"nothing", "the same", "another place", "an object elsewhere"}), 0, E::same,
         afterCut, "after a cut from {}"},
        {"still", "A camera that stands still: a history must settle.", "frames", steps({32, 64}),
         0, E::settles, stillFrames, "in front of a still camera after {} frames", "",
         kRestlessShare},
    };
}

}  // namespace crevice
