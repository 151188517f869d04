// SPDX-License-Identifier: MIT
// Planning and running the steps of stress cases.
#include "tools/measure/stress/run.h"

#include <crevice/config.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

namespace crevice {
namespace {

Result<std::vector<const StressCase*>> chooseCases(const std::vector<std::string>& names)
{
    std::vector<const StressCase*> chosen;
    std::vector<std::string> known;
    for (const StressCase& each : stressCases()) {
        known.push_back(each.name);
        if (names.empty() || std::find(names.begin(), names.end(), each.name) != names.end())
            chosen.push_back(&each);
    }
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            Diagnostic error{Code::usage, "there is no case '" + name + "'"};
            error.help = suggestName(name, known, "cases");
            return error;
        }
    return chosen;
}

/// The ends, the ordinary one, without which they say nothing, and kinds of which each must be the
/// same: between those there is no way from one to the next.
bool isQuick(const StressCase& stress, std::size_t step)
{
    const bool kind = stress.unit.empty() && stress.expectation == Expectation::same;
    return step == 0 || step + 1 == stress.steps.size() || step == stress.ordinary || kind;
}

std::string seriesKey(const StressRecord& record)
{
    return record.config + "\n" + record.variant + "\n" + record.case_name + "\n" + record.format;
}

/// Draws steps, and judges each by those of its series that are there already.
class Steps {
public:
    Steps(const std::vector<StressTask>& tasks, const std::vector<StressRecord>& known,
          StressHow how)
        : how_(std::move(how)),
          tasks_(tasks),
          records_(tasks.size())
    {
        std::unordered_map<std::string, const StressRecord*> places;
        for (const StressRecord& record : known) places.emplace(record.key, &record);
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            keys_.push_back(how_.key(tasks[task]));
            const auto found = places.find(keys_[task]);
            if (found != places.end()) records_[task] = *found->second;
        }
    }

    MeasureJob job() const
    {
        MeasureJob job;
        for (std::size_t task = 0; task < tasks_.size(); ++task) {
            job.tasks.push_back({keys_[task], stepTitle(tasks_[task]), {}});
            if (records_[task]) job.done.insert(keys_[task]);
        }
        return job;
    }

    Result<Measured> measure(std::size_t task)
    {
        StressDrawing done = how_.measure(tasks_[task]);
        done.record.key = keys_[task];
        done.record.device = how_.device;
        done.record.version = how_.version;
        records_[task] = done.record;
        const Verdict verdict = verdictOf(task);
        const bool fails = verdict.outcome == Outcome::breaks ||
                           (verdict.outcome == Outcome::invalid &&
                            tasks_[task].step == static_cast<int>(tasks_[task].stress->ordinary));
        if (fails && !done.ao.pixels.empty()) {
            done.record.picture = "pictures/" + done.record.key + ".png";
            if (const Status kept = how_.keep(done); !kept) return kept.diagnostics();
        }
        const char* const words[] = {"holds",   "BREAKS", "beyond the format",
                                     "refused", "absent", "VOID"};
        std::string outcome = words[static_cast<int>(verdict.outcome)];
        if (!verdict.why.empty()) outcome += ": " + verdict.reason();
        return Measured{toJsonLine(done.record), std::move(outcome)};
    }

private:
    Verdict verdictOf(std::size_t task) const
    {
        const std::string key = seriesKey(*records_[task]);
        std::vector<const StressRecord*> series(tasks_[task].stress->steps.size());
        std::size_t first = task;
        while (first > 0 && records_[first - 1] && seriesKey(*records_[first - 1]) == key) --first;
        for (std::size_t i = first;
             i < tasks_.size() && records_[i] && seriesKey(*records_[i]) == key; ++i)
            series[records_[i]->step] = &*records_[i];
        return judge(*tasks_[task].stress, series, tasks_[task].step);
    }

    StressHow how_;
    const std::vector<StressTask>& tasks_;
    std::vector<std::string> keys_;
    std::vector<std::optional<StressRecord>> records_;  ///< By task.
};

}  // namespace

Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources)
{
    const auto cases = chooseCases(options.cases);
    if (!cases) return cases.diagnostics();
    const std::vector<std::string> configs =
        options.configs.empty() ? configNames(sources) : options.configs;
    std::vector<StressTask> tasks;
    for (const std::string& config : configs) {
        const ConfigOptions chosen = {
            config, options.variant, options.overrides, {}, options.roots};
        const Result<Description> description = loadDescription(chosen, sources);
        if (!description) return description.diagnostics();
        std::vector<std::string> formats = surfaceFormats(*description);
        for (const StressCase* stress : *cases) {
            const bool all_formats = stress->formats && !options.quick;
            for (std::size_t f = 0; f < (all_formats ? formats.size() : 1); ++f)
                for (std::size_t step = 0; step < stress->steps.size(); ++step)
                    if (!options.quick || isQuick(*stress, step))
                        tasks.push_back({chosen, stress, formats[f], static_cast<int>(step)});
        }
    }
    return tasks;
}

std::string stepTitle(const StressTask& task)
{
    const std::string variant = task.config.variant.empty() ? "" : " " + task.config.variant;
    return task.config.config + variant + ", " + task.stress->name +
           (task.format.empty() ? "" : " " + task.format) + ", " +
           task.stress->steps[task.step].label;
}

MeasureJob stressJob(const std::vector<StressTask>& tasks, const std::vector<StressRecord>& known,
                     StressHow how)
{
    const auto steps = std::make_shared<Steps>(tasks, known, std::move(how));
    MeasureJob job = steps->job();
    job.measure = [steps](std::size_t task) { return steps->measure(task); };
    return job;
}

Result<std::vector<StressRecord>> recordsOf(const MeasureJob& job, const std::string& file)
{
    const Result<std::vector<StressRecord>> all = readStressRecords(file);
    if (!all) return all.diagnostics();
    std::unordered_map<std::string, const StressRecord*> places;
    for (const StressRecord& record : *all) places.emplace(record.key, &record);
    std::vector<StressRecord> records;
    for (const MeasureTask& task : job.tasks)
        if (const auto found = places.find(task.key); found != places.end())
            records.push_back(*found->second);
    return records;
}

std::string seriesName(const StressSeries& series)
{
    return series.stress->name + (series.format.empty() ? "" : " " + series.format);
}

std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records)
{
    std::vector<StressSeries> all;
    std::map<std::string, std::size_t> places;
    for (const StressRecord& record : records) {
        const auto stress =
            std::find_if(stressCases().begin(), stressCases().end(),
                         [&](const StressCase& each) { return each.name == record.case_name; });
        if (stress == stressCases().end() || record.step >= static_cast<int>(stress->steps.size()))
            continue;
        const auto [place, is_new] = places.emplace(seriesKey(record), all.size());
        if (is_new) {
            const std::string variant = record.variant.empty() ? "" : " " + record.variant;
            all.push_back({&*stress, record.config + variant, record.format, {}});
            all.back().steps.resize(stress->steps.size());
        }
        all[place->second].steps[record.step] = &record;
    }
    return all;
}

}  // namespace crevice
