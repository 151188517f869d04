// SPDX-License-Identifier: MIT
// Levels by a budget: a front as C gives it, and what the governor says.
#include <crevice/governor.h>
#include <crevice/renderer.h>

#include "core/base/text.h"
#include "effects/api/c/handles.h"
#include "effects/api/front.h"

using namespace crevice;

namespace {

/// Errors: CV6011.
Result<std::vector<FrontLevel>> takeLevels(const crevice_level* levels, int count)
{
    std::vector<FrontLevel> all;
    const Status taken =
        takeEach(levels, count, "crevice_level", [&all](std::size_t, const crevice_level& level) {
            FrontLevel& made = all.emplace_back();
            Status given = checkGiven(level.config, "the config of a level");
            if (level.set_count != 0) given = firstOf(given, checkGiven(level.set, "`set`"));
            if (given && level.set_count < 0)
                return Status(Diagnostic{Code::bad_input, "set_count is below 0"});
            made.name = textOf(level.config);
            made.ms = level.milliseconds;
            made.error = level.error;
            for (int i = 0; given && i < level.set_count; ++i) {
                given = checkGiven(level.set[i], "an entry of `set`");
                made.set.push_back(textOf(level.set[i]));
            }
            return given;
        });
    if (!taken) return taken.diagnostics();
    return all;
}

Status govern(crevice_effect& effect, const crevice_governor_desc& desc)
{
    if (desc.front && desc.level_count != 0)
        return Diagnostic{Code::bad_input, "a governor is given a front and levels",
                          "give it one of them"};
    auto levels = desc.front ? readFront(desc.front) : takeLevels(desc.levels, desc.level_count);
    if (!levels) return levels.diagnostics();
    GovernorOptions options;
    options.budget_ms = desc.budget_ms;
    options.most_error = desc.most_error;
    if (desc.share != 0) options.share = desc.share;
    if (desc.wait != 0) options.wait = desc.wait;
    Result<Governor> governor = Governor::create(std::move(*levels), options);
    if (!governor) return governor.diagnostics();
    std::vector<std::shared_ptr<LoadedConfig>> loaded;
    std::vector<Description> descriptions;
    Diagnostics all;
    for (const FrontLevel& level : governor->levels()) {
        EffectRequest request = effect.request;
        request.config = level.name;
        request.overrides = level.set;
        auto made = loadEffect(request);
        if (!made) return ofLevel(level, made.diagnostics());
        append(all, ofLevel(level, made.diagnostics()));
        descriptions.push_back((*made)->description);
        loaded.push_back(std::move(*made));
    }
    const Status status = effect.effect->govern(std::move(*governor), std::move(descriptions));
    if (!status) return status;
    effect.levels = std::move(loaded);
    effect.loaded = effect.levels[static_cast<std::size_t>(rendererOf(effect).level())];
    append(all, status.diagnostics());
    return all;
}

/// Errors: CV6011.
Status checkGoverned(const crevice_effect* effect)
{
    if (Status given = checkGiven(effect, "the effect"); !given) return given;
    if (const_cast<Effect&>(*effect->effect).governor()) return {};
    return Diagnostic{Code::bad_input, "the effect has no governor",
                      "give it one by crevice_effect_govern"};
}

/// Calls `call` with the effect's governor.
template <class Call>
crevice_error* onGovernor(crevice_effect* effect, const Call& call) noexcept
{
    return guarded([&]() -> Status {
        const Status governed = checkGoverned(effect);
        return governed ? call(*effect->effect->governor()) : governed;
    });
}

}  // namespace

crevice_error* crevice_effect_govern(crevice_effect* effect, const crevice_governor_desc* desc)
{
    return onEffect(effect, [&] {
        crevice_governor_desc own = {};
        const Status given = take(desc, "crevice_governor_desc", own);
        return given ? govern(*effect, own) : given;
    });
}

crevice_error* crevice_effect_add_time(crevice_effect* effect, double milliseconds, int level)
{
    return onGovernor(effect, [&](Governor& governor) {
        governor.addTime(milliseconds, level < 0 ? governor.level() : level);
        return Status();
    });
}

crevice_error* crevice_effect_set_budget(crevice_effect* effect, double milliseconds)
{
    return onGovernor(effect, [&](Governor& governor) { return governor.setBudget(milliseconds); });
}

crevice_error* crevice_effect_set_estimate(crevice_effect* effect, double error)
{
    return onGovernor(effect, [&](Governor& governor) {
        governor.setEstimate(error);
        return Status();
    });
}

crevice_error* crevice_effect_get_governor(const crevice_effect* effect,
                                           crevice_governor_report* report)
{
    return guarded([&]() -> Status {
        const Status given =
            firstOf(checkGoverned(effect), check(report, "crevice_governor_report"));
        if (!given) return given;
        const Governor& governor = *const_cast<Effect&>(*effect->effect).governor();
        const GovernorReport now = governor.report();
        crevice_governor_report own = {};
        own.level = now.level;
        own.config = governor.levels()[static_cast<std::size_t>(now.level)].name.c_str();
        own.milliseconds = now.ms;
        own.predicted_ms = now.predicted_ms;
        own.error = now.error;
        own.estimate = now.estimate;
        give(own, report);
        return given;
    });
}
