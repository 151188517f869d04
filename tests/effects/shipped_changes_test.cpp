// SPDX-License-Identifier: MIT
// What a user may change in a shipped config: every switch that it offers, and every format.
#include <crevice/compile.h>

#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <set>

using namespace crevice;

namespace {

/// Plans changes one at a time: all of them of sampled subjects and at night, else each that
/// another subject had not.
struct Changes {
    std::set<std::string> planned = {};

    void check(const Subject& subject, const Description& changed, const std::string& what)
    {
        const auto same = [&](const Subject& each) {
            return each.config == subject.config && each.variant == subject.variant;
        };
        const std::vector<Subject> whole = sampledSubjects();
        const bool is_new = planned.insert(what).second;
        if (!is_new && std::none_of(whole.begin(), whole.end(), same)) return;
        const Result<Plan> plan =
            compile(changed, usualTraits(), usualCaps(), {{256, 144}, {}, {}});
        INFO(subject.config << " " << subject.variant << ": " << what << "\n"
                            << toText(plan.diagnostics()));
        CHECK(plan.ok());
    }
};

}  // namespace

TEST_CASE("Every switch that a shipped config offers can be turned to all its values")
{
    Changes changes;
    for (const Subject& subject : subjects()) {
        Description description = descriptionOf(subject);
        for (FeatureDesc& feature : description.features) {
            const int before = feature.value;
            for (std::size_t value = 0; value < feature.values.size(); ++value) {
                feature.value = static_cast<int>(value);
                changes.check(subject, description, feature.name + " " + feature.values[value]);
            }
            feature.value = before;
        }
    }
}

TEST_CASE("Every colour target of a shipped config may have another format")
{
    Changes changes;
    for (const Subject& subject : subjects()) {
        Description description = descriptionOf(subject);
        for (TargetDesc& target : description.targets) {
            const std::vector<Format> before = target.formats;
            if (formatInfo(before.front()).format_class == FormatClass::depth) continue;
            for (const Format format : {Format::r8, Format::r16f, Format::rgba8, Format::rgba16f}) {
                target.formats = {format};
                changes.check(subject, description, target.name + " as " + formatInfo(format).name);
            }
            target.formats = before;
        }
    }
}
