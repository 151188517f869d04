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
    for (const Code code : {Code::no_egl, Code::no_osmesa, Code::gl_function, Code::gl_version,
                            Code::no_format, Code::out_of_memory, Code::no_backend})
        CHECK(exitCodeOf({{code, "x"}}) == kExitMachine);
    for (const Code code : {Code::bad_size, Code::too_big_for_device, Code::scene_missing,
                            Code::shader_compile, Code::syntax, Code::image_size})
        CHECK(exitCodeOf({{code, "x"}}) == kExitBadInput);
}
