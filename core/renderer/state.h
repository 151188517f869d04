// SPDX-License-Identifier: MIT
// What a renderer is made of: a description, its plan's objects, and levels that may be drawn.
#pragma once

#include <crevice/renderer.h>

#include "core/config/values.h"
#include "core/plan/depth_precision.h"
#include "core/run/execution.h"

#include <cmath>

namespace crevice {

struct Renderer::State {
    /// A description that may take the place of the present one.
    struct Level {
        Description description;
        std::string label;  ///< "level 0, 'mobile'", for messages.
        Values loaded;      ///< Those that its config gave.
        Execution::Programs programs =
            {};  ///< For size and traits of now, so that none is dropped.
    };

    Device* device;
    Values loaded = {};  ///< Those that the config gave.
    Description description = {};
    CompileOptions options = {};
    SceneTraits traits = {};
    std::unique_ptr<Execution> execution = nullptr;
    bool timing = false;
    std::vector<std::string> followed = {};
    std::vector<Level> levels = {};
    int level = -1;  ///< That is drawn, of those.

    Result<Plan> planOf(const Description& other, const SceneTraits& scene,
                        const CompileOptions& with_options) const
    {
        return other.planner->plan(other, scene, device->caps(), with_options);
    }

    /// The state of another plan and its objects, made beside those of this one, without levels.
    /// `remember`: its histories go on.
    Result<State> with(Description other, const CompileOptions& with_options,
                       const SceneTraits& scene, bool remember = true) const
    {
        Result<Plan> plan = planOf(other, scene, with_options);
        if (!plan) return plan.diagnostics();
        auto made = Execution::create(*device, std::move(*plan), execution.get(), remember);
        if (!made) return made.diagnostics();
        if (timing) (void)(*made)->setTiming(true);
        (*made)->follow(followed);
        return {State{device, loaded, std::move(other), with_options, scene, std::move(*made),
                      timing, followed},
                plan.diagnostics()};
    }

    /// Takes the place of this one, and its levels.
    void become(State next)
    {
        next.levels = std::move(levels);
        next.level = level;
        *this = std::move(next);
    }

    /// Compiles the programs of a level. Errors: those of `create`. levels.cpp has it.
    Status ready(Level& each);

    /// ... Of all of them. Warns of what fails.
    Diagnostics readyLevels()
    {
        Diagnostics warnings;
        for (Level& each : levels)
            if (const Status status = ready(each); !status)
                for (const Diagnostic& error : status.diagnostics())
                    warnings.push_back(asWarning(error));
        return warnings;
    }

    /// That of the name, or null.
    template <class T>
    static T* find(std::vector<T>& list, std::string_view name)
    {
        const int index = indexOf(list, name);
        return index < 0 ? nullptr : &list[index];
    }

    /// Changes the entry `name` of a list wherever there is one, if all of them pass `check`: what
    /// is drawn by `draw`, then levels by `change`, true where their plan is another then. Nothing
    /// where there is no entry. Warns of levels that fail.
    template <class T, class Check, class Draw, class Change>
    std::optional<Status> changeAll(std::vector<T> Description::*list, std::string_view view,
                                    const Check& check, const Draw& draw, const Change& change)
    {
        const std::string name(levels.empty() ? "" : view);  // which may be the old plan's
        T* const own = find(description.*list, view);
        bool known = own != nullptr, changed = false;
        Status status = own ? check(*own) : Status();
        for (const Level& each : levels) {
            const T* const found = findNamed(each.description.*list, view);
            known = known || found;
            if (found && status) status = check(*found);
        }
        if (!known) return std::nullopt;
        if (status && own) status = draw(*own);
        if (!status) return status;
        for (Level& each : levels)
            if (T* const found = find(each.description.*list, name))
                changed = change(each.description, *found) || changed;
        Diagnostics all = status.diagnostics();
        if (changed) append(all, readyLevels());
        return all;
    }

    Status setParam(ParamDesc& param, const std::array<float, 4>& value);
    std::array<float, 4> units(const ParamDesc& param) const
    {
        return sceneUnits(param, traits, options.extent.height);
    }

    /// Compiles the programs of all words that set values, so that setting one compiles none, and
    /// makes the levels ready. Warns of what fails.
    Diagnostics prepareAll()
    {
        Diagnostics warnings;
        for (std::size_t i = 0; i < description.features.size(); ++i) {
            const FeatureDesc& feature = description.features[i];
            // The present word too: its values may have been set otherwise since.
            for (std::size_t word = 0; !feature.sets.empty() && word < feature.values.size();
                 ++word) {
                Description set = description;
                set.features[i].value = static_cast<int>(word);
                applyLevel(set, feature.name);
                const Result<Plan> plan = planOf(set, traits, options);
                const auto made = plan ? execution->prepare(*plan) : plan.diagnostics();
                for (Diagnostic each : made ? Diagnostics() : made.diagnostics()) {
                    each.message =
                        feature.name + " '" + feature.values[word] + "': " + each.message;
                    warnings.push_back(asWarning(std::move(each)));
                }
            }
        }
        append(warnings, readyLevels());
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
        const bool same_draws = execution->sameDraws(frame);
        if (options.strict && !same_draws) {
            Diagnostics errors = warnElided(frame, *device);
            for (Diagnostic& error : errors) {
                error.severity = Severity::error;
                error.message = "the frame cannot be drawn whole: " + error.message;
            }
            if (!errors.empty()) return errors;
        }
        SceneTraits scene = steadyTraitsOf(frame, same_draws ? &traits : nullptr);
        const Result<bool> holds = followScale(scene);
        if (!holds) return holds.diagnostics();
        if (*holds && scene == traits) return execution->setImports(frame);
        scene.draws = rangeOf(frame.draws, frame.camera);
        SceneTraits moved = traits;
        moved.camera = scene.camera;
        if (moved == scene && formatsHold(scene)) {  // histories go on
            if (Status status = execution->setImports(frame); !status) return status;
            traits = scene;
            return planOf(description, traits, options).diagnostics();
        }
        Result<State> next = with(description, options, scene);
        if (!next) return next.diagnostics();
        if (Status status = next->execution->setImports(frame); !status) return status;
        become(std::move(*next));
        Diagnostics all = next.diagnostics();
        append(all, prepareAll());
        return all;
    }

    /// Becomes `with` its arguments, or stays where that fails.
    Status replan(Description other, const CompileOptions& with_options, bool remember = true)
    {
        Result<State> next = with(std::move(other), with_options, traits, remember);
        if (next) become(std::move(*next));
        return next.diagnostics();
    }
};

}  // namespace crevice
