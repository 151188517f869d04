// SPDX-License-Identifier: MIT
// Driver logs become diagnostics in the author's files.
#include <crevice/glsl_stage.h>

#include "tests/support/catch.h"

using namespace crevice;

namespace {

SourceRef textOf(const std::string& name, const std::string& text)
{
    return std::make_shared<SourceText>(SourceText{name, text});
}

/// Two files: what `main` includes is file 1.
GlslStage twoFiles()
{
    const std::string main =
        "#version 300 es\n#include \"b.glsl\"\nout float x;\nvoid main() {\n"
        "    /* why */ x = foo + foobar;   x = ;\n}\n";
    Result<GlslStage> stage =
        assembleStage({{"main", textOf("main.frag", main)},
                       {"b.glsl", textOf("b.glsl", "\nfloat f() { return bar; }\n")}},
                      {}, "main", {});
    REQUIRE(stage.ok());
    return *stage;
}

Diagnostics explain(const std::string& log)
{
    return explainLog(twoFiles(), Code::shader_compile, log);
}

/// The only diagnostic, as "file:line:column+length message".
std::string only(const std::string& log)
{
    const Diagnostics diagnostics = explain(log);
    REQUIRE(diagnostics.size() == 1);
    const Diagnostic& one = diagnostics[0];
    CHECK(one.code == Code::shader_compile);
    return placeName(one.place) + "+" + std::to_string(one.place.length) + " " + one.message;
}

}  // namespace

TEST_CASE("each vendor's error is found at the author's line")
{
    const char* const kLogs[] = {
        "0:5(16): error: `foo' undeclared\n",
        "0(5) : error C1503: undefined variable \"foo\"\n",
        "ERROR: 0:5: 'foo' : undeclared identifier\n",
        "0:5: L0001: Undefined variable 'foo'\n",
        "0:5: error: 'foo' undeclared.\r\n",
        "0:5(3): preprocessor error: 'foo' is bad",
    };
    for (const char* log : kLogs) {
        const std::string found = only(log);
        INFO(found);
        CHECK(found.find("main.frag:5:19+3 ") == 0);
        CHECK(found.find("foo") != std::string::npos);
        CHECK(found.find("rror:") == std::string::npos);
        CHECK(found.back() != '.');
    }
    CHECK(only(kLogs[1]) == "main.frag:5:19+3 'foo' is not declared");
}

TEST_CASE("an error in an included file is found there, whichever source string the driver gives")
{
    const std::string text = twoFiles().text;
    CHECK(text.find("#line 100001 1\n") != std::string::npos);
    for (const char* log :
         {"0:100002(20): error: `bar' undeclared", "1:100002(20): error: `bar' undeclared",
          "1(100002) : error C1503: undefined variable \"bar\"",
          "ERROR: 1:100002: 'bar' : undeclared identifier"})
        CHECK(only(log).find("b.glsl:2:20+3 ") == 0);
}

TEST_CASE("a driver's warning stays a warning")
{
    for (const char* log : {"0:5(16): warning: `foo' used uninitialized",
                            "0(5) : warning C7050: \"foo\"", "WARNING: 0:5: 'foo' : unused"}) {
        const Diagnostics diagnostics = explain(log);
        REQUIRE(diagnostics.size() == 1);
        CHECK(diagnostics[0].severity == Severity::warning);
        CHECK(diagnostics[0].place.line == 5);
    }
}

TEST_CASE("each message of a log is a diagnostic, and what Mesa indents belongs to the one before")
{
    const Diagnostics diagnostics = explain(
        "0:5(1): error: no matching function for call to `g(int)'; candidates are:\n"
        "0:5(1): error:    float g(float)\n"
        "0:5(1): error:    float g(vec2)\n"
        "0:3(1): error: second\n");
    REQUIRE(diagnostics.size() == 2);
    CHECK(diagnostics[0].message ==
          "no matching function for call to `g(int)'; candidates are: "
          "float g(float); float g(vec2)");
    CHECK(diagnostics[1].message == "second");
    CHECK(diagnostics[1].place.line == 3);
}

TEST_CASE("places that are not in the text do no harm")
{
    CHECK(only("7:3: error: odd").find("main.frag+1 odd") == 0);
    CHECK(only("0:999: error: odd").find("main.frag:999+1 odd") == 0);
    CHECK(only("0:0: error: odd").find("main.frag+1 odd") == 0);
    CHECK(only("0:2147483647(2147483647): error: 'odd'").find("main.frag") == 0);
    CHECK(explainLog({}, Code::shader_link, "0:5: error: odd").size() == 1);
    for (const char* log : {"0", "0:", "0:5", "0(5", "0(5)", "error", "error:", ":", "'", "0:5(1)"})
        CHECK(explain(log).size() == 1);
}
