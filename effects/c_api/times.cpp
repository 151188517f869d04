// SPDX-License-Identifier: MIT
// What passes take on the GPU.
#include <crevice/renderer.h>

#include "effects/c_api/effect.h"
#include "effects/c_api/structs.h"

using namespace crevice;

namespace {

/// The latest, or null.
const FrameTimes* timesOf(const crevice_effect& effect)
{
    return const_cast<Effect&>(*effect.effect).renderer().times();
}

Status getPassTime(const crevice_effect& effect, int index, crevice_pass_time* time)
{
    const int count = crevice_effect_pass_time_count(&effect);
    if (index < 0 || index >= count)
        return Diagnostic{Code::bad_input, "there is no time of pass " + std::to_string(index) +
                                               ", but of " + std::to_string(count) + " passes"};
    const auto at = static_cast<std::size_t>(index);
    crevice_pass_time own = {};
    own.name = const_cast<Effect&>(*effect.effect).renderer().plan().passes[at].name.c_str();
    own.milliseconds = timesOf(effect)->pass_ms[at];
    give(own, time);
    return {};
}

}  // namespace

crevice_error* crevice_effect_set_timing(crevice_effect* effect, bool on)
{
    return onEffect(effect, [&] { return effect->effect->renderer().setTiming(on); });
}

int crevice_effect_pass_time_count(const crevice_effect* effect)
{
    const FrameTimes* times = effect ? timesOf(*effect) : nullptr;
    return times ? static_cast<int>(times->pass_ms.size()) : 0;
}

crevice_error* crevice_effect_get_pass_time(const crevice_effect* effect, int index,
                                            crevice_pass_time* time)
{
    return guarded([&] {
        const Status given =
            firstOf(checkGiven(effect, "the effect"), check(time, "crevice_pass_time"));
        return given ? getPassTime(*effect, index, time) : given;
    });
}
