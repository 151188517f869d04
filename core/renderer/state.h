// SPDX-License-Identifier: MIT
// What a renderer is made of: a description, its plan's objects, and levels that are ready.
#pragma once

#include <crevice/renderer.h>

#include "core/compile/depth_precision.h"
#include "core/config/values.h"
#include "core/run/execution.h"

#include <cmath>

namespace crevice {

/// Whether a plan made with the param's value `now` does not hold for `next`.
bool changesPlan(const Description& description, const ParamDesc& param,
                 const std::array<float, 4>& now, const std::array<float, 4>& next);

struct Renderer::State {
    /// A description that may take the place of the present one at once.
    struct Level {
        Description description;
        Values loaded = {};                 ///< Those that its config gave.
        std::optional<Plan> plan = {};      ///< For the size and traits of now.
        Execution::Programs programs = {};  ///< Of the plan, so that nothing drops them.
    };

    Device* device;
    Values loaded = {};  ///< Those that the config gave.
    Description description = {};
    CompileOptions options = {};
    SceneTraits traits = {};
    std::unique_ptr<Execution> execution = nullptr;
    bool timing = false;
    std::vector<Level> levels = {};
    int level = -1;  ///< That is drawn, of those.

    /// The state of another plan and its objects, made beside those of this one, without levels.
    /// `remember`: its histories go on.
    Result<State> with(Description other, const CompileOptions& with_options,
                       const SceneTraits& scene, bool remember = true) const
    {
        Result<Plan> plan = compile(other, scene, device->caps(), with_options);
        if (!plan) return plan.diagnostics();
        Result<State> made =
            with(std::move(other), std::move(*plan), with_options, scene, remember);
        if (!made) return made.diagnostics();
        return {std::move(*made), plan.diagnostics()};
    }
    Result<State> with(Description other, Plan plan, const CompileOptions& with_options,
                       const SceneTraits& scene, bool remember) const
    {
        auto made = Execution::create(*device, std::move(plan), execution.get(), remember);
        if (!made) return made.diagnostics();
        if (timing) (void)(*made)->setTiming(true);
        return State{device,           loaded, std::move(other), with_options, scene,
                     std::move(*made), timing};
    }

    /// Takes the place of this one, and its levels.
    void become(State next)
    {
        next.levels = std::move(levels);
        next.level = level;
        *this = std::move(next);
    }

    /// Plans a level, or all, and compiles their programs. Errors: those of `create`; what fails
    /// has no plan then. levels.cpp has both.
    Status ready(Level& each);
    Diagnostics readyLevels();

    /// Sets a param or feature in those levels that have it and take the value.
    void setParamOfLevels(std::string_view name, const float* values, int count);
    void setFeatureOfLevels(std::string_view name, const std::string& word);

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
                const Result<Plan> plan = compile(set, traits, device->caps(), options);
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
        return formatsHold(description, execution->plan(), scene);
    }
    bool formatsHold(const Description& of, const Plan& plan, const SceneTraits& scene) const
    {
        return allOf(plan.targets, [&](const PlanTarget& target) {
            const TargetDesc& desc = *findNamed(of.targets, target.name);
            return chooseFormat(of, desc, scene, device->caps(), options.extent.height) ==
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
