// SPDX-License-Identifier: MIT
// Regression guard: whether a fresh bench has the errors of an older one, and costs no more by
// ratios, never by absolute times.
#pragma once

#include "tools/measure/bench/sample.h"

namespace crevice {

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
