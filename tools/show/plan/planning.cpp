// SPDX-License-Identifier: MIT
// Planning without a device.
#include "tools/show/plan/planning.h"

#include "core/config/decode_report.h"
#include "core/frame/frame_math.h"
#include "core/glsl/compiler_words.h"

namespace crevice {

DeviceCaps usualCaps()
{
    DeviceCaps caps = minimumCaps();
    caps.name = "OpenGL ES 3.0 with float targets";
    caps.max_texture_size =
        8192;  // as GPUs with float targets have at least; the standard's 2048 is below 1080p
    for (const FormatInfo& info : allFormats()) {
        caps.renderable[static_cast<int>(info.format)] = true;
        caps.sample_counts[static_cast<int>(info.format)] = 1u << 1 | 1u << 3;
    }
    return caps;
}

SceneTraits usualTraits()
{
    SceneTraits traits;
    traits.lights = 1;
    traits.alpha_tested = true;
    traits.specular = true;
    traits.textured = true;
    return traits;
}

namespace {

struct Setting {
    std::string what;  // "scene.lights 0"
    SceneTraits traits;
};

void set(const TraitInfo& trait, SceneTraits& traits, int value)
{
    if (trait.flag)
        traits.*trait.flag = value != 0;
    else
        traits.*trait.count = value;
}

std::vector<Setting> otherSettings()
{
    std::vector<Setting> settings;
    Setting full = {"everything that a scene can have", usualTraits()};
    for (const TraitInfo& trait : kTraits) {
        const int usual = trait.value(usualTraits());
        if (startsWith(trait.name, "scene.")) set(trait, full.traits, 1);
        for (const int value : {0, 1, 2}) {
            if (value == usual || value > trait.most) continue;
            settings.push_back(
                {std::string(trait.name) + " " + std::to_string(value), usualTraits()});
            set(trait, settings.back().traits, value);
        }
    }
    settings.push_back(full);
    return settings;
}

Result<Plan> planFor(const Description& description, const SceneTraits& traits, Extent extent)
{
    return compile(description, traits, usualCaps(), {extent});
}

/// Warns of outputs that are nowhere but in their declaration, and perhaps before ==.
void warnUnwritten(const PlanProgram& program, Diagnostics& warnings)
{
    const std::string& text = program.fragment.text;
    for (const GlslOutput& output : program.fragment.outputs) {
        int uses = 0;
        for (std::size_t at = findWord(text, output.name); at != text.npos;
             at = findWord(text, output.name, at + 1))
            uses +=
                text.compare(text.find_first_not_of(' ', at + output.name.size()), 2, "==") != 0;
        if (uses > 1) continue;
        warnings.push_back(asWarning(
            {Code::output_mismatch, "'" + output.name + "' is an output, and nothing writes it",
             "write " + output.name + " = ...;", output.place, program.pointer}));
    }
}

}  // namespace

Result<Plan> planForEveryScene(const Result<Description>& description, const std::string& name,
                               Extent extent, GlslCheck& shaders)
{
    if (!description) return description.diagnostics();
    const std::string variant = name.empty() ? "" : "variant '" + name + "'";
    Description roomy = *description;
    roomy.limits.bytes = std::numeric_limits<double>::infinity();
    Result<Plan> plan = planFor(roomy, usualTraits(), extent);
    Diagnostics errors = plan ? Diagnostics() : plan.diagnostics();
    if (plan) shaders.add(*plan, variant);
    Setting largest = {variant, usualTraits()};
    for (const Setting& setting : otherSettings()) {
        const Result<Plan> other = planFor(roomy, setting.traits, extent);
        const std::string with = setting.what + (variant.empty() ? "" : " and " + variant);
        if (other) shaders.add(*other, with);
        if (plan && other && other->texture_bytes > plan->texture_bytes) {
            plan->texture_bytes = other->texture_bytes;
            largest = {with, setting.traits};
        }
        if (other) continue;
        for (Diagnostic error : other.diagnostics()) {
            if (error.severity != Severity::error) continue;
            error.notes.push_back({{}, "found with " + with});
            addOnce(errors, std::move(error));
        }
    }
    if (plan && plan->texture_bytes > description->limits.bytes) {
        const Result<Plan> refused = planFor(*description, largest.traits, extent);
        append(errors, refused.diagnostics());
        if (!largest.what.empty())
            errors.back().notes.push_back({{}, "found with " + largest.what});
    }
    append(errors, shaders.check(*description));
    cutShort(errors);
    for (Diagnostic& each : errors)
        if (endsWith(each.message, "', which is not defined"))
            each.help = table::declaredBy(shippedSources(), "features",
                                          lowerCase(quotedName(each.message))) +
                        each.help;
    if (!errors.empty()) return errors;
    Diagnostics warnings = plan.diagnostics();
    for (const PlanProgram& program : plan->programs) warnUnwritten(program, warnings);
    return {std::move(*plan), std::move(warnings)};
}

}  // namespace crevice
