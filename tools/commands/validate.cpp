// SPDX-License-Identifier: MIT
// crevice validate: reads, decodes and plans configs, and compiles their shaders, with no GL.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/show/plan/planning.h"

#include <crevice/config.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace crevice {
namespace {

struct ValidateOptions : ConfigOptions {
    std::vector<std::string> configs;
    bool all = false;
    bool json = false;
};

/// One config, or one of its variants.
struct Checked {
    std::string config;
    std::string variant;
    Result<Plan> plan;
};

/// The config, and where no variant was asked for, each of its variants.
std::vector<Checked> check(ConfigOptions options, const SourceSet& sources, GlslCheck& shaders)
{
    std::vector<Checked> checked = {
        {options.config, options.variant, planForEveryScene(options, sources, shaders)}};
    if (!options.variant.empty() || !checked[0].plan) return checked;
    for (const std::string& variant : variantNames(sources, requestOf(options))) {
        options.variant = variant;
        checked.push_back({options.config, variant, planForEveryScene(options, sources, shaders)});
    }
    return checked;
}

void printText(const Checked& each)
{
    report(each.plan.diagnostics(), false);
    const std::string variant = each.variant.empty() ? "" : " variant " + each.variant;
    if (each.plan)
        print("%s%s: ok (%zu passes)\n", each.config.c_str(), variant.c_str(),
              each.plan->passes.size());
    else
        print("%s%s: failed\n", each.config.c_str(), variant.c_str());
}

nlohmann::json toJson(const Checked& each)
{
    return {{"config", each.config},
            {"variant", each.variant},
            {"ok", each.plan.ok()},
            {"diagnostics", nlohmann::json::parse(toJson(each.plan.diagnostics()))}};
}

int validate(ValidateOptions options)
{
    const CheckoutSources sources(options.checkout, options.roots);
    if (options.all) options.configs = configNames(sources);
    nlohmann::json results = nlohmann::json::array();
    Diagnostics all;
    GlslCheck shaders;
    report(warnUnchecked(), false);
    for (const std::string& config : options.configs) {
        options.config = config;
        for (const Checked& each : check(options, sources, shaders)) {
            append(all, each.plan.diagnostics());
            if (!options.json) printText(each);
            results.push_back(toJson(each));
        }
    }
    if (options.json) printAsJson(results);
    return exitCodeOf(all);
}

}  // namespace

void addValidateCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("validate", "Check configs without drawing");
    auto options = std::make_shared<ValidateOptions>();
    auto* configs =
        command->add_option("CONFIG", options->configs, "Names of shipped configs, or files");
    auto* all = command->add_flag("--all", options->all, "Check every shipped config");
    configs->excludes(all);
    addConfigOptions(*command, *options);
    command->add_flag("--json", options->json, "Print results and diagnostics as JSON");
    command->footer(
        "Examples:\n"
        "  crevice validate my.json\n"
        "  crevice validate learnopengl --set radius=0.8\n"
        "  crevice validate --all --json");
    command->callback([options, all, configs, &exit_code] {
        if (all->empty() && configs->empty()) throw CLI::RequiredError("CONFIG or --all");
        exit_code = validate(*options);
    });
}

}  // namespace crevice
