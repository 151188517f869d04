// SPDX-License-Identifier: MIT
// Private to effects/api: what is checked and said of the levels of a front, whoever made them.
#pragma once

#include <crevice/baked.h>
#include <crevice/governor.h>

namespace crevice {

/// Errors: those of Governor::create about levels, each at its level.
Status checkFront(const std::vector<FrontLevel>& levels);

/// Levels that were baked. Errors: CV2301 where what was baked is no front.
Result<std::vector<FrontLevel>> frontOf(const std::vector<BakedConfig>& baked);

/// Loads each level by `load`, of a FrontLevel, which gives a Result of anything. Errors: its own,
/// with the level's place.
template <class Load>
Status loadLevels(const std::vector<FrontLevel>& levels, const Load& load)
{
    Diagnostics all;
    for (const FrontLevel& level : levels) {
        Status loaded = load(level);
        for (Diagnostic each : loaded.diagnostics()) {
            const std::string note = "in level '" + level.name + "' of the front";
            if (each.place.source)
                each.notes.push_back({level.place, note});
            else
                each.place = level.place;
            all.push_back(std::move(each));
        }
        if (!loaded) break;
    }
    return all;
}

}  // namespace crevice
