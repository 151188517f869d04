// SPDX-License-Identifier: MIT
#include "tools/measure/reference/sparse_truth.h"

#include "tools/measure/reference/pixel_tracer.h"

#include <cmath>
#include <optional>

namespace crevice {
namespace {

constexpr int kBlock = 512;  // places tried at once

// The k-th of a sequence that fills the picture evenly however long it is: multiples of powers of
// the plastic number's inverse [Roberts 2018].
glm::ivec2 placeOf(std::size_t k, Extent extent)
{
    constexpr double kAlong = 0.7548776662466927, kUp = 0.5698402909980532;
    const auto part = [k](double step) { return std::fmod(0.5 + step * double(k), 1.0); };
    return {static_cast<int>(part(kAlong) * extent.width),
            static_cast<int>(part(kUp) * extent.height)};
}

struct Mean {
    double mean = 0;
    double deviation = 0;  // of the mean
};

template <class Value>
Mean meanOf(std::size_t count, Value&& value)
{
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += value(i);
        squares += value(i) * value(i);
    }
    const double n = static_cast<double>(count), mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / n)};
}

}  // namespace

Result<SparseTruth> SparseTruth::begin(const RayScene& scene, const Camera& camera, Extent extent,
                                       const TraceOptions& options)
{
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    return SparseTruth(PixelTracer(scene, camera, extent, options, 1));
}

Status SparseTruth::grow(std::size_t pixels)
{
    const Extent extent = tracer_.extent();
    const std::size_t all = std::size_t(extent.width) * extent.height;
    std::vector<std::optional<float>> block(kBlock);
    while (pixels_.size() < pixels && tried_ < all) {
        onProcessors(0, kBlock, [&](int i) {
            const glm::ivec2 place = placeOf(tried_ + i, extent);
            ProbedPoint point;
            block[i].reset();
            if (!tracer_.probed(place.x, place.y, point)) return;
            const ProbeCount count = tracer_.countOpen(point, place.x, place.y, 0);
            block[i] = count.over > 0 ? float(count.open) / float(count.over) : 1.0f;
        });
        for (int i = 0; i < kBlock; ++i, ++tried_) {
            const glm::ivec2 place = placeOf(tried_, extent);
            if (block[i]) pixels_.push_back({place.x, place.y, *block[i]});
        }
    }
    if (!pixels_.empty()) return {};
    return nothingSeen();
}

Result<SparseError> sparseError(const Image& picture, const SparseTruth& truth)
{
    const std::vector<TruePixel>& pixels = truth.pixels();
    SparseError error;
    double white = 0, dark = 0;
    for (const TruePixel& pixel : pixels) {
        const float off = picture.at(pixel.x, pixel.y) - pixel.visibility;
        if (!std::isfinite(off))
            return Diagnostic{Code::not_finite, "the occlusion is not a number at pixel " +
                                                    std::to_string(pixel.x) + ", " +
                                                    std::to_string(pixel.y)};
        error.squares.push_back(off * off);
        error.bias += off;
        if (off < 0.0f) dark += off * off;
        white += (1.0 - pixel.visibility) * (1.0 - pixel.visibility);
    }
    const std::size_t count = pixels.size();
    const Mean square = meanOf(count, [&](std::size_t i) { return double(error.squares[i]); });
    error.rmse = std::sqrt(square.mean);
    error.margin = error.rmse > 0 ? kConfidence * square.deviation / (2 * error.rmse) : 0.0;
    error.bias /= static_cast<double>(count);
    error.without_ao = std::sqrt(white / static_cast<double>(count));
    error.dark = square.mean > 0 ? dark / (square.mean * static_cast<double>(count)) : 0.0;
    std::vector<float> sorted = error.squares;
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * double(count - 1));
    std::nth_element(sorted.begin(), place, sorted.end());
    error.p99 = std::sqrt(*place);
    return error;
}

double deviationsBelow(const SparseError& less, const SparseError& more, double share)
{
    const std::size_t count = std::min(less.squares.size(), more.squares.size());
    const Mean gap = meanOf(count, [&](std::size_t i) {
        return share * share * double(more.squares[i]) - double(less.squares[i]);
    });
    return gap.deviation > 0 ? gap.mean / gap.deviation : 0.0;
}

}  // namespace crevice
