// SPDX-License-Identifier: MIT
// Modules of one family stand in for each other: swapped in every shipped config, it still plans.
#include "tests/core/config/load_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <algorithm>

using namespace crevice;

namespace {

using Names = std::vector<std::string>;

Names extendsOf(const std::string& path)
{
    Names names;
    const Node file = need(parseDocument(shippedSources().find(path)));
    if (const Node* list = file.find("extends"))
        for (const Node& each : list->items) names.push_back(each.text);
    return names;
}

/// Whether the module, or one that it extends, has a fragment shader of that name.
bool makesShader(const std::string& module, const std::string& shader)
{
    const Node file = need(parseDocument(shippedSources().find(module + ".json")));
    if (at(file, "shaders/" + shader + "/fragment")) return true;
    const Names extended = extendsOf(module + ".json");
    return std::any_of(extended.begin(), extended.end(),
                       [&](const std::string& each) { return makesShader(each, shader); });
}

/// The modules that stand in for each other: all filters, or all estimators.
Names modulesOf(const std::string& family)
{
    Names modules;
    for (const std::string& path : shippedSources().list()) {
        const std::size_t end = path.rfind(".json");
        if (path.rfind(family + "/", 0) != 0 || end == std::string::npos) continue;
        const std::string module = path.substr(0, end);
        if (family == "filter" || makesShader(module, "ssao")) modules.push_back(module);
    }
    return modules;
}

/// The one that the config, or a config that it extends, names.
std::string moduleOf(const std::string& config, const Names& modules)
{
    for (const std::string& each : extendsOf("configs/" + config + ".json")) {
        if (std::find(modules.begin(), modules.end(), each) != modules.end()) return each;
        if (each.find('/') != std::string::npos) continue;
        if (const std::string deeper = moduleOf(each, modules); !deeper.empty()) return deeper;
    }
    return "";
}

Result<Plan> planSwapped(const std::string& config, const std::string& swap)
{
    const Result<Node> document = loadConfig(shippedSources(), {config, "", {swap}});
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, shippedSources());
    if (!description) return description.diagnostics();
    return compile(*description, usualTraits(), usualCaps(), {{256, 144}, {}, {}});
}

bool isWarning(const Diagnostic& diagnostic) { return diagnostic.severity == Severity::warning; }

/// filter/indirect filters what ssao/ssdo alone makes. The error must name that module.
void checkIndirect(const Result<Plan>& plan, const std::string& config, const std::string& to)
{
    const bool filter = to == "filter/indirect";
    CHECK((filter || moduleOf(config, {"filter/indirect"}) == "filter/indirect"));
    Diagnostics errors = plan.diagnostics();
    errors.erase(std::remove_if(errors.begin(), errors.end(), isWarning), errors.end());
    REQUIRE(errors.size() == 1);
    CHECK(errors.front().code == Code::target_missing);
    CHECK(errors.front().help.find("ssao/ssdo") != std::string::npos);
}

}  // namespace

TEST_CASE("Every filter and every estimator takes the place of that of every shipped config")
{
    const std::size_t stride = nightly() ? 1 : 5;  // so each config and each module is taken
    const Names configs = configNames(shippedSources());
    for (const char* family : {"filter", "ssao"}) {
        const Names modules = modulesOf(family);
        CHECK(modules.size() >= 8);
        for (std::size_t i = 0; i < configs.size(); ++i) {
            const std::string& config = configs[i];
            const std::string from = moduleOf(config, modules);
            INFO(config << " " << from);
            REQUIRE_FALSE(from.empty());
            for (std::size_t j = i % stride; j < modules.size(); j += stride) {
                const std::string& to = modules[j];
                const Result<Plan> plan = planSwapped(config, from + "=" + to);
                INFO(to << "\n" << toText(plan.diagnostics()));
                if (plan)
                    CHECK(findNamed(plan->outputs, "ao"));
                else
                    checkIndirect(plan, config, to);
            }
        }
    }
}

TEST_CASE("A swap changes the module and leaves out with a warning what was set for the old one")
{
    const Node document =
        need(loadConfig(shippedSources(), {"thesis", "", {"ssao/hemisphere=ssao/gtao"}}));
    CHECK(at(document, "shaders/ssao/fragment")->text == "ssao/shaders/gtao.frag");
    const Result<Description> description = decode(document, shippedSources());
    REQUIRE(description.ok());
    Names elided;
    for (const Diagnostic& each : description->unused) {
        CHECK(each.severity == Severity::warning);
        // thesis sets which generator makes rotation_noise, which gtao does not read
        const bool unused = each.pointer == "/generated/rotation_noise";
        CHECK(each.code == (unused ? Code::unused_name : Code::unknown_param));
        elided.push_back(each.pointer);
    }
    CHECK(elided == Names{"/params/bias_length", "/params/samples", "/features/guards",
                          "/features/basis", "/features/range_check", "/generated/kernel",
                          "/generated/rotation_noise"});
    CHECK_FALSE(findNamed(description->params, "samples"));
}

TEST_CASE("A module is swapped in the configs that a config extends, and not in other modules")
{
    const Node deep =
        need(loadConfig(shippedSources(), {"mobile", "", {"filter/upsample=filter/box"}}));
    CHECK(at(deep, "shaders/filter/fragment")->text == "filter/shaders/box.frag");
    // ssao/ssdo extends ssao/hemisphere, which takes the place of nothing here.
    const Node ssdo =
        need(loadConfig(shippedSources(), {"thesis", "", {"ssao/hemisphere=ssao/ssdo"}}));
    CHECK(at(ssdo, "targets/indirect"));
    const Diagnostic inner =
        failure(shippedSources(), {"ssdo", "", {"ssao/hemisphere=ssao/sphere"}});
    CHECK(inner.code == Code::module_missing);
}

TEST_CASE("A swap of what is not there, or for what is not there, is an error in the override")
{
    const auto fails = [](const char* text, Code code, const char* help) {
        const Diagnostic error = failure(shippedSources(), {"gtao", "", {text}});
        INFO(toText({error}));
        CHECK(error.code == code);
        CHECK(error.place.source->name == std::string("--set ") + text);
        CHECK(error.help.find(help) != std::string::npos);
    };
    fails("filter/bilateral=filter/box", Code::module_missing, "'filter/bilateral_normal'");
    fails("filter/bilateral_normal=filter/bx", Code::module_missing, "'filter/box'");
    fails("filter/bilateral_normal=5", Code::wrong_type, "name of a module");
    fails("filter/bilateral_normal=", Code::override_syntax, "write");
    fails("filter/bilateral_normal=ssao/sphere", Code::module_clash, "keep one");
}
