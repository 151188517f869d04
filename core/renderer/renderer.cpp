// SPDX-License-Identifier: MIT
// The renderer: keeps a description's plan in step with params, size and scene, and runs it.
#include <crevice/renderer.h>

#include "core/compile/depth_precision.h"
#include "core/config/values.h"
#include "core/run/execution.h"

#include <cmath>

namespace crevice {
namespace {

/// Whether a plan made with the param's value `now` does not hold for `next`.
bool changesPlan(const Description& description, const ParamDesc& param,
                 const std::array<float, 4>& now, const std::array<float, 4>& next)
{
    if (param.bind == Bind::define) return true;
    for (const GeneratedDesc& generated : description.generated)
        if (generated.count_param.name == param.name) return true;
    for (const TargetDesc& target : description.targets)
        if (target.size.scale_param.name == param.name || target.samples_param.name == param.name)
            return true;
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

struct Renderer::State {
    Device* device;
    Values loaded = {};  ///< Those that the config gave.
    Description description = {};
    CompileOptions options = {};
    SceneTraits traits = {};
    std::unique_ptr<Execution> execution = nullptr;
    bool timing = false;

    /// The state of another plan and its objects, made beside those of this one.
    Result<State> with(Description other, const CompileOptions& with_options,
                       const SceneTraits& scene) const
    {
        Result<Plan> plan = compile(other, scene, device->caps(), with_options);
        if (!plan) return plan.diagnostics();
        auto made = Execution::create(*device, std::move(*plan), execution.get());
        if (!made) return made.diagnostics();
        if (timing) (void)(*made)->setTiming(true);
        return {
            State{device, loaded, std::move(other), with_options, scene, std::move(*made), timing},
            plan.diagnostics()};
    }

    /// Compiles the programs of all levels, so that setting one compiles none. Warns of what fails.
    Diagnostics prepareLevels()
    {
        Diagnostics warnings;
        for (std::size_t i = 0; i < description.features.size(); ++i) {
            const FeatureDesc& feature = description.features[i];
            // The present word too: its values may have been set otherwise since.
            for (std::size_t word = 0; !feature.sets.empty() && word < feature.values.size();
                 ++word) {
                Description level = description;
                level.features[i].value = static_cast<int>(word);
                applyLevel(level, feature.name);
                const Result<Plan> plan = compile(level, traits, device->caps(), options);
                const Status ready = plan ? execution->prepare(*plan) : plan.diagnostics();
                for (Diagnostic each : ready ? Diagnostics() : ready.diagnostics()) {
                    each.message =
                        feature.name + " '" + feature.values[word] + "': " + each.message;
                    warnings.push_back(asWarning(std::move(each)));
                }
            }
        }
        return warnings;
    }

    /// Whether the plan's formats are those chosen for such a scene. Allocates nothing.
    bool formatsHold(const SceneTraits& scene) const
    {
        const Plan& plan = execution->plan();
        return allOf(plan.targets, [&](const PlanTarget& target) {
            const TargetDesc& desc = *findNamed(description.targets, target.name);
            return chooseFormat(description, desc, scene, device->caps(), options.extent.height) ==
                   plan.textures[target.texture].format;
        });
    }

    /// Gives the plan lengths that are relative to the scene. Whether its formats still hold then.
    Result<bool> followScale(const SceneTraits& scene)
    {
        traits.scale = scene.scale;
        bool holds = true;
        for (const ParamDesc& param : description.params) {
            if (!isRelative(param)) continue;
            const std::array<float, 4> value = sceneUnits(param, scene, options.extent.height);
            if (std::isnan(value[0]))
                return Diagnostic{Code::missing_import,
                                  param.name + " is relative to what Frame::scale lacks",
                                  "set it, by Effect::setScale, or give a length in scene units",
                                  param.place, param.pointer};
            execution->setParam(param.name, value.data());
            holds = holds && formatsHold(scene);
        }
        return holds;
    }

    /// Makes this fit the frame, or leaves it where that fails. A new plan's warnings come back.
    Status prepare(const Frame& frame)
    {
        if (Status status = checkFrame(frame); !status) return status;
        if (options.strict) {
            Diagnostics errors = warnElided(frame, *device);
            for (Diagnostic& error : errors) {
                error.severity = Severity::error;
                error.message = "the frame cannot be drawn whole: " + error.message;
            }
            if (!errors.empty()) return errors;
        }
        SceneTraits scene = steadyTraitsOf(frame);
        const Result<bool> holds = followScale(scene);
        if (!holds) return holds.diagnostics();
        if (*holds && scene == traits) return execution->setImports(frame);
        scene.draws = rangeOf(frame.draws, frame.camera);
        SceneTraits moved = traits;
        moved.camera = scene.camera;
        if (moved == scene && formatsHold(scene)) {  // histories go on
            if (Status status = execution->setImports(frame); !status) return status;
            traits = scene;
            return compile(description, traits, device->caps(), options).diagnostics();
        }
        Result<State> next = with(description, options, scene);
        if (!next) return next.diagnostics();
        if (Status status = next->execution->setImports(frame); !status) return status;
        *this = std::move(*next);
        Diagnostics all = next.diagnostics();
        append(all, prepareLevels());
        return all;
    }

    /// Becomes `with` its arguments, or stays where that fails.
    Status replan(Description other, const CompileOptions& with_options)
    {
        Result<State> next = with(std::move(other), with_options, traits);
        if (next) *this = std::move(*next);
        return next.diagnostics();
    }
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(Device& device, Description description,
                                                   const CompileOptions& options,
                                                   const SceneTraits& traits)
{
    auto state =
        State{&device, valuesOf(description)}.with(std::move(description), options, traits);
    if (!state) return state.diagnostics();
    Diagnostics all = state.diagnostics();
    append(all, state->prepareLevels());
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
    if (control == ClipControl() && range == DepthRange()) return frame;
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

Status Renderer::setTiming(bool on)
{
    state_->timing = on;
    if (state_->execution->setTiming(on) || !on) return {};
    const DeviceCaps& caps = state_->device->caps();
    return asWarning({Code::no_timers,
                      caps.timers ? "the plan's views have more than " +
                                        std::to_string(kMaxFrameTimers) + " passes together"
                                  : "'" + caps.name + "' has no timer that can be trusted",
                      "time with renderTimed, which waits for each pass and takes the clock"});
}

const FrameTimes* Renderer::times() const { return state_->execution->times(); }

Status Renderer::setParam(std::string_view name, const float* values, int count)
{
    std::vector<ParamDesc>& params = state_->description.params;
    const int index = indexOf(params, name);
    if (index < 0) return unknown(Code::unknown_param, "param", name, namesOf(params), "params");
    ParamDesc* const param = &params[index];
    if (Status status = checkValue(*param, values, count); !status) return status;

    const auto units = [&] {
        return sceneUnits(*param, state_->traits, state_->options.extent.height);
    };
    const std::array<float, 4> old = param->value, before = units();
    param->value = {};
    std::copy(values, values + count, param->value.begin());
    if (param->value == old) return {};
    const std::array<float, 4> next = units();
    const bool replans = changesPlan(state_->description, *param, before, next);
    const bool reformats =
        param->semantic == ParamSemantic::length && !state_->formatsHold(state_->traits);
    if (!reformats && !replans) {
        state_->execution->setParam(name, next.data());
        return {};
    }
    Description description = state_->description;
    param->value = old;  // which stays where there is no plan for the next
    const std::string cause = param->bind == Bind::define
                                  ? "param '" + param->name + "' is bound as a define"
                              : reformats ? "param '" + param->name + "' wants other formats"
                                          : "param '" + param->name + "' brought passes back";
    const Named at = *param;
    const Status status = state_->replan(std::move(description), state_->options);
    return withCompiled(status, *state_->execution, cause, at);
}

Status Renderer::setImportFormat(std::string_view name, Format format)
{
    Description description = state_->description;
    const int index = indexOf(description.imports, name);
    if (index < 0)
        return unknown(Code::reference_missing, "import", name, namesOf(description.imports),
                       "imports");
    ImportDesc& import = description.imports[index];
    if (import.format == formatInfo(format).name) return {};
    import.format = formatInfo(format).name;
    return state_->replan(std::move(description), state_->options);
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
    applyLevel(description, feature->name);
    const Named at = *feature;
    const Status status = state_->replan(std::move(description), state_->options);
    return withCompiled(status, *state_->execution, "feature '" + at.name + "' is a define", at);
}

Status Renderer::reload(Description description, const CompileOptions& options)
{
    const Values loaded = valuesOf(description);
    Diagnostics all = carryOver(state_->loaded, state_->description, description);
    const Status status = state_->replan(std::move(description), options);
    if (!status) return status;
    state_->loaded = loaded;
    append(all, status.diagnostics());
    append(all, state_->prepareLevels());
    return all;
}

Status Renderer::resize(Extent extent)
{
    if (extent == state_->options.extent) return {};
    CompileOptions options = state_->options;
    options.extent = extent;
    return state_->replan(state_->description, options);
}

TextureId Renderer::output(std::string_view name, int view) const
{
    return state_->execution->output(name, view);
}

const Plan& Renderer::plan() const { return state_->execution->plan(); }
const Description& Renderer::description() const { return state_->description; }

}  // namespace crevice
