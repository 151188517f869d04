// SPDX-License-Identifier: MIT
// Bench results as JSON Lines. The keys are the fields' names.
#include "tools/measure/bench/sample.h"

#include "core/base/content_hash.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/line_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

namespace crevice {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Extent, width, height)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeFigures, median, q1, q3)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassTime, name, ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorFigures, rmse, bias, p99, rmse_fit, power_fit, pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorBudget, taps, filter, half_size, off_screen, hidden_layers,
                                   precision, model)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChangeFigures, rms, p99, p999, truth, rmse, changes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(UncoveredFigures, frames, rmse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionFigures, paths, settled_after, uncovered, uncovered_rest,
                                   uncovered_pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BenchSample, key, failure, config, peer, overrides, disable,
                                   family, output, scene, camera, extent, radius, rays, radius_px,
                                   samples, triangles, device, software, version, error,
                                   error_without_ao, budget, budget_failure, motion, motion_failure,
                                   clock, repeats, total, cost, cost_with_geometry, passes,
                                   ratio_copy, ratio_learnopengl, ratio_with_geometry,
                                   texture_bytes, bytes_read, bytes_written, ao_picture,
                                   ground_truth_picture, difference_picture)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlannedBench, device, command, bench_samples)

namespace {

/// The key of a line that is no sample but what is planned.
const char* const kPlanned = "planned";

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
    value.emplace("peer", false);
    value.emplace("disable", std::vector<std::string>());
    value.emplace("motion", MotionFigures());
    value.emplace("motion_failure", "");
    value.emplace("cost_with_geometry", TimeFigures());
    value.emplace("ratio_with_geometry", 0.0);
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

class Reader {
public:
    void readFile(const std::string& path)
    {
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        append(diagnostics_,
               readLines(path, {"bench sample", "crevice bench"}, [&](nlohmann::json&& json) {
                   if (json.is_object() && json.contains(kPlanned))
                       return add(json[kPlanned].get<PlannedBench>());
                   BenchSample sample = parseSample(std::move(json));
                   sample.folder = folder.string();
                   resolvePictures(sample, folder);
                   add(std::move(sample));
               }));
    }

    Result<BenchResults> take()
    {
        if (hasErrors(diagnostics_)) return std::move(diagnostics_);
        return {{std::move(samples_), std::move(planned_)}, std::move(diagnostics_)};
    }

private:
    void add(PlannedBench planned)
    {
        const auto same = [&planned](const PlannedBench& known) {
            return known.device == planned.device && known.command == planned.command;
        };
        const auto known = std::find_if(planned_.begin(), planned_.end(), same);
        if (known == planned_.end())
            planned_.push_back(std::move(planned));
        else
            *known = std::move(planned);
    }

    void add(BenchSample sample)
    {
        const auto [place, is_new] =
            places_.emplace(sample.device + identityOf(sample), samples_.size());
        if (is_new) {
            samples_.push_back(std::move(sample));
            return;
        }
        BenchSample& known = samples_[place->second];
        const bool hides_figures = !sample.failure.empty() && known.failure.empty();
        if (!hides_figures || sample.key != known.key) known = std::move(sample);
    }

    std::vector<BenchSample> samples_;
    std::vector<PlannedBench> planned_;
    std::unordered_map<std::string, std::size_t> places_;
    Diagnostics diagnostics_;
};

}  // namespace

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

std::string plannedId(const BenchSample& sample)
{
    ContentHash hash;
    hash.addText(identityOf(sample));
    return hash.hex();
}

std::string nameSuffix(const BenchSample& sample)
{
    const std::string output = sample.output == kOcclusionOutput ? "" : " output=" + sample.output;
    return output + (sample.disable.empty() ? "" : " without " + joined(sample.disable));
}

std::string toJsonLine(const BenchSample& sample)
{
    nlohmann::json json = sample;
    if (sample.disable.empty()) json.erase("disable");
    if (sample.motion.paths.empty()) json.erase("motion");
    if (sample.motion_failure.empty()) json.erase("motion_failure");
    return jsonLine(json);
}

std::string toJsonLine(const PlannedBench& planned)
{
    nlohmann::json json;
    json[kPlanned] = planned;
    return jsonLine(json);
}

BenchCoverage coverageOf(const BenchResults& results)
{
    BenchCoverage coverage;
    std::set<std::pair<std::string, std::string>> all;
    for (const BenchSample& sample : results.samples) {
        all.insert({sample.device, plannedId(sample)});
        ++(sample.failure.empty() ? coverage.measured : coverage.failed);
        std::vector<std::string>& configs = coverage.configs;
        if (sample.failure.empty() &&
            std::find(configs.begin(), configs.end(), sample.config) == configs.end())
            configs.push_back(sample.config);
    }
    for (const PlannedBench& planned : results.planned)
        for (const std::string& id : planned.bench_samples) all.insert({planned.device, id});
    coverage.planned = all.size();
    return coverage;
}

std::string coverageText(const BenchCoverage& coverage)
{
    constexpr std::size_t kMostNamed = 8;
    if (coverage.whole()) return "";
    const std::vector<std::string>& all = coverage.configs;
    const std::size_t named = std::min(all.size(), kMostNamed);
    std::string text = std::to_string(coverage.measured) + " of " +
                       std::to_string(coverage.planned) + " bench samples measured";
    if (coverage.failed > 0) text += ", " + std::to_string(coverage.failed) + " failed";
    if (named > 0) text += ": " + joined({all.begin(), all.begin() + static_cast<long>(named)});
    if (named < all.size()) text += " and " + std::to_string(all.size() - named) + " more configs";
    return text + "; what to take may change with the rest";
}

Result<std::vector<BenchSample>> readBenchSamples(const std::vector<std::string>& paths)
{
    Result<BenchResults> results = readBenchResults(paths);
    if (!results) return results.diagnostics();
    return {std::move(results->samples), results.diagnostics()};
}

Result<BenchResults> readBenchResults(const std::vector<std::string>& paths)
{
    Reader reader;
    for (const std::string& path : paths) reader.readFile(resultsFile(path));
    return reader.take();
}

}  // namespace crevice
