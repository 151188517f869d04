// SPDX-License-Identifier: MIT
#include "tools/measure/motion/figures.h"

#include "tools/measure/motion/flow.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

/// Half a step of 8 bits: less is no change in a picture.
constexpr float kStillChange = 0.5f / 255.0f;

class Squares {
public:
    void add(double value)
    {
        sum_ += value * value;
        ++count_;
    }
    double rms() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0.0; }
    long long count() const { return count_; }

private:
    double sum_ = 0;
    long long count_ = 0;
};

/// By the nearest rank; reorders the values.
double percentile(std::vector<float>& values, double share)
{
    if (values.empty()) return 0.0;
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto place = values.begin() + std::max(static_cast<std::ptrdiff_t>(rank) - 1,
                                                 static_cast<std::ptrdiff_t>(0));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void addErrors(const Image& frame, const Image& truth, const Image* mask, Squares& errors)
{
    for (int y = 0; y < truth.extent.height; ++y)
        for (int x = 0; x < truth.extent.width; ++x)
            if (std::isfinite(truth.at(x, y)) && (!mask || mask->at(x, y) > 0.0f))
                errors.add(static_cast<double>(frame.at(x, y)) - truth.at(x, y));
}

}  // namespace

ChangeFigures changeFigures(const std::vector<Image>& frames, const PathTruth& truth)
{
    Squares beyond, own, errors;
    std::vector<float> sizes;
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        const Image changes = changeAlong(truth.flows[i], frames[i], frames[i + 1]);
        const Image owns = changeAlong(truth.flows[i], truth.frames[i], truth.frames[i + 1]);
        for (std::size_t k = 0; k < changes.pixels.size(); ++k) {
            if (std::isnan(owns.pixels[k])) continue;
            const float change = changes.pixels[k] - owns.pixels[k];
            own.add(owns.pixels[k]);
            beyond.add(change);
            sizes.push_back(std::abs(change));
        }
    }
    for (std::size_t i = 0; i < frames.size(); ++i)
        addErrors(frames[i], truth.frames[i], nullptr, errors);
    return {beyond.rms(), percentile(sizes, 0.99), percentile(sizes, 0.999), own.rms(),
            errors.rms(), beyond.count()};
}

double errorOver(const Image& frame, const Image& truth, const Image* mask)
{
    Squares errors;
    addErrors(frame, truth, mask, errors);
    return errors.rms();
}

void Settling::add(const Image& frame)
{
    ++count_;
    bool changed = count_ == 1;
    for (std::size_t k = 0; k < last_.pixels.size() && !changed; ++k)
        changed = !(std::abs(frame.pixels[k] - last_.pixels[k]) <= kStillChange);
    if (changed) changed_ = count_;
    last_ = frame;
}

}  // namespace crevice
