// SPDX-License-Identifier: MIT
#include "tools/measure/cost/check.h"

#include "core/base/numbers.h"
#include "tools/measure/cost/pass_roles.h"

#include <algorithm>

namespace crevice {

namespace {

bool isForAo(const CostReport& pass)
{
    const CostReport& role = pass.at("for");
    return role == nameOf(PassRole::ao) || role == nameOf(PassRole::geometry_for_ao);
}

int spillsOf(const CostReport& gpu)
{
    return gpu.at("spills").get<int>() + gpu.at("fills").get<int>();
}

/// What a pass of that name may do: what it did, or, of a new name, what any pass of the config
/// did.
struct Allowed {
    bool spills = false;
    bool refused = false;
    int threads = 0;
};

Allowed allowedOf(const CostReport& passes, const CostReport& name, std::size_t gpu)
{
    const bool known = std::any_of(passes.begin(), passes.end(), [&](const CostReport& each) {
        return isForAo(each) && each.at("pass") == name;
    });
    Allowed allowed;
    for (const CostReport& each : passes) {
        if (!isForAo(each) || (known && each.at("pass") != name)) continue;
        const CostReport& figures = each.at("gpus").at(gpu);
        if (figures.contains("refusal")) {
            allowed.refused = true;
            continue;
        }
        const int threads = figures.at("threads");
        allowed.spills = allowed.spills || spillsOf(figures) > 0;
        allowed.threads = allowed.threads == 0 ? threads : std::min(allowed.threads, threads);
    }
    return allowed;
}

class Comparison {
public:
    CostComparison result;

    void config(const CostReport& before, const CostReport& after)
    {
        const std::string name = after.at("config");
        const CostReport &was = before.at("ao_with_geometry"), &is = after.at("ao_with_geometry");
        for (const CostReport& pass : after.at("passes"))
            for (std::size_t gpu = 0; isForAo(pass) && gpu < pass.at("gpus").size(); ++gpu)
                checkPass(name, before.at("passes"), pass, gpu);
        if (was.contains("fetches") && !is.contains("fetches"))
            result.worse.push_back(
                name + ": fetches are not counted: " + after.at("uncounted").get<std::string>());
        else if (was.contains("fetches"))
            grown(name, "fetches a pixel", was["fetches"], is["fetches"]);
        for (std::size_t gpu = 0; gpu < is.at("gpus").size(); ++gpu)
            checkSum(name, was.at("gpus").at(gpu), is.at("gpus").at(gpu));
    }

private:
    void grown(const std::string& where, const char* what, double was, double is)
    {
        const std::string text =
            where + ": " + what + " were " + significant(was, 5) + " and are " + significant(is, 5);
        if (is > was * (1 + kCostGrowth)) result.worse.push_back(text);
        if (was > is * (1 + kCostGrowth)) result.better.push_back(text);
    }

    void checkPass(const std::string& config, const CostReport& before, const CostReport& pass,
                   std::size_t gpu)
    {
        const CostReport& is = pass.at("gpus").at(gpu);
        const Allowed allowed = allowedOf(before, pass.at("pass"), gpu);
        const std::string where = config + ", " + is.at("gpu").get<std::string>() + ", " +
                                  pass.at("pass").get<std::string>();
        if (is.contains("refusal")) {
            if (!allowed.refused)
                result.worse.push_back(where + ": refused: " + is["refusal"].get<std::string>());
            return;
        }
        if (!allowed.spills && spillsOf(is) > 0)
            result.worse.push_back(where + ": spills where nothing did, " + is["spills"].dump() +
                                   ":" + is["fills"].dump());
        if (is.at("threads") < allowed.threads)
            result.worse.push_back(where + ": occupancy was " + std::to_string(allowed.threads) +
                                   " and is " + is["threads"].dump() + " of " +
                                   is.at("most_threads").dump());
    }

    void checkSum(const std::string& config, const CostReport& was, const CostReport& is)
    {
        if (is.contains("refused")) return;  // the sum lacks a pass
        const std::string where = config + ", " + is.at("gpu").get<std::string>();
        grown(where, "instructions", was.at("instructions"), is.at("instructions"));
        if (was.contains("cycles")) grown(where, "cycles a pixel", was["cycles"], is["cycles"]);
        const auto spilled = [](const CostReport& sum) {
            return sum.at("largest_spills").get<double>() + sum.at("its_fills").get<double>();
        };
        // Where none spilled, checkPass says which does.
        if (spilled(was) > 0) grown(where, "spills and fills", spilled(was), spilled(is));
    }
};

Diagnostic broken(const std::string& name, const std::string& what)
{
    return {Code::results_broken, "'" + name + "' holds no costs: " + what,
            "write it again with 'crevice cost CONFIG... --out FILE'"};
}

}  // namespace

Result<ApprovedCost> readCost(const std::string& name, const std::string& text,
                              const CostOptions& like)
{
    try {
        ApprovedCost approved{CostReport::parse(text), like};
        const CostReport& report = approved.report;
        CostOptions& options = approved.options;
        options.configs.clear();
        for (const CostReport& config : report.at("configs"))
            options.configs.push_back(config.at("config"));
        options.config.variant = report.at("variant");
        options.config.overrides = report.at("set").get<std::vector<std::string>>();
        options.scene.scene = report.at("scene");
        options.scene.camera = report.at("camera");
        options.scene.size = report.at("size").at(0).dump() + "x" + report.at("size").at(1).dump();
        options.gpus = report.at("gpus").get<std::vector<std::string>>();
        report.at("compilers").get<std::string>();
        return approved;
    } catch (const CostReport::exception& error) {
        return broken(name, error.what());
    }
}

Result<CostComparison> compareCosts(const CostReport& approved, const CostReport& now)
{
    Comparison comparison;
    try {
        for (std::size_t i = 0; i < now.at("configs").size(); ++i)
            comparison.config(approved.at("configs").at(i), now["configs"][i]);
    } catch (const CostReport::exception& error) {
        return broken("the approved file", error.what());
    }
    return std::move(comparison.result);
}

}  // namespace crevice
