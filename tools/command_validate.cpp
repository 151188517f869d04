// SPDX-License-Identifier: MIT
// crevice validate: reads, decodes and plans configs with no GL at all.
#include "tools/cli_output.h"
#include "tools/commands.h"
#include "tools/config_options.h"
#include "tools/planning.h"

#include "core/load.h"

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

int validate(ValidateOptions options)
{
    const CheckoutSources sources(options.checkout);
    if (options.all) options.configs = configNames(sources);
    int exit_code = kExitOk;
    nlohmann::json results = nlohmann::json::array();
    for (const std::string& config : options.configs) {
        options.config = config;
        const Result<Plan> plan = planWithoutDevice(options, sources);
        if (exit_code == kExitOk) exit_code = exitCodeOf(plan.diagnostics());
        if (options.json) {
            results.push_back({{"config", config},
                               {"ok", plan.ok()},
                               {"diagnostics", nlohmann::json::parse(toJson(plan.diagnostics()))}});
            continue;
        }
        report(plan.diagnostics(), false);
        if (plan)
            std::printf("%s: ok (%zu passes)\n", config.c_str(), plan->passes.size());
        else
            std::printf("%s: failed\n", config.c_str());
    }
    if (options.json) std::puts(results.dump(2).c_str());
    return exit_code;
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
    command->add_flag("--json", options->json, "Print the results as JSON");
    command->footer("Examples:\n"
                    "  crevice validate my.json\n"
                    "  crevice validate learnopengl --set radius=0.8\n"
                    "  crevice validate --all --json");
    command->callback([options, all, configs, &exit_code] {
        if (all->empty() && configs->empty())
            throw CLI::RequiredError("CONFIG or --all");
        exit_code = validate(*options);
    });
}

}  // namespace crevice
