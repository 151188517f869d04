// SPDX-License-Identifier: MIT
// Which geometry is drawn for the occlusion alone.
#include "tools/show/plan/without_occlusion.h"

#include "tests/support/need.h"

#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

/// The names of the passes that draw geometry for the output `ao` alone.
std::vector<std::string> ownPasses(const ConfigOptions& request, const std::string& output = "ao")
{
    const Description description = need(loadDescription(request, shippedSources()));
    const CompileOptions options{{960, 540}, {output}};
    const Plan plan = need(compile(description, usualTraits(), usualCaps(), options));
    const std::vector<bool> own =
        need(ownGeometry(plan, description, usualTraits(), usualCaps(), options));
    REQUIRE(own.size() == plan.passes.size());
    std::vector<std::string> names;
    for (std::size_t pass = 0; pass < own.size(); ++pass)
        if (own[pass]) names.push_back(plan.passes[pass].name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("Geometry is the occlusion's own where the lit picture does without it")
{
    CHECK(ownPasses({"gtao", "", {}, ""}).empty());  // deferred light needs the G-buffer itself
    CHECK(ownPasses({"high", "", {}, ""}) == Names{"back_faces", "second_layer", "second_back"});
    CHECK(ownPasses({"mobile", "", {}, ""}) == Names{"geometry"});  // forward light: no depth first
    CHECK(ownPasses({"mobile", "", {}, ""}, "color") == Names{"geometry"});
    CHECK(ownPasses({"balanced+geometry/host_depth", "", {}, ""}).empty());
    CHECK(ownPasses({"high", "", {"intensity=0"}, ""}, "color").empty());
}
