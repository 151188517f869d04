// SPDX-License-Identifier: MIT
// An effect's config: from a name, file or text to a description, and from set values to a patch.
#include <crevice/compile.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "core/config/values.h"
#include "core/json/merge.h"
#include "effects/api/c/handles.h"

namespace crevice {
namespace {

/// Lays the patch over the document.
Status applyPatch(Node& document, const std::string& patch)
{
    if (patch.empty()) return {};
    const Result<Node> read =
        parseDocument(std::make_shared<SourceText>(SourceText{"(patch)", patch}));
    if (!read) return read.diagnostics();
    Diagnostics errors;
    mergePatch(document, *read, errors);
    return errors;
}

/// "radius=0.8", as overrides are written.
std::string overrideOf(const ParamDesc& param)
{
    const int count = componentCount(param.type);
    std::vector<std::string> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(shortest(param.value[i]));
    if (isRelative(param))
        numbers[0] =
            param.value[1] > 0 ? shortest(param.value[1]) + "%" : shortest(param.value[2]) + "px";
    return param.name + "=" + (count == 1 ? numbers[0] : "[" + joined(numbers) + "]");
}

std::string overrideOf(const FeatureDesc& feature)
{
    const std::string& word = feature.values[static_cast<std::size_t>(feature.value)];
    return feature.name + "=" + (feature.boolean ? word : jsonString(word));
}

/// What was set by itself: no value that a word of a feature set.
std::vector<std::string> overridesOf(const Description& loaded, const Description& now)
{
    const Values before = untouched(valuesOf(loaded), now);
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < now.features.size(); ++i)
        if (now.features[i].value != before.features[i])
            overrides.push_back(overrideOf(now.features[i]));
    for (std::size_t i = 0; i < now.params.size(); ++i)
        if (now.params[i].value != before.params[i]) overrides.push_back(overrideOf(now.params[i]));
    return overrides;
}

}  // namespace

struct LoadedDocument {
    Node bare;   ///< Without the patch, ...
    Node whole;  ///< ... and with it.
};

Result<std::unique_ptr<LoadedConfig>> loadEffect(const EffectRequest& request)
{
    if (request.baked) return loadBaked(request);
    const CheckoutSources sources(request.folder);
    Result<Node> bare =
        loadConfig(sources, {request.config, {}, request.overrides, {}, request.limits});
    if (!bare) return bare.diagnostics();
    const auto document = std::make_shared<LoadedDocument>(LoadedDocument{*bare, std::move(*bare)});
    if (Status patched = applyPatch(document->whole, request.patch); !patched)
        return patched.diagnostics();
    Result<Description> description = decode(document->whole, sources, request.limits);
    if (!description) return description.diagnostics();
    description->planner = compilingPlanMaker();
    auto loaded = loadedOf(std::move(*description), request.outputs);
    loaded->document = document;
    return {std::move(loaded), description.diagnostics()};
}

Result<std::string> patchOf(const LoadedConfig& loaded, const Description& now)
{
    if (!loaded.document) return noPatch();
    Node document = loaded.document->whole;
    for (const std::string& each : overridesOf(loaded.description, now))
        if (Status status = applyOverride(document, each); !status) return status.diagnostics();
    return toJson(patchBetween(loaded.document->bare, document));
}

Result<std::vector<FrontLevel>> levelsOf(const char* front) { return readFront(front); }

}  // namespace crevice
