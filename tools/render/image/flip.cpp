// SPDX-License-Identifier: MIT
// [Andersson et al. 2020], section by section: 4.1 colours as the eye filters them, 4.2 edges and
// points, 4.3 both in one.
#include "tools/render/image/image_metrics.h"

#include "tools/render/image/srgb.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr double kPi = 3.14159265358979323846;

// sRGB's primaries under D65, by columns.
const glm::dmat3 kXyzFromRgb = {{10135552. / 24577794, 2613072. / 12288897, 1425312. / 73733382},
                                {8788810. / 24577794, 8788810. / 12288897, 8788810. / 73733382},
                                {4435075. / 24577794, 887015. / 12288897, 70074185. / 73733382}};
const glm::dvec3 kWhite = kXyzFromRgb * glm::dvec3(1);

/// Three values a pixel, a row after the other.
struct Planes {
    Extent extent;
    std::vector<glm::dvec3> pixels;

    /// Beyond the border lies its nearest pixel.
    const glm::dvec3& at(int x, int y) const
    {
        x = std::clamp(x, 0, extent.width - 1);
        y = std::clamp(y, 0, extent.height - 1);
        return pixels[static_cast<std::size_t>(y) * extent.width + x];
    }
};

/// Weights of the pixels from -radius to radius, for each of three values.
using Kernel = std::vector<glm::dvec3>;

Planes filtered(const Planes& from, const Kernel& along_x, const Kernel& along_y)
{
    const auto pass = [](const Planes& source, const Kernel& kernel, int dx, int dy) {
        const int radius = static_cast<int>(kernel.size() / 2);
        Planes out{source.extent, {}};
        for (int y = 0; y < source.extent.height; ++y)
            for (int x = 0; x < source.extent.width; ++x) {
                glm::dvec3 sum(0);
                for (int i = -radius; i <= radius; ++i)
                    sum += kernel[i + radius] * source.at(x + i * dx, y + i * dy);
                out.pixels.push_back(sum);
            }
        return out;
    };
    return pass(pass(from, along_x, 1, 0), along_y, 0, 1);
}

/// Luminance and two opponent colours of linear light.
glm::dvec3 opponentOf(const glm::dvec3& rgb)
{
    const glm::dvec3 xyz = kXyzFromRgb * rgb / kWhite;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

Planes opponents(const Image& image)
{
    Planes planes{image.extent, {}};
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x) {
            glm::dvec3 rgb;
            for (int c = 0; c < 3; ++c)
                rgb[c] = linearFromSrgb(
                    std::clamp(image.at(x, y, image.channels < 3 ? 0 : c), 0.0f, 1.0f));
            planes.pixels.push_back(opponentOf(rgb));
        }
    return planes;
}

/// CIELAB whose colours fade in the dark.
glm::dvec3 labOf(const glm::dvec3& opponent)
{
    const double y = (opponent.x + 16) / 116;
    const glm::dvec3 xyz = glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * kWhite;
    const glm::dvec3 rgb =
        glm::clamp(glm::inverse(kXyzFromRgb) * xyz, glm::dvec3(0), glm::dvec3(1));
    glm::dvec3 root = kXyzFromRgb * rgb / kWhite;
    for (int c = 0; c < 3; ++c) {
        const double delta = 6.0 / 29;
        root[c] = root[c] > delta * delta * delta ? std::cbrt(root[c])
                                                  : root[c] / (3 * delta * delta) + 4.0 / 29;
    }
    const double lightness = 116 * root.y - 16;
    return {lightness, 0.01 * lightness * 500 * (root.x - root.y),
            0.01 * lightness * 200 * (root.y - root.z)};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

/// What the eye blurs: each opponent colour by the sum of two Gaussians, of which the second one is
/// only the third colour's.
Planes blurred(const Planes& planes, double pixels_per_degree)
{
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * pixels_per_degree));
    glm::dvec3 sum(0);
    const auto kernelOf = [&](const glm::dvec3& width, const glm::dvec3& height) {
        Kernel kernel;
        glm::dvec3 all(0);
        for (int i = -radius; i <= radius; ++i) {
            const double degrees = i / pixels_per_degree;
            kernel.push_back(glm::exp(-kPi * kPi * degrees * degrees / width));
            all += kernel.back();
        }
        sum += height * all * all;
        return kernel;
    };
    const glm::dvec3 widths = {0.0047, 0.0053, 0.04}, more_width(0.025);
    const glm::dvec3 heights = glm::dvec3(1, 1, 34.1) * glm::sqrt(kPi / widths);
    const glm::dvec3 more = glm::dvec3(0, 0, 13.5) * glm::sqrt(kPi / more_width);
    const Kernel first = kernelOf(widths, heights), second = kernelOf(more_width, more);
    Planes one = filtered(planes, first, first);
    const Planes two = filtered(planes, second, second);
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        one.pixels[i] = (heights * one.pixels[i] + more * two.pixels[i]) / sum;
    return one;
}

/// Lengths of the first and second derivatives of luminance: edges and points.
std::vector<glm::dvec2> featuresOf(const Planes& planes, double pixels_per_degree)
{
    const double deviation = 0.5 * 0.082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    Kernel smooth(2 * radius + 1), derived(smooth);
    glm::dvec3 sum(0), above(0), below(0);
    for (int i = -radius; i <= radius; ++i) {
        const double share = i / deviation, bell = std::exp(-share * share / 2);
        smooth[i + radius] = glm::dvec3(bell);
        derived[i + radius] = {-i * bell, (share * share - 1) * bell, 0};
        sum += smooth[i + radius];
        above += glm::max(derived[i + radius], glm::dvec3(0));
        below -= glm::min(derived[i + radius], glm::dvec3(0));
    }
    for (glm::dvec3& each : smooth) each /= sum;
    for (glm::dvec3& each : derived)
        for (int c = 0; c < 2; ++c) each[c] /= each[c] > 0 ? above[c] : below[c];
    Planes luminance = planes;
    for (glm::dvec3& each : luminance.pixels) each = glm::dvec3((each.x + 16) / 116);
    const Planes across = filtered(luminance, derived, smooth);
    const Planes along = filtered(luminance, smooth, derived);
    std::vector<glm::dvec2> features;
    for (std::size_t i = 0; i < across.pixels.size(); ++i)
        features.emplace_back(std::hypot(across.pixels[i].x, along.pixels[i].x),
                              std::hypot(across.pixels[i].y, along.pixels[i].y));
    return features;
}

/// Of a colour difference, in [0, 1]: small ones get most of the range.
double redistributed(double difference, double most)
{
    constexpr double kKnee = 0.4, kAtKnee = 0.95;
    const double knee = kKnee * most;
    return difference < knee ? difference * kAtKnee / knee
                             : kAtKnee + (difference - knee) / (most - knee) * (1 - kAtKnee);
}

}  // namespace

double meanFlip(const Image& test, const Image& reference, double pixels_per_degree)
{
    constexpr double kColorPower = 0.7, kFeaturePower = 0.5;
    const double most =
        std::pow(hyab(labOf(opponentOf({0, 1, 0})), labOf(opponentOf({0, 0, 1}))), kColorPower);
    const Planes ours = opponents(test), theirs = opponents(reference);
    const Planes seen = blurred(ours, pixels_per_degree);
    const Planes wanted = blurred(theirs, pixels_per_degree);
    const auto features = featuresOf(ours, pixels_per_degree);
    const auto wanted_features = featuresOf(theirs, pixels_per_degree);
    double sum = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        const double color = redistributed(
            std::pow(hyab(labOf(seen.pixels[i]), labOf(wanted.pixels[i])), kColorPower), most);
        const glm::dvec2 off = glm::abs(features[i] - wanted_features[i]);
        const double feature = std::pow(std::max(off.x, off.y) / std::sqrt(2.0), kFeaturePower);
        sum += std::pow(color, 1 - feature);
    }
    return sum / static_cast<double>(seen.pixels.size());
}

}  // namespace crevice
