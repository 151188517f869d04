// SPDX-License-Identifier: MIT
// The renderer: keeps a description's plan in step with params, size and scene, and runs it.
#include "core/renderer/state.h"

namespace crevice {
namespace {

/// Whether a plan made with the param's value `now` does not hold for `next`.
bool changesPlan(const Description& description, const ParamDesc& param,
                 const std::array<float, 4>& now, const std::array<float, 4>& next)
{
    if (param.bind == Bind::define) return true;
    for (const GeneratedDesc& generated : description.generated)
        if (generated.count_param.name == param.name) return true;
    for (const TargetDesc& target : description.targets) {
        const SizeDesc& size = target.size;
        if (size.scale_param.name == param.name || target.samples_param.name == param.name)
            return true;
        for (const ProductDesc* texels : {&size.width, &size.height, &size.depth})
            if (findNamed(texels->params, param.name)) return true;
    }
    for (const PassDesc& pass : description.passes) {
        if (pass.frustum_scale_param.name == param.name) return true;
        for (const NoOpDesc& no_op : pass.no_op)
            if (no_op.name == param.name &&
                isAll(now, param.type, no_op.at) != isAll(next, param.type, no_op.at))
                return true;
    }
    return false;
}

Diagnostic unknown(Code code, const char* what, std::string_view name,
                   std::vector<std::string> names, const char* heading)
{
    return {code, std::string("there is no ") + what + " '" + std::string(name) + "'",
            suggestName(name, std::move(names), heading)};
}

/// The status of a new plan, with a warning where shaders had to compile for it.
Status withCompiled(const Status& status, const Execution& execution, const std::string& cause,
                    const Named& at)
{
    if (!status || execution.compiled().empty()) return status;
    const std::string shaders = "'" + joined(execution.compiled(), "', '") + "'";
    Diagnostics all = status.diagnostics();
    all.push_back(
        asWarning({Code::recompiled, cause + ", so setting it compiled " + shaders,
                   "set each value once while loading, since what was compiled is kept, or "
                   "bind a param that changes often as a uniform",
                   at.place, at.pointer}));
    return all;
}

}  // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::createPlanned(Device& device, Description description,
                                                          const CompileOptions& options,
                                                          const SceneTraits& traits)
{
    auto state =
        State{&device, valuesOf(description)}.with(std::move(description), options, traits);
    if (!state) return state.diagnostics();
    Diagnostics all = state.diagnostics();
    append(all, state->prepareAll());
    auto made = std::make_unique<State>(std::move(*state));
    return {std::unique_ptr<Renderer>(new Renderer(std::move(made))), std::move(all)};
}

const Frame& Renderer::asHostDraws(const Frame& frame)
{
    const Device& device = *state_->device;
    const ClipControl control = device.clipControl();
    // Where crevice alone draws depth, the host's range, one for its sky say, means nothing.
    const auto is_depth = [](const ImportDesc& import) {
        return import.type == ImportType::texture &&
               formatInfo(formatFromName(import.format)).format_class == FormatClass::depth;
    };
    const bool reads_depth = anyOf(plan().imports, is_depth);
    const DepthRange range = reads_depth ? device.depthRange() : DepthRange();
    const auto has_all = [](const auto& camera) {
        return camera.clip_control && camera.depth_range;
    };
    if ((control == ClipControl() && range == DepthRange()) ||
        (has_all(frame.camera) &&
         allOf(frame.other_views, [&](const FrameView& view) { return has_all(view.camera); })))
        return frame;
    clipped_ = frame;
    const auto take = [&](Camera& camera) {
        if (!camera.clip_control) camera.clip_control = control;
        if (!camera.depth_range) camera.depth_range = range;
    };
    take(clipped_.camera);
    for (FrameView& view : clipped_.other_views) take(view.camera);
    return clipped_;
}

Status Renderer::render(const Frame& given)
{
    const Frame& frame = asHostDraws(given);
    const Status prepared = state_->prepare(frame);
    if (!prepared) return prepared;
    Diagnostics all = prepared.diagnostics();
    append(all, state_->execution->run(frame).diagnostics());
    return all;
}

Result<FrameTimes> Renderer::renderTimed(const Frame& given)
{
    const Frame& frame = asHostDraws(given);
    const Status prepared = state_->prepare(frame);
    if (!prepared) return prepared.diagnostics();
    auto timed = state_->execution->runTimed(frame);
    Diagnostics all = prepared.diagnostics();
    append(all, timed.diagnostics());
    if (!timed) return all;
    return {std::move(*timed), std::move(all)};
}

Result<bool> Renderer::warm(const Frame& given)
{
    const Frame& frame = asHostDraws(given);
    const Status prepared = state_->prepare(frame);
    if (!prepared) return prepared.diagnostics();
    const Result<bool> ready = state_->execution->warm(frame);
    if (!ready) return ready;
    return {*ready, prepared.diagnostics()};
}

Status Renderer::setTiming(bool on)
{
    state_->timing = on;
    if (state_->execution->setTiming(on) || !on) return {};
    return asWarning({Code::no_timers,
                      "'" + state_->device->caps().name + "' has no timer that can be trusted",
                      "time with renderTimed, which waits for each pass and takes the clock"});
}

const FrameTimes* Renderer::times() const { return state_->execution->times(); }

void Renderer::follow(std::string_view output)
{
    std::vector<std::string>& names = state_->followed;
    if (contains(names, output)) return;
    names.emplace_back(output);
    state_->execution->follow(names);
}

const std::array<float, 4>* Renderer::value(std::string_view output) const
{
    return state_->execution->value(output);
}

void Renderer::takeTimes() { state_->execution->takeTimes(); }

Status Renderer::State::setParam(ParamDesc& param, const std::array<float, 4>& value)
{
    const std::array<float, 4> old = param.value, before = units(param);
    param.value = value;
    if (value == old) return {};
    const std::array<float, 4> next = units(param);
    const bool replans = changesPlan(description, param, before, next);
    const bool reformats = param.semantic == ParamSemantic::length && !formatsHold(traits);
    if (!reformats && !replans) {
        execution->setParam(param.name, next.data());
        return {};
    }
    Description changed = description;
    param.value = old;  // which stays where there is no plan for the next
    const std::string cause = param.bind == Bind::define
                                  ? "param '" + param.name + "' is bound as a define"
                              : reformats ? "param '" + param.name + "' wants other formats"
                                          : "param '" + param.name + "' brought passes back";
    const Named at = param;
    const Status status = replan(std::move(changed), options);
    return withCompiled(status, *execution, cause, at);
}

Status Renderer::setParam(std::string_view name, const float* values, int count)
{
    State& state = *state_;
    std::array<float, 4> value = {};
    const auto status = state.changeAll(
        &Description::params, name,
        [&](const ParamDesc& each) { return checkValue(each, values, count); },
        [&](ParamDesc& own) {
            std::copy(values, values + count, value.begin());
            return state.setParam(own, value);
        },
        [&](Description& level, ParamDesc& param) {
            const std::array<float, 4> before = state.units(param);
            param.value = {};
            std::copy(values, values + count, param.value.begin());
            return changesPlan(level, param, before, state.units(param));
        });
    if (status) return *status;
    return unknown(Code::unknown_param, "param", name, namesOf(state.description.params), "params");
}

Status Renderer::setFeature(std::string_view name, std::string_view value)
{
    State& state = *state_;
    const std::string word(value);
    const auto indexIn = [&](const FeatureDesc& each) {
        const auto found = std::find(each.values.begin(), each.values.end(), word);
        return static_cast<int>(found - each.values.begin());
    };
    const auto status = state.changeAll(
        &Description::features, name,
        [&](const FeatureDesc& each) -> Status {
            if (indexIn(each) < static_cast<int>(each.values.size())) return {};
            return unknown(Code::feature_value, "value", word, each.values, each.name.c_str());
        },
        [&](const FeatureDesc& own) -> Status {
            if (own.value == indexIn(own)) return {};
            Description changed = state.description;
            State::find(changed.features, own.name)->value = indexIn(own);
            applyLevel(changed, own.name);
            const Named at = own;
            const Status planned = state.replan(std::move(changed), state.options);
            return withCompiled(planned, *state.execution, "feature '" + at.name + "' is a define",
                                at);
        },
        [&](Description& level, FeatureDesc& feature) {
            feature.value = indexIn(feature);
            applyLevel(level, feature.name);
            return true;
        });
    if (status) return *status;
    return unknown(Code::feature_missing, "feature", name, namesOf(state.description.features),
                   "features");
}

Status Renderer::reload(Description description, const CompileOptions& options)
{
    if (!description.planner) description.planner = state_->description.planner;
    const Values loaded = valuesOf(description);
    Diagnostics all = carryOver(state_->loaded, state_->description, description);
    const Status status = state_->replan(std::move(description), options, false);
    if (!status) return status;
    state_->loaded = loaded;
    state_->levels.clear();
    state_->level = -1;
    append(all, status.diagnostics());
    append(all, state_->prepareAll());
    return all;
}

Status Renderer::resize(Extent extent)
{
    if (extent == state_->options.extent) return {};
    CompileOptions options = state_->options;
    options.extent = extent;
    const Status status = state_->replan(state_->description, options);
    if (!status) return status;
    Diagnostics all = status.diagnostics();
    append(all, state_->readyLevels());
    return all;
}

TextureId Renderer::output(std::string_view name, int view) const
{
    return state_->execution->output(name, view);
}

const Plan& Renderer::plan() const { return state_->execution->plan(); }
const Description& Renderer::description() const { return state_->description; }

}  // namespace crevice
