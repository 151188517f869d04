// SPDX-License-Identifier: MIT
// Regression guard: whether a fresh bench has the errors of an older one, and costs no more by
// ratios, never by absolute times.
#pragma once

#include "tools/measure/bench/sample.h"

#include <string>
#include <vector>

namespace crevice {

/// How much more still counts as the same; of errors, how much less too.
struct BenchLimits {
    /// Of an error, where device, driver and version are the same: two runs agree to the last digit
    /// on one processor, and another kind rounds otherwise.
    double error = 1e-6;
    double other_error = 1e-4;  ///< Of an error, where one of them is another.
    double ratio = 0.15;  ///< Relative. Ratios of medians on a busy machine differ by up to 10 %.
    bool errors_only = false;  ///< Compares no ratios: for machines that are never quiet.
};

/// One figure of one sample that is not what it was.
struct BenchChange {
    std::string sample;  ///< "learnopengl samples=16, room, 960x540".
    std::string figure;  ///< "rmse"
    double before = 0;
    double now = 0;
    double limit = 0;  ///< What `now` may be to count as the same: at most, of an error that is
                       ///< less now at least.
};

struct BenchComparison {
    std::vector<BenchChange> worse;
    std::vector<BenchChange> better;  ///< Cost ratios.
    /// A fault may happen to lower an error: like a worse figure, to be looked at and then updated.
    std::vector<BenchChange> better_errors;
    std::vector<std::string> failed;   ///< Had figures, and now fail: sample and reason.
    std::vector<std::string> missing;  ///< Had figures, and are not measured now.
    int compared = 0;                  ///< Samples in both.
    int without_ratios = 0;  ///< Of those, measured on another device or by another clock.

    bool differs() const
    {
        return !worse.empty() || !better_errors.empty() || !failed.empty() || !missing.empty();
    }
};

/// Samples are the same where questionOf() is, whatever became of their shaders or is switched off;
/// one from the same device goes before one from another. Errors are compared always, cost ratios
/// on one device and by one clock alone.
BenchComparison compareBenches(const std::vector<BenchSample>& before,
                               const std::vector<BenchSample>& now, const BenchLimits& limits = {});

}  // namespace crevice
