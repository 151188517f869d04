// SPDX-License-Identifier: MIT
// Compares two benches sample by sample.
#include "tools/measure/bench/choice.h"

#include "core/base/text.h"

#include <cmath>

namespace crevice {
namespace {

using Kind = BenchChange::Kind;

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

class Comparer {
public:
    explicit Comparer(bool errors_only) : errors_only_(errors_only) {}

    void compare(const BenchSample& before, const BenchSample& now)
    {
        sample_ = sampleTitle(before);
        if (!now.failure.empty()) {
            result.changes.push_back({Kind::failed, sample_, now.failure});
            return;
        }
        ++result.compared;
        const bool same_device = before.device == now.device;
        same_error_ =
            same_device && before.version == now.version ? kSameError : kSameErrorElsewhere;
        compareError("rmse", before.error.rmse, now.error.rmse);
        compareError("rmse_fit", before.error.rmse_fit, now.error.rmse_fit);
        compareError("bias", before.error.bias, now.error.bias);
        for (const auto& [path, figures] : before.motion.paths) {
            const auto same = now.motion.paths.find(path);
            if (same == now.motion.paths.end()) continue;
            compareError("motion " + path, figures.rms, same->second.rms);
            compareError("motion " + path + " rmse", figures.rmse, same->second.rmse);
        }
        if (errors_only_) return;
        if (!same_device || before.clock != now.clock) {
            ++result.without_ratios;
            return;
        }
        compareRatio("ratio_learnopengl", before.ratio_learnopengl, now.ratio_learnopengl);
    }

    BenchComparison result;

private:
    void compareError(const std::string& figure, double before, double now)
    {
        if (std::abs(now - before) <= same_error_) return;
        const Kind kind = std::abs(now) < std::abs(before) ? Kind::odd : Kind::worse;
        result.changes.push_back({kind, sample_, figure, before, now});
    }

    void compareRatio(const char* figure, double before, double now)
    {
        if (!(before > 0.0) || !(now > 0.0)) return;  // one of the runs had nothing to divide by
        const double most = 1.0 + kSameRatio;
        if (now > before * most)
            result.changes.push_back({Kind::worse, sample_, figure, before, now});
        else if (now * most < before)
            result.changes.push_back({Kind::cheaper, sample_, figure, before, now});
    }

    bool errors_only_;
    double same_error_ = 0;
    std::string sample_;
};

}  // namespace

bool BenchComparison::differs() const
{
    return anyOf(changes, [](const BenchChange& change) {
        return change.kind != BenchChange::Kind::cheaper;
    });
}

BenchComparison compareBenches(const std::vector<BenchSample>& before,
                               const std::vector<BenchSample>& now, bool errors_only)
{
    Comparer comparer(errors_only);
    for (const BenchSample& sample : before) {
        if (!sample.failure.empty()) continue;
        if (const BenchSample* same = findSame(now, sample))
            comparer.compare(sample, *same);
        else
            comparer.result.changes.push_back({Kind::missing, sampleTitle(sample)});
    }
    return std::move(comparer.result);
}

}  // namespace crevice
