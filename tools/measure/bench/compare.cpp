// SPDX-License-Identifier: MIT
// Compares two benches sample by sample.
#include "tools/measure/bench/compare.h"

#include "tools/measure/bench/views.h"

#include <cmath>

namespace crevice {
namespace {

/// The same sample in other results, best from the same device and with the same switched off; null
/// when there is none.
const BenchSample* findSame(const std::vector<BenchSample>& samples, const BenchSample& wanted)
{
    const std::string question = questionOf(wanted);
    const BenchSample* found = nullptr;
    int best = -1;
    for (const BenchSample& sample : samples) {
        const int likeness =
            2 * (sample.device == wanted.device) + (sample.disable == wanted.disable);
        if (likeness <= best || questionOf(sample) != question) continue;
        found = &sample;
        best = likeness;
    }
    return found;
}

std::string nameOf(const BenchSample& sample)
{
    return sampleLabel(sample) + ", " + viewName(sample.scene, sample.camera) + ", " +
           extentName(sample.extent);
}

class Comparer {
public:
    explicit Comparer(const BenchLimits& limits) : limits_(limits) {}

    void compare(const BenchSample& before, const BenchSample& now)
    {
        sample_ = nameOf(before);
        if (!now.failure.empty()) {
            result.failed.push_back(sample_ + ": " + now.failure);
            return;
        }
        ++result.compared;
        const bool same_device = before.device == now.device;
        most_error_ =
            same_device && before.version == now.version ? limits_.error : limits_.other_error;
        compareError("rmse", before.error.rmse, now.error.rmse);
        compareError("rmse_fit", before.error.rmse_fit, now.error.rmse_fit);
        compareBias(before.error.bias, now.error.bias);
        compareMotion(before.motion, now.motion);
        if (limits_.errors_only) return;
        if (!same_device || before.clock != now.clock) {
            ++result.without_ratios;
            return;
        }
        compareRatio("ratio_copy", before.ratio_copy, now.ratio_copy);
        compareRatio("ratio_learnopengl", before.ratio_learnopengl, now.ratio_learnopengl);
    }

    BenchComparison result;

private:
    void compareError(const std::string& figure, double before, double now)
    {
        if (now > before + most_error_)
            result.worse.push_back({sample_, figure, before, now, before + most_error_});
        else if (now < before - most_error_)
            result.better_errors.push_back({sample_, figure, before, now, before - most_error_});
    }

    /// Where both were measured.
    void compareMotion(const MotionFigures& before, const MotionFigures& now)
    {
        for (const auto& [path, figures] : before.paths) {
            const auto same = now.paths.find(path);
            if (same == now.paths.end()) continue;
            compareError("motion " + path, figures.rms, same->second.rms);
            compareError("motion " + path + " rmse", figures.rmse, same->second.rmse);
        }
    }

    /// Of the other sign it is another one, however small.
    void compareBias(double before, double now)
    {
        if (std::abs(now - before) <= most_error_) return;
        const double limit = before + (now > before ? most_error_ : -most_error_);
        auto& changes = std::abs(now) < std::abs(before) ? result.better_errors : result.worse;
        changes.push_back({sample_, "bias", before, now, limit});
    }

    void compareRatio(const char* figure, double before, double now)
    {
        if (!(before > 0.0) || !(now > 0.0)) return;  // one of the runs had nothing to divide by
        const double most = 1.0 + limits_.ratio;
        if (now > before * most)
            result.worse.push_back({sample_, figure, before, now, before * most});
        else if (now * most < before)
            result.better.push_back({sample_, figure, before, now, before * most});
    }

    BenchLimits limits_;
    double most_error_ = 0;
    std::string sample_;
};

}  // namespace

BenchComparison compareBenches(const std::vector<BenchSample>& before,
                               const std::vector<BenchSample>& now, const BenchLimits& limits)
{
    Comparer comparer(limits);
    for (const BenchSample& sample : before) {
        if (!sample.failure.empty()) continue;
        if (const BenchSample* same = findSame(now, sample))
            comparer.compare(sample, *same);
        else
            comparer.result.missing.push_back(nameOf(sample));
    }
    return std::move(comparer.result);
}

}  // namespace crevice
