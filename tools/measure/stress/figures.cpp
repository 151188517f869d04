// SPDX-License-Identifier: MIT
// Figures of pictures.
#include "tools/measure/stress/record.h"

#include "core/base/text.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/image/srgb.h"
#include "tools/render/view_diagnosis.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr double kMiddle = 0.8;  // share of width and height that planes are judged in

bool isNear(const StressShot& shot, int x, int y)
{
    return anyOf(shot.spoiled, [&](const glm::ivec2 at) {
        return std::max(std::abs(at.x - x), std::abs(at.y - y)) <= shot.reach_px;
    });
}

/// The pixel of the ordinary picture that shows what pixel (x, y) of this one does.
glm::ivec2 ordinaryPixel(const StressShot& shot, const glm::dmat2& unturned, Extent ordinary,
                         Extent size, int x, int y)
{
    const glm::dvec2 pixels(size.width, size.height);
    const glm::dvec2 here = (glm::dvec2(x, y) + 0.5) / pixels * 2.0 - 1.0;
    const glm::dvec2 there = unturned * (here - shot.moved);
    return glm::ivec2(
        glm::floor((there + 1.0) / 2.0 * glm::dvec2(ordinary.width, ordinary.height)));
}

/// The target whose occlusion the pass hands on to `target`; empty where it makes its own.
std::string keptBy(const Plan& plan, const Description& description, const PlanPass& pass,
                   const std::string& target)
{
    const PassDesc* desc = findNamed(description.passes, pass.name);
    if (!desc) return "";
    for (const PreservesConstantDesc& each : desc->preserves_constant)
        for (const PlanInput& input : pass.inputs)
            if (each.name == target && input.name == each.sampler.name &&
                input.kind == InputKind::target)
                return plan.targets[input.index].name;
    return "";
}

/// Of a share of the exact occlusion.
bool isOff(double kept, double least, double most) { return !(kept >= least && kept <= most); }

}  // namespace

double formatStep(Format format, double distance, const StressShot& shot)
{
    const double near = shot.near_distance, far = shot.far_distance;
    const auto floatStep = [distance](int bits) {
        return std::exp2(std::floor(std::log2(distance)) - bits);
    };
    if (format == Format::rgba16f || format == Format::r16f) return floatStep(10);
    if (format == Format::rgba32f || format == Format::r32f) return floatStep(23);
    // Depths near 1, where most of them lie, are as fine in single float as in 24 bits.
    const double depths = format == Format::depth16 ? 65536.0 : 16777216.0;
    if (shot.camera.orthographic()) return (far - near) / depths;
    return distance * distance * (far - near) / (near * far * depths);
}

void describeOcclusion(const Image& ao, StressRecord& record)
{
    double sum = 0;
    long long count = 0;
    record.least = HUGE_VAL;
    record.most = -HUGE_VAL;
    for (std::size_t i = 0; i < ao.pixels.size(); i += ao.channels) {
        const double value = ao.pixels[i];
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
        record.least = std::min(record.least, value);
        record.most = std::max(record.most, value);
        record.out_of_range += value < 0 || value > 1;
    }
    if (count == 0) record.least = record.most = 0;
    record.mean = count > 0 ? sum / static_cast<double>(count) : 0;
}

void describeSurface(const Image& ao, const StressShot& shot, Format format, StressRecord& record)
{
    const auto shareAt = [&](double distance) {
        return shot.radius > 0 ? formatStep(format, distance, shot) / shot.radius : 0.0;
    };
    if (shot.distances.pixels.empty()) {
        record.step_share = shot.farthest > 0 ? shareAt(shot.farthest) : 0;
        record.resolved = record.step_share <= kOpenShare ? 1 : 0;
        return;
    }
    const Extent size = shot.extent;
    const int left = static_cast<int>(size.width * (1 - kMiddle) / 2);
    const int low = static_cast<int>(size.height * (1 - kMiddle) / 2);
    long long seen = 0, resolved = 0, below = 0;
    double sum = 0;
    record.judged_least = 1;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double distance = shot.distances.at(x, y);
            if (distance <= 0) continue;
            ++seen;
            if (shareAt(distance) > kOpenShare) continue;
            ++resolved;
            const float value = ao.at(x, y);
            if (x < left || x >= size.width - left || y < low || y >= size.height - low ||
                !std::isfinite(value))
                continue;
            ++record.judged;
            sum += value;
            below += value < kOpenPixel;
            record.judged_least = std::min<double>(record.judged_least, value);
        }
    const double middle = shot.distances.at(size.width / 2, size.height / 2);
    record.step_share = middle > 0 ? shareAt(middle) : 0;
    record.resolved = seen > 0 ? static_cast<double>(resolved) / static_cast<double>(seen) : 1;
    const double judged = static_cast<double>(std::max(record.judged, 1LL));
    record.judged_mean = record.judged > 0 ? sum / judged : 0;
    record.judged_below = static_cast<double>(below) / judged;
}

PictureChange changeBetween(const Image& ordinary, const Image& image, const StressShot& shot)
{
    PictureChange found;
    double pixels = 0;
    const Extent size = ordinary.extent;
    const int width = image.extent.width, border = shot.border_px;
    const glm::dmat2 unturned = glm::inverse(shot.turned);
    std::map<std::pair<int, int>, std::pair<double, int>> blocks;  // sum of changes, pixels
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = border; x < width - border; ++x) {
            const glm::ivec2 other = ordinaryPixel(shot, unturned, size, image.extent, x, y);
            if (other.x < border || other.x >= size.width - border || other.y < 0 ||
                other.y >= size.height || isNear(shot, x, y))
                continue;
            const double here = image.at(x, y), there = ordinary.at(other.x, other.y);
            auto& [changes, count] = blocks[{x / shot.block_px, y / shot.block_px}];
            changes += std::isfinite(here - there) ? here - there : 1;
            ++count;
            found.mean += here;
            found.ordinary += there;
            ++pixels;
        }
    double sum = 0, largest = 0;
    for (const auto& [place, block] : blocks) {
        const double change = std::abs(block.first / block.second);
        sum += change;
        largest = std::max(largest, change);
    }
    if (blocks.empty()) return found;
    found.change = shot.spoiled.empty() ? sum / static_cast<double>(blocks.size()) : largest;
    found.mean /= pixels;
    found.ordinary /= pixels;
    return found;
}

void describeError(const Image& ao, const Image& ground_truth, StressRecord& record)
{
    const auto error = compareImages(ao, ground_truth);
    const auto white = compareImages(Image(ground_truth.extent, 1, 1.0f), ground_truth);
    if (!error || !white) return;
    record.rmse = error->rmse;
    record.rmse_white = white->rmse;
    record.exact = white->bias;
    record.occlusion = white->bias - error->bias;
    for (std::size_t i = 0; i < ao.pixels.size(); i += ao.channels)
        if (std::isnan(ground_truth.pixels[i / ao.channels]) && ao.pixels[i] < record.background)
            record.background = ao.pixels[i];
}

double errorOfLight(const Image& without, const Image& color, const Image& ao)
{
    double sum = 0;
    for (std::size_t i = 0; i < color.pixels.size(); ++i) {
        const std::size_t channel = i % color.channels, pixel = i / color.channels * ao.channels;
        if (channel < 3)
            sum += std::abs(linearFromSrgb(color.pixels[i]) -
                            linearFromSrgb(without.pixels[i]) * ao.pixels[pixel]);
    }
    return sum / static_cast<double>(color.pixels.size());
}

double shareChanged(const Image& before, const Image& after, double limit)
{
    if (!(before.extent == after.extent)) return 1;
    std::size_t changed = 0;
    for (std::size_t i = 0; i < before.pixels.size(); i += before.channels)
        changed += !(std::abs(double(after.pixels[i]) - before.pixels[i]) <= limit);
    return static_cast<double>(changed * before.channels) /
           static_cast<double>(std::max<std::size_t>(before.pixels.size(), 1));
}

double radiusInPixels(const StressShot& shot)
{
    double distance = shot.middle > 0 ? shot.middle : shot.farthest;
    if (!shot.distances.pixels.empty())
        distance = shot.distances.at(shot.extent.width / 2, shot.extent.height / 2);
    if (distance <= 0 && !shot.camera.orthographic()) return 0;
    return pixelsOf(shot.radius, distance, shot.camera, shot.extent);
}

std::vector<PassPicture> occlusionPasses(const Plan& plan, const Description& description,
                                         const std::string& output)
{
    std::vector<PassPicture> passes;
    const OutputDesc* desc = findNamed(description.outputs, output);
    std::string target = desc ? desc->target.name : "";
    while (const PlanTarget* found = findNamed(plan.targets, target)) {
        const PlanPass& pass = plan.passes[found->first_pass];
        passes.push_back({pass.name, target});
        target = keptBy(plan, description, pass, target);
    }
    std::reverse(passes.begin(), passes.end());
    return passes;
}

std::string departingPass(const StressCase& stress, const StressShot& shot,
                          const std::vector<PassPicture>& passes,
                          const std::vector<PassPicture>& ordinary, const StressRecord& record)
{
    if (shot.output != "ao") return passes.empty() ? "" : passes.back().pass;
    const bool is_ordinary = record.step == static_cast<int>(stress.ordinary);
    const double least = is_ordinary ? kLeastStrength : kLeastKept;
    const double most = is_ordinary ? kMostStrength : kMostKept;
    const double kept = record.exact > 0 ? record.occlusion / record.exact : 1;
    const double whole = std::max(1 - record.mean, 1e-9);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        StressRecord figures;
        describeOcclusion(passes[i].occlusion, figures);
        if (record.out_of_range > 0 && figures.out_of_range > 0) return passes[i].pass;
        const double occlusion = 1 - figures.mean;
        const bool plain =
            stress.expectation == Expectation::open || stress.expectation == Expectation::one;
        if (plain && occlusion > 1 - kOpenMean && occlusion >= whole / 2) return passes[i].pass;
        if (!plain && isOff(kept, least, most) && isOff(kept * occlusion / whole, least, most))
            return passes[i].pass;
        if (stress.expectation != Expectation::same || i >= ordinary.size()) continue;
        const double change =
            changeBetween(ordinary[i].occlusion, passes[i].occlusion, shot).change;
        if (change > stress.limit && change >= record.change / 2) return passes[i].pass;
    }
    return "";
}

}  // namespace crevice
