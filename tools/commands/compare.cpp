// SPDX-License-Identifier: MIT
// crevice compare: how far one image is from another, and whether that is within limits.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

constexpr double kNoLimit = -1.0;

struct CompareOptions {
    std::string test;
    std::string ground_truth;
    std::string mask;
    std::string difference;
    std::string max_abs;
    double max_rmse = kNoLimit;
    double max_bad_fraction = kNoLimit;
    bool json = false;
};

/// The three images of a comparison; `mask` is empty when none was given.
struct Images {
    Image test, ground_truth, mask;

    const Image* maskOrNull() const { return mask.pixels.empty() ? nullptr : &mask; }
};

Result<Images> readImages(const CompareOptions& options)
{
    Images images;
    Diagnostics errors;
    const auto read = [&errors](const std::string& path, Image& image) {
        Result<Image> result = readImage(path);
        append(errors, result.diagnostics());
        if (result) image = std::move(*result);
    };
    read(options.test, images.test);
    read(options.ground_truth, images.ground_truth);
    if (!options.mask.empty()) read(options.mask, images.mask);
    if (hasErrors(errors)) return errors;
    return {std::move(images), std::move(errors)};
}

/// What a pixel may be off by before it counts as bad: "0.05", "2/255", or "" for the usual 0.05.
Result<double> parseThreshold(const std::string& text)
{
    if (text.empty()) return 0.05;
    const std::size_t slash = text.find('/');
    double value = 0.0, divisor = 1.0;
    const bool ok =
        CLI::detail::lexical_cast(text.substr(0, slash), value) &&
        (slash == std::string::npos || CLI::detail::lexical_cast(text.substr(slash + 1), divisor));
    if (ok && value >= 0.0 && divisor > 0.0) return value / divisor;
    return Diagnostic{Code::usage, "--max-abs '" + text + "' is not a number of at least 0",
                      "write --max-abs 0.05 or --max-abs 2/255"};
}

/// CLI11's own checks let "nan" through, a limit that nothing breaks.
std::string checkLimit(const std::string& text)
{
    double value = 0.0;
    if (CLI::detail::lexical_cast(text, value) && value >= 0.0) return {};
    return "'" + text + "' is not a number of at least 0";
}

/// The limits that are broken, a sentence each.
std::vector<std::string> brokenLimits(const CompareOptions& options,
                                      const ImageDifference& difference)
{
    std::vector<std::string> broken;
    const auto check = [&broken](const char* what, double value, double limit) {
        if (limit >= 0.0 && !(value <= limit))
            broken.push_back(std::string(what) + " is " + nlohmann::json(value).dump() +
                             ", over the limit of " + nlohmann::json(limit).dump());
    };
    check("rmse", difference.rmse, options.max_rmse);
    const bool has_fraction = options.max_bad_fraction >= 0.0, has_abs = !options.max_abs.empty();
    check("the fraction of bad pixels", difference.bad_fraction,
          has_abs && !has_fraction ? 0.0 : options.max_bad_fraction);
    if (difference.non_finite > 0 && (options.max_rmse >= 0.0 || has_fraction || has_abs))
        broken.push_back(std::to_string(difference.non_finite) + " pixels are not finite");
    return broken;
}

void printFigures(const ImageDifference& figures, double threshold,
                  const std::vector<std::string>& broken)
{
    print("rmse      %s\n", fixed(figures.rmse, 6).c_str());
    print("bias      %s%s\n", std::signbit(figures.bias) ? "" : "+",
          fixed(figures.bias, 6).c_str());
    print("p99       %s\n", fixed(figures.p99, 6).c_str());
    print("max       %s\n", fixed(figures.max, 6).c_str());
    print("pattern   %s every 2 to 8 pixels\n", fixed(figures.pattern, 6).c_str());
    print("rmse_fit  %s at power %s\n", fixed(figures.rmse_fit, 6).c_str(),
          fixed(figures.power_fit, 3).c_str());
    print("psnr      %s dB\n", fixed(figures.psnr_db, 2).c_str());
    print("bad       %s %% of pixels are off by more than %s\n",
          fixed(figures.bad_fraction * 100.0, 4).c_str(), significant(threshold, 6).c_str());
    print("pixels    %lld, and %lld masked, %lld not finite\n", figures.pixels, figures.masked,
          figures.non_finite);
    for (const std::string& sentence : broken) printMessage("%s\n", sentence.c_str());
}

void printFiguresJson(const ImageDifference& figures, double threshold,
                      const std::vector<std::string>& broken)
{
    printAsJson({
        {"rmse", figures.rmse},
        {"bias", figures.bias},
        {"p99", figures.p99},
        {"max", figures.max},
        {"pattern", figures.pattern},
        {"rmse_fit", figures.rmse_fit},
        {"power_fit", figures.power_fit},
        {"psnr_db", figures.psnr_db},
        {"threshold", threshold},
        {"bad_fraction", figures.bad_fraction},
        {"pixels", figures.pixels},
        {"masked", figures.masked},
        {"non_finite", figures.non_finite},
        {"broken_limits", broken},
    });
}

/// Figures over no pixel would look like a perfect match.
Status checkCompared(const ImageDifference& figures)
{
    if (figures.pixels > 0) return {};
    return Diagnostic{Code::image_broken,
                      "no pixel is left to compare: " + std::to_string(figures.masked) +
                          " are masked, " + std::to_string(figures.non_finite) + " are not finite",
                      "masked is where the ground truth is not finite or the --mask is 0"};
}

Status writeDifference(const CompareOptions& options, const Images& images)
{
    if (options.difference.empty()) return {};
    const Result<Image> picture =
        differencePicture(images.test, images.ground_truth, images.maskOrNull());
    if (!picture) return picture.diagnostics();
    return writeImage(options.difference, *picture);
}

int compareFiles(const CompareOptions& options)
{
    const Result<double> threshold = parseThreshold(options.max_abs);
    if (!threshold) return report(threshold.diagnostics(), options.json);
    if (!options.difference.empty()) {
        const Status writable = checkWritable(options.difference);
        if (!writable) return report(writable.diagnostics(), options.json);
    }
    const Result<Images> images = readImages(options);
    if (!images) return report(images.diagnostics(), options.json);
    const Result<ImageDifference> figures =
        compareImages(images->test, images->ground_truth, images->maskOrNull(), *threshold);
    if (!figures) return report(figures.diagnostics(), options.json);
    const Status compared = checkCompared(*figures);
    if (!compared) return report(compared.diagnostics(), options.json);
    const Status written = writeDifference(options, *images);
    if (!written) return report(written.diagnostics(), options.json);

    const std::vector<std::string> broken = brokenLimits(options, *figures);
    (options.json ? printFiguresJson : printFigures)(*figures, *threshold, broken);
    return broken.empty() ? kExitOk : kExitDiffers;
}

}  // namespace

void addCompareCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("compare", "Measure one image against another");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("TEST", options->test, "The image to measure, PNG or PFM")->required();
    command->add_option("GROUND_TRUTH", options->ground_truth, "The image to compare with")
        ->required();
    addText(*command, "--mask", options->mask, "FILE",
            "Compare only pixels where this image is above 0");
    command
        ->add_option("--max-rmse", options->max_rmse,
                     "Fail (5) if the rmse is above this, such as 0.05")
        ->check(checkLimit, "at least 0");
    command->add_option("--max-abs", options->max_abs,
                        "A pixel that is off by more than this is bad: 0.05 (the default) or "
                        "2/255. Given alone: fail (5) if any pixel is bad");
    command
        ->add_option("--max-bad-fraction", options->max_bad_fraction,
                     "Fail (5) if a larger share of pixels is bad, [0, 1]")
        ->check(checkLimit)
        ->check(CLI::Range(0.0, 1.0));
    addText(*command, "--diff", options->difference, "FILE.png",
            "Write the signed difference to this file: red is too bright, blue too dark");
    command->add_flag("--json", options->json, "Print the figures as JSON");
    command->footer(
        "Examples:\n"
        "  crevice compare ao.pfm ground_truth.pfm --max-rmse 0.13 --diff diff.png\n"
        "  crevice compare egl.png osmesa.png --max-abs 2/255 --max-bad-fraction 0.001");
    command->callback([options, &exit_code] { exit_code = compareFiles(*options); });
}

}  // namespace crevice
