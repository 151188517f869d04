// SPDX-License-Identifier: MIT
// Which config to take: the most accurate within a time, or the cheapest within an error.
//
// A config must hold up in every scene that was measured, so its worst scene counts, for time and
// error apart.
//
// Only samples that show the same view on one device can be compared with each other. A fresh bench
// is compared with an older one by errors and ratios, never by absolute times.
#pragma once

#include "tools/measure/bench/sample.h"

namespace crevice {

/// Samples with the same ground truth and the same clockwork. Failed samples are in no view.
struct ResultView {
    std::string device;
    std::string scene;
    std::string camera;
    Extent extent;
    double radius = 0;
    std::string clock;                      ///< As BenchSample has it.
    std::vector<std::size_t> samples = {};  ///< Indexes, in the order of the results.
    /// The scene, of a file its name where no other is called so; with its camera where it was seen
    /// from several.
    std::string name = {};
};

/// Sorted by device, scene and camera; of one scene and camera the view with the most samples
/// first.
std::vector<ResultView> benchViews(const std::vector<BenchSample>& samples);

/// One view of each scene and camera on a device: at the extent that most samples share, then the
/// radius that most samples share. Sweeps of size and radius are thus kept out of a choice
/// between configs. An extent that is not 0x0 is the one to take.
std::vector<ResultView> mainViews(const std::vector<ResultView>& views, const std::string& device,
                                  Extent extent = {});

/// The devices in the order of their first samples.
std::vector<std::string> benchDevices(const std::vector<BenchSample>& samples);

/// "room from above", or "room" where the camera has no name.
std::string viewName(const std::string& scene, const std::string& camera);

/// Which of the results are asked about.
struct ChoiceScope {
    std::string device;   ///< Part of a device's name; may stay empty where there is one device.
    std::string scene;    ///< Empty: all scenes.
    Extent extent;        ///< 0x0: the one with the most samples.
    bool motion = false;  ///< Flicker counts as error.
};

/// Of tools/render/camera_path.h, those that what moves slowly and what moves fast.
constexpr const char* kFlickerPaths[] = {"sub-pixel", "pan"};

/// How much occlusion changes from frame to frame, rms over both paths; 0 where that was not
/// measured. With it the error is the root of rmse^2 + flicker^2.
double flickerOf(const MotionFigures& motion);

/// A config with its sample count and overrides, over all scenes of a scope. In each of them it is
/// less wrong than no ambient occlusion at all.
struct Candidate {
    std::string label;       ///< As sampleLabel has it.
    std::size_t sample = 0;  ///< One of its samples, for what is the same in all scenes.
    double ms = 0;           ///< BenchSample::cost: what it adds to a host that has a G-buffer.
    double ratio = 0;        ///< Of that over the cost of learnopengl.
    double error = 0;        ///< rmse, with flicker where the scope asks for it.
    double flicker = 0;      ///< What of the error is flicker.
    std::string slowest_view = {};
    std::string worst_view = {};
    std::string ratio_view = {};  ///< Where the ratio is largest.
};

struct Candidates {
    std::string device;
    std::vector<ResultView> views;
    std::vector<Candidate> list;       ///< In the order of the results.
    std::vector<std::string> elided;   ///< What lacks figures in a view, and where.
    std::vector<std::string> harmful;  ///< Labels of what is no better than no ambient occlusion.
    double error_without_ao = 0;       ///< In the scene where it is largest.
};

/// Everything that can be chosen.
/// Errors: CV8001 for a scope that names no device, scene or size of the results, or for several
/// devices where none was named; CV7009 where no sample has figures.
Result<Candidates> findCandidates(const std::vector<BenchSample>& samples,
                                  const ChoiceScope& scope);

/// The candidates that no other beats: none is as cheap and less wrong, or as right and cheaper. By
/// rising time, hence falling error; of equals the first one. Those without a time are left out.
std::vector<std::size_t> frontOf(const std::vector<Candidate>& list);

/// The one of a front where more time begins to buy little: furthest below the straight line
/// between the ends, with time on a log scale; where none is below, the end with the smaller
/// product of time and error. Requires a front that is not empty.
std::size_t balancedOf(const std::vector<Candidate>& list, const std::vector<std::size_t>& front);

/// What is asked of a choice.
struct ChoiceLimit {
    enum class Kind { time_ms, ratio, error };
    Kind kind = Kind::time_ms;
    double most = 0;
};

/// All of them hold.
using ChoiceLimits = std::vector<ChoiceLimit>;

/// Whether the fastest within the limits is wanted, as with one of error; else the most accurate.
bool wantsLeastTime(const ChoiceLimits& limits);

/// Reads "2ms", "500us", "1s", or "0.5x" for a multiple of the cost of learnopengl. Errors: CV8001.
Result<ChoiceLimit> parseBudget(const std::string& text);

/// What differs by less is as good.
constexpr double kWorth = 0.05;

/// Into Candidates::list.
struct Choice {
    /// The limits, the best first: the fastest, or without a limit of error the fastest of those
    /// whose error is the least but for kWorth.
    std::vector<std::size_t> within;
    std::vector<std::size_t> beyond;  ///< The nearest first.
};

/// Errors: CV4001 when nothing is within the limit; the help names what comes nearest, if anything.
Result<Choice> choose(const Candidates& candidates, const ChoiceLimits& limits);

/// "at most 2 ms and an error of at most 0.05".
std::string limitText(const ChoiceLimits& limits);

/// Largest change of an error that counts as none, where device, driver and version are the same:
/// two runs agree to the last digit on one processor, and another kind rounds otherwise.
constexpr double kSameError = 1e-6;
constexpr double kSameErrorElsewhere = 1e-4;  ///< Where one of them is another.

/// Largest relative change of a ratio. Medians on a busy machine differ by up to 10 %.
constexpr double kSameRatio = 0.15;

/// Something about one sample that is not what it was.
struct BenchChange {
    enum class Kind {
        cheaper,  ///< A cost ratio.
        odd,      ///< An error that is less: a fault may happen to lower one, so it needs a look.
        worse,
        failed,   ///< Had figures.
        missing,  ///< Had figures, and is not measured now.
    };
    Kind kind = Kind::worse;
    std::string sample;       ///< Its title.
    std::string figure = {};  ///< "rmse"; why it failed.
    double before = 0;
    double now = 0;
};

struct BenchComparison {
    std::vector<BenchChange> changes;
    int compared = 0;        ///< Samples in both.
    int without_ratios = 0;  ///< Of those, measured on another device or by another clock.

    /// All but what is cheaper.
    bool differs() const;
};

/// Samples are the same where questionOf() is, whatever became of their shaders or is switched off;
/// one from the same device goes before one from another. Errors are compared always, cost ratios
/// on one device and by one clock alone, and not with `errors_only`.
BenchComparison compareBenches(const std::vector<BenchSample>& before,
                               const std::vector<BenchSample>& now, bool errors_only = false);

}  // namespace crevice
