// SPDX-License-Identifier: MIT
#include "tools/render/image/image_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

constexpr double kLeastPower = 0.1;
constexpr double kMostPower = 10.0;
constexpr double kPowerTolerance = 1e-4;  // of log(power): far below what an eye or a report shows

// Values that count, side by side.
struct Pairs {
    std::vector<float> test;
    std::vector<float> ground_truth;
};

std::string sizeName(const Image& image)
{
    return std::to_string(image.extent.width) + "x" + std::to_string(image.extent.height);
}

Status checkSizes(const Image& test, const Image& ground_truth, const Image* mask)
{
    if (test.pixels.empty() || ground_truth.pixels.empty() || (mask && mask->pixels.empty()))
        return Diagnostic{Code::image_broken, "an image to compare has no pixels"};
    const Image* odd = test.extent != ground_truth.extent            ? &test
                       : mask && mask->extent != ground_truth.extent ? mask
                                                                     : nullptr;
    if (!odd) return {};
    return Diagnostic{Code::image_size,
                      (odd == mask ? "the mask and the images" : "the images") +
                          (" differ in size: " + sizeName(*odd)) + " and " + sizeName(ground_truth),
                      "render both at the same --size"};
}

// By colour, so that alpha does not make black count.
bool admits(const Image& mask, int x, int y)
{
    const int colors = mask.channels == 2 ? 1 : std::min(mask.channels, 3);
    for (int channel = 0; channel < colors; ++channel)
        if (mask.at(x, y, channel) > 0.0f) return true;
    return false;
}

bool finitePixel(const Image& image, int x, int y, int channels)
{
    for (int channel = 0; channel < channels; ++channel)
        if (!std::isfinite(image.at(x, y, channel))) return false;
    return true;
}

bool masked(const Image& ground_truth, const Image* mask, int x, int y, int channels)
{
    return (mask && !admits(*mask, x, y)) || !finitePixel(ground_truth, x, y, channels);
}

Pairs collectPairs(const Image& test, const Image& ground_truth, const Image* mask,
                   ImageDifference& figures)
{
    Pairs pairs;
    const int channels = std::min(test.channels, ground_truth.channels);
    for (int y = 0; y < ground_truth.extent.height; ++y) {
        for (int x = 0; x < ground_truth.extent.width; ++x) {
            if (masked(ground_truth, mask, x, y, channels))
                ++figures.masked;
            else if (!finitePixel(test, x, y, channels))
                ++figures.non_finite;
            else {
                ++figures.pixels;
                for (int channel = 0; channel < channels; ++channel) {
                    pairs.test.push_back(test.at(x, y, channel));
                    pairs.ground_truth.push_back(ground_truth.at(x, y, channel));
                }
            }
        }
    }
    return pairs;
}

double rmseOfPower(const Pairs& pairs, double power)
{
    double sum = 0;
    for (std::size_t k = 0; k < pairs.test.size(); ++k) {
        const double error = std::pow(std::max(pairs.test[k], 0.0f), power) - pairs.ground_truth[k];
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(pairs.test.size()));
}

// Golden-section search over log(power), in which contrast is even.
void fitPower(const Pairs& pairs, ImageDifference& figures)
{
    const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
    double low = std::log(kLeastPower), high = std::log(kMostPower);
    double left = high - ratio * (high - low), right = low + ratio * (high - low);
    double at_left = rmseOfPower(pairs, std::exp(left));
    double at_right = rmseOfPower(pairs, std::exp(right));
    while (high - low > kPowerTolerance) {
        const bool keep_left = at_left < at_right;
        (keep_left ? high : low) = keep_left ? right : left;
        (keep_left ? right : left) = keep_left ? left : right;
        (keep_left ? at_right : at_left) = keep_left ? at_left : at_right;
        double& fresh = keep_left ? left : right;
        fresh = keep_left ? high - ratio * (high - low) : low + ratio * (high - low);
        (keep_left ? at_left : at_right) = rmseOfPower(pairs, std::exp(fresh));
    }
    figures.power_fit = std::exp((low + high) / 2);
    figures.rmse_fit = rmseOfPower(pairs, figures.power_fit);
    const double unfitted = rmseOfPower(pairs, 1.0);
    if (unfitted > figures.rmse_fit) return;
    figures.power_fit = 1.0;  // a constant image, or one that no power betters
    figures.rmse_fit = unfitted;
}

void addErrors(const Pairs& pairs, double threshold, ImageDifference& figures)
{
    const std::size_t count = pairs.test.size();
    std::vector<double> errors(count);
    double sum = 0, squares = 0;
    std::size_t bad = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double error = static_cast<double>(pairs.test[k]) - pairs.ground_truth[k];
        sum += error;
        squares += error * error;
        errors[k] = std::abs(error);
        bad += errors[k] > threshold;
    }
    figures.rmse = std::sqrt(squares / static_cast<double>(count));
    figures.bias = sum / static_cast<double>(count);
    figures.bad_fraction = static_cast<double>(bad) / static_cast<double>(count);
    figures.psnr_db = figures.rmse > 0 ? -20.0 * std::log10(figures.rmse)
                                       : std::numeric_limits<double>::infinity();
    figures.max = *std::max_element(errors.begin(), errors.end());
    const std::size_t rank = (count * 99 + 99) / 100 - 1;  // the nearest-rank percentile
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    figures.p99 = errors[rank];
}

double patternOf(const Image& test, const Image& ground_truth, const Image* mask)
{
    const int width = ground_truth.extent.width, height = ground_truth.extent.height;
    // Of all pixels above and to the left: errors, and pixels that count.
    const std::size_t row = width + 1;
    std::vector<double> errors(row * (height + 1)), counts(errors);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool counts_here =
                !masked(ground_truth, mask, x, y, 1) && finitePixel(test, x, y, 1);
            const auto add = [&](std::vector<double>& sums, double value) {
                const std::size_t at = (y + 1) * row + x + 1;
                sums[at] = value + sums[at - 1] + sums[at - row] - sums[at - row - 1];
            };
            add(errors, counts_here ? double{test.at(x, y)} - ground_truth.at(x, y) : 0.0);
            add(counts, counts_here);
        }
    }
    const auto sum = [&](const std::vector<double>& sums, int x, int y, int reach) {
        const std::size_t left = std::max(x - reach, 0), right = std::min(x + reach + 1, width);
        const std::size_t low = std::max(y - reach, 0), high = std::min(y + reach + 1, height);
        return sums[high * row + right] - sums[high * row + left] - sums[low * row + right] +
               sums[low * row + left];
    };
    double squares = 0, pixels = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (sum(counts, x, y, 0) < 0.5) continue;
            const double off = sum(errors, x, y, 1) / sum(counts, x, y, 1) -
                               sum(errors, x, y, 4) / sum(counts, x, y, 4);
            squares += off * off;
            pixels += 1;
        }
    }
    return pixels > 0 ? std::sqrt(squares / pixels) : 0.0;
}

void setPixel(Image& image, int x, int y, float red, float green, float blue)
{
    image.at(x, y, 0) = red;
    image.at(x, y, 1) = green;
    image.at(x, y, 2) = blue;
}

}  // namespace

Result<ImageDifference> compareImages(const Image& test, const Image& ground_truth,
                                      const Image* mask, double threshold, bool fit)
{
    if (const Status status = checkSizes(test, ground_truth, mask); !status)
        return status.diagnostics();
    ImageDifference figures;
    const Pairs pairs = collectPairs(test, ground_truth, mask, figures);
    if (pairs.test.empty()) return figures;
    addErrors(pairs, threshold, figures);
    if (!fit) return figures;
    figures.pattern = patternOf(test, ground_truth, mask);
    fitPower(pairs, figures);
    return figures;
}

Result<Image> differencePicture(const Image& test, const Image& ground_truth, const Image* mask,
                                double range)
{
    if (const Status status = checkSizes(test, ground_truth, mask); !status)
        return status.diagnostics();
    Image picture(ground_truth.extent, 3, 0.5f);
    for (int y = 0; y < ground_truth.extent.height; ++y) {
        for (int x = 0; x < ground_truth.extent.width; ++x) {
            if (masked(ground_truth, mask, x, y, 1)) continue;
            if (!finitePixel(test, x, y, 1)) {
                setPixel(picture, x, y, 1, 0, 1);
                continue;
            }
            const double error = static_cast<double>(test.at(x, y)) - ground_truth.at(x, y);
            const float fade = static_cast<float>(1.0 - std::min(std::abs(error) / range, 1.0));
            if (error > 0)
                setPixel(picture, x, y, 1, fade, fade);
            else
                setPixel(picture, x, y, fade, fade, 1);
        }
    }
    return picture;
}

Image withChannels(const Image& image, int channels)
{
    Image to(image.extent, channels, 1.0f);
    for (std::size_t k = 0; k < to.pixels.size() / channels; ++k)
        std::copy_n(&image.pixels[k * image.channels], std::min(image.channels, channels),
                    &to.pixels[k * channels]);
    return to;
}

}  // namespace crevice
