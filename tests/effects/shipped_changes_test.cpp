// SPDX-License-Identifier: MIT
// What a user may change in a shipped config: every switch that it offers, and every format.
#include "tests/support/catch.h"

#include <crevice/compile.h>

#include "tests/support/shipped_subjects.h"
#include "tools/plan/planning.h"

using namespace crevice;

namespace {

void checkPlans(const Description& description, const std::string& change)
{
    CompileOptions options;
    options.extent = {256, 144};
    const Result<Plan> plan = compile(description, usualTraits(), usualCaps(), options);
    INFO(change << "\n" << toText(plan.diagnostics()));
    CHECK(plan.ok());
}

}  // namespace

TEST_CASE("Every switch that a shipped config offers can be turned to all its values")
{
    for (const Subject& subject : subjects()) {
        const Description description = descriptionOf(subject);
        for (std::size_t i = 0; i < description.features.size(); ++i)
            for (std::size_t value = 0; value < description.features[i].values.size(); ++value) {
                Description changed = description;
                changed.features[i].value = static_cast<int>(value);
                checkPlans(changed, subject.config + " " + subject.variant + ": " +
                                        changed.features[i].name + " " +
                                        changed.features[i].values[value]);
            }
    }
}

TEST_CASE("Every colour target of a shipped config may have another format")
{
    for (const Subject& subject : subjects()) {
        const Description description = descriptionOf(subject);
        for (std::size_t i = 0; i < description.targets.size(); ++i)
            for (const Format format : {Format::r8, Format::r16f, Format::rgba8, Format::rgba16f}) {
                Description changed = description;
                TargetDesc& target = changed.targets[i];
                if (formatInfo(target.formats.front()).format_class == FormatClass::depth) continue;
                target.formats = {format};
                checkPlans(changed, subject.config + " " + subject.variant + ": " + target.name +
                                        " as " + formatInfo(format).name);
            }
    }
}
