// SPDX-License-Identifier: MIT
// crevice validate: reads, decodes and plans configs with no GL at all.
#include "tools/cli_output.h"
#include "tools/commands.h"
#include "tools/config_options.h"
#include "tools/planning.h"
#include "tools/sarif.h"

#include "core/load.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace crevice {
namespace {

struct ValidateOptions : ConfigOptions {
    std::vector<std::string> configs;
    bool all = false;
    std::string format = "text";
};

void printText(const std::string& config, const Result<Plan>& plan)
{
    report(plan.diagnostics(), false);
    if (plan)
        std::printf("%s: ok (%zu passes)\n", config.c_str(), plan->passes.size());
    else
        std::printf("%s: failed\n", config.c_str());
}

int validate(ValidateOptions options)
{
    const CheckoutSources sources(options.checkout);
    if (options.all) options.configs = configNames(sources);
    nlohmann::json results = nlohmann::json::array();
    Diagnostics all;
    for (const std::string& config : options.configs) {
        options.config = config;
        const Result<Plan> plan = planWithoutDevice(options, sources);
        append(all, plan.diagnostics());
        if (options.format == "text") printText(config, plan);
        results.push_back({{"config", config},
                           {"ok", plan.ok()},
                           {"diagnostics", nlohmann::json::parse(toJson(plan.diagnostics()))}});
    }
    if (options.format == "json") std::puts(results.dump(2).c_str());
    if (options.format == "sarif") std::fputs(toSarif(all, CREVICE_VERSION).c_str(), stdout);
    return exitCodeOf(all);
}

}  // namespace

void addValidateCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("validate", "Check configs without drawing");
    auto options = std::make_shared<ValidateOptions>();
    auto* configs = command->add_option("CONFIG", options->configs, "Names of shipped configs, or files");
    auto* all = command->add_flag("--all", options->all, "Check every shipped config");
    configs->excludes(all);
    addConfigOptions(*command, *options);
    auto* format = command->add_option("--format", options->format,
                                       "text, json, or sarif (SARIF 2.1.0, for editors and CI)")
                       ->check(CLI::IsMember({"text", "json", "sarif"}))
                       ->capture_default_str();
    command
        ->add_flag_callback(
            "--json", [options] { options->format = "json"; }, "The same as --format json")
        ->excludes(format);
    command->footer("Examples:\n"
                    "  crevice validate my.json\n"
                    "  crevice validate learnopengl --set radius=0.8\n"
                    "  crevice validate --all --format sarif > configs.sarif");
    command->callback([options, all, configs, &exit_code] {
        if (all->empty() && configs->empty())
            throw CLI::RequiredError("CONFIG or --all");
        exit_code = validate(*options);
    });
}

}  // namespace crevice
