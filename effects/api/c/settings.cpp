// SPDX-License-Identifier: MIT
// What an effect has to set, for user interfaces.
#include <crevice/renderer.h>

#include "core/config/field_types.h"
#include "effects/api/c/handles.h"

#include <algorithm>

using namespace crevice;

namespace {

template <class T>
int countOf(const crevice_effect* effect, const std::vector<T> Description::*list)
{
    return effect ? static_cast<int>((effect->loaded->description.*list).size()) : 0;
}

/// Errors: CV6011.
template <class Struct>
Status checkPlace(const crevice_effect* effect, int index, int count, const Struct* into,
                  const char* name)
{
    const Status given = firstOf(checkGiven(effect, "the effect"), check(into, name));
    if (!given || (index >= 0 && index < count)) return given;
    return Diagnostic{Code::bad_input, "the index " + std::to_string(index) + " is not below " +
                                           std::to_string(count)};
}

void fill(const ParamDesc& from, crevice_param& to)
{
    to.name = from.name.c_str();
    to.label = from.label.empty() ? to.name : from.label.c_str();
    to.group = from.group.c_str();
    to.unit = from.unit.c_str();
    to.tooltip = from.tooltip.c_str();
    to.components = componentCount(from.type);
    to.integer = from.type == ParamType::int_;
    to.compiles = from.bind == Bind::define;
    to.min = from.min;
    to.max = from.max;
    to.soft_max = from.soft_max > 0 ? from.soft_max : from.max;
    to.step = from.step;
    std::copy(from.value.begin(), from.value.end(), to.default_value);
}

void fill(const FeatureDesc& from, const std::vector<const char*>& words, crevice_feature& to)
{
    to.name = from.name.c_str();
    to.boolean = from.boolean;
    to.words = words.data();
    to.word_count = static_cast<int>(words.size());
    to.default_word = from.value;
}

}  // namespace

int crevice_effect_param_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::params);
}

crevice_error* crevice_effect_get_param(const crevice_effect* effect, int index,
                                        crevice_param* param)
{
    return guarded([&] {
        const Status given =
            checkPlace(effect, index, crevice_effect_param_count(effect), param, "crevice_param");
        if (!given) return given;
        const auto at = static_cast<std::size_t>(index);
        crevice_param own = {};
        fill(effect->loaded->description.params[at], own);
        const std::array<float, 4>& value = rendererOf(*effect).description().params[at].value;
        std::copy(value.begin(), value.end(), own.value);
        give(own, param);
        return given;
    });
}

int crevice_effect_feature_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::features);
}

crevice_error* crevice_effect_get_feature(const crevice_effect* effect, int index,
                                          crevice_feature* feature)
{
    return guarded([&] {
        const Status given = checkPlace(effect, index, crevice_effect_feature_count(effect),
                                        feature, "crevice_feature");
        if (!given) return given;
        const auto at = static_cast<std::size_t>(index);
        crevice_feature own = {};
        fill(effect->loaded->description.features[at], effect->loaded->words[at], own);
        own.word = rendererOf(*effect).description().features[at].value;
        give(own, feature);
        return given;
    });
}

int crevice_effect_import_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::imports);
}

crevice_error* crevice_effect_get_import(const crevice_effect* effect, int index,
                                         crevice_import* import)
{
    return guarded([&] {
        const Status given = checkPlace(effect, index, crevice_effect_import_count(effect), import,
                                        "crevice_import");
        if (!given) return given;
        static const std::vector<std::string> types = table::spellings(ImportType());
        const ImportDesc& from =
            effect->loaded->description.imports[static_cast<std::size_t>(index)];
        crevice_import own = {};
        own.name = from.name.c_str();
        own.type = types[static_cast<std::size_t>(from.type)].c_str();
        own.format = from.type == ImportType::texture ? from.format.c_str() : "";
        own.optional = from.optional;
        give(own, import);
        return given;
    });
}

crevice_error* crevice_effect_get_patch(crevice_effect* effect, const char** patch)
{
    return guarded([&]() -> Status {
        const Status given =
            firstOf(checkGiven(effect, "the effect"), checkGiven(patch, "the place for the patch"));
        if (!given) return given;
        const Result<Node> made = patchOf(*effect->loaded, rendererOf(*effect).description());
        if (!made) return made.diagnostics();
        effect->patch = toJson(*made);
        *patch = effect->patch.c_str();
        return {};
    });
}
