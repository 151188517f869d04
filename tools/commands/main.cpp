// SPDX-License-Identifier: MIT
// The crevice command.
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"

#include <CLI/CLI.hpp>

#include <exception>

namespace {

/// What there was once, and what there is instead.
constexpr std::pair<const char*, const char*> kGone[] = {
    {"compare-bench", "write crevice report FOLDER --against FOLDER"},
    {"--ablate", "write --disable"},
    {"--diff", "write diff <(crevice explain ONE) <(crevice explain OTHER)"},
    {"--reference", "write crevice reference"},
};

/// Whether it begins with one of the long dashes that word processors make of two hyphens.
bool hasLongDash(const std::string& word)
{
    const std::string_view start = std::string_view(word).substr(0, 3);
    return crevice::contains({"\u2010", "\u2011", "\u2012", "\u2013", "\u2014", "\u2212"}, start);
}

/// Says of arguments in the wrong place where they belong.
void nameMisplaced(const CLI::App& app, const std::vector<std::string>& arguments,
                   crevice::Diagnostic& error)
{
    const std::vector<std::string> left = app.remaining();
    const auto dash = std::find_if(arguments.begin(), arguments.end(), hasLongDash);
    if (dash != arguments.end()) {
        error.message = "'" + *dash + "' begins with a long dash";
        error.help = "write two hyphens: --" + dash->substr(3);
    } else if (arguments[0] != app.get_name() && arguments[0][0] != '-') {
        error.message = "'" + arguments[0] + "' stands before the command";
        error.help = "the command comes first: crevice " + app.get_name() + " " + arguments[0];
    } else if (left.size() == 1 && left[0][0] != '-') {
        const auto at = std::find(arguments.begin(), arguments.end(), left[0]);
        const bool value = at != arguments.begin() && at[-1] == "--host-depth";
        if (at - arguments.begin() > 1 && at[-2] == "--set")
            error.help = "write --set " + at[-1] + "=" + left[0] + "; " + error.help;
        else if (at != arguments.begin() && crevice::isDigit(at[-1].back()))
            error.help = "write the unit behind the number, as one word: " + at[-1] +
                         at->substr(0, 1) + "; " + error.help;
        else if (value || app.get_option_no_throw("--config"))
            error.help =
                "write " + (value ? at[-1] + "=" : "--config ") + left[0] + "; " + error.help;
    }
}

/// Says of the first argument that is no command or option of `app` which was meant.
void nameUnknown(const CLI::App& app, const std::vector<std::string>& arguments,
                 crevice::Diagnostic& error)
{
    std::vector<std::string> commands, options;
    for (const CLI::App* each : app.get_subcommands(nullptr)) commands.push_back(each->get_name());
    for (const CLI::Option* each : app.get_options())
        for (const std::string& name : each->get_lnames()) options.push_back("--" + name);
    for (const std::string& argument : arguments) {
        const std::string word = argument.substr(0, argument.find('='));
        const bool option = word.size() > 2 && word[0] == '-' && !crevice::isDigit(word[1]);
        const std::vector<std::string>& known = option ? options : commands;
        if (known.empty() || crevice::contains(known, word)) continue;
        const std::string what = option ? "option" : "command";
        const auto* gone = std::find_if(std::begin(kGone), std::end(kGone),
                                        [&](const auto& each) { return each.first == word; });
        error.message = "there is no " + what + " '" + word + "'";
        error.help = (gone != std::end(kGone) ? gone->second
                                              : crevice::suggestName(word, known, what + "s")) +
                     "; " + error.help;
        return;
    }
}

int usageError(const CLI::App& app, const CLI::ParseError& error,
               const std::vector<std::string>& arguments)
{
    using namespace crevice;
    const auto chosen = app.get_subcommands();
    Diagnostic diagnostic{Code::usage, error.what()};
    diagnostic.help =
        "see crevice " + (chosen.empty() ? "" : chosen[0]->get_name() + " ") + "--help";
    if (startsWith(diagnostic.message, "Could not convert"))
        diagnostic.help = "a number is wanted, without a unit; " + diagnostic.help;
    nameUnknown(chosen.empty() ? app : *chosen[0], arguments, diagnostic);
    if (!chosen.empty()) nameMisplaced(*chosen[0], arguments, diagnostic);
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
    using namespace crevice;
    for (const auto add :
         {addRenderCommand, addValidateCommand, addExplainCommand, addDoctorCommand,
          addCompareCommand, addReferenceCommand, addBenchCommand, addReportCommand,
          addChooseCommand, addCostCommand, addSchemaCommand, addStressCommand, addTestCommand,
          addBakeCommand, addViewCommand, addLookCommands})
        add(app, exit_code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return usageError(app, error, {argv + 1, argv + argc});
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
