// SPDX-License-Identifier: MIT
// What GLSL ES leaves to chance is written: a sampler without a precision is lowp, which holds 8
// bits, and a literal has the precision of what it meets.
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <regex>

using namespace crevice;

namespace {

/// The precision of a sampler that the text declares, empty where the declaration has none.
std::string precisionOf(const std::string& text, const std::string& sampler)
{
    const std::regex declaration("uniform\\s+(?:(highp|mediump|lowp)\\s+)?sampler2D(?:MS)?\\s+" +
                                 sampler + "\\s*;");
    std::smatch found;
    return std::regex_search(text, found, declaration) ? found[1].str() : "";
}

/// Whether half floats lose what a texture holds.
bool isWide(Format format)
{
    const FormatInfo& info = formatInfo(format);
    return info.format_class == FormatClass::depth ||
           (info.format_class == FormatClass::floating && info.bytes == 4 * info.channels);
}

bool isWide(const Plan& plan, const PlanInput& input)
{
    if (input.kind != InputKind::target && input.kind != InputKind::history) return false;
    return isWide(plan.textures[plan.targets[input.index].texture].format);
}

}  // namespace

TEST_CASE("Every sampler of a shipped shader has a precision, and no literal is shifted by a count")
{
    const std::regex bare("uniform\\s+sampler");
    // Which is converted in the same expression.
    const std::regex shift("\\b[0-9]\\w*\\s*<<\\s*u?int\\s*\\(");
    CHECK(std::regex_search("1u << uint(max(first, last) + 0.5)", shift));
    CHECK_FALSE(std::regex_search("1 << (level - 1)", shift));
    for (const std::string& path : shippedSources().list()) {
        INFO(path);
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, bare));
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, shift));
    }
}

TEST_CASE("What reads depth or 32-bit floats in a shipped config has a highp sampler for it")
{
    for (const Subject& subject : subjects()) {
        ConfigOptions options;
        options.config = subject.config;
        options.variant = subject.variant;
        const Plan plan = need(planWithoutDevice(options, shippedSources()));
        for (const PlanPass& pass : plan.passes)
            for (const PlanInput& input : pass.inputs) {
                if (input.name.empty() || !isWide(plan, input)) continue;
                INFO(subject.config << " " << subject.variant << ", pass " << pass.name << ", "
                                    << input.name);
                CHECK(precisionOf(plan.programs[pass.program].fragment.text, input.name) ==
                      "highp");
            }
    }
}
