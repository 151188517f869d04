// SPDX-License-Identifier: MIT
#include "tools/render/target_diagnosis.h"

#include "core/base/text.h"
#include "tools/render/device/poison_device.h"

#include <cfloat>
#include <cmath>
#include <cstring>

namespace crevice {
namespace {

constexpr float kMostHalf = 65504.0f;

std::string number(double value) { return significant(value, 4); }

const TargetHealth* healthOf(const std::vector<TargetHealth>& all, const std::string& target)
{
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const TargetHealth& each) { return each.target == target; });
    return at == all.end() ? nullptr : &*at;
}

// "; it reads radius = 0.5, power = 1": the params that feed the pass's shader; empty without any.
std::string paramsRead(const Description& description, const PlanPass& pass)
{
    std::string text;
    for (const ParamDesc& param : description.params) {
        if (componentCount(param.type) > 1 || !findNamed(pass.uniforms, param.name)) continue;
        text += (text.empty() ? "; it reads " : ", ") + param.name + " = " + number(param.value[0]);
    }
    return text;
}

std::string pixelsText(const TargetHealth& health, std::size_t count)
{
    return std::to_string(count) + " of " + std::to_string(health.pixels) + " pixels";
}

Diagnostic about(const Description& description, const std::string& pass, Code code,
                 std::string message)
{
    Diagnostic diagnostic{code, std::move(message)};
    if (const PassDesc* desc = findNamed(description.passes, pass)) {
        diagnostic.place = desc->place;
        diagnostic.pointer = desc->pointer;
    }
    return diagnostic;
}

std::string whyUndefined(const PlanPass& pass, const TargetHealth& health)
{
    const auto cleared = [&](const PlanAttachment& each) {
        return each.name == health.target && each.load == LoadOp::clear;
    };
    const bool clears = anyOf(pass.color, cleared) || cleared(pass.depth);
    if (pass.type == PassType::draw && !clears)
        return "a draw covers only what its triangles cover: add \"clear\": {\"" + health.target +
               "\": 0} to the pass";
    return "some path through the fragment shader ends without writing it (a discard, an output "
           "that "
           "is set in one branch alone), or reads a texel that nothing wrote";
}

std::string causeOf(const Description& description, const PlanPass& pass,
                    const TargetHealth& health)
{
    if (health.not_numbers + health.infinite > 0)
        return std::string(
                   "all that it reads is finite, so its shader divides by zero, normalizes a "
                   "vector of no length, takes the root or power of something negative, or leaves "
                   "the range of the target's format") +
               paramsRead(description, pass);
    if (health.out_of_range == 0) return whyUndefined(pass, health);
    return std::string(
               "the format clamps them: clamp in the shader, where a sum or root goes wrong") +
           paramsRead(description, pass);
}

// What is wrong with the target, in one sentence.
Diagnostic fault(const Description& description, const TargetHealth& health)
{
    const std::string who = "pass '" + health.pass + "' ";
    const std::string where = " target '" + health.target + "'";
    const std::string at = ", the first at (" + std::to_string(health.first_bad.x) + ", " +
                           std::to_string(health.first_bad.y) + ") from the upper left";
    const std::size_t not_finite = health.not_numbers + health.infinite;
    if (not_finite > 0) {
        const char* what = health.infinite == 0      ? " that are not a number"
                           : health.not_numbers == 0 ? " that are infinite"
                                                     : " that are not finite";
        return about(
            description, health.pass, Code::target_not_finite,
            who + "writes " + pixelsText(health, not_finite) + what + " into" + where + at);
    }
    if (health.out_of_range > 0)
        return about(description, health.pass, Code::target_out_of_range,
                     who + "writes " + pixelsText(health, health.out_of_range) +
                         " out of range into" + where + at + ": " + number(health.first_value));
    return about(
        description, health.pass, Code::target_undefined,
        who + "leaves " + pixelsText(health, health.undefined) + " of" + where + " undefined" + at);
}

// The error about the first bad target; everything bad behind it becomes a note.
Diagnostics firstBad(const Description& description, const Plan& plan,
                     const std::vector<TargetHealth>& health)
{
    Diagnostics found;
    for (const TargetHealth& each : health) {
        if (!each.bad()) continue;
        const PlanPass* pass = findNamed(plan.passes, each.pass);
        if (!found.empty()) {
            const PassDesc* desc = findNamed(description.passes, each.pass);
            found[0].notes.push_back(
                {desc ? desc->place : Place{},
                 "target '" + each.target + "' of pass '" + each.pass + "' is wrong too"});
            continue;
        }
        found.push_back(fault(description, each));
        if (pass) found[0].help = causeOf(description, *pass, each);
    }
    return found;
}

// Whether a constant target can be so because it reads the other: that one is constant, or its
// first channel has the same value everywhere, as where it holds occlusion with depth behind it.
bool explains(const TargetHealth& other, const TargetHealth& target)
{
    return other.constant ||
           (other.minimum[0] == other.maximum[0] && other.minimum[0] == target.minimum[0]);
}

// The first pass on the way to `target` none of whose inputs explains why that is constant.
const TargetHealth& rootOf(const Plan& plan, const std::vector<TargetHealth>& health,
                           const TargetHealth& target)
{
    const PlanPass* pass = findNamed(plan.passes, target.pass);
    for (const PlanInput& input : pass ? pass->inputs : std::vector<PlanInput>{}) {
        if (input.kind != InputKind::target) continue;
        const TargetHealth* from = healthOf(health, plan.targets[input.index].name);
        const bool drawn =
            input.name.empty() && from && from->minimum[0] > 0;  // a mask that lets all through
        if (from && from != &target && !drawn && explains(*from, target))
            return rootOf(plan, health, *from);
    }
    return target;
}

Diagnostic constantOutput(const Description& description, const std::string& output,
                          const std::string& pass, const std::string& value)
{
    return asWarning(about(description, pass, Code::output_constant,
                           "output '" + output + "' is " + value + " everywhere"));
}

/// From the upper left on, row by row.
template <class Look>
void forPixels(const Image& image, const Look& look)
{
    for (int y = image.extent.height - 1; y >= 0; --y)
        for (int x = 0; x < image.extent.width; ++x)
            look(&image.pixels[(std::size_t(y) * image.extent.width + x) * image.channels],
                 PixelPlace{x, image.extent.height - 1 - y});
}

std::string valueText(const TargetHealth& health)
{
    std::string text;
    for (int i = 0; i < health.channels; ++i)
        text += (i > 0 ? ", " : "") + number(health.minimum[i]);
    return health.channels > 1 ? "(" + text + ")" : text;
}

}  // namespace

std::string whyPlanned(const Plan& plan)
{
    std::string text;
    for (const Elided& each : plan.elided)
        if (each.optimization == "no_op" || each.optimization == "condition")
            text += (text.empty() ? "" : "; ") + each.what + " does not run: " + each.reason;
    return text;
}

TargetHealth examine(const Image& drawn, const Image& redrawn)
{
    TargetHealth health;
    health.channels = std::min(drawn.channels, 4);
    health.constant = true;
    health.minimum.fill(HUGE_VALF);
    health.maximum.fill(-HUGE_VALF);
    health.pixels = static_cast<std::size_t>(drawn.extent.width) * drawn.extent.height;
    const std::size_t bytes = sizeof(float) * drawn.channels;
    forPixels(drawn, [&](const float* one, const PixelPlace& place) {
        const float* other = one - drawn.pixels.data() + redrawn.pixels.data();
        const bool was_bad = health.bad();
        bool nan = false, inf = false;
        for (int i = 0; i < health.channels; ++i) {
            nan = nan || std::isnan(one[i]);
            inf = inf || std::isinf(one[i]);
            if (!std::isfinite(one[i])) continue;
            health.minimum[i] = std::min(health.minimum[i], one[i]);
            health.maximum[i] = std::max(health.maximum[i], one[i]);
        }
        health.not_numbers += nan;
        health.infinite += inf && !nan;
        health.undefined += std::memcmp(one, other, bytes) != 0;
        health.constant = health.constant && std::memcmp(one, drawn.pixels.data(), bytes) == 0;
        if (!was_bad && health.bad()) health.first_bad = place;
    });
    return health;
}

void examineFloats(const Image& floats, Format stored, TargetHealth& health)
{
    const FormatInfo& format = formatInfo(stored);
    const bool unorm = format.format_class == FormatClass::unorm;
    const bool narrow = floatFormat(stored) != stored;
    const auto step = static_cast<float>(format.absolute_step);
    const float most = unorm ? 1 + step : narrow ? kMostHalf : FLT_MAX;
    const float least = unorm ? -step : -most;
    std::size_t not_numbers = 0, infinite = 0, out_of_range = 0;
    forPixels(floats, [&](const float* pixel, const PixelPlace& place) {
        const float* bad = nullptr;
        bool nan = false;
        for (int i = 0; i < health.channels; ++i) {
            health.minimum[i] = std::fmin(health.minimum[i], pixel[i]);  // without NaN
            health.maximum[i] = std::fmax(health.maximum[i], pixel[i]);
            if (pixel[i] >= least && pixel[i] <= most) continue;
            if (!bad) bad = pixel + i;
            nan = nan || std::isnan(pixel[i]);
        }
        if (!bad) return;
        if (not_numbers + infinite + out_of_range == 0) {
            health.first_bad = place;
            health.first_value = *bad;
        }
        not_numbers += nan;
        infinite += !nan && std::isinf(*bad);
        out_of_range += !nan && !std::isinf(*bad);
    });
    health.not_numbers = std::max(health.not_numbers, not_numbers);
    health.infinite = std::max(health.infinite, infinite);
    health.out_of_range = out_of_range;
}

Diagnostics diagnose(const Description& description, const Plan& plan,
                     const std::vector<TargetHealth>& health)
{
    Diagnostics found = firstBad(description, plan, health);
    if (!found.empty()) return found;
    for (const PlanOutput& output : plan.outputs) {
        if (output.constant >= 0) {
            found.push_back(constantOutput(description, output.name, "",
                                           number(plan.constants[output.constant])));
            found.back().help = whyPlanned(plan);
            continue;
        }
        const TargetHealth* target = healthOf(health, plan.targets[output.target].name);
        if (!target || !target->constant) continue;
        const TargetHealth& root = rootOf(plan, health, *target);
        found.push_back(constantOutput(description, output.name, root.pass, valueText(*target)));
        const PlanPass* pass = findNamed(plan.passes, root.pass);
        found.back().help = "pass '" + root.pass + "' writes the same everywhere" +
                            (pass ? paramsRead(description, *pass) : "");
    }
    return found;
}

}  // namespace crevice
