// SPDX-License-Identifier: MIT
// The plan of each shipped config, as `crevice explain NAME` prints it, compared with the approved
// one in tests/data/plans. tools/scripts/approve.sh takes the new plans as the approved ones.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tools/plan/planning.h"
#include "tools/plan/print.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace crevice;
namespace fs = std::filesystem;

namespace {

using Lines = std::vector<std::string>;

const fs::path kPlans = fs::path(CREVICE_SOURCE_DIR) / "tests/data/plans";

std::string planText(const std::string& name)
{
    ConfigOptions options;
    options.config = name;
    const Result<Plan> plan = planWithoutDevice(options, shippedSources());
    INFO(toText(plan.diagnostics()));
    REQUIRE(plan.ok());
    return toText(*plan);
}

std::string readText(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Lines linesOf(const std::string& text)
{
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The lines from the first to the last that differ: approved ones after '-', new ones after '+'.
std::string difference(const std::string& approved, const std::string& now)
{
    const Lines old_lines = linesOf(approved), new_lines = linesOf(now);
    const std::size_t shorter = std::min(old_lines.size(), new_lines.size());
    std::size_t first = 0, last = 0;
    while (first < shorter && old_lines[first] == new_lines[first]) ++first;
    while (last < shorter - first && *(old_lines.rbegin() + last) == *(new_lines.rbegin() + last))
        ++last;
    std::string text = "from line " + std::to_string(first + 1) + "\n";
    for (std::size_t i = first; i + last < old_lines.size(); ++i)
        text += "- " + old_lines[i] + "\n";
    for (std::size_t i = first; i + last < new_lines.size(); ++i)
        text += "+ " + new_lines[i] + "\n";
    return text;
}

}  // namespace

TEST_CASE("The plan of every shipped config is the approved one")
{
    const bool approve = std::getenv("CREVICE_APPROVE") != nullptr;
    if (approve) fs::create_directories(kPlans);
    for (const std::string& name : configNames(shippedSources())) {
        const fs::path path = kPlans / (name + ".txt");
        const std::string now = planText(name);
        if (approve) std::ofstream(path, std::ios::binary) << now;
        const std::string approved = readText(path);
        if (approved == now) continue;
        FAIL_CHECK("the plan of " << name << " is not that of tests/data/plans/" << name << ".txt, "
                                  << difference(approved, now)
                                  << "where that was meant, tools/scripts/approve.sh approves it");
    }
}

TEST_CASE("Every approved plan is that of a shipped config")
{
    const std::vector<std::string> names = configNames(shippedSources());
    for (const auto& entry : fs::directory_iterator(kPlans)) {
        INFO("delete " << entry.path().filename());
        CHECK(std::count(names.begin(), names.end(), entry.path().stem().string()) == 1);
    }
}

TEST_CASE("A plan that changed is reported line by line")
{
    CHECK(difference("a\nb\nc\nd\n", "a\nx\nd\n") == "from line 2\n- b\n- c\n+ x\n");
    CHECK(difference("a\n", "a\nb\n") == "from line 2\n+ b\n");
    CHECK(difference("", "a\n") == "from line 1\n+ a\n");
}
