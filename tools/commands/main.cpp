// SPDX-License-Identifier: MIT
// The crevice command.
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"

#include <CLI/CLI.hpp>

#include <exception>

namespace {

int usageError(const CLI::App& app, const CLI::ParseError& error)
{
    using namespace crevice;
    const auto chosen = app.get_subcommands();
    Diagnostic diagnostic{Code::usage, error.what()};
    diagnostic.help =
        "see crevice " + (chosen.empty() ? "" : chosen[0]->get_name() + " ") + "--help";
    report({diagnostic}, false);
    return kExitUsage;
}

int run(int argc, char** argv)
{
    int exit_code = crevice::kExitOk;
    CLI::App app("Screen-space ambient occlusion, driven by data.", "crevice");
    app.set_version_flag("--version", "crevice " CREVICE_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 bad input, 2 bad usage, 3 the machine lacks something,\n"
        "4 a result cannot be written, 5 over a limit, or something is wrong, 130 interrupted.\n"
        "Each command has its own --help with examples.");
    crevice::addRenderCommand(app, exit_code);
    crevice::addValidateCommand(app, exit_code);
    crevice::addExplainCommand(app, exit_code);
    crevice::addDoctorCommand(app, exit_code);
    crevice::addCompareCommand(app, exit_code);
    crevice::addReferenceCommand(app, exit_code);
    crevice::addBenchCommand(app, exit_code);
    crevice::addReportCommand(app, exit_code);
    crevice::addChooseCommand(app, exit_code);
    crevice::addCostCommand(app, exit_code);
    crevice::addSchemaCommand(app, exit_code);
    crevice::addStressCommand(app, exit_code);
    crevice::addViewCommand(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return usageError(app, error);
    }
    return exit_code;
}

}  // namespace

int main(int argc, char** argv)
{
    // The project's own code does not throw; the libraries that read scenes and arguments may.
    crevice::reserveStreams();
    try {
        return crevice::finishOutput(run(argc, argv));
    } catch (const std::exception& error) {
        return crevice::report({{crevice::Code::internal, error.what()}}, false);
    }
}
