// SPDX-License-Identifier: MIT
// crevice schema: the config format for editors, as JSON Schema, and for readers, as Markdown.
#include "tools/show/schema/schema.h"
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/scene/file/import.h"

#include <CLI/CLI.hpp>

namespace crevice {

void addSchemaCommand(CLI::App& app, int& exit_code)
{
    struct Options {
        std::string format = "json";
        std::string checkout;
    };
    CLI::App* command = app.add_subcommand("schema",
                                           "Print the config format: every key with its type, "
                                           "default and range");
    auto options = std::make_shared<Options>();
    command
        ->add_option("--format", options->format,
                     "json: a JSON Schema (draft 7) for editors; markdown: tables for readers; "
                     "scenes: what is read of scene files")
        ->check(CLI::IsMember({"json", "markdown", "scenes"}))
        ->capture_default_str();
    addCheckoutOption(*command, options->checkout);
    command->footer(
        "Examples:\n"
        "  crevice schema > crevice.schema.json\n"
        "  crevice schema --format markdown");
    command->callback([options, &exit_code] {
        const CheckoutSources sources(options->checkout);
        const std::string& format = options->format;
        printLines(format == "json"       ? schemaJson(sources)
                   : format == "markdown" ? schemaMarkdown()
                                          : gltfTables() + "\n" + mtlTable());
        exit_code = kExitOk;
    });
}

}  // namespace crevice
