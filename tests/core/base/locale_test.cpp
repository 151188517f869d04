// SPDX-License-Identifier: MIT
// A host's locale changes nothing: Qt and GTK programs call setlocale, and then printf writes 0,5.
#include "tests/support/comma_locale.h"

#include "core/base/text.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <cmath>
#include <sstream>

#ifdef __SANITIZE_ADDRESS__
// setlocale of glibc 2.36 keeps the parts of LOCPATH for good.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:__argz_add_sep\n"; }
#endif

using namespace crevice;

namespace {

/// All that is text of a config's plan, with the GLSL of its programs.
std::string planned(const Subject& subject)
{
    CompileOptions options;
    options.extent = {960, 540};
    const Plan plan = need(compile(descriptionOf(subject), usualTraits(), usualCaps(), options));
    std::string text = toText(plan) + toJson(plan);
    for (const PlanProgram& program : plan.programs)
        for (const GlslStage* stage : {&program.vertex, &program.fragment}) text += stage->text;
    return text;
}

std::string messages()
{
    std::string all;
    for (const char* override : {"radius=-0.5", "power=1234567.5", "samples=1.5", "radius=1e999"}) {
        const auto config = loadConfig(shippedSources(), {"learnopengl", "", {override}});
        all +=
            toText(config ? decode(*config, shippedSources()).diagnostics() : config.diagnostics());
    }
    return all;
}

void checkNumbers()
{
    CHECK(shortest(0.5f) == "0.5");
    CHECK(shortest(1e-9) == "1e-09");
    CHECK(fixed(1234.5678, 2) == "1234.57");
    CHECK(significant(0.000012345, 3) == "1.23e-05");
    CHECK(scientific(0.5, 3) == "5.000e-01");
    CHECK(parseNumber("1234.5") == 1234.5);
    CHECK_FALSE(parseNumber("1234,5"));
    CHECK_FALSE(parseNumber("1.5 "));
    CHECK_FALSE(parseNumber(""));
    CHECK(parseNumber("-1e999") == -HUGE_VAL);
    CHECK(parseNumber("1e-999") == 0.0);
}

}  // namespace

// One test, since making the locale takes longer than all that is tested.
TEST_CASE(
    "Numbers, messages, plans and their GLSL are the same under a locale with a decimal comma")
{
    const std::vector<Subject> all = subjects();
    std::vector<std::string> ordinary;
    for (const Subject& subject : all) ordinary.push_back(planned(subject));
    const std::string ordinary_messages = messages();
    REQUIRE(ordinary_messages.find("-0.5") != std::string::npos);

    const auto locale = commaLocale();
    std::ostringstream stream;
    stream << 1234.5;
    REQUIRE(stream.str() == "1.234,5");  // so the locale is what it is said to be
    checkNumbers();
    CHECK(messages() == ordinary_messages);
    for (std::size_t i = 0; i < all.size(); ++i) {
        INFO(all[i].config << " " << all[i].variant);
        CHECK((planned(all[i]) == ordinary[i]));
    }
}
