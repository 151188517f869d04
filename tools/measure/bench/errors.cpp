// SPDX-License-Identifier: MIT
// Pictures of a config with some things made ideal, and what they say about its error.
#include "tools/measure/bench/errors.h"

#include "tools/commands/cli/config_options.h"
#include "tools/measure/taps.h"
#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

const char* const kLayersModule = "command/second_layer.json";

/// Tiles of noise and of half-size targets stay where they are on the screen.
constexpr int kMarginStep = 16;

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

Result<std::unique_ptr<Renderer>> makeRenderer(const Stage& stage, const Description& description)
{
    return Renderer::create(stage.device, description, {stage.extent, {kOcclusionOutput}, {}},
                            traitsOf(stage.frame));
}

/// On a stage with the frame that the config gets.
Result<Image> drawConverged(const Stage& stage, Description& description,
                            const std::function<bool()>& interrupted)
{
    MeanImage mean;
    const int most = description.generated.empty() ? 1 : kMostConvergedFrames;
    for (int count = 0; count < most; ++count) {
        reseed(description, static_cast<unsigned>(count));
        const auto renderer = makeRenderer(stage, description);
        if (!renderer) return renderer.diagnostics();
        if (const Status drawn = (*renderer)->render(stage.frame); !drawn)
            return drawn.diagnostics();
        const Result<Image> frame = readOutput(stage.device, **renderer, kOcclusionOutput);
        if (!frame) return frame;
        mean.add(*frame);
        if (mean.noise() < kConvergedNoise || interrupted()) break;
    }
    return mean.take();
}

Result<Image> draw(const Stage& stage, Description& description, unsigned ideal,
                   const std::function<bool()>& interrupted)
{
    auto host = HostTextures::make(stage.device, description, stage.extent, stage.frame);
    if (!host) return host.diagnostics();
    const Result<Frame> frame = host->frameOf(stage.frame);
    if (!frame) return frame.diagnostics();
    const Stage hosted = {stage.device, *frame, stage.extent, stage.sources};
    if (ideal & kIdealTaps) return drawConverged(hosted, description, interrupted);
    const auto renderer = makeRenderer(hosted, description);
    if (!renderer) return renderer.diagnostics();
    return drawSettled(stage.device, **renderer, *frame, kOcclusionOutput);
}

int marginOf(int side) { return (side / 2 + kMarginStep - 1) / kMarginStep * kMarginStep; }

Image middleOf(const Image& image, Extent extent, Extent margin)
{
    Image middle(extent, 1);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            middle.at(x, y) = image.at(x + margin.width, y + margin.height);
    return middle;
}

/// Draws more than the view and cuts off what is outside of it.
template <class Draw>
Result<Image> drawWider(const Stage& stage, Draw draw)
{
    const Extent margin = {marginOf(stage.extent.width), marginOf(stage.extent.height)};
    const Extent extent = {stage.extent.width + 2 * margin.width,
                           stage.extent.height + 2 * margin.height};
    glm::dmat4 narrower(1.0);
    narrower[0][0] = static_cast<double>(stage.extent.width) / extent.width;
    narrower[1][1] = static_cast<double>(stage.extent.height) / extent.height;
    Frame frame = stage.frame;
    frame.camera.clip_from_view = narrower * glm::dmat4(frame.camera.clip_from_view);
    const Result<Image> image = draw(Stage{stage.device, frame, extent, stage.sources});
    if (!image) return image;
    return middleOf(*image, stage.extent, margin);
}

/// Adds back faces and a second layer, where the estimator would read them.
Status addLayers(const Stage& stage, Description& description)
{
    const auto layers = loadDescription({kLayersModule, {}, {}, {}}, stage.sources);
    if (!layers) return layers.diagnostics();
    Description layered = description;
    layOver(layered, *layers);
    const Result<Plan> plan = compile(layered, traitsOf(stage.frame), stage.device.caps(),
                                      {stage.extent, {kOcclusionOutput}, {}});
    if (!plan) return plan.diagnostics();
    const bool read =
        std::any_of(layers->passes.begin(), layers->passes.end(),
                    [&plan](const PassDesc& pass) { return findNamed(plan->passes, pass.name); });
    if (read) description = std::move(layered);
    return {};
}

/// The parts that are the change of the error when one thing is ideal.
constexpr struct {
    Ideal ideal;
    double ErrorBudget::*change;
} kParts[] = {
    {kIdealTaps, &ErrorBudget::taps},
    {kIdealFilter, &ErrorBudget::filter},
    {kIdealSize, &ErrorBudget::half_size},
    {kIdealScreen, &ErrorBudget::off_screen},
    {kIdealLayers, &ErrorBudget::hidden_layers},
    {kIdealFormats, &ErrorBudget::precision},
};

}  // namespace

Result<Image> idealOcclusion(const Stage& stage, Description description, unsigned ideal,
                             const std::function<bool()>& interrupted)
{
    if (ideal & kIdealTaps) takeAllSamples(description);
    if (ideal & kIdealSize) takeFullSize(description);
    if (ideal & kIdealFilter) leaveOutFilter(description);
    if (ideal & kIdealLayers)
        if (const Status added = addLayers(stage, description); !added) return added.diagnostics();
    if (ideal & kIdealFormats) widenFormats(description, stage.device.caps());
    const auto drawOn = [&](const Stage& seen) {
        return draw(seen, description, ideal, interrupted);
    };
    if (!(ideal & kIdealScreen) || takeGuardBand(description)) return drawOn(stage);
    return drawWider(stage, drawOn);
}

ErrorBudget budgetOf(double rmse, const std::function<Result<double>(unsigned ideal)>& errorOf,
                     std::string& failure)
{
    const auto errorOr = [&](unsigned ideal, double otherwise) {
        const Result<double> error = errorOf(ideal);
        if (error) return *error;
        if (failure.empty()) failure = error.diagnostics().front().message;
        return otherwise;
    };
    ErrorBudget budget;
    for (const auto& part : kParts) budget.*part.change = errorOr(part.ideal, rmse) - rmse;
    budget.model = errorOr(kIdealEverything, 0.0);
    return budget;
}

}  // namespace crevice
