// SPDX-License-Identifier: MIT
#include "core/plan/optimizations.h"

namespace crevice {

const RuleInfo kRules[7] = {
    {"unread", "passes, attachments and shader outputs that no output asked for needs"},
    {"identity", "passes whose outputs are known unrun, by a param or by a constant that they read"},
    {"sharing", "a texture of its own for each target"},
    {"background", "pixels of a pass whose values are known undrawn, by a mask"},
    {"outside", "in a frame, things whose bounds lie outside of what a pass shows"},
    {"bounds", "in a frame, pixels of a pass where the bounds of no thing lie"},
    {"unchanged", "passes of a frame whose input is the last frame's"},
};

std::vector<std::string> ruleNames()
{
    std::vector<std::string> names;
    for (const RuleInfo& rule : kRules) names.push_back(rule.name);
    return names;
}

}  // namespace crevice
