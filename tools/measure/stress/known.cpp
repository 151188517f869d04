// SPDX-License-Identifier: MIT
// How each step of a config stood in an earlier run, and what is worse since: `crevice stress` as a
// gate.
//
// A file of known steps has a line a config and case, for those of shipped configs in
// docs/stress/known.jsonl: {"case":"near_far","config":"gtao","steps":{"1:1e1":0.03,
// "0.01:1e4":["breaks",0.12]}}. A number alone is the error of a step that holds.
#include "tools/measure/stress/run.h"

#include "tools/measure/line_file.h"

#include "core/base/text.h"

#include <nlohmann/json.hpp>

namespace crevice {

std::string_view knownStepsText();  // docs/stress/known.jsonl, embedded at build

namespace {

constexpr double kInheritedError = 2;  // of a config's error over that of the one it extends
constexpr double kRounded = 1.001;     // errors are kept with four digits

bool fails(Outcome outcome) { return outcome == Outcome::breaks || outcome == Outcome::invalid; }

double errorOf(const StressCase& stress, const StressRecord& record)
{
    const auto bad = static_cast<double>(record.bad_pixels + record.out_of_range);
    if (bad > 0) return bad;
    if (record.rmse >= 0) return record.rmse;
    switch (stress.expectation) {
    case Expectation::open: return 1 - (record.judged > 0 ? record.judged_mean : record.mean);
    case Expectation::one: return std::max(1 - record.least, record.most - 1);
    case Expectation::sound:
    case Expectation::opens:
    case Expectation::darkens: return record.mean;  // of light, or of a picture of a few pixels
    default: return record.change;
    }
}

StressStanding standingOf(const StressSeries& series, std::size_t step)
{
    return {judge(*series.stress, series.steps, step).outcome,
            errorOf(*series.stress, *series.steps[step])};
}

void addLine(const nlohmann::json& line, KnownSteps& known)
{
    auto& steps = known[{line.at("config"), line.at("case")}];
    for (const auto& [label, value] : line.at("steps").items()) {
        StressStanding standing;
        for (int i = 0; value.is_array() && wordOf(standing.outcome) != value.at(0) && i < 6; ++i)
            standing.outcome = static_cast<Outcome>(i);
        standing.error = value.is_array() ? value.at(1) : value;
        steps[label] = standing;
    }
}

/// Notes the first shipped config that is looked up.
class FirstConfig : public SourceSet {
public:
    explicit FirstConfig(const SourceSet& sources) : sources_(sources) {}

    SourceRef find(std::string_view path) const override
    {
        constexpr std::string_view kFolder = "configs/", kSuffix = ".json";
        if (name.empty() && startsWith(path, kFolder) && shippedSources().find(path))
            name = path.substr(kFolder.size(), path.size() - kFolder.size() - kSuffix.size());
        return sources_.find(path);
    }

    std::vector<std::string> list() const override { return sources_.list(); }

    mutable std::string name;

private:
    const SourceSet& sources_;
};

}  // namespace

KnownSteps standingsOf(const std::vector<StressSeries>& all)
{
    KnownSteps known;
    for (const StressSeries& series : all)
        for (std::size_t step = 0; step < series.steps.size(); ++step)
            if (series.steps[step] && series.steps[step]->absent.empty())
                known[{series.config, series.stress->name}][series.stress->steps[step].label] =
                    standingOf(series, step);
    return known;
}

std::string toLines(const KnownSteps& known)
{
    std::string lines;
    for (const auto& [name, steps] : known) {
        nlohmann::json values;
        for (const auto& [label, standing] : steps) {
            const double error = nlohmann::json::parse(significant(standing.error, 4));
            if (standing.outcome == Outcome::holds)
                values[label] = error;
            else
                values[label] = {wordOf(standing.outcome), error};
        }
        lines +=
            jsonLine({{"config", name.first}, {"case", name.second}, {"steps", values}}) + "\n";
    }
    return lines;
}

Result<KnownSteps> readKnownSteps(const std::string& path)
{
    KnownSteps known;
    const Diagnostics diagnostics =
        readLines(path, {"case of known steps", "crevice stress"},
                  [&known](const nlohmann::json& line) { addLine(line, known); });
    if (hasErrors(diagnostics)) return diagnostics;
    return {std::move(known), diagnostics};
}

const KnownSteps& shippedSteps()
{
    static const KnownSteps known = [] {
        KnownSteps all;
        for (const std::string_view line : split(knownStepsText(), '\n'))
            if (!line.empty()) addLine(nlohmann::json::parse(line), all);
        return all;
    }();
    return known;
}

std::string shippedNameOf(const ConfigOptions& config, const SourceSet& sources)
{
    const FirstConfig first(sources);
    (void)loadConfig(first, requestOf(config));
    return first.name;
}

std::vector<std::string> worseThan(const KnownSteps& known, const KnownConfig& config,
                                   const StressSeries& series, int& unjudged)
{
    std::vector<std::string> worse;
    const auto steps = known.find({config.name, series.stress->name});
    for (std::size_t step = 0; step < series.steps.size(); ++step) {
        if (!series.steps[step]) continue;
        const std::string& label = series.stress->steps[step].label;
        const Verdict is = judge(*series.stress, series.steps, step);
        const double error = errorOf(*series.stress, *series.steps[step]);
        const bool has = steps != known.end() && steps->second.count(label) > 0;
        if (!has && config.known_only) {
            unjudged += is.outcome != Outcome::absent;
            continue;
        }
        const StressStanding before = has ? steps->second.at(label) : StressStanding{};
        const bool drawn = is.outcome != Outcome::refused && is.outcome != Outcome::absent &&
                           before.outcome != Outcome::refused;
        const double factor = config.same ? kRounded : kInheritedError;
        const double most = std::max(factor * before.error, before.error + kSameChange);
        std::string what;
        if (fails(is.outcome) && !fails(before.outcome))
            what = wordOf(is.outcome) + ": " + is.reason();
        else if (has && drawn && error > most)
            what = "error " + significant(error, 4) + ", " +
                   (config.same ? "was " : "`" + config.name + "` has ") +
                   significant(before.error, 4) +
                   (series.steps[step]->departing_pass.empty()
                        ? ""
                        : ", first in pass '" + series.steps[step]->departing_pass + "'");
        if (!what.empty())
            worse.push_back(series.config + ", " + series.stress->name + ", " + label + ": " +
                            what);
    }
    return worse;
}

}  // namespace crevice
