// SPDX-License-Identifier: MIT
#include "tools/commands/cli/patch_text.h"

#include "core/json/merge.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

/// Writes {"radius": {"default": 0.8}} as {"radius": 0.8} where the base declares it.
void shorten(nlohmann::ordered_json& patch, const Node& base)
{
    for (const char* section : {"params", "features"}) {
        const Node* declared = base.find(section);
        if (!declared || !patch.contains(section) || !patch[section].is_object()) continue;
        for (auto& [name, entry] : patch[section].items())
            if (declared->find(name) && entry.size() == 1 && entry.is_object() &&
                entry.contains("default") && !entry["default"].is_null())
                entry = nlohmann::ordered_json(entry["default"]);
    }
}

}  // namespace

Result<std::string> patchText(const Node& base, Node now, const std::vector<std::string>& extends,
                              const SourceSet& sources)
{
    const Result<Description> description = decode(now, sources);
    if (!description) return description.diagnostics();
    for (const Diagnostic& each : description->unused) {  // what a swapped module took with it
        if (each.code != Code::unknown_param) continue;
        if (Status gone = applyOverride(now, each.pointer + "=null"); !gone)
            return gone.diagnostics();
    }
    nlohmann::ordered_json json = {{"format", 1}, {"extends", extends}};
    auto patch = nlohmann::ordered_json::parse(toJson(patchBetween(base, now)));
    shorten(patch, base);
    json.update(patch);
    return json.dump(2) + '\n';
}

}  // namespace crevice
