// SPDX-License-Identifier: MIT
// Planning and running the steps of stress cases.
#include "tools/stress/run.h"

#include "core/config/load.h"

#include <algorithm>
#include <cmath>
#include <map>
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

/// The ends, and the middle where the ends may be beyond the format.
bool isQuick(const StressCase& stress, std::size_t step)
{
    const bool ordinary = step == stress.ordinary && stress.expectation == Expectation::open;
    return step == 0 || step + 1 == stress.steps.size() || ordinary;
}

bool inShard(const Shard& shard, std::size_t index)
{
    return index % static_cast<std::size_t>(shard.count) + 1 ==
           static_cast<std::size_t>(shard.index);
}

std::string seriesKey(const StressRecord& record)
{
    return record.config + "\n" + record.variant + "\n" + record.case_name + "\n" + record.format;
}

std::string leftText(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    return whole < 100 ? std::to_string(whole) + " s" : std::to_string((whole + 59) / 60) + " min";
}

class Loop {
public:
    Loop(const std::vector<StressTask>& tasks, const std::vector<StressRecord>& known,
         LineFile& file, const StressWorld& world)
        : tasks_(tasks), file_(file), world_(world), start_(world.seconds())
    {
        for (const StressRecord& record : known) known_.emplace(record.key, &record);
    }

    StressSummary run()
    {
        std::size_t next = 0;
        while (next < tasks_.size() && take(tasks_[next], next)) ++next;
        summary_.missing = static_cast<int>(tasks_.size() - next);
        return std::move(summary_);
    }

private:
    /// False when the run ends before this step.
    bool take(const StressTask& task, std::size_t index)
    {
        const std::string key = world_.key(task);
        if (const auto found = known_.find(key); found != known_.end()) {
            ++summary_.kept;
            summary_.records.push_back(*found->second);
            return true;
        }
        summary_.interrupted = world_.interrupted();
        const double elapsed = world_.seconds() - start_;
        if (summary_.interrupted || (world_.time_budget_s > 0 && elapsed >= world_.time_budget_s))
            return false;
        StressDrawing done = world_.measure(task);
        summary_.interrupted = world_.interrupted();
        if (summary_.interrupted) return false;
        done.record.key = key;
        done.record.device = world_.device;
        done.record.version = world_.version;
        return write(task, done) && tell(task, index + 1);
    }

    bool write(const StressTask& task, StressDrawing& done)
    {
        const Verdict verdict = verdictOf(task, done.record);
        if (verdict.outcome == Outcome::breaks && !done.ao.pixels.empty()) {
            done.record.picture = "pictures/" + done.record.key + ".png";
            summary_.written = world_.keep(done);
            if (!summary_.written) return false;
        }
        summary_.written = file_.append(toJsonLine(done.record));
        if (!summary_.written) return false;
        ++summary_.measured;
        verdict_ = verdict;
        summary_.records.push_back(std::move(done.record));
        return true;
    }

    /// As far as what came before tells.
    Verdict verdictOf(const StressTask& task, const StressRecord& record) const
    {
        std::vector<const StressRecord*> series(task.stress->steps.size());
        for (auto other = summary_.records.rbegin();
             other != summary_.records.rend() && seriesKey(*other) == seriesKey(record); ++other)
            series[other->step] = &*other;
        series[task.step] = &record;
        return judge(*task.stress, series, task.step);
    }

    bool tell(const StressTask& task, std::size_t done) const
    {
        std::string line = "[" + std::to_string(done) + "/" + std::to_string(tasks_.size()) + "] " +
                           stepTitle(task) + ": ";
        const char* const words[] = {"holds", "BREAKS", "beyond the format", "refused", "absent"};
        line += words[static_cast<int>(verdict_.outcome)];
        if (!verdict_.why.empty() && verdict_.outcome != Outcome::beyond)
            line += ": " + verdict_.why;
        const double elapsed = world_.seconds() - start_;
        const double left = elapsed / summary_.measured * static_cast<double>(tasks_.size() - done);
        if (done < tasks_.size()) line += "; about " + leftText(left) + " left";
        world_.say(line);
        return true;
    }

    const std::vector<StressTask>& tasks_;
    LineFile& file_;
    const StressWorld& world_;
    const double start_;
    std::unordered_map<std::string, const StressRecord*> known_;
    Verdict verdict_;
    StressSummary summary_;
};

}  // namespace

Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources)
{
    const auto cases = chooseCases(options.cases);
    if (!cases) return cases.diagnostics();
    const std::vector<std::string> configs =
        options.configs.empty() ? configNames(sources) : options.configs;
    std::vector<StressTask> tasks;
    std::size_t index = 0;
    for (const std::string& config : configs) {
        const ConfigOptions chosen = {config, options.variant, options.overrides, {}, options.roots};
        const Result<Description> description = loadDescription(chosen, sources);
        if (!description) return description.diagnostics();
        std::vector<std::string> formats = surfaceFormats(*description);
        for (const StressCase* stress : *cases) {
            const bool all_formats = stress->formats && !options.quick;
            if (!inShard(options.shard, index++)) continue;
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

StressSummary runStress(const std::vector<StressTask>& tasks,
                        const std::vector<StressRecord>& known, LineFile& file,
                        const StressWorld& world)
{
    return Loop(tasks, known, file, world).run();
}

std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records)
{
    std::vector<StressSeries> all;
    std::map<std::string, std::size_t> places;
    for (const StressRecord& record : records) {
        const auto stress = std::find_if(stressCases().begin(), stressCases().end(),
                                         [&](const StressCase& each) {
                                             return each.name == record.case_name;
                                         });
        if (stress == stressCases().end() ||
            record.step >= static_cast<int>(stress->steps.size()))
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
