// SPDX-License-Identifier: MIT
// The renderer: keeps a description's plan in step with params, size and scene, and runs it.
#include "core/run/renderer.h"

#include "core/base/numbers.h"
#include "core/compile/depth_precision.h"
#include "core/run/execution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

Diagnostic paramError(Code code, const ParamDesc& param, const std::string& what, std::string help)
{
    Diagnostic error{code, param.name + " " + what};
    error.place = param.place;
    error.pointer = param.pointer;
    error.help = std::move(help);
    return error;
}

std::string numberText(double value) { return significant(value, 6); }

std::string rangeText(const ParamDesc& param)
{
    return "[" + numberText(param.min) + ", " + numberText(param.max) + "]" +
           (param.unit.empty() ? "" : " " + param.unit);
}

bool wholeInt(float value)
{
    constexpr float kLimit = 2147483648.0f;  // the least float that no int holds
    return value == std::floor(value) && value >= -kLimit && value < kLimit;
}

Status checkParam(const ParamDesc& param, const float* values, int count)
{
    const int components = componentCount(param.type);
    if (count != components)
        return paramError(Code::bad_length, param,
                          "has " + std::to_string(components) + " components, and " +
                              std::to_string(count) + " values were given",
                          "give one value for each component");
    for (int i = 0; i < count; ++i) {
        if (!std::isfinite(values[i]))
            return paramError(Code::not_finite, param, "must be finite", "in " + rangeText(param));
        if (double{values[i]} < param.min || double{values[i]} > param.max)
            return paramError(Code::out_of_range, param,
                              numberText(values[i]) + " is outside " + rangeText(param),
                              "give a value in that range");
        if (param.type == ParamType::int_ && !wholeInt(values[i]))
            return paramError(Code::out_of_range, param,
                              numberText(values[i]) + " is no whole number",
                              "give a whole number in " + rangeText(param));
    }
    return {};
}

/// Whether all components are `value`: where an identity holds.
bool isAll(const std::array<float, 4>& values, ParamType type, float value)
{
    return std::all_of(values.begin(), values.begin() + componentCount(type),
                       [&](float each) { return each == value; });
}

/// What the choice of formats depends on besides the description and the device.
struct Wants {
    const SceneTraits& traits;
    PrecisionNeed need;
};

/// Whether formats chosen for `now` do not hold for `next`. Allocates nothing.
bool changesFormats(const Description& description, const DeviceCaps& caps, const Wants& now,
                    const Wants& next)
{
    const auto chosen = [&](const TargetDesc& target, const Wants& wants) {
        return chooseFormat(description, target, wants.traits, caps, wants.need);
    };
    return std::any_of(description.targets.begin(), description.targets.end(),
                       [&](const TargetDesc& target) {
                           return chosen(target, now) != chosen(target, next);
                       });
}

/// Whether a plan made with the param's present value does not hold for `next`.
bool changesPlan(const Description& description, const ParamDesc& param,
                 const std::array<float, 4>& next)
{
    if (param.bind == Bind::define) return true;
    for (const GeneratedDesc& generated : description.generated)
        if (generated.count_param.name == param.name) return true;
    for (const TargetDesc& target : description.targets)
        if (target.size.scale_param.name == param.name ||
            target.samples_param.name == param.name) return true;
    for (const PassDesc& pass : description.passes) {
        if (pass.draws_within_param.name == param.name) return true;
        for (const IdentityDesc& identity : pass.identity)
            if (identity.param.name == param.name &&
                isAll(param.value, param.type, identity.at) != isAll(next, param.type, identity.at))
                return true;
    }
    return false;
}

Diagnostic unknown(Code code, const char* what, std::string_view name,
                   std::vector<std::string> names, const char* heading)
{
    Diagnostic error{code, std::string("there is no ") + what + " '" + std::string(name) + "'"};
    error.help = suggestName(name, std::move(names), heading);
    return error;
}

Diagnostic dropped(const std::string& what, const Named& old, const std::string& why)
{
    Diagnostic warning{Code::value_dropped, what + " '" + old.name +
                                                "' is no longer what was set at run time: " + why};
    warning.severity = Severity::warning;
    warning.help = "set it again, to a value that the config has now";
    return warning;
}

/// Sets in `next` what is different in `now` from `loaded`, and warns of what cannot be set.
Diagnostics carryOver(const Values& loaded, const Description& now, Description& next)
{
    Diagnostics warnings;
    for (std::size_t i = 0; i < now.params.size(); ++i) {
        const ParamDesc& old = now.params[i];
        if (old.value == loaded.params[i]) continue;
        const auto param = std::find_if(next.params.begin(), next.params.end(),
                                        [&](const ParamDesc& each) { return each.name == old.name; });
        const bool there = param != next.params.end() && param->type == old.type;
        const Status fits =
            there ? checkParam(*param, old.value.data(), componentCount(old.type)) : Status{};
        if (there && fits) param->value = old.value;
        else
            warnings.push_back(dropped("param", old, there ? fits.diagnostics()[0].message
                                                           : "the config has none like it"));
    }
    for (std::size_t i = 0; i < now.features.size(); ++i) {
        const FeatureDesc& old = now.features[i];
        if (old.value == loaded.features[i]) continue;
        const std::string& word = old.values[old.value];
        const auto feature =
            std::find_if(next.features.begin(), next.features.end(),
                         [&](const FeatureDesc& each) { return each.name == old.name; });
        const std::vector<std::string> words =
            feature == next.features.end() ? std::vector<std::string>{} : feature->values;
        const auto at = std::find(words.begin(), words.end(), word);
        if (at != words.end()) feature->value = static_cast<int>(at - words.begin());
        else
            warnings.push_back(dropped("feature", old, "the config has no '" + word + "'"));
    }
    return warnings;
}

Diagnostics joined(Diagnostics first, const Diagnostics& second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The status of a new plan, with a warning where shaders had to compile for it.
Status withCompiled(const Status& status, const Execution& execution, const std::string& cause,
                    const Reference& at)
{
    if (!status || execution.compiled().empty()) return status;
    std::string shaders;
    for (const std::string& label : execution.compiled())
        shaders += (shaders.empty() ? "'" : ", '") + label + "'";
    Diagnostic warning{Code::recompiled, cause + ", so setting it compiled " + shaders, at.place,
                       at.pointer};
    warning.severity = Severity::warning;
    warning.help = "set each value once while loading, since what was compiled is kept, or bind a "
                   "param that changes often as a uniform";
    return joined(status.diagnostics(), {warning});
}

}  // namespace

struct Renderer::State {
    Device& device;
    Description description;
    CompileOptions options;
    SceneTraits traits;
    std::unique_ptr<Execution> execution = nullptr;

    /// Plans and makes the objects. `previous` may be null; it is left as it is.
    static Result<std::unique_ptr<State>> make(Device& device, Description description,
                                               const CompileOptions& options,
                                               const SceneTraits& traits, const State* previous);

    /// Whether its plan holds for a camera of another range, whose histories then go on.
    bool holdsFor(const SceneTraits& other) const;

    /// Makes `state` fit the frame's traits and textures, or leaves it where that fails. The
    /// warnings of a new plan come back.
    static Status prepare(std::unique_ptr<State>& state, const Frame& frame);

    /// Puts a new state in the place of `state`, or leaves it where that fails.
    static Status replan(std::unique_ptr<State>& state, Description description,
                         const CompileOptions& options);
};

auto Renderer::State::make(Device& device, Description description, const CompileOptions& options,
                           const SceneTraits& traits, const State* previous)
    -> Result<std::unique_ptr<State>>
{
    Result<Plan> plan = compile(description, traits, device.caps(), options);
    if (!plan) return plan.diagnostics();
    auto execution = Execution::create(device, description, std::move(*plan),
                                       previous ? previous->execution.get() : nullptr);
    if (!execution) return execution.diagnostics();
    std::unique_ptr<State> state(
        new State{device, std::move(description), options, traits, std::move(*execution)});
    return {std::move(state), plan.diagnostics()};
}

bool Renderer::State::holdsFor(const SceneTraits& other) const
{
    SceneTraits same = traits;
    same.camera = other.camera;
    const int height = options.extent.height;
    return same == other &&
           !changesFormats(description, device.caps(),
                           {traits, precisionNeed(description, traits, height)},
                           {other, precisionNeed(description, other, height)});
}

Status Renderer::State::prepare(std::unique_ptr<State>& state, const Frame& frame)
{
    if (Status status = checkFrame(frame); !status) return status;
    const SceneTraits traits = traitsOf(frame);
    if (traits == state->traits) return state->execution->setImports(frame);
    if (state->holdsFor(traits)) {
        if (Status status = state->execution->setImports(frame); !status) return status;
        state->traits = traits;
        return compile(state->description, traits, state->device.caps(), state->options)
            .diagnostics();
    }
    auto next = make(state->device, state->description, state->options, traits, state.get());
    if (!next) return next.diagnostics();
    if (Status status = (*next)->execution->setImports(frame); !status) return status;
    state = std::move(*next);
    return next.diagnostics();
}

Status Renderer::State::replan(std::unique_ptr<State>& state, Description description,
                               const CompileOptions& options)
{
    auto next = make(state->device, std::move(description), options, state->traits, state.get());
    if (next) state = std::move(*next);
    return next.diagnostics();
}

Renderer::Renderer(std::unique_ptr<State> state)
    : state_(std::move(state)), loaded_(valuesOf(state_->description))
{
}

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(Device& device, Description description,
                                                   const CompileOptions& options,
                                                   const SceneTraits& traits)
{
    auto state = State::make(device, std::move(description), options, traits, nullptr);
    if (!state) return state.diagnostics();
    std::unique_ptr<Renderer> renderer(new Renderer(std::move(*state)));
    return {std::move(renderer), state.diagnostics()};
}

Status Renderer::render(const Frame& frame)
{
    const Status prepared = State::prepare(state_, frame);
    if (!prepared) return prepared;
    return joined(prepared.diagnostics(), state_->execution->run(frame).diagnostics());
}

Result<FrameTimes> Renderer::renderTimed(const Frame& frame)
{
    const Status prepared = State::prepare(state_, frame);
    if (!prepared) return prepared.diagnostics();
    auto timed = state_->execution->runTimed(frame);
    Diagnostics all = joined(prepared.diagnostics(), timed.diagnostics());
    if (!timed) return all;
    return {std::move(*timed), std::move(all)};
}

Status Renderer::setParam(std::string_view name, const float* values, int count)
{
    std::vector<ParamDesc>& params = state_->description.params;
    const auto param = std::find_if(params.begin(), params.end(),
                                    [&](const ParamDesc& each) { return each.name == name; });
    if (param == params.end())
        return unknown(Code::unknown_param, "param", name, namesOf(params), "params");
    if (Status status = checkParam(*param, values, count); !status) return status;

    std::array<float, 4> next = param->value;
    std::copy(values, values + count, next.begin());
    if (next == param->value) return {};
    const SceneTraits& traits = state_->traits;
    const int height = state_->options.extent.height;
    const bool reformats =
        param->name == kRadiusName &&
        changesFormats(state_->description, state_->device.caps(),
                       {traits, precisionNeed(state_->description, traits, height)},
                       {traits, precisionNeed(traits, next[0], height)});
    if (!reformats && !changesPlan(state_->description, *param, next)) {
        param->value = next;
        state_->execution->setParam(*param);
        return {};
    }
    Description description = state_->description;
    description.params[param - params.begin()].value = next;
    const std::string cause = param->bind == Bind::define
                                  ? "param '" + param->name + "' is bound as a define"
                              : reformats ? "param '" + param->name + "' wants other formats"
                                          : "param '" + param->name + "' brought passes back";
    const Reference at{param->name, param->place, param->pointer};
    const Status status = State::replan(state_, std::move(description), state_->options);
    return withCompiled(status, *state_->execution, cause, at);
}

Status Renderer::setFeature(std::string_view name, std::string_view value)
{
    const std::vector<FeatureDesc>& features = state_->description.features;
    const FeatureDesc* feature = findNamed(features, name);
    if (!feature)
        return unknown(Code::feature_missing, "feature", name, namesOf(features), "features");
    const auto& all = feature->values;
    const auto word = std::find(all.begin(), all.end(), value);
    if (word == all.end())
        return unknown(Code::feature_value, "value", value, all, feature->name.c_str());
    const int index = static_cast<int>(word - all.begin());
    if (index == feature->value) return {};
    Description description = state_->description;
    description.features[feature - features.data()].value = index;
    const Reference at{feature->name, feature->place, feature->pointer};
    const Status status = State::replan(state_, std::move(description), state_->options);
    return withCompiled(status, *state_->execution, "feature '" + at.name + "' is a define", at);
}

Status Renderer::reload(Description description, const CompileOptions& options)
{
    const Values loaded = valuesOf(description);
    Diagnostics all = carryOver(loaded_, state_->description, description);
    auto next = State::make(state_->device, std::move(description), options, state_->traits,
                            state_.get());
    if (!next) return next.diagnostics();
    state_ = std::move(*next);
    loaded_ = loaded;
    return joined(std::move(all), next.diagnostics());
}

Status Renderer::resize(Extent extent)
{
    if (extent == state_->options.extent) return {};
    CompileOptions options = state_->options;
    options.extent = extent;
    return State::replan(state_, state_->description, options);
}

TextureId Renderer::output(std::string_view name, int view) const
{
    return state_->execution->output(name, view);
}

std::string Renderer::changes() const { return valuesPatch(loaded_, state_->description); }

const Plan& Renderer::plan() const { return state_->execution->plan(); }
const Description& Renderer::description() const { return state_->description; }

}  // namespace crevice
