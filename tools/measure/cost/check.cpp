// SPDX-License-Identifier: MIT
#include "tools/measure/cost/check.h"

#include "core/base/text.h"

namespace crevice {

namespace {

class Comparison {
public:
    CostComparison result;

    void config(const CostReport& before, const CostReport& after)
    {
        const std::string name = after.at("config");
        const CostReport &was = before.at("ao_with_geometry"), &is = after.at("ao_with_geometry");
        if (was.contains("fetches") && !is.contains("fetches"))
            result.worse.push_back(
                name + ": fetches are not counted: " + after.at("uncounted").get<std::string>());
        else
            grown(name, "fetches a pixel", was.value("fetches", 0.0), is.value("fetches", 0.0));
        for (std::size_t gpu = 0; gpu < is.at("gpus").size(); ++gpu)
            compareGpu(name, was.at("gpus").at(gpu), is.at("gpus").at(gpu));
    }

private:
    void grown(const std::string& where, const char* what, double was, double is)
    {
        const std::string text =
            where + ": " + what + " were " + significant(was, 5) + " and are " + significant(is, 5);
        if (is > was * (1 + kCostGrowth)) result.worse.push_back(text);
        if (was > is * (1 + kCostGrowth)) result.better.push_back(text);
    }

    void compareGpu(const std::string& config, const CostReport& was, const CostReport& is)
    {
        const std::string where = config + ", " + is.at("gpu").get<std::string>();
        if (is.contains("refused")) {  // and the sum lacks a pass
            if (!was.contains("refused")) result.worse.push_back(where + ": a pass is refused");
            return;
        }
        for (const auto& [key, what] : {std::pair("instructions", "instructions"),
                                        {"cycles", "cycles a pixel"},
                                        {"largest_spills", "spills"},
                                        {"its_fills", "fills"}})
            grown(where, what, was.value(key, 0.0), is.value(key, 0.0));
        if (is.at("lowest_threads") < was.at("lowest_threads"))
            result.worse.push_back(where + ": occupancy was " + was["lowest_threads"].dump() +
                                   " and is " + is["lowest_threads"].dump() + " of " +
                                   is.at("most_threads").dump());
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
