// SPDX-License-Identifier: MIT
// crevice validate: reads, decodes and plans configs, and compiles their shaders, with no GL.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

struct ValidateOptions : ConfigOptions {
    std::vector<std::string> configs;
    std::string size = "960x540";
    bool all = false;
    bool json = false;
};

/// One config, or one of its variants.
struct Checked {
    std::string config;
    std::string variant;
    Result<Plan> plan;
};

/// Tells of the config, and where no variant was asked for and it is right, of each of its
/// variants, as soon as that is known: many take minutes.
void check(const ValidateOptions& options, Extent extent, const SourceSet& sources,
           GlslCheck& shaders, const std::function<void(const Checked&)>& tell)
{
    bool broken = false;
    ConfigOptions config = options;
    const auto plan = [&](const std::string& variant) {
        if (broken) return;
        config.variant = variant;
        const auto description = loadDescription(config, sources);
        const Checked checked = {options.config, variant,
                                 planForEveryScene(description, variant, extent, shaders)};
        broken = variant.empty() && !checked.plan;
        tell(checked);
    };
    plan(options.variant);
    if (options.variant.empty())
        for (const std::string& variant : variantNames(sources, requestOf(options))) plan(variant);
}

/// What was said before, of the config or of another variant, is not said again.
void printText(const Checked& each, const std::string& size, std::set<std::string>& said)
{
    Diagnostics fresh = each.plan.diagnostics();
    const auto known = [&](const Diagnostic& it) { return !said.insert(toText(it)).second; };
    fresh.erase(std::remove_if(fresh.begin(), fresh.end(), known), fresh.end());
    report(fresh, false);
    const std::string variant = each.variant.empty() ? "" : " variant " + each.variant;
    if (each.plan)
        print("%s%s: ok (%zu passes, %s of textures at %s)\n", each.config.c_str(), variant.c_str(),
              each.plan->passes.size(), bytesText(each.plan->texture_bytes).c_str(), size.c_str());
    else
        print("%s%s: failed\n", each.config.c_str(), variant.c_str());
}

nlohmann::json toJson(const Checked& each)
{
    return {{"config", each.config},
            {"variant", each.variant},
            {"ok", each.plan.ok()},
            {"texture_bytes", each.plan ? each.plan->texture_bytes : 0},
            {"diagnostics", nlohmann::json::parse(toJson(each.plan.diagnostics()))}};
}

int validate(ValidateOptions options)
{
    const Result<Extent> extent = parseSize(options.size);
    if (!extent) return report(extent.diagnostics(), options.json);
    const CheckoutSources sources(options.checkout, options.roots);
    if (options.all) options.configs = configNames(sources);
    nlohmann::json results = nlohmann::json::array();
    Diagnostics all;
    GlslCheck shaders;
    report(warnUnchecked(), false);
    for (const std::string& config : options.configs) {
        options.config = config;
        std::set<std::string> said;
        check(options, *extent, sources, shaders, [&](const Checked& each) {
            append(all, each.plan.diagnostics());
            if (!options.json) return printText(each, options.size, said);
            results.push_back(toJson(each));
        });
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
    addText(*command, "--size", options->size, "WxH", "Pixels of the picture that is planned for");
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
