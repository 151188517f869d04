// SPDX-License-Identifier: MIT
// Sums, what counts as worse, and what is written and read again: on figures made up here.
#include "tests/support/need.h"
#include "tools/measure/cost/check.h"

#include <crevice/shipped.h>

#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

CompilerFigures figures(int instructions, int spills, int threads, double cycles)
{
    CompilerFigures made;
    made.instructions = instructions;
    made.spills = spills;
    made.fills = 2 * spills;
    made.threads = threads;
    made.code_bytes = 16 * instructions;
    made.cycles = cycles;
    made.unit_cycles = {cycles, 0, 0, 0, 0, cycles / 2};
    return made;
}

PassCost pass(const char* name, PassRole role, double pixels, double fetches,
              const CompilerFigures& each)
{
    PassCost made;
    made.pass = name;
    made.role = role;
    made.extent = {64, 32};
    made.pixels = pixels;
    made.bytes = {100, 40, 60};
    if (role != PassRole::geometry_for_ao) made.fetches = fetches;
    made.figures = {each};
    return made;
}

/// One config: half-size AO, a filter, back faces and lighting.
CostReport report()
{
    CostReport made;
    made.scene = "room";
    made.extent = {128, 64};
    made.camera = "eye=4,2,6";
    made.variant = "fast";
    made.set = {"radius=0.5"};
    made.version = "Mesa 22.3.6";
    made.gpus = {findCostGpu("Mali-G57")};
    made.configs.resize(1);
    made.configs[0].config = "some";
    made.configs[0].geometry_bytes_for_ao = 1000;
    made.configs[0].passes = {
        pass("ssao", PassRole::ao, 0.25, 8, figures(400, 3, 1, 40)),
        pass("filter", PassRole::ao, 1, 5, figures(100, 0, 2, 4)),
        pass("back_faces", PassRole::geometry_for_ao, 1, 0, figures(10, 0, 2, 0.5)),
        pass("lighting", PassRole::picture, 1, 3, figures(300, 0, 2, 12))};
    return made;
}

/// How many figures are worse than `report()` once `change` has been at its config.
template <class Change>
std::size_t worse(Change&& change)
{
    CostReport now = report();
    change(now.configs[0]);
    return compareCosts(report(), now).worse.size();
}

std::vector<PassRole> rolesOf(const char* config)
{
    ConfigOptions options;
    options.config = config;
    return passRoles(need(planWithoutDevice(options, CheckoutSources(""))));
}

}  // namespace

TEST_CASE("The cost of AO is that of its passes, each for its share of the picture's pixels")
{
    const CostReport made = report();
    const CostSum alone = sumOfAo(made, made.configs[0], false);
    CHECK(alone.passes == 2);
    CHECK(alone.fetches == 13.0);
    CHECK(alone.bytes.written == 120);
    CHECK(alone.gpus[0].instructions == 500);
    CHECK(alone.gpus[0].spills == 3);
    CHECK(alone.gpus[0].fills == 6);
    CHECK(alone.gpus[0].threads == 1);
    CHECK(alone.gpus[0].cycles == 40 * 0.25 + 4);
    const CostSum all = sumOfAo(made, made.configs[0], true);
    CHECK(all.passes == 3);
    CHECK(all.fetches == 13.0);
    CHECK(all.bytes.written == 1180);
    CHECK(all.gpus[0].cycles == 14.5);
}

TEST_CASE("Spills, lost occupancy and a tenth more of anything are worse, and less is not")
{
    CHECK(worse([](ConfigCost&) {}) == 0);
    CHECK(worse([](ConfigCost& now) { now.passes[1].figures[0].spills = 1; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[1].figures[0].threads = 1; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[0].figures[0].fills *= 2; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[0].figures[0].instructions = 445; }) == 0);
    CHECK(worse([](ConfigCost& now) { now.passes[0].figures[0].instructions = 460; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[0].figures[0].cycles = 50; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[1].fetches = 7; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[2].figures[0].instructions = 100; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[3].figures[0] = figures(900, 9, 1, 90); }) == 0);
    CHECK(worse([](ConfigCost& now) { now.passes[1].figures[0].refusal = "no"; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.uncounted = "no context"; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.config = "other"; }) == 1);
    CHECK(worse([](ConfigCost& now) { now.passes[0].figures[0] = figures(200, 0, 2, 9); }) == 0);
    CHECK(worse([](ConfigCost& now) { now.passes.erase(now.passes.begin()); }) == 0);
}

TEST_CASE("A pass of a new name may do what some pass of its config did")
{
    const auto renamed = [](ConfigCost& now) { now.passes[1].pass = "blur"; };
    CHECK(worse(renamed) == 0);
    CHECK(worse([&](ConfigCost& now) {
              renamed(now);
              now.passes[1].figures[0].threads = 1;
          }) == 0);
    CostReport before = report(), now = report();
    before.configs[0].passes.erase(before.configs[0].passes.begin());
    CHECK(compareCosts(before, now).worse.size() >= 2);  // ssao is new, spills, and has 1 thread
}

TEST_CASE("Costs read from JSON are those that were written")
{
    const std::string text = toJson(report());
    const CostReport again = need(readCost("costs.json", text));
    CHECK(toJson(again) == text);
    CHECK(again.configs[0].passes[2].role == PassRole::geometry_for_ao);
    CHECK(compareCosts(report(), again).worse.empty());
    CHECK(text.find("{\"gpu\": \"Mali-G57\", \"instructions\": 400,") != std::string::npos);
}

TEST_CASE("What holds no costs is an error that says how to write some")
{
    for (const char* text : {"", "{}", "[1, 2]", "{\"scene\": 3}", "not JSON"}) {
        INFO(text);
        const auto read = readCost("costs.json", text);
        REQUIRE_FALSE(read.ok());
        CHECK(read.diagnostics()[0].code == Code::results_broken);
        CHECK(read.diagnostics()[0].help.find("--out FILE") != std::string::npos);
    }
}

TEST_CASE("The table has a row for each pass and says when fetches were not counted")
{
    CostReport made = report();
    CHECK(toText(made).find("AO in all           13.00") != std::string::npos);
    CHECK(toText(made).find("not counted") == std::string::npos);
    made.configs[0].uncounted = "there is no EGL";
    made.configs[0].passes[0].figures[0].refusal = "'x' undeclared";
    const std::string text = toText(made);
    CHECK(text.find("fetches not counted: there is no EGL\n") != std::string::npos);
    CHECK(text.find("Mali-G57 refuses ssao: 'x' undeclared\n") != std::string::npos);
}

TEST_CASE("Passes are for AO, for the picture, or geometry that one of them needs")
{
    using R = PassRole;
    CHECK(rolesOf("mobile") ==
          std::vector<R>{R::geometry, R::ao, R::ao, R::ao, R::ao, R::ao, R::picture});
    CHECK(rolesOf("high") == std::vector<R>{R::geometry, R::ao, R::geometry_for_ao,
                                            R::geometry_for_ao, R::geometry_for_ao, R::ao, R::ao,
                                            R::ao, R::ao, R::ao, R::picture});
}
