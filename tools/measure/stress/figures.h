// SPDX-License-Identifier: MIT
// What a picture of a stress case shows, in figures; the passes that a config's occlusion goes
// through, and which of them a failure begins with.
#pragma once

#include "tools/measure/stress/record.h"

#include <crevice/compile.h>

namespace crevice {

/// The step of a format at a distance, in scene units: of depth formats, for the camera's near and
/// far distance; of half and single float, as a position.
double formatStep(Format format, double distance, const StressShot& shot);

/// Mean, least and most of the finite pixels; adds those outside [0, 1] to what is out of range.
void describeOcclusion(const Image& ao, StressRecord& record);

/// What the format makes of the surface, and the pixels of the middle where that is fine enough.
void describeSurface(const Image& ao, const StressShot& shot, Format format, StressRecord& record);

/// Over what both pictures show.
struct PictureChange {
    /// The mean absolute change; where it is not a number in one picture, 1. Where pixels are
    /// spoiled, the largest change farther away.
    double change = 1;
    double ordinary = 0;  ///< Mean of the ordinary picture.
    double mean = 0;      ///< Of the other.
};
PictureChange changeBetween(const Image& ordinary, const Image& image, const StressShot& shot);

/// Mean distance of a colour, as linear light, from that without occlusion times the occlusion.
double errorOfLight(const Image& without, const Image& color, const Image& ao);

/// Share of the pixels that differ by more than `limit`.
double shareChanged(const Image& before, const Image& after, double limit);

/// Error, occlusion and background against the ground truth, over the pixels that it has.
void describeError(const Image& ao, const Image& ground_truth, StressRecord& record);

/// Of the shot's radius, at what is seen in the middle.
double radiusInPixels(const StressShot& shot);

/// What a pass wrote of the occlusion, in 32-bit floats.
struct PassPicture {
    std::string pass;
    std::string target;
    Image occlusion = {};
};

/// From the estimator to the last filter: the writer of the output, and of what it says that it
/// keeps (`preserves_constant`), and so on. Without pictures.
std::vector<PassPicture> occlusionPasses(const Plan& plan, const Description& description,
                                         const std::string& output);

/// The first pass whose picture departs from the exact answer at least half as far as that which
/// `record` is about, and past the limits of the case; empty where none does, or what is expected
/// is not an amount. Of colours the last one, since no exact answer has those. `ordinary` are those
/// of the ordinary step.
std::string departingPass(const StressCase& stress, const StressShot& shot,
                          const std::vector<PassPicture>& passes,
                          const std::vector<PassPicture>& ordinary, const StressRecord& record);

}  // namespace crevice
