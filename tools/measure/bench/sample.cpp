// SPDX-License-Identifier: MIT
// Bench results as JSON Lines. The keys are the fields' names.
#include "tools/measure/bench/sample.h"

#include "core/base/text.h"
#include "tools/measure/line_file.h"
#include "tools/show/plan/print.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <unordered_map>

namespace crevice {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Extent, width, height)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeFigures, median, q1, q3)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassTime, name, ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorFigures, rmse, bias, p99, pattern, rmse_fit, power_fit,
                                   pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChangeFigures, rms, p99, p999, truth, rmse, changes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(UncoveredFigures, frames, rmse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionFigures, paths, settled_after, uncovered, uncovered_rest,
                                   uncovered_pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BenchSample, key, failure, config, overrides, disable, family,
                                   output, scene, camera, extent, radius, rays, radius_px, samples,
                                   triangles, device, software, version, error, error_without_ao,
                                   motion, motion_failure, clock, repeats, total, cost,
                                   cost_with_geometry, passes, ratio_learnopengl,
                                   ratio_with_geometry, texture_bytes, bytes_read, bytes_written,
                                   ao_picture, ground_truth_picture, difference_picture)

namespace {

/// JSON has no NaN: it is written as null. True where there was one; it becomes 0.
bool replaceNulls(nlohmann::json& value)
{
    if (value.is_null()) {
        value = 0;
        return true;
    }
    bool found = false;
    if (value.is_structured())
        for (nlohmann::json& child : value) found = replaceNulls(child) || found;
    return found;
}

BenchSample parseSample(nlohmann::json value)
{
    const bool not_finite = replaceNulls(value);
    value.emplace("output", kOcclusionOutput);  // lines of earlier versions have none
    value.emplace("disable", std::vector<std::string>());
    value.emplace("motion", MotionFigures());
    value.emplace("motion_failure", "");
    value.emplace("cost_with_geometry", TimeFigures());
    value.emplace("ratio_with_geometry", 0.0);
    if (value.contains("error") && value["error"].is_object())
        value["error"].emplace("pattern", 0.0);
    BenchSample sample = value.get<BenchSample>();
    if (not_finite && sample.failure.empty()) sample.failure = "a figure is not finite";
    return sample;
}

/// Pictures are named relative to their results file; afterwards, relative to the working folder.
void resolvePictures(BenchSample& sample, const std::filesystem::path& folder)
{
    for (std::string* picture :
         {&sample.ao_picture, &sample.ground_truth_picture, &sample.difference_picture})
        if (!picture->empty()) *picture = (folder / *picture).string();
}

std::string resultsFile(const std::string& path)
{
    std::error_code unreadable;
    if (!std::filesystem::is_directory(path, unreadable)) return path;
    return (std::filesystem::path(path) / "results.jsonl").string();
}

/// Samples by what they are of.
class Reader {
public:
    void add(BenchSample sample)
    {
        const auto [place, is_new] =
            places_.emplace(sample.device + identityOf(sample), samples.size());
        if (is_new) {
            samples.push_back(std::move(sample));
            return;
        }
        BenchSample& known = samples[place->second];
        const bool hides_figures = !sample.failure.empty() && known.failure.empty();
        if (!hides_figures || sample.key != known.key) known = std::move(sample);
    }

    std::vector<BenchSample> samples;

private:
    std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace

Camera BenchView::matrices() const
{
    return {camera.view_from_world, clipFromView(camera, extent, bounds)};
}

bool isPresetConfig(std::string_view config)
{
    return contains({"mobile_low", "mobile", "balanced", "high"}, config);
}

std::string questionOf(const BenchSample& sample)
{
    nlohmann::json question = {sample.config, sample.overrides, sample.scene, sample.camera,
                               sample.extent, sample.radius,    sample.rays};
    if (sample.output != kOcclusionOutput) question.push_back(sample.output);
    return jsonLine(question);
}

std::string identityOf(const BenchSample& sample)
{
    const std::string disabled = sample.disable.empty() ? "" : jsonLine(sample.disable);
    return questionOf(sample) + disabled;
}

std::string nameSuffix(const BenchSample& sample)
{
    const std::string output = sample.output == kOcclusionOutput ? "" : " output=" + sample.output;
    return output + (sample.disable.empty() ? "" : " without " + joined(sample.disable));
}

std::string sampleLabel(const BenchSample& sample)
{
    std::string label = sample.config;
    for (const std::string& value : sample.overrides)
        if (!startsWith(value, "radius=")) label += " " + value;
    return label + nameSuffix(sample);
}

std::string sampleTitle(const BenchSample& sample)
{
    std::string title = sample.config;
    for (const std::string& text : sample.overrides) title += " " + text;
    return title + nameSuffix(sample) + ", " + sample.scene + ", " + sizeText(sample.extent);
}

std::string toJsonLine(const BenchSample& sample)
{
    nlohmann::json json = sample;
    if (sample.disable.empty()) json.erase("disable");
    if (sample.motion.paths.empty()) json.erase("motion");
    if (sample.motion_failure.empty()) json.erase("motion_failure");
    return jsonLine(json);
}

Result<std::vector<BenchSample>> readBenchSamples(const std::vector<std::string>& paths)
{
    Reader reader;
    Diagnostics diagnostics;
    for (const std::string& each : paths) {
        const std::string path = resultsFile(each);
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        append(diagnostics,
               readLines(path, {"bench sample", "crevice bench"}, [&](nlohmann::json&& json) {
                   if (json.is_object() && json.contains("planned")) return;  // of earlier versions
                   BenchSample sample = parseSample(std::move(json));
                   sample.folder = folder.string();
                   resolvePictures(sample, folder);
                   reader.add(std::move(sample));
               }));
    }
    if (hasErrors(diagnostics)) return diagnostics;
    return {std::move(reader.samples), std::move(diagnostics)};
}

}  // namespace crevice
