// SPDX-License-Identifier: MIT
// Costs as a table, passes down, GPUs across, and against costs that were approved.
#include "tools/measure/cost/cost.h"

#include "core/base/text.h"
#include "tools/measure/cost/gpus.h"

namespace crevice {
namespace {

using Row = std::vector<std::string>;

constexpr double kMebibyte = 1 << 20;

/// Keys of a pass, or of a sum.
struct Keys {
    const char *spills, *fills, *threads;
};
constexpr Keys kPassKeys = {"spills", "fills", "threads"};
constexpr Keys kSumKeys = {"largest_spills", "its_fills", "lowest_threads"};

std::string textAt(const CostReport& figures, const char* key)
{
    return std::to_string(figures.at(key).get<int>());
}

/// The columns of one GPU after its bar.
Row cellsOf(const CostReport& figures, const Keys& keys)
{
    if (figures.contains("refusal")) return {"|", "refused", "-", "-", "-", "-", "-"};
    const double cycles = figures.value("cycles", -1.0);
    const double arithmetic = figures.value("arithmetic", 0.0);
    const std::string share =
        fixed(100 * figures.value("arithmetic_16_bit", 0.0) / std::max(arithmetic, 1.0), 0) + "%";
    return {"|",
            textAt(figures, "instructions") + (figures.contains("refused") ? "+" : ""),
            fixed(figures.value("run", 0.0), 0),
            textAt(figures, keys.spills) + ":" + textAt(figures, keys.fills),
            textAt(figures, keys.threads) + "/" + textAt(figures, "most_threads"),
            cycles < 0 ? "-" : fixed(cycles, cycles < 99.95 ? 1 : 0),
            arithmetic > 0 ? share : "-"};
}

Row rowOf(const std::string& name, const CostReport& figures, const Keys& keys)
{
    Row row = {name, figures.contains("pixels") ? fixed(figures["pixels"], 2) : "",
               figures.contains("fetches") ? fixed(figures["fetches"], 2) : "-",
               fixed(figures.at("tile_bytes").get<double>() / kMebibyte, 2)};
    for (const CostReport& gpu : figures.at("gpus"))
        for (std::string& cell : cellsOf(gpu, keys)) row.push_back(std::move(cell));
    return row;
}

/// A row of one cell is a line of its own. Above each bar stands the name of its GPU.
std::string aligned(const std::vector<Row>& rows, const CostReport& gpus)
{
    std::vector<std::size_t> widths(rows.front().size());
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size() && row.size() > 1; ++i)
            widths[i] = std::max(widths[i], row[i].size());
    std::string names, text;
    std::size_t at = 0, gpu = 0;
    for (std::size_t i = 0; i < widths.size(); at += widths[i++] + 1)
        if (rows.front()[i] == "|") {
            names.resize(at, ' ');
            names += "| " + gpus.at(gpu++).get<std::string>();
        }
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::size_t width = row.size() > 1 ? widths[i] : row[i].size();
            const std::string padding(width - row[i].size(), ' ');
            line += (i > 0 ? " " : "") + (i > 0 ? padding + row[i] : row[i] + padding);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return names + "\n" + text;
}

void addPasses(const CostReport& config, PassRole role, std::vector<Row>& rows)
{
    for (const CostReport& pass : config.at("passes"))
        if (pass.at("for") == nameOf(role)) rows.push_back(rowOf(pass["pass"], pass, kPassKeys));
}

std::string timesOf(const CostReport& sum)
{
    std::string text = "AO in all, estimated:";
    for (const CostReport& each : sum.at("gpus")) {
        const CostGpu* gpu = findCostGpu(each.at("gpu").get<std::string>());
        if (!gpu || !each.contains("milliseconds")) continue;
        text += (text.back() == ':' ? " " : "; ") + std::string(gpu->name) + ", " +
                std::to_string(gpu->cores) + " cores at " + std::to_string(gpu->megahertz) +
                " MHz: " + significant(each["megacycles"], 3) + " million cycles, " +
                fixed(each["milliseconds"], each["milliseconds"] < 9.95 ? 1 : 0) + " ms";
    }
    return text + "\n";
}

std::string tableOf(const CostReport& report, const CostReport& config)
{
    std::vector<Row> rows = {{"pass", "px", "fetches", "MiB"}};
    for (std::size_t i = 0; i < report.at("gpus").size(); ++i)
        rows[0].insert(rows[0].end(), {"|", "inst", "run", "sp:fi", "occ", "cyc", "16b"});
    addPasses(config, PassRole::ao, rows);
    rows.push_back(rowOf("AO in all", config.at("ao"), kSumKeys));
    if (config.at("ao_with_geometry") != config.at("ao")) {
        rows.push_back({"drawn for AO alone"});
        addPasses(config, PassRole::geometry_for_ao, rows);
        rows.push_back(rowOf("AO with that", config.at("ao_with_geometry"), kSumKeys));
    }
    rows.push_back({"not for AO alone"});
    addPasses(config, PassRole::geometry, rows);
    addPasses(config, PassRole::picture, rows);
    return aligned(rows, report.at("gpus")) + timesOf(config.at("ao"));
}

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
                                        {"run", "instructions run a pixel"},
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

std::string costText(const CostReport& report)
{
    std::string text;
    for (const CostReport& config : report.at("configs")) {
        const auto textOf = [](const CostReport& json) { return json.get<std::string>(); };
        text += textOf(config.at("config"));
        if (report.at("variant") != "") text += " --variant " + textOf(report["variant"]);
        for (const CostReport& each : report.at("set")) text += " " + textOf(each);
        text += ": " + textOf(report.at("scene")) + ", " + report.at("size")[0].dump() + "x" +
                report["size"][1].dump() + ", compilers of " + textOf(report.at("compilers")) +
                "\n" + tableOf(report, config);
        for (const CostReport& pass : config.at("passes"))
            for (const CostReport& gpu : pass.at("gpus"))
                if (gpu.contains("refusal"))
                    text += textOf(gpu.at("gpu")) + " refuses " + textOf(pass.at("pass")) + ": " +
                            textOf(gpu["refusal"]) + "\n";
        if (config.contains("uncounted"))
            text += "fetches and loops not counted: " + textOf(config["uncounted"]) + "\n";
        text += "\n";
    }
    return text +
           "Mend spills (sp:fi above 0:0) first, then occ below its most. run, cyc and fetches are "
           "for a pixel, loops as often as they run. See docs/reference/cost.md.\n";
}

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
