// SPDX-License-Identifier: MIT
// What a step of a stress case showed, and what follows from that: pure figures, no GL.
#pragma once

#include "tools/measure/stress/case.h"

#include <crevice/compile.h>

namespace crevice {

/// One step of one series, as one line of stress.jsonl.
struct StressRecord {
    std::string config;  ///< "learnopengl sound": with its variant.
    std::string case_name;
    int step = 0;  ///< Into StressCase::steps.
    std::string device;
    std::string version;

    std::string refusal;  ///< The error that came instead of a first frame.
    std::string absent;   ///< What the config lacks for this step; then there are no figures.

    /// The first, by passes, that holds what is not finite or out of range, drawn in 32-bit floats.
    std::string bad_target;
    std::string bad_pass;
    long long bad_pixels = 0;    ///< Not finite.
    long long out_of_range = 0;  ///< Past what the format holds; of occlusion outside [0, 1].
    int bad_x = 0, bad_y = 0;    ///< The uppermost, from the upper left.
    double bad_value = 0;        ///< There, where it is finite.
    double background = 1;       ///< Least, where the ground truth has no surface.
    double mean = 0;             ///< Of the occlusion's finite pixels, as are the next two.
    double least = 0;
    double most = 0;

    std::string stored;  ///< The format that the surface is read from.
    /// That format's step over the radius, at what is seen in the middle.
    double step_share = 0;
    double resolved = 1;   ///< Share of the surface where that is at most a tenth.
    long long judged = 0;  ///< Pixels of the middle that show it so.
    double judged_mean = 0;
    double judged_least = 0;
    double judged_below = 0;  ///< Share of them below 0.95.
    /// Mean against the ordinary picture; of what must settle, the share of pixels that the next
    /// frame changes.
    double change = 0;

    /// Mean occlusion of the exact answer, and of the picture over the same pixels. That is the
    /// ray-traced ground truth or, of what must be the same, the ordinary picture. -1: not known.
    double exact = -1;
    double occlusion = -1;
    double rmse = -1;        ///< Against the ground truth; -1: not traced.
    double rmse_white = -1;  ///< That of a white picture.

    /// The first whose occlusion departs from the exact answer as the picture does.
    std::string departing_pass;

    double radius_px = 0;  ///< On screen, in the middle.
    int height_px = 0;     ///< Of the picture.
    std::string picture;   ///< Of a failure, relative to the file.
};

enum class Outcome {
    holds,
    breaks,
    /// Sound, but more than the format can resolve; `why` says what came of it.
    beyond,
    refused,  ///< Reported before the first frame.
    absent,   ///< The config has no part of it.
    /// The ordinary picture is not ambient occlusion as the ground truth has it, so that what
    /// follows from it says nothing. A failure.
    invalid,
};

/// "holds", "breaks", ... "void" of what is not valid.
std::string wordOf(Outcome outcome);

struct Verdict {
    Outcome outcome = Outcome::holds;
    std::string why;
    /// Of a failure: what becomes of the occlusion, as a sentence about it goes on: "is lost".
    std::string effect = {};
    std::string pass = {};  ///< The first in which a failure shows, where that is known.

    /// Why, "first in pass 'ssao'".
    std::string reason() const;
};

/// Judges one step. `series` are the case's records of one config by step, with null for
/// those that are missing; that of `step` must be there.
Verdict judge(const StressCase& stress, const std::vector<const StressRecord*>& series,
              std::size_t step);

/// How far a series holds on one side of its ordinary step.
struct Reach {
    int holds_to = -1;   ///< The last step of that side that holds; -1: not even the ordinary one.
    int breaks_at = -1;  ///< The first one that fails; -1: none does.
    std::string why;
};

struct Breakdown {
    Reach down, up;  ///< Towards the first and the last step; both begin at the ordinary one.
    int failures = 0;
    int refused = 0;
    bool absent = false;     ///< There is no figure at all.
    std::string why_absent;  ///< Of the first step.
    std::string invalid;     ///< Why the ordinary picture, and with it the case, is not valid.
    std::string beyond;      ///< "beyond depth16 at 1e-3:3e5: 90 % of the occlusion lost"
};

Breakdown findBreakdown(const StressCase& stress, const std::vector<const StressRecord*>& series);

/// "holds from 1e-6 to 1e6", "holds to 0.1:316, breaks at 0.01:1e4: the mean is 0.93".
std::string describe(const StressCase& stress, const Breakdown& breakdown);

// --- figures.cpp: what a picture shows, in figures; the passes that a config's occlusion goes
// through, and which of them a failure begins with ---

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
