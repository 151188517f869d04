// SPDX-License-Identifier: MIT
// Configs as C reads them, and those that were baked.
#include "core/base/text.h"
#include "effects/api/c/handles.h"

namespace crevice {
namespace {

std::vector<std::vector<const char*>> wordsOf(const Description& description)
{
    std::vector<std::vector<const char*>> all;
    for (const FeatureDesc& feature : description.features) {
        std::vector<const char*>& words = all.emplace_back();
        for (const std::string& word : feature.values) words.push_back(word.c_str());
    }
    return all;
}

}  // namespace

std::unique_ptr<LoadedConfig> loadedOf(Description description, std::vector<std::string> outputs)
{
    auto loaded = std::make_unique<LoadedConfig>();
    loaded->description = std::move(description);
    loaded->words = wordsOf(loaded->description);
    loaded->outputs = outputs.empty() ? namesOf(loaded->description.outputs) : std::move(outputs);
    return loaded;
}

Result<std::unique_ptr<LoadedConfig>> loadBaked(const EffectRequest& request)
{
    if (!request.folder.empty() || !request.patch.empty())
        return Diagnostic{Code::not_baked, "a baked effect takes no folder and no patch",
                          "bake the config with them: crevice bake CONFIG --effects FOLDER"};
    Result<BakedConfig> baked = bakedConfig(*request.baked, request.config);
    if (!baked) return baked.diagnostics();
    baked->description.limits = request.limits;
    auto loaded = loadedOf(std::move(baked->description), request.outputs);
    loaded->scene = baked->scene;
    return loaded;
}

Diagnostic noPatch()
{
    return {Code::not_baked, "a baked effect has no patch",
            "keep the values that were set, by crevice_effect_get_param"};
}

}  // namespace crevice
