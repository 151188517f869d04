// SPDX-License-Identifier: MIT
// Levels: descriptions whose programs are there before they are drawn.
#include "core/renderer/state.h"

namespace crevice {
namespace {

/// Errors: CV2102 where `level` takes something of the host that `other` does not.
Status checkNeeds(const Description& level, const Description& other)
{
    for (const ImportDesc& import : level.imports) {
        const bool texture = import.type == ImportType::texture;
        if (import.optional || (!texture && import.type != ImportType::draw_list)) continue;
        const ImportDesc* const same = findNamed(other.imports, import.name);
        if (same && same->type == import.type && !same->optional) continue;
        return Diagnostic{Code::reference_missing,
                          "level '" + level.name + "' takes the " +
                              (texture ? "texture '" : "draws '") + import.name + "', and level '" +
                              other.name + "' does not",
                          "lay the same module over all levels, as in 'mobile+geometry/host_depth'",
                          import.place};
    }
    return {};
}

Diagnostics labelled(Diagnostics found, const std::string& label)
{
    for (Diagnostic& each : found) each.message = label + ": " + each.message;
    return found;
}

}  // namespace

Status Renderer::State::ready(Level& each)
{
    execution->keep(each.programs);
    const Result<Plan> plan = planOf(each.description, traits, options);
    auto programs = plan ? execution->prepare(*plan) : plan.diagnostics();
    if (!programs) return labelled(programs.diagnostics(), each.label);
    each.programs = std::move(*programs);
    return labelled(plan.diagnostics(), each.label);
}

Status Renderer::setLevels(std::vector<Description> levels, int level)
{
    State& state = *state_;
    std::vector<State::Level> made;
    Diagnostics all;
    for (Description& each : levels) {
        if (!each.planner) each.planner = state.description.planner;
        Status same = checkNeeds(each, levels.front());
        if (same) same = checkNeeds(levels.front(), each);
        if (!same) return same;
        const std::string label = "level " + std::to_string(made.size()) + ", '" + each.name + "'";
        const Values loaded = valuesOf(each);
        append(all, labelled(carryOver(state.loaded, state.description, each), label));
        for (ImportDesc& import : each.imports)
            if (const ImportDesc* now = findNamed(state.description.imports, import.name))
                import.format = now->format;
        made.push_back({each, label, loaded});
        const Status status = state.ready(made.back());
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
    const State::Level& level = state.levels[index];
    state.execution->keep(level.programs);
    Result<State> next = state.with(level.description, state.options, state.traits);
    if (!next) return labelled(next.diagnostics(), level.label);
    state.become(std::move(*next));
    state.loaded = level.loaded;
    state.level = index;
    return {};
}

int Renderer::level() const { return state_->level; }

const ImportDesc* Renderer::import(std::string_view name) const
{
    const ImportDesc* found = findNamed(state_->description.imports, name);
    for (const State::Level& each : state_->levels)
        if (!found) found = findNamed(each.description.imports, name);
    return found && found->type == ImportType::texture ? found : nullptr;
}

Status Renderer::setImportFormat(std::string_view name, Format format)
{
    State& state = *state_;
    const std::string word = formatInfo(format).name;
    const auto status = state.changeAll(
        &Description::imports, name, [](const ImportDesc&) { return Status(); },
        [&](const ImportDesc& own) -> Status {
            if (own.format == word) return {};
            Description changed = state.description;
            State::find(changed.imports, own.name)->format = word;
            return state.replan(std::move(changed), state.options);
        },
        [&](Description&, ImportDesc& import) {
            return std::exchange(import.format, std::string(word)) != word;
        });
    if (status) return *status;
    return Diagnostic{Code::reference_missing, "there is no import '" + std::string(name) + "'",
                      suggestName(name, namesOf(state.description.imports), "imports")};
}

}  // namespace crevice
