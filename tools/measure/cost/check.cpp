// SPDX-License-Identifier: MIT
#include "tools/measure/cost/check.h"

#include "core/base/numbers.h"

#include <algorithm>

namespace crevice {

namespace {

bool isForAo(const PassCost& pass)
{
    return pass.role == PassRole::ao || pass.role == PassRole::geometry_for_ao;
}

/// What a pass of that name may do: what it did, or, of a new name, what any pass of the config
/// did.
struct Allowed {
    bool spills = false;
    bool refused = false;
    int threads = 0;
};

Allowed allowedOf(const ConfigCost& config, const std::string& pass, std::size_t gpu)
{
    const bool known =
        std::any_of(config.passes.begin(), config.passes.end(),
                    [&](const PassCost& each) { return isForAo(each) && each.pass == pass; });
    Allowed allowed;
    bool first = true;
    for (const PassCost& each : config.passes) {
        if (!isForAo(each) || (known && each.pass != pass)) continue;
        const CompilerFigures& figures = each.figures[gpu];
        allowed.refused = allowed.refused || !figures.refusal.empty();
        if (!figures.refusal.empty()) continue;
        allowed.spills = allowed.spills || figures.spills + figures.fills > 0;
        allowed.threads = first ? figures.threads : std::min(allowed.threads, figures.threads);
        first = false;
    }
    return allowed;
}

class Comparison {
public:
    CostComparison result;

    void config(const CostReport& approved, const ConfigCost& before, const CostReport& now,
                const ConfigCost& after)
    {
        for (std::size_t i = 0; i < approved.gpus.size(); ++i)
            for (std::size_t k = 0; k < now.gpus.size(); ++k)
                if (approved.gpus[i] == now.gpus[k]) passes(*now.gpus[k], before, i, after, k);
        const CostSum was = sumOfAo(approved, before, true), is = sumOfAo(now, after, true);
        if (was.fetches && is.fetches)
            grown(after.config, "fetches a pixel", *was.fetches, *is.fetches);
        else if (was.fetches)
            result.worse.push_back(after.config + ": fetches are not counted: " + after.uncounted);
        for (std::size_t i = 0; i < approved.gpus.size(); ++i)
            for (std::size_t k = 0; k < now.gpus.size(); ++k)
                if (approved.gpus[i] == now.gpus[k])
                    sums(after.config + ", " + now.gpus[k]->name, was.gpus[i], is.gpus[k]);
    }

private:
    void grown(const std::string& where, const char* what, double was, double is)
    {
        const std::string text =
            where + ": " + what + " were " + significant(was, 5) + " and are " + significant(is, 5);
        if (is > was * (1 + kCostGrowth)) result.worse.push_back(text);
        if (was > is * (1 + kCostGrowth)) result.better.push_back(text);
    }

    void passes(const CostGpu& gpu, const ConfigCost& before, std::size_t before_gpu,
                const ConfigCost& after, std::size_t gpu_index)
    {
        for (const PassCost& pass : after.passes) {
            if (!isForAo(pass)) continue;
            const CompilerFigures& is = pass.figures[gpu_index];
            const Allowed allowed = allowedOf(before, pass.pass, before_gpu);
            const std::string where = after.config + ", " + gpu.name + ", " + pass.pass;
            if (!is.refusal.empty()) {
                if (!allowed.refused) result.worse.push_back(where + ": refused: " + is.refusal);
                continue;
            }
            if (!allowed.spills && is.spills + is.fills > 0)
                result.worse.push_back(where + ": spills where nothing did, " +
                                       std::to_string(is.spills) + ":" + std::to_string(is.fills));
            if (is.threads < allowed.threads)
                result.worse.push_back(
                    where + ": occupancy was " + std::to_string(allowed.threads) + " and is " +
                    std::to_string(is.threads) + " of " + std::to_string(gpu.most_threads));
        }
    }

    void sums(const std::string& where, const GpuSum& was, const GpuSum& is)
    {
        if (is.refused && !was.refused) return;  // the sum lacks a pass, as `passes` says
        grown(where, "instructions", was.instructions, is.instructions);
        if (was.cycles >= 0) grown(where, "cycles a pixel", was.cycles, is.cycles);
        // Where none spilled, `passes` says which does.
        if (was.spills + was.fills > 0)
            grown(where, "spills and fills", was.spills + was.fills, is.spills + is.fills);
    }
};

}  // namespace

CostComparison compareCosts(const CostReport& approved, const CostReport& now)
{
    Comparison comparison;
    for (const ConfigCost& before : approved.configs) {
        const auto after =
            std::find_if(now.configs.begin(), now.configs.end(),
                         [&](const ConfigCost& each) { return each.config == before.config; });
        if (after == now.configs.end())
            comparison.result.worse.push_back(before.config + ": missing now");
        else
            comparison.config(approved, before, now, *after);
    }
    return comparison.result;
}

}  // namespace crevice
