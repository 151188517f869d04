// SPDX-License-Identifier: MIT
// Compiling: the order of passes, writers and readers, cycles, and what is asked for.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

const char* const kByte = R"({"format": ["r8"]})";
const char* const kDepth = R"({"format": ["depth24"]})";

/// With these outputs asked for.
CompileOptions asking(const std::vector<std::string>& outputs)
{
    CompileOptions options = sized();
    options.outputs = outputs;
    return options;
}

}  // namespace

TEST_CASE("Passes run in the order of the data, and where that decides nothing of the document")
{
    checkEach({
        {"the order of the data",
         {{"last: b -> c", "middle: a -> b", "first: -> a"}, {{"o", "c"}}},
         "first, middle, last"},
        {"two that are ready",
         {{"right: -> r", "left: -> l", "join: l r -> x"}, {{"o", "x"}}},
         "right, left, join"},
        {"one that no output needs",
         {{"used: -> a", "no: a -> b", "end: a -> c"}, {{"o", "c"}}},
         "used, end"},
    });
}

TEST_CASE("A graph that cannot be ordered is one error for each of its mistakes")
{
    checkEach({
        {"no outputs", {{"ssao: -> ao"}, {}}, "CV2205 "},
        {"a cycle behind a pass that is in none",
         {{"start: -> s", "a: s z -> x", "b: x -> y", "c: y -> z"}, {{"o", "z"}}},
         "CV2204 /passes/a"},
        {"two cycles",
         {{"a: y -> x", "b: x -> y", "c: q -> p", "d: p -> q"}, {{"o", "x"}}},
         "CV2204 /passes/a; CV2204 /passes/c"},
        {"reading its own colour", {{"a: x -> x"}, {{"o", "x"}}}, "CV2203 /passes/a"},
        {"reading its own depth through another name",
         {{R"(a: from -> x | "type": "draw", "depth": "d", "inputs": {"from": "d"})"},
          {{"o", "x"}},
          {{"d", kDepth}}},
         "CV2203 /passes/a/inputs/from"},
        {"two writers", {{"a: -> x", "b: -> y x"}, {{"o", "x"}}}, "CV2201 /passes/b/color/1"},
        {"never written, however many read it",
         {{"a: ghost -> x", "b: ghost x -> y"}, {{"o", "y"}}, {{"ghost", kByte}}},
         "CV2202 /passes/a"},
        {"an output that is never written",
         {{"a: -> x"}, {{"o", "ghost"}}, {{"ghost", kByte}}},
         "CV2202 /outputs/o"},
        {"a mistake where no output needs it",
         {{"a: -> x", "b: typo -> y"}, {{"o", "x"}}},
         "CV5003 /passes/b/shader"},
    });
}

TEST_CASE("Mistakes of different kinds are all reported in one run")
{
    const Result<Plan> plan =
        tryCompile(describe(Sketch{{"a: typo -> x", "b: -> x", "c: q -> p", "d: p -> q"},
                                   {{"out", "x"}, {"cycle", "p"}},
                                   {{"p", kDepth}}}));
    for (const Code code :
         {Code::uniform_unbound, Code::two_writers, Code::cycle, Code::attachment_kind})
        CHECK(findDiagnostic(plan.diagnostics(), code));
    CHECK(plan.diagnostics().size() == 4);
}

TEST_CASE("A cycle is reported along the data, with the targets")
{
    const Diagnostic error = onlyError(
        describe(Sketch{{"start: -> s", "a: s z -> x", "b: x -> y", "c: y -> z"}, {{"out", "z"}}}));
    CHECK_THAT(error.message, Catch::Contains("a -> b (x) -> c (y) -> a (z)"));
    CHECK(textAt(error.place) == "\"a\"");
}

TEST_CASE("The second of two writers is refused, with a note for the first")
{
    const Diagnostic error = onlyError(describe(Sketch{{"a: -> x", "b: -> y x"}, {{"out", "x"}}}));
    REQUIRE(error.notes.size() == 1);
    CHECK(textAt(error.notes[0].place) == "\"x\"");
    CHECK(error.notes[0].place.column < error.place.column);
}

TEST_CASE("Only the outputs asked for keep passes alive, and an unknown one is refused")
{
    const Description description =
        describe(Sketch{{"ssao: -> ao", "light: ao -> lit"}, {{"ao", "ao"}, {"color", "lit"}}});
    const Plan plan = planOf(description, {}, asking({"ao"}));
    CHECK(passNames(plan) == "ssao");
    REQUIRE(plan.outputs.size() == 1);
    CHECK(plan.outputs[0].name == "ao");
    CHECK(outcome(description) == "ssao, light");
    const Diagnostic error = onlyError(description, {}, ampleCaps(), asking({"aoo"}));
    CHECK(error.code == Code::output_missing);
    CHECK_THAT(error.help, Catch::Contains("'ao'"));
}

TEST_CASE("A optimization that does not exist cannot be switched off")
{
    const Diagnostic error = onlyError(describe(Sketch{{"a: -> x"}, {{"out", "x"}}}), {},
                                       ampleCaps(), keeping("dead_pas"));
    CHECK(error.code == Code::bad_enum);
    CHECK_THAT(error.help, Catch::Contains("'dead_pass'"));
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
    std::string lifetimes;
    for (const PlanTarget& target : plan.targets)
        lifetimes += target.name + " " + std::to_string(target.first_pass) + "-" +
                     std::to_string(target.last_pass) + " ";
    CHECK(lifetimes == "x 0-2 y 1-2 z 2-3 ");
}
