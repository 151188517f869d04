// SPDX-License-Identifier: MIT
// The subcommands of crevice. Each adds itself to the command line; when it is chosen it runs and
// leaves an ExitCode of tools/commands/cli/output.h in `exit_code`.
#pragma once

namespace CLI {
class App;
}

namespace crevice {

void addRenderCommand(CLI::App& app, int& exit_code);
void addValidateCommand(CLI::App& app, int& exit_code);
void addExplainCommand(CLI::App& app, int& exit_code);
void addDoctorCommand(CLI::App& app, int& exit_code);
void addCompareCommand(CLI::App& app, int& exit_code);
void addReferenceCommand(CLI::App& app, int& exit_code);
void addBenchCommand(CLI::App& app, int& exit_code);
void addReportCommand(CLI::App& app, int& exit_code);
void addChooseCommand(CLI::App& app, int& exit_code);
void addCostCommand(CLI::App& app, int& exit_code);
void addSchemaCommand(CLI::App& app, int& exit_code);
void addStressCommand(CLI::App& app, int& exit_code);
void addTestCommand(CLI::App& app, int& exit_code);
void addBakeCommand(CLI::App& app, int& exit_code);
void addViewCommand(CLI::App& app, int& exit_code);
void addLookCommands(CLI::App& app, int& exit_code);

}  // namespace crevice
