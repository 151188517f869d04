// SPDX-License-Identifier: MIT
// Which exit code a list of diagnostics stands for.
#include "tests/support/catch.h"

#include "tools/commands/cli/output.h"

using namespace crevice;

namespace {

Diagnostic warningOf(Code code)
{
    Diagnostic warning{code, "something"};
    warning.severity = Severity::warning;
    return warning;
}

}  // namespace

TEST_CASE("the first error chooses the exit code, whatever warnings stand before it")
{
    const Diagnostic input{Code::unknown_key, "a"};
    const Diagnostic machine{Code::no_egl, "b"};
    CHECK(exitCodeOf({}) == kExitOk);
    CHECK(exitCodeOf({warningOf(Code::no_format)}) == kExitOk);
    CHECK(exitCodeOf({warningOf(Code::no_egl), input, machine}) == kExitBadInput);
    CHECK(exitCodeOf({machine, input}) == kExitMachine);
    CHECK(exitCodeOf({{Code::usage, "x"}}) == kExitUsage);
    CHECK(exitCodeOf({{Code::cannot_write, "x"}}) == kExitOutput);
}
