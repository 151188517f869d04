// SPDX-License-Identifier: MIT
// Levels: descriptions whose plans and programs are there before they are drawn.
#include "core/renderer/state.h"

namespace crevice {
namespace {

/// What a host must hand over, by kind and name.
std::vector<std::string> needsOf(const Description& description)
{
    std::vector<std::string> needs;
    for (const ImportDesc& import : description.imports)
        if (!import.optional &&
            (import.type == ImportType::texture || import.type == ImportType::draw_list))
            needs.push_back((import.type == ImportType::texture ? "the texture '" : "the draws '") +
                            import.name + "'");
    std::sort(needs.begin(), needs.end());
    if (needs.empty()) needs.push_back("nothing");
    return needs;
}

/// Errors: CV2102 where a level needs what the first does not, or the other way round.
Status checkNeeds(const Description& first, const Description& level)
{
    const std::vector<std::string> wanted = needsOf(first), found = needsOf(level);
    if (wanted == found) return {};
    return Diagnostic{Code::reference_missing,
                      "level '" + level.name + "' takes " + joined(found, " and ") +
                          ", and level '" + first.name + "' takes " + joined(wanted, " and "),
                      "lay the same module over all levels, as in 'mobile+geometry/host_depth'",
                      level.place};
}

Diagnostics ofLevel(const Description& level, Diagnostics found)
{
    for (Diagnostic& each : found) each.message = "level '" + level.name + "': " + each.message;
    return found;
}

}  // namespace

Status Renderer::State::ready(Level& each)
{
    each.plan.reset();
    execution->keep(each.programs);
    Result<Plan> plan = compile(each.description, traits, device->caps(), options);
    if (!plan) return ofLevel(each.description, plan.diagnostics());
    auto programs = execution->prepare(*plan);
    if (!programs) return ofLevel(each.description, programs.diagnostics());
    each.plan = std::move(*plan);
    each.programs = std::move(*programs);
    return ofLevel(each.description, plan.diagnostics());
}

Diagnostics Renderer::State::readyLevels()
{
    Diagnostics warnings;
    for (Level& each : levels) {
        const Status status = ready(each);
        if (!status)
            for (const Diagnostic& error : status.diagnostics())
                warnings.push_back(asWarning(error));
    }
    return warnings;
}

void Renderer::State::setParamOfLevels(std::string_view name, const float* values, int count)
{
    for (Level& each : levels) {
        const int index = indexOf(each.description.params, name);
        if (index < 0) continue;
        ParamDesc& param = each.description.params[index];
        if (!checkValue(param, values, count)) continue;
        const auto before = sceneUnits(param, traits, options.extent.height);
        param.value = {};
        std::copy(values, values + count, param.value.begin());
        const auto now = sceneUnits(param, traits, options.extent.height);
        if (!each.plan || changesPlan(each.description, param, before, now)) {
            (void)ready(each);  // `setLevel` tells what fails
            continue;
        }
        if (const int used = indexOf(each.plan->params, name); used >= 0)
            each.plan->params[used].initial = now;
    }
}

void Renderer::State::setFeatureOfLevels(std::string_view name, const std::string& word)
{
    for (Level& each : levels) {
        const int index = indexOf(each.description.features, name);
        if (index < 0) continue;
        FeatureDesc& feature = each.description.features[index];
        const auto found = std::find(feature.values.begin(), feature.values.end(), word);
        if (found == feature.values.end()) continue;
        feature.value = static_cast<int>(found - feature.values.begin());
        applyLevel(each.description, name);
        (void)ready(each);
    }
}

Status Renderer::setLevels(std::vector<Description> levels, int level)
{
    State& state = *state_;
    std::vector<State::Level> made;
    Diagnostics all;
    for (Description& each : levels) {
        if (Status same = checkNeeds(levels.front(), each); !same) return same;
        Values loaded = valuesOf(each);
        append(all, ofLevel(each, carryOver(state.loaded, state.description, each)));
        for (ImportDesc& import : each.imports)
            if (const ImportDesc* now = findNamed(state.description.imports, import.name))
                import.format = now->format;
        made.push_back({each, std::move(loaded)});
    }
    for (State::Level& each : made) {
        const Status status = state.ready(each);
        if (!status) return status;
        append(all, status.diagnostics());
    }
    std::swap(state.levels, made);
    const int before = std::exchange(state.level, -1);
    const Status status = setLevel(level);
    if (status) return all;
    std::swap(state.levels, made);
    state.level = before;
    return status;
}

Status Renderer::setLevel(int index)
{
    State& state = *state_;
    if (index == state.level) return {};
    State::Level& level = state.levels[index];
    const bool holds =
        level.plan && state.formatsHold(level.description, *level.plan, state.traits);
    if (const Status status = holds ? Status() : state.ready(level); !status) return status;
    state.execution->keep(level.programs);
    Result<State> next =
        state.with(level.description, *level.plan, state.options, state.traits, true);
    if (!next) return ofLevel(level.description, next.diagnostics());
    state.become(std::move(*next));
    state.loaded = level.loaded;
    state.level = index;
    return {};
}

int Renderer::level() const { return state_->level; }

const ImportDesc* Renderer::import(std::string_view name) const
{
    const auto find = [name](const Description& description) {
        const ImportDesc* found = findNamed(description.imports, name);
        return found && found->type == ImportType::texture ? found : nullptr;
    };
    const ImportDesc* found = find(state_->description);
    for (const State::Level& each : state_->levels)
        if (!found) found = find(each.description);
    return found;
}

Status Renderer::setImportFormat(std::string_view name, Format format)
{
    State& state = *state_;
    const ImportDesc* const known = import(name);
    if (!known)
        return Diagnostic{Code::reference_missing, "there is no import '" + std::string(name) + "'",
                          suggestName(name, namesOf(state.description.imports), "imports")};
    const std::string word = formatInfo(format).name;
    if (known->format == word) return {};
    Description description = state.description;
    if (const int index = indexOf(description.imports, name); index >= 0) {
        description.imports[index].format = word;
        if (Status status = state.replan(std::move(description), state.options); !status)
            return status;
    }
    for (State::Level& each : state.levels)
        if (const int index = indexOf(each.description.imports, name); index >= 0)
            each.description.imports[index].format = word;
    return state.readyLevels();
}

}  // namespace crevice
