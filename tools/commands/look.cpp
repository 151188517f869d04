// SPDX-License-Identifier: MIT
// crevice inspect, list and params: what there is in a scene, to choose, and to set in a config.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/print.h"
#include "tools/show/schema/schema.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

struct LookOptions : ConfigOptions {  // `config` is what is looked at, a scene or a kind too
    ImportOptions import = {};
    bool json = false;
};

Result<nlohmann::ordered_json> look(std::string_view command, const LookOptions& options)
{
    const CheckoutSources sources(options.checkout, options.roots);
    if (command == "inspect") return inspectScene(options.config, options.import);
    if (command == "list") return listJson(sources, kBuiltinScenes, options.config);
    return settingsJson(sources, requestOf(options));
}

}  // namespace

void addLookCommands(CLI::App& app, int& exit_code)
{
    const auto options = std::make_shared<LookOptions>();  // of the one that is chosen
    const auto add = [&](auto name, auto about, auto at, auto is, auto example) {
        CLI::App* command = app.add_subcommand(name, about);
        command->add_option(at, options->config, is)->required(name != std::string_view("list"));
        command->footer(std::string("Example:\n  crevice ") + example);
        command->add_flag("--json", options->json, "Print it as JSON");
        command->callback([options, name, &exit_code] {
            const Result<nlohmann::ordered_json> found = look(name, *options);
            if (!found) exit_code = report(found.diagnostics(), options->json);
            if (found) options->json ? printAsJson(*found) : printTables(*found);
        });
        return command;
    };
    CLI::App* command = add("inspect", "Show what there is in a scene", "SCENE", "A file or name",
                            "inspect model.glb");
    addImportOptions(*command, options->import);
    command = add("list", "Show which configs, modules and scenes there are", "KIND",
                  "configs, estimators, filters, modules or scenes; or all", "list filters");
    addCheckoutOption(*command, options->checkout);
    command = add("params", "Show what there is to set in a config", "CONFIG",
                  "A shipped config's name, or a file", "params gtao --set radius=5%");
    addConfigOptions(*command, *options);
}

}  // namespace crevice
