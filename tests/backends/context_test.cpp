// SPDX-License-Identifier: MIT
// What contexts say when there are none, without needing one.
#include <crevice/context.h>

#include "backends/context/dynamic_library.h"
#include "tests/support/catch.h"

namespace crevice {

TEST_CASE("a backend that does not exist is refused with the nearest name")
{
    const auto context = makeContext("elg");
    REQUIRE_FALSE(context.ok());
    const Diagnostic& error = context.diagnostics()[0];
    CHECK(error.code == Code::no_backend);
    CHECK(error.help.find("egl") != std::string::npos);
    CHECK(error.help.find("osmesa") != std::string::npos);
}

TEST_CASE("a library that is missing is an error with every name tried and a way out")
{
    const auto library = openLibrary({"libno_such_1.so", "libno_such_2.so"}, Code::no_egl, "help");
    REQUIRE_FALSE(library.ok());
    const Diagnostic& error = library.diagnostics()[0];
    CHECK(error.code == Code::no_egl);
    CHECK(error.help == "help");
    REQUIRE(error.notes.size() == 2);
    CHECK(error.notes[0].text.find("libno_such_1.so") != std::string::npos);
    CHECK(error.notes[1].text.find("libno_such_2.so") != std::string::npos);
}

TEST_CASE("the first library of a list that exists is opened")
{
    const auto library = openLibrary({"libno_such_1.so", "libc.so.6"}, Code::no_egl, "help");
    REQUIRE(library.ok());
    CHECK(findSymbol(*library, "strlen"));
    CHECK_FALSE(findSymbol(*library, "no_such_function"));
}

}  // namespace crevice
