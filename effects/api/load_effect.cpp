// SPDX-License-Identifier: MIT
// Effects of configs by name, file or text: what links the config language and the compiler.
#include <crevice/compile.h>
#include <crevice/effect.h>
#include <crevice/shipped.h>

#include "effects/api/front.h"

namespace crevice {

Result<Effect> Effect::create(Device& device, std::string_view config, Extent size,
                              std::vector<std::string> outputs, const Limits* limits)
{
    const LoadRequest request{std::string(config), {}, {}, {}, limits ? *limits : Limits()};
    const Result<Node> document = loadConfig(shippedSources(), request);
    if (!document) return document.diagnostics();
    Result<Description> description = decode(*document, shippedSources(), request.limits);
    if (!description) return description.diagnostics();
    description->planner = compilingPlanMaker();
    return create(device, std::move(*description), SceneTraits(), size, std::move(outputs));
}

Status Effect::govern(std::vector<FrontLevel> levels, const GovernorOptions& options,
                      const Limits* limits)
{
    Result<Governor> governor = Governor::create(std::move(levels), options);
    if (!governor) return governor.diagnostics();
    std::vector<Description> descriptions;
    const Status loaded = loadLevels(governor->levels(), [&](const FrontLevel& level) -> Status {
        const Limits most = limits ? *limits : Limits();
        auto document = loadConfig(shippedSources(), {level.name, {}, level.set, {}, most});
        if (!document) return document.diagnostics();
        auto description = decode(*document, shippedSources(), most);
        if (!description) return description.diagnostics();
        description->planner = compilingPlanMaker();
        descriptions.push_back(std::move(*description));
        return description.diagnostics();
    });
    if (!loaded) return loaded;
    Diagnostics all = loaded.diagnostics();
    append(all, govern(std::move(*governor), std::move(descriptions)).diagnostics());
    return all;
}

}  // namespace crevice
