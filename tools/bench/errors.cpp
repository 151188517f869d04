// SPDX-License-Identifier: MIT
// Converged and precise pictures of a config, and what they say about its error.
#include "tools/bench/errors.h"

#include "tools/cli/output_request.h"
#include "tools/image/image_metrics.h"
#include "tools/measure/taps.h"
#include "tools/render/read_output.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

const char* const kOutput = "ao";
const char* const kRawOutput = "target.ao";

/// 1 where the ground truth is known.
Image seenMask(const Image& ground_truth)
{
    Image mask(ground_truth.extent, 1);
    for (std::size_t k = 0; k < mask.pixels.size(); ++k)
        mask.pixels[k] = std::isfinite(ground_truth.pixels[k]) ? 1.0f : 0.0f;
    return mask;
}

double rmseWhere(const Image& mask, const Image& test, const Image& ground_truth)
{
    const Result<ImageDifference> figures = compareImages(test, ground_truth, &mask);
    return figures ? figures->rmse : -1.0;
}

/// The widest format that can stand in for `format`; 32-bit floats cannot be filtered.
Format wideFormat(Format format, bool filtered)
{
    const FormatInfo& info = formatInfo(format);
    if (info.format_class == FormatClass::depth) return Format::depth32f;
    if (info.channels == 1) return filtered ? Format::r16f : Format::r32f;
    if (info.channels == 2) return filtered ? Format::rg16f : Format::rg32f;
    return filtered ? Format::rgba16f : Format::rgba32f;
}

bool readLinearly(const Description& description, const TargetDesc& target)
{
    for (const PassDesc& pass : description.passes)
        for (const InputDesc& input : pass.inputs)
            if (input.has_filter && input.filter == Filter::linear &&
                (input.from.empty() ? input.sampler.name : input.from.name) == target.name)
                return true;
    return false;
}

void widen(const Description& description, TargetDesc& target, const DeviceCaps& caps)
{
    const Format wide = wideFormat(target.formats.front(), readLinearly(description, target));
    if (caps.canRender(wide)) target.formats.insert(target.formats.begin(), wide);
}

/// Widens the targets that hold occlusion, before, within and after the filter: `ao`, what the
/// output comes from, and what has their formats, since a no-op passes a filter's input on as its
/// output.
void widenOcclusion(Description& description, const DeviceCaps& caps)
{
    const OutputDesc* output = findNamed(description.outputs, kOutput);
    std::vector<std::vector<Format>> formats;
    for (const TargetDesc& target : description.targets)
        if (target.name == kOutput || (output && target.name == output->target.name))
            formats.push_back(target.formats);
    for (TargetDesc& target : description.targets)
        if (std::find(formats.begin(), formats.end(), target.formats) != formats.end())
            widen(description, target, caps);
}

/// Seeds by counting down from the largest, since people count up from 1: noise that the mean
/// shared with the config would look like no noise.
void reseed(Description& description, unsigned frame)
{
    unsigned seed = ~(frame * static_cast<unsigned>(description.generated.size()));
    for (GeneratedDesc& generated : description.generated) generated.seed = seed--;
}

/// The mean of frames and how much noise is left in it (Welford's running variance).
class MeanImage {
public:
    void add(const Image& frame)
    {
        if (count_++ == 0) {
            mean_ = Image(frame.extent, 1);
            squares_ = 0;
        }
        for (std::size_t k = 0; k < mean_.pixels.size(); ++k) {
            const float value = frame.pixels[k * static_cast<std::size_t>(frame.channels)];
            const float change = value - mean_.pixels[k];
            mean_.pixels[k] += change / static_cast<float>(count_);
            squares_ += static_cast<double>(change) * (value - mean_.pixels[k]);
        }
    }

    /// As an rmse over the pixels. Infinite after one frame, which has no spread.
    double noise() const
    {
        if (count_ < 2) return std::numeric_limits<double>::infinity();
        const double pixels = static_cast<double>(mean_.pixels.size());
        return std::sqrt(squares_ / pixels / (count_ - 1) / count_);
    }

    Image take() { return std::move(mean_); }

private:
    Image mean_;
    double squares_ = 0;  ///< Sum over pixels and frames of the squared distance to the mean.
    int count_ = 0;
};

Result<Image> meanOverSeeds(const Stage& stage, Description& description, const std::string& output,
                            const std::function<bool()>& interrupted)
{
    MeanImage mean;
    for (int count = 0; count < kMostConvergedFrames; ++count) {
        reseed(description, static_cast<unsigned>(count));
        const Result<Image> frame = drawOutput(stage, description, output);
        if (!frame) return frame;
        mean.add(*frame);
        if (mean.noise() < kConvergedNoise || interrupted()) break;
    }
    return mean.take();
}

/// The target before any filter, where there is one and it is of full size; else the output.
/// `draw` gets the description that exposes it and its output's name.
template <class Draw>
Result<Image> beforeFilter(const Stage& stage, Description description, Draw draw)
{
    if (exposeOutput(description, kRawOutput)) {
        Result<Image> raw = draw(description, kRawOutput);
        if (!raw || raw->extent == stage.extent) return raw;
    }
    return draw(description, kOutput);
}

}  // namespace

Result<Image> drawOutput(const Stage& stage, Description description, const std::string& output)
{
    const Result<std::unique_ptr<Renderer>> renderer = Renderer::create(
        stage.device, std::move(description), {stage.extent, {output}, {}}, traitsOf(stage.frame));
    if (!renderer) return renderer.diagnostics();
    return drawSettled(stage.device, **renderer, stage.frame, output);
}

Result<Image> convergedOcclusion(const Stage& stage, const Description& description,
                                 const std::function<bool()>& interrupted)
{
    Description many = description;
    takeAllSamples(many);
    widenOcclusion(many, stage.device.caps());
    return beforeFilter(stage, std::move(many),
                        [&](Description& exposed, const std::string& output) {
                            return meanOverSeeds(stage, exposed, output, interrupted);
                        });
}

Result<Image> unfilteredOcclusion(const Stage& stage, const Description& description)
{
    return beforeFilter(stage, description,
                        [&stage](Description& exposed, const std::string& output) {
                            return drawOutput(stage, exposed, output);
                        });
}

Result<Image> preciseOcclusion(const Stage& stage, const Description& description)
{
    Description wide = description;
    for (TargetDesc& target : wide.targets) widen(wide, target, stage.device.caps());
    return drawOutput(stage, std::move(wide), kOutput);
}

ErrorBudget budgetOf(const BudgetPictures& pictures)
{
    const Image mask = seenMask(pictures.ground_truth);
    ErrorBudget budget;
    budget.sampling = rmseWhere(mask, pictures.unfiltered, pictures.converged);
    budget.noise = rmseWhere(mask, pictures.ao, pictures.converged);
    budget.model = rmseWhere(mask, pictures.converged, pictures.ground_truth);
    budget.precision = rmseWhere(mask, pictures.ao, pictures.precise);
    return budget;
}

}  // namespace crevice
