// SPDX-License-Identifier: MIT
// Compiling: the order of passes, writers and readers, cycles, and what is asked for.
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

const char* const kByte = R"({"format": ["r8"]})";
const char* const kDepth = R"({"format": ["depth24"]})";

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
        {"a cycle behind a pass that is in none",
         {{"start: -> s", "a: s z -> x", "b: x -> y", "c: y -> z"}, {{"o", "z"}}},
         "CV2204 /passes/a"},
        {"two cycles",
         {{"a: y -> x", "b: x -> y", "c: q -> p", "d: p -> q"}, {{"o", "x"}}},
         "CV2204 /passes/a; CV2204 /passes/c"},
        {"reading its own depth through another name",
         {{R"(a: from -> x | "type": "draw", "depth": "d", "inputs": {"from": "d"})"},
          {{"o", "x"}},
          {{"d", kDepth}}},
         "CV2203 /passes/a/inputs/from"},
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
    CHECK(outcome(description) == "ssao, light");
}
