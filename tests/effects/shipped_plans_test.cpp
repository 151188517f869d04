// SPDX-License-Identifier: MIT
// Plans of shipped configs compared with the approved ones in tests/data/plans: six as
// `crevice explain NAME` prints them, of all others what they run and take, a line each.
// With CREVICE_APPROVE=1 it takes the new plans as the approved ones.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace crevice;
namespace fs = std::filesystem;

namespace {

Plan planned(const std::string& name)
{
    ConfigOptions options;
    options.config = name;
    return need(planWithoutDevice(options, shippedSources()));
}

std::string inOneLine(const std::string& name)
{
    const Plan plan = planned(name);
    return name + ": " + std::to_string(plan.textures.size()) + " textures, " +
           fixed(plan.texture_bytes, 0) + " bytes; " + joined(namesOf(plan.passes)) + "\n";
}

void checkApproved(const std::string& name, const std::string& now)
{
    const fs::path path = fs::path(CREVICE_SOURCE_DIR) / "tests/data/plans" / (name + ".txt");
    if (std::getenv("CREVICE_APPROVE")) {
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << now;
    }
    std::ostringstream approved;
    approved << std::ifstream(path, std::ios::binary).rdbuf();
    std::istringstream lines(now), approved_lines(approved.str());
    std::string line, wanted;
    while (std::getline(lines, line) && std::getline(approved_lines, wanted) && line == wanted) {
    }
    INFO("in " << path << ", from this line on:\n- " << wanted << "\n+ " << line << "\n"
               << "where that was meant, run it with CREVICE_APPROVE=1, which approves it");
    CHECK((now == approved.str()));
}

}  // namespace

TEST_CASE("The plan of every shipped config is the approved one")
{
    const std::vector<std::string> whole = {"balanced", "balanced_temporal", "gtao",
                                            "high",     "learnopengl",       "mobile"};
    std::string others;
    for (const std::string& name : configNames(shippedSources()))
        if (!contains(whole, name)) others += inOneLine(name);
    for (const std::string& name : whole) checkApproved(name, toText(planned(name)));
    checkApproved("others", others);
}
