// SPDX-License-Identifier: MIT
// A time budget: the front that C gives, and what the governor says.
#include <crevice/governor.h>
#include <crevice/renderer.h>

#include "core/base/text.h"
#include "effects/api/c/handles.h"
#include "effects/api/front.h"

using namespace crevice;

namespace {

Status govern(crevice_effect& effect, const crevice_governor_desc& desc)
{
    const bool baked = !desc.front && effect.request.baked;
    Status given = baked ? Status() : checkGiven(desc.front, "the front");
    if (!given) return given;
    auto levels = baked ? frontOf(*effect.request.baked) : levelsOf(desc.front);
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
    std::size_t next = 0;
    const Status status = loadLevels(governor->levels(), [&](const FrontLevel& level) -> Status {
        EffectRequest request = effect.request;
        request.config = level.name;
        request.overrides = level.set;
        if (baked)  // of which several may have one name
            request.baked = std::make_shared<const std::vector<BakedConfig>>(
                1, (*effect.request.baked)[next++]);
        auto made = loadEffect(request);
        if (!made) return made.diagnostics();
        descriptions.push_back((*made)->description);
        loaded.push_back(std::move(*made));
        return made.diagnostics();
    });
    if (!status) return status;
    const Status governed = effect.effect->govern(std::move(*governor), std::move(descriptions));
    if (!governed) return governed;
    effect.levels = std::move(loaded);
    effect.loaded = effect.levels[static_cast<std::size_t>(rendererOf(effect).level())];
    Diagnostics all = status.diagnostics();
    append(all, governed.diagnostics());
    return all;
}

/// Calls `call` with the effect's governor. Errors: CV6011 for none; its own.
template <class Call>
crevice_error* onGovernor(const crevice_effect* effect, const Call& call) noexcept
{
    return guarded([&]() -> Status {
        if (Status given = checkGiven(effect, "the effect"); !given) return given;
        if (Governor* const governor = const_cast<Effect&>(*effect->effect).governor())
            return call(*governor);
        return Diagnostic{Code::bad_input, "the effect has no governor",
                          "give it one by crevice_effect_govern"};
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

crevice_error* crevice_effect_get_governor(const crevice_effect* effect,
                                           crevice_governor_report* report)
{
    return onGovernor(effect, [&](const Governor& governor) {
        const Status given = check(report, "crevice_governor_report");
        if (!given) return given;
        const GovernorReport now = governor.report();
        const std::string& config = governor.levels()[static_cast<std::size_t>(now.level)].name;
        give(crevice_governor_report{sizeof(crevice_governor_report), now.level, config.c_str(),
                                     now.ms, now.predicted_ms, now.error, now.estimate},
             report);
        return given;
    });
}
