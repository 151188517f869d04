// SPDX-License-Identifier: MIT
// Converged and precise pictures of a config, and what they say about its error.
#include "tools/bench_errors.h"

#include "tools/image_metrics.h"
#include "tools/output_request.h"
#include "tools/read_output.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

const char* const kOutput = "ao";
const char* const kRawOutput = "target.ao";

/// 1 where the truth is known.
Image seenMask(const Image& truth)
{
    Image mask(truth.extent, 1);
    for (std::size_t k = 0; k < mask.pixels.size(); ++k)
        mask.pixels[k] = std::isfinite(truth.pixels[k]) ? 1.0f : 0.0f;
    return mask;
}

double rmseWhere(const Image& mask, const Image& test, const Image& truth)
{
    const Result<ImageDifference> figures = compareImages(test, truth, &mask);
    return figures ? figures->rmse : -1.0;
}

/// The widest format that can stand in for `format`.
Format wideFormat(Format format)
{
    const FormatInfo& info = formatInfo(format);
    if (info.format_class == FormatClass::depth) return Format::depth32f;
    return info.channels == 1 ? Format::r32f : info.channels == 2 ? Format::rg32f : Format::rgba32f;
}

void widen(TargetDesc& target, const DeviceCaps& caps)
{
    const Format wide = wideFormat(target.formats.front());
    if (caps.canRender(wide)) target.formats.insert(target.formats.begin(), wide);
}

/// Widens the targets that hold the occlusion, before and after the filter.
void widenOcclusion(Description& description, const DeviceCaps& caps)
{
    const OutputDesc* output = findNamed(description.outputs, kOutput);
    for (TargetDesc& target : description.targets)
        if (target.name == kOutput || (output && target.name == output->target.name))
            widen(target, caps);
}

void takeAllSamples(Description& description)
{
    for (ParamDesc& param : description.params)
        if (param.name == "samples") param.value[0] = static_cast<float>(param.max);
}

void reseed(Description& description, unsigned frame)
{
    unsigned seed = frame * static_cast<unsigned>(description.generated.size()) + 1;
    for (GeneratedDesc& generated : description.generated) generated.seed = seed++;
}

/// Adds a frame to the mean of `count` before it. Returns the change as an rmse.
double addToMean(Image& mean, const Image& frame, int count)
{
    double squares = 0;
    for (std::size_t k = 0; k < mean.pixels.size(); ++k) {
        const float value = frame.pixels[k * frame.channels];
        const float change = (value - mean.pixels[k]) / static_cast<float>(count + 1);
        mean.pixels[k] += change;
        squares += static_cast<double>(change) * change;
    }
    return std::sqrt(squares / static_cast<double>(mean.pixels.size()));
}

Result<Image> meanOverSeeds(const Stage& stage, Description& description, const std::string& output,
                            const std::function<bool()>& interrupted)
{
    Image mean;
    for (int count = 0; count < kMostConvergedFrames; ++count) {
        reseed(description, static_cast<unsigned>(count));
        const Result<Image> frame = drawOutput(stage, description, output);
        if (!frame) return frame;
        if (count == 0) mean = Image(frame->extent, 1);
        const double change = addToMean(mean, *frame, count);
        if ((count > 0 && change < kConvergedChange) || interrupted()) break;
    }
    return mean;
}

}  // namespace

Result<Image> drawOutput(const Stage& stage, Description description, const std::string& output)
{
    const Result<std::unique_ptr<Renderer>> renderer =
        Renderer::create(stage.device, std::move(description), {stage.extent, {output}, {}},
                         traitsOf(stage.frame));
    if (!renderer) return renderer.diagnostics();
    if (const Status drawn = (*renderer)->render(stage.frame); !drawn) return drawn.diagnostics();
    return readOutput(stage.device, **renderer, output);
}

Result<Image> convergedOcclusion(const Stage& stage, const Description& description,
                                 const std::function<bool()>& interrupted)
{
    Description many = description;
    takeAllSamples(many);
    widenOcclusion(many, stage.device.caps());
    if (exposeOutput(many, kRawOutput)) {
        Result<Image> raw = meanOverSeeds(stage, many, kRawOutput, interrupted);
        if (!raw || raw->extent == stage.extent) return raw;
    }
    return meanOverSeeds(stage, many, kOutput, interrupted);
}

Result<Image> preciseOcclusion(const Stage& stage, const Description& description)
{
    Description wide = description;
    for (TargetDesc& target : wide.targets) widen(target, stage.device.caps());
    return drawOutput(stage, std::move(wide), kOutput);
}

ErrorBudget budgetOf(const Image& ao, const Image& truth, const Image& converged,
                     const Image& precise)
{
    const Image mask = seenMask(truth);
    ErrorBudget budget;
    budget.noise = rmseWhere(mask, ao, converged);
    budget.model = rmseWhere(mask, converged, truth);
    budget.precision = rmseWhere(mask, ao, precise);
    return budget;
}

double radiusOnScreen(double radius, const Camera& camera, const Image& depth)
{
    std::vector<float> seen;
    for (std::size_t k = 0; k < depth.pixels.size(); k += depth.channels)
        if (depth.pixels[k] < 1.0f) seen.push_back(depth.pixels[k]);
    if (seen.empty()) return 0.0;
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::nth_element(seen.begin(), middle, seen.end());
    const glm::dmat4 clip_from_view = camera.clip_from_view;
    const glm::dvec4 view = glm::inverse(clip_from_view) * glm::dvec4(0, 0, *middle * 2.0 - 1.0, 1);
    const double w = (clip_from_view * (view / view.w)).w;
    return radius * std::abs(clip_from_view[1][1] / w) * depth.extent.height / 2.0;
}

}  // namespace crevice
