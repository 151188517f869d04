// SPDX-License-Identifier: MIT
#include "tools/commands/cli/run_program.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>

using namespace crevice;

namespace {

/// Runs a shell script of these lines.
ProgramRun runScript(const std::string& lines, const std::string& input = {}, double time_s = 20)
{
    const TemporaryFolder folder("run_program");
    const std::string path = folder.write("script", "#!/bin/sh\n" + lines + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return runProgram(path, {"CREVICE_WORD=said so"}, input, time_s);
}

}  // namespace

TEST_CASE("A program gets its input and variables, and what it prints comes back in order")
{
    const ProgramRun run = runScript(
        "cat; echo \"$CREVICE_WORD\" >&2; echo \"${PATH:+a path}\"; exit 3", "some\ntext\n");
    CHECK(run.ended);
    CHECK(run.exit_code == 3);
    CHECK(run.output == "some\ntext\nsaid so\na path\n");
}

TEST_CASE("A program that prints much before it reads blocks nobody")
{
    const std::string input(1 << 20, 'x');
    const ProgramRun run = runScript("head -c 1000000 /dev/zero | tr '\\0' y; cat", input);
    CHECK(run.ended);
    CHECK(run.output.size() == 1000000 + input.size());
}

TEST_CASE("A program that hangs, crashes or is not there is told from one that ends")
{
    const ProgramRun late = runScript("exec sleep 60", "", 0.2);
    CHECK_FALSE(late.ended);
    CHECK(late.failure == "it ran for more than 0.2 s");
    const ProgramRun crashed = runScript("echo so far; kill -9 $$");
    CHECK_FALSE(crashed.ended);
    CHECK(crashed.failure == "it was ended by signal 9");
    CHECK(crashed.output == "so far\n");
    const ProgramRun missing = runProgram("/nowhere/at all", {}, "", 5);
    CHECK_FALSE(missing.ended);
    CHECK(missing.failure == "it cannot be started: No such file or directory");
}
