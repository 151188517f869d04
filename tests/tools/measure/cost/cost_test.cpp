// SPDX-License-Identifier: MIT
// Sums, what counts as worse, and what is written and read again: on figures made up here.
#include "tests/support/need.h"
#include "tools/measure/cost/check.h"
#include "tools/measure/cost/pass_roles.h"

#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

CostReport figures(int instructions, int spills, int threads, double cycles)
{
    return {{"gpu", "Mali-G57"},  {"instructions", instructions},
            {"spills", spills},   {"fills", 2 * spills},
            {"threads", threads}, {"most_threads", 2},
            {"cycles", cycles},   {"code_bytes", 16 * instructions}};
}

CostReport pass(const char* name, PassRole role, double pixels, double fetches,
                const CostReport& each)
{
    CostReport made = {{"pass", name},       {"for", nameOf(role)}, {"size", {64, 32}},
                       {"pixels", pixels},   {"tile_bytes", 100},   {"read_bytes", 60},
                       {"loaded_bytes", 40}, {"gpus", {each}}};
    if (role != PassRole::geometry_for_ao) made["fetches"] = fetches;
    return made;
}

/// One config: half-size AO, a filter, back faces and lighting.
CostReport report()
{
    CostReport config = {{"config", "some"}, {"geometry_bytes_for_ao", 1000}};
    config["passes"] = {pass("ssao", PassRole::ao, 0.25, 8, figures(400, 3, 1, 40)),
                        pass("filter", PassRole::ao, 1, 5, figures(100, 0, 2, 4)),
                        pass("back_faces", PassRole::geometry_for_ao, 1, 0, figures(10, 0, 2, 0.5)),
                        pass("lighting", PassRole::picture, 1, 3, figures(300, 0, 2, 12))};
    addSums(config);
    return {{"scene", "room"},       {"size", {128, 64}},
            {"camera", "eye=4,2,6"}, {"variant", "fast"},
            {"set", {"radius=0.5"}}, {"compilers", "Mesa 22.3.6"},
            {"gpus", {"Mali-G57"}},  {"configs", CostReport::array({config})}};
}

/// How many figures are worse than `report()` once `change` has been at its config.
template <class Change>
std::size_t worse(Change&& change)
{
    CostReport now = report();
    CostReport& config = now["configs"][0];
    change(config["passes"]);
    addSums(config);
    return need(compareCosts(report(), now)).worse.size();
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
    const CostReport config = report()["configs"][0];
    const CostReport &alone = config["ao"], &all = config["ao_with_geometry"];
    CHECK(alone["passes"] == 2);
    CHECK(alone["fetches"] == 13.0);
    CHECK(alone["tile_bytes"] == 200);
    const CostReport& gpu = alone["gpus"][0];
    CHECK(gpu["instructions"] == 500);
    CHECK(gpu["largest_spills"] == 3);
    CHECK(gpu["its_fills"] == 6);
    CHECK(gpu["lowest_threads"] == 1);
    CHECK(gpu["cycles"] == 40 * 0.25 + 4);
    CHECK(all["passes"] == 3);
    CHECK(all["fetches"] == 13.0);
    CHECK(all["tile_bytes"] == 1300);
    CHECK(all["gpus"][0]["cycles"] == 14.5);
}

TEST_CASE("Spills, lost occupancy and a tenth more of anything are worse, and less is not")
{
    const auto after = [](std::size_t pass, const char* key, auto value) {
        return worse([&](CostReport& passes) { passes[pass]["gpus"][0][key] = value; });
    };
    CHECK(worse([](CostReport&) {}) == 0);
    CHECK(after(1, "spills", 9) == 1);
    CHECK(after(0, "fills", 12) == 1);
    CHECK(after(0, "instructions", 445) == 0);
    CHECK(after(0, "instructions", 570) == 1);
    CHECK(after(0, "cycles", 50) == 1);
    CHECK(after(2, "instructions", 100) == 1);
    CHECK(after(0, "threads", 0) == 1);
    CHECK(after(1, "refusal", "no") == 1);
    CHECK(worse([](CostReport& now) { now[1]["fetches"] = 7; }) == 1);
    CHECK(worse([](CostReport& now) { now[3]["gpus"][0] = figures(900, 9, 1, 90); }) == 0);
    CHECK(worse([](CostReport& now) { now[0]["gpus"][0] = figures(200, 0, 2, 9); }) == 0);
    CHECK(worse([](CostReport& now) { now.erase(0); }) == 0);
}

TEST_CASE("Costs are read as they were written, under the options that they were measured under")
{
    const ApprovedCost again = need(readCost("costs.json", costJson(report()), {}));
    CHECK(again.report == report());
    CHECK(again.options.configs == std::vector<std::string>{"some"});
    CHECK(again.options.scene.size == "128x64");
    CHECK(again.options.config.overrides == std::vector<std::string>{"radius=0.5"});
    for (const char* text : {"", "[1, 2]", "{\"scene\": 3}", "not JSON"}) {
        INFO(text);
        const auto read = readCost("costs.json", text, {});
        REQUIRE_FALSE(read.ok());
        CHECK(read.diagnostics()[0].code == Code::results_broken);
    }
    CostReport cut = report();
    cut["configs"][0].erase("ao_with_geometry");
    CHECK_FALSE(compareCosts(cut, report()).ok());
}

TEST_CASE("The table has a row for each pass and says when fetches were not counted")
{
    CostReport made = report();
    CHECK(costText(made).find("AO in all           13.00") != std::string::npos);
    CHECK(costText(made).find("not counted") == std::string::npos);
    made["configs"][0]["uncounted"] = "there is no EGL";
    made["configs"][0]["passes"][0]["gpus"][0]["refusal"] = "'x' undeclared";
    const std::string text = costText(made);
    CHECK(text.find("fetches not counted: there is no EGL\n") != std::string::npos);
    CHECK(text.find("Mali-G57 refuses ssao: 'x' undeclared\n") != std::string::npos);
}

TEST_CASE("Passes are for AO, for the picture, or geometry that one of them needs")
{
    using R = PassRole;
    CHECK(rolesOf("mobile") ==
          std::vector<R>{R::geometry, R::ao, R::ao, R::ao, R::ao, R::ao, R::ao, R::picture});
    CHECK(rolesOf("high") == std::vector<R>{R::geometry, R::ao, R::geometry_for_ao,
                                            R::geometry_for_ao, R::geometry_for_ao, R::ao, R::ao,
                                            R::ao, R::ao, R::ao, R::ao, R::picture});
}
