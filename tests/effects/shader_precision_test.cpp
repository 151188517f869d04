// SPDX-License-Identifier: MIT
// What GLSL ES leaves to chance is written: a sampler without a precision is lowp, which holds 8
// bits, and a literal has the precision of what it meets.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tools/plan/planning.h"

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

/// Every shipped config, and again with each of its variants.
std::vector<ConfigOptions> subjects()
{
    std::vector<ConfigOptions> all;
    for (const std::string& name : configNames(shippedSources())) {
        ConfigOptions options;
        options.config = name;
        all.push_back(options);
        const Result<Node> document =
            parseDocument(shippedSources().find("configs/" + name + ".json"));
        REQUIRE(document.ok());
        const Node* variants = document->find("variants");
        if (!variants) continue;
        for (const Member& variant : variants->members) {
            options.variant = variant.key;
            all.push_back(options);
        }
    }
    return all;
}

}  // namespace

TEST_CASE("Every sampler of a shipped shader has a precision")
{
    const std::regex bare("uniform\\s+sampler");
    for (const std::string& path : shippedSources().list()) {
        INFO(path);
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, bare));
    }
}

TEST_CASE("No literal of a shipped shader is shifted by what is converted in the same expression")
{
    const std::regex shift("\\b[0-9]\\w*\\s*<<\\s*u?int\\s*\\(");
    CHECK(std::regex_search("1u << uint(max(first, last) + 0.5)", shift));
    CHECK_FALSE(std::regex_search("1 << (level - 1)", shift));
    for (const std::string& path : shippedSources().list()) {
        INFO(path);
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, shift));
    }
}

TEST_CASE("What reads depth or 32-bit floats in a shipped config has a highp sampler for it")
{
    for (const ConfigOptions& options : subjects()) {
        const Result<Plan> plan = planWithoutDevice(options, shippedSources());
        REQUIRE(plan.ok());
        for (const PlanPass& pass : plan->passes)
            for (const PlanInput& input : pass.inputs) {
                if (input.sampler.empty() || !isWide(*plan, input)) continue;
                INFO(options.config << " " << options.variant << ", pass " << pass.name << ", "
                                    << input.sampler);
                CHECK(precisionOf(plan->programs[pass.program].fragment.text, input.sampler) ==
                      "highp");
            }
    }
}
