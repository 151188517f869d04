// SPDX-License-Identifier: MIT
// What holds for every shipped config before any GL: it loads, plans, and stays short.
#include <crevice/compile.h>
#include <crevice/recording_device.h>

#include "core/run/dirty_passes.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <algorithm>

using namespace crevice;

TEST_CASE("A still frame of a config without history runs no pass, and the last one new runs alone")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        SceneTraits traits;
        traits.lights = 1;
        const Plan plan =
            need(compile(descriptionOf({name}), traits, generousCaps(), {{256, 144}}));
        const bool remembers =
            std::any_of(plan.targets.begin(), plan.targets.end(),
                        [](const PlanTarget& each) { return each.history_texture >= 0; });
        if (remembers) continue;
        PassCache cache(plan);
        const auto runs = [&cache](const std::vector<char>& changed) {
            const std::vector<char>& chosen = cache.choose(changed);
            return std::count(chosen.begin(), chosen.end(), 1);
        };
        std::vector<char> changed(plan.passes.size(), 1);
        runs(changed);
        changed.assign(changed.size(), 0);
        CHECK(runs(changed) == 0);
        changed.back() = 1;
        CHECK(runs(changed) == 1);
    }
}

TEST_CASE("Every shipped config plans on a full and on a bare device")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Description description = descriptionOf({name});
        need(compile(description, usualTraits(), generousCaps(), {{256, 144}, {}, {}}));
        const bool float_positions = findNamed(description.targets, "position") != nullptr;
        const Result<Plan> result = compile(description, {}, minimumCaps(), {{64, 64}, {}, {}});
        CHECK(result.ok() == !float_positions);
        if (!result.ok()) CHECK(result.diagnostics().front().code == Code::no_format);
    }
}

TEST_CASE(
    "Every attachment of a shipped config is as large as its pass, on a device that wants it so")
{
    DeviceCaps caps = generousCaps();
    caps.equal_attachments = true;
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Plan plan = need(compile(descriptionOf({name}), {}, caps, {{256, 144}, {}, {}}));
        for (const PlanPass& pass : plan.passes) {
            std::vector<PlanAttachment> attachments = pass.color;
            if (pass.has_depth) attachments.push_back(pass.depth);
            for (const PlanAttachment& each : attachments) {
                if (each.target < 0) continue;
                const PlanTarget& target = plan.targets[each.target];
                CHECK(plan.textures[target.texture].extent == pass.extent);
                CHECK(plan.textures[target.drawn_texture].extent == pass.extent);
            }
        }
    }
}

TEST_CASE("Every config says what it is in 25 lines or fewer, and every param what it does")
{
    for (const std::string& name : configNames(shippedSources())) {
        const std::string& text = shippedSources().find("configs/" + name + ".json")->text;
        const Description description = descriptionOf({name});
        INFO(name);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 25);
        CHECK(description.name == name);
        CHECK(!description.text.empty());
        for (const ParamDesc& param : description.params) {
            INFO(param.name);
            CHECK(!param.tooltip.empty());
            CHECK(!param.unit.empty());
        }
    }
}

TEST_CASE("Shipped configs with the least and the most of every count fit, or lack uniforms alone")
{
    for (const Subject& subject : subjects()) {
        for (const bool most : {false, true}) {
            INFO(subject.config << " " << subject.variant << (most ? " most" : " least"));
            const Description description = withCounts(descriptionOf(subject), most);
            const CompileOptions options = {{64, 36}};
            need(compile(description, usualTraits(), generousCaps(), options));
            const Result<Plan> usual = compile(description, usualTraits(), usualCaps(), options);
            if (usual) continue;
            CHECK(most);
            for (const Diagnostic& each : usual.diagnostics())
                if (each.severity == Severity::error) CHECK(each.pointer == "/params/samples");
        }
    }
}
