// SPDX-License-Identifier: MIT
// Costs as JSON, and back: an object without lists inside takes one line, so that a difference of
// two files reads well.
#include "tools/measure/cost/cost.h"

#include "tools/show/plan/print.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

/// As many digits as tell two shaders apart, so that files stay short.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

constexpr PassRole kRoles[] = {PassRole::ao, PassRole::geometry_for_ao, PassRole::geometry,
                               PassRole::picture};

Json figuresJson(const CostGpu& gpu, const CompilerFigures& figures)
{
    Json json = {{"gpu", gpu.name}};
    if (!figures.refusal.empty()) {
        json["refusal"] = figures.refusal;
        return json;
    }
    json["instructions"] = figures.instructions;
    json["spills"] = figures.spills;
    json["fills"] = figures.fills;
    json["threads"] = figures.threads;
    json["most_threads"] = gpu.most_threads;
    if (figures.cycles >= 0) json["cycles"] = rounded(figures.cycles);
    for (std::size_t i = 0; i < gpu.units.size(); ++i)
        json["cycles_" + gpu.units[i]] = rounded(figures.unit_cycles[i]);
    if (figures.registers >= 0) json["registers"] = figures.registers;
    json["code_bytes"] = figures.code_bytes;
    if (figures.arithmetic < 0) return json;
    json["arithmetic"] = figures.arithmetic;
    json["arithmetic_16_bit"] = figures.half_arithmetic;
    return json;
}

void addBytes(const MovedBytes& bytes, Json& json)
{
    json["tile_bytes"] = std::llround(bytes.written + bytes.loaded);
    json["read_bytes"] = std::llround(bytes.read - bytes.loaded);
}

Json passJson(const CostReport& report, const PassCost& pass)
{
    Json json = {{"pass", pass.pass},
                 {"for", nameOf(pass.role)},
                 {"size", {pass.extent.width, pass.extent.height}},
                 {"pixels", rounded(pass.pixels)}};
    if (pass.fetches) json["fetches"] = rounded(*pass.fetches);
    addBytes(pass.bytes, json);
    json["loaded_bytes"] = std::llround(pass.bytes.loaded);
    json["gpus"] = Json::array();
    for (std::size_t i = 0; i < pass.figures.size(); ++i)
        json["gpus"].push_back(figuresJson(*report.gpus[i], pass.figures[i]));
    return json;
}

Json sumJson(const CostReport& report, const CostSum& sum)
{
    Json json = {{"passes", sum.passes}};
    if (sum.fetches) json["fetches"] = rounded(*sum.fetches);
    addBytes(sum.bytes, json);
    json["gpus"] = Json::array();
    for (std::size_t i = 0; i < sum.gpus.size(); ++i) {
        const GpuSum& gpu = sum.gpus[i];
        Json each = {
            {"gpu", report.gpus[i]->name},   {"instructions", gpu.instructions},
            {"largest_spills", gpu.spills},  {"its_fills", gpu.fills},
            {"lowest_threads", gpu.threads}, {"most_threads", report.gpus[i]->most_threads},
            {"code_bytes", gpu.code_bytes}};
        if (gpu.refused) each["refused"] = true;
        if (gpu.cycles >= 0) each["cycles"] = rounded(gpu.cycles);
        if (gpu.arithmetic >= 0) each["arithmetic"] = gpu.arithmetic;
        if (gpu.arithmetic >= 0) each["arithmetic_16_bit"] = gpu.half_arithmetic;
        json["gpus"].push_back(std::move(each));
    }
    return json;
}

/// Throws nlohmann's exceptions where something is missing or of another type.
CompilerFigures figuresFrom(const CostGpu& gpu, const Json& json)
{
    CompilerFigures figures;
    figures.refusal = json.value("refusal", "");
    if (!figures.refusal.empty()) return figures;
    figures.instructions = json.at("instructions");
    figures.spills = json.at("spills");
    figures.fills = json.at("fills");
    figures.threads = json.at("threads");
    figures.cycles = json.value("cycles", -1.0);
    for (const std::string& unit : gpu.units)
        figures.unit_cycles.push_back(json.at("cycles_" + unit));
    figures.registers = json.value("registers", -1);
    figures.code_bytes = json.at("code_bytes");
    figures.arithmetic = json.value("arithmetic", -1);
    figures.half_arithmetic = json.value("arithmetic_16_bit", -1);
    return figures;
}

PassCost passFrom(const CostReport& report, const Json& json)
{
    PassCost pass;
    pass.pass = json.at("pass");
    const std::string role = json.at("for");
    for (const PassRole each : kRoles)
        if (role == nameOf(each)) pass.role = each;
    pass.extent = {json.at("size").at(0), json.at("size").at(1)};
    pass.pixels = json.at("pixels");
    if (json.count("fetches") > 0) pass.fetches = json.at("fetches").get<double>();
    pass.bytes.loaded = json.at("loaded_bytes");
    pass.bytes.written = json.at("tile_bytes").get<double>() - pass.bytes.loaded;
    pass.bytes.read = json.at("read_bytes").get<double>() + pass.bytes.loaded;
    for (std::size_t i = 0; i < report.gpus.size(); ++i)
        pass.figures.push_back(figuresFrom(*report.gpus[i], json.at("gpus").at(i)));
    return pass;
}

CostReport reportFrom(const Json& json)
{
    CostReport report;
    report.scene = json.at("scene");
    report.extent = {json.at("size").at(0), json.at("size").at(1)};
    report.camera = json.at("camera");
    report.variant = json.at("variant");
    report.set = json.at("set").get<std::vector<std::string>>();
    report.version = json.at("compilers");
    for (const std::string name : json.at("gpus"))
        if (const CostGpu* gpu = findCostGpu(name)) report.gpus.push_back(gpu);
    for (const Json& each : json.at("configs")) {
        ConfigCost config;
        config.config = each.at("config");
        config.uncounted = each.value("uncounted", "");
        config.geometry_bytes_for_ao = each.at("geometry_bytes_for_ao");
        for (const Json& pass : each.at("passes")) config.passes.push_back(passFrom(report, pass));
        report.configs.push_back(std::move(config));
    }
    return report;
}

}  // namespace

std::string toJson(const CostReport& report)
{
    Json json = {{"scene", report.scene},   {"size", {report.extent.width, report.extent.height}},
                 {"camera", report.camera}, {"variant", report.variant},
                 {"set", report.set},       {"compilers", report.version},
                 {"gpus", Json::array()},   {"configs", Json::array()}};
    for (const CostGpu* gpu : report.gpus) json["gpus"].push_back(gpu->name);
    for (const ConfigCost& config : report.configs) {
        Json each = {{"config", config.config}};
        if (!config.uncounted.empty()) each["uncounted"] = config.uncounted;
        each["geometry_bytes_for_ao"] = std::llround(config.geometry_bytes_for_ao);
        each["ao"] = sumJson(report, sumOfAo(report, config, false));
        each["ao_with_geometry"] = sumJson(report, sumOfAo(report, config, true));
        each["passes"] = Json::array();
        for (const PassCost& pass : config.passes) each["passes"].push_back(passJson(report, pass));
        json["configs"].push_back(std::move(each));
    }
    return jsonLines(json) + "\n";
}

Result<CostReport> readCost(const std::string& name, const std::string& text)
{
    std::string what;
    try {
        CostReport report = reportFrom(Json::parse(text));
        if (!report.gpus.empty() && !report.configs.empty()) return report;
        what = "it has no config, or no GPU that is known";
    } catch (const Json::exception& error) {
        what = error.what();
    }
    return Diagnostic{Code::results_broken, "'" + name + "' holds no costs: " + what,
                      "write it again with 'crevice cost CONFIG... --out FILE'"};
}

}  // namespace crevice
