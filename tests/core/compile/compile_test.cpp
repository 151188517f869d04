// SPDX-License-Identifier: MIT
// Compiling: the order of passes, writers and readers, cycles, and what is asked for.
#include "tests/support/plan_rig.h"

using namespace crevice;

TEST_CASE("Passes run in the order of the data, whatever the order of the document")
{
    const Plan plan =
        planOf(describe(Sketch{{"last: b -> c", "middle: a -> b", "first: -> a"}, {{"out", "c"}}}));
    CHECK(passNames(plan) == "first, middle, last");
}

TEST_CASE("Among passes that are ready the document's order decides")
{
    const Plan plan = planOf(
        describe(Sketch{{"right: -> r", "left: -> l", "join: l r -> both"}, {{"out", "both"}}}));
    CHECK(passNames(plan) == "right, left, join");
}

TEST_CASE("A pass that no output needs is left out with what it would cost")
{
    const Plan plan =
        planOf(describe(Sketch{{"used: -> a", "unused: a -> b", "end: a -> c"}, {{"out", "c"}}}));
    CHECK(passNames(plan) == "used, end");
    const Elided* left = elided(plan, "pass unused");
    REQUIRE(left);
    CHECK(left->optimization == "dead_pass");
}

TEST_CASE("Only the outputs asked for keep passes alive")
{
    const Description description =
        describe(Sketch{{"ssao: -> ao", "light: ao -> lit"}, {{"ao", "ao"}, {"color", "lit"}}});
    CompileOptions options = sized();
    options.outputs = {"ao"};
    const Plan plan = planOf(description, {}, options);
    CHECK(passNames(plan) == "ssao");
    REQUIRE(plan.outputs.size() == 1);
    CHECK(plan.outputs[0].name == "ao");
    CHECK(passNames(planOf(description)) == "ssao, light");
}

TEST_CASE("An unknown output is refused with the nearest name")
{
    const Description description = describe(Sketch{{"ssao: -> ao"}, {{"ao", "ao"}}});
    CompileOptions options = sized();
    options.outputs = {"aoo"};
    const Diagnostic error = onlyError(description, {}, ampleCaps(), options);
    CHECK(error.code == Code::output_missing);
    CHECK(error.help.find("'ao'") != error.help.npos);
}

TEST_CASE("A config without outputs is refused")
{
    const Diagnostic error = onlyError(describe(Sketch{{"ssao: -> ao"}, {}}));
    CHECK(error.code == Code::no_outputs);
}

TEST_CASE("A optimization that does not exist cannot be switched off")
{
    CompileOptions options = sized();
    options.disable = {"dead_pas"};
    const Diagnostic error =
        onlyError(describe(Sketch{{"a: -> x"}, {{"out", "x"}}}), {}, ampleCaps(), options);
    CHECK(error.code == Code::bad_enum);
    CHECK(error.help.find("'dead_pass'") != error.help.npos);
}

TEST_CASE("A cycle is reported along the data, with the targets")
{
    const Diagnostic error = onlyError(
        describe(Sketch{{"start: -> s", "a: s z -> x", "b: x -> y", "c: y -> z"}, {{"out", "z"}}}));
    CHECK(error.code == Code::cycle);
    CHECK(error.message.find("a -> b (x) -> c (y) -> a (z)") != error.message.npos);
    CHECK(error.pointer == "/passes/a");
    CHECK(textAt(error.place) == "\"a\"");
}

TEST_CASE("Two cycles are two errors")
{
    const Result<Plan> plan = tryCompile(
        describe(Sketch{{"a: y -> x", "b: x -> y", "c: q -> p", "d: p -> q"}, {{"out", "x"}}}));
    REQUIRE(plan.diagnostics().size() == 2);
    CHECK(plan.diagnostics()[0].pointer == "/passes/a");
    CHECK(plan.diagnostics()[1].pointer == "/passes/c");
}

TEST_CASE("A pass that reads what it writes is refused")
{
    SECTION("as colour")
    {
        const Diagnostic error = onlyError(describe(Sketch{{"a: x -> x"}, {{"out", "x"}}}));
        CHECK(error.code == Code::reads_own_output);
        CHECK(error.pointer == "/passes/a");
    }
    SECTION("as depth, through another name")
    {
        const Diagnostic error = onlyError(describe(
            Sketch{{R"(a: from -> x | "type": "draw", "depth": "d", "inputs": {"from": "d"})"},
                   {{"out", "x"}},
                   {{"d", R"({"format": ["depth24"]})"}}}));
        CHECK(error.code == Code::reads_own_output);
        CHECK(error.pointer == "/passes/a/inputs/from");
        CHECK(textAt(error.place) == "\"d\"");
    }
}

TEST_CASE("The second of two writers is refused, with a note for the first")
{
    const Diagnostic error = onlyError(describe(Sketch{{"a: -> x", "b: -> y x"}, {{"out", "x"}}}));
    CHECK(error.code == Code::two_writers);
    CHECK(error.pointer == "/passes/b/color/1");
    REQUIRE(error.notes.size() == 1);
    CHECK(textAt(error.notes[0].place) == "\"x\"");
    CHECK(error.notes[0].place.column < error.place.column);
}

TEST_CASE("A target that no pass writes is one error, however many read it")
{
    const Diagnostic error = onlyError(describe(Sketch{{"a: ghost -> x", "b: ghost x -> y"},
                                                       {{"out", "y"}},
                                                       {{"ghost", R"({"format": ["r8"]})"}}}));
    CHECK(error.code == Code::never_written);
    CHECK(error.pointer == "/passes/a");
}

TEST_CASE("An output of a target that no pass writes is refused at the output")
{
    const Diagnostic error = onlyError(
        describe(Sketch{{"a: -> x"}, {{"out", "ghost"}}, {{"ghost", R"({"format": ["r8"]})"}}}));
    CHECK(error.code == Code::never_written);
    CHECK(error.pointer == "/outputs/out");
}

TEST_CASE("A broken pass is reported even where no output needs it")
{
    const Diagnostic error =
        onlyError(describe(Sketch{{"a: -> x", "b: typo -> y"}, {{"out", "x"}}}));
    CHECK(error.code == Code::uniform_unbound);
}

TEST_CASE("Mistakes of different kinds are all reported in one run")
{
    const Result<Plan> plan =
        tryCompile(describe(Sketch{{"a: typo -> x", "b: -> x", "c: q -> p", "d: p -> q"},
                                   {{"out", "x"}, {"cycle", "p"}},
                                   {{"p", R"({"format": ["depth24"]})"}}}));
    CHECK(findDiagnostic(plan.diagnostics(), Code::uniform_unbound));
    CHECK(findDiagnostic(plan.diagnostics(), Code::two_writers));
    CHECK(findDiagnostic(plan.diagnostics(), Code::cycle));
    CHECK(findDiagnostic(plan.diagnostics(), Code::attachment_kind));
    CHECK(plan.diagnostics().size() == 4);
}

TEST_CASE("The same input gives the same plan, and is left as it was")
{
    const Description description =
        describe(Sketch{{"a: -> x y", "b: x -> z", "c: y z -> w"}, {{"out", "w"}, {"mid", "z"}}});
    const Description copy = description;
    const std::string first = toJson(planOf(description));
    CHECK(first == toJson(planOf(copy)));
    CHECK(first == toJson(planOf(description)));
}

TEST_CASE("Lifetimes begin at the writer and end at the last reader or never")
{
    const Plan plan =
        planOf(describe(Sketch{{"a: -> x", "b: x -> y", "c: x y -> z"}, {{"out", "z"}}}));
    REQUIRE(plan.targets.size() == 3);
    CHECK(plan.targets[0].first_pass == 0);
    CHECK(plan.targets[0].last_pass == 2);
    CHECK(plan.targets[1].first_pass == 1);
    CHECK(plan.targets[1].last_pass == 2);
    CHECK(plan.targets[2].last_pass == 3);
}
