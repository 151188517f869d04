// SPDX-License-Identifier: MIT
// What an effect has to set, for user interfaces, what comes out of it, and what its passes take.
#include <crevice/renderer.h>

#include "effects/api/c/handles.h"

using namespace crevice;

namespace {

/// Errors: CV6011.
Status checkView(const crevice_effect& effect, int view)
{
    const int views = rendererOf(effect).plan().views;
    if (view >= 0 && view < views) return {};
    return Diagnostic{Code::bad_input,
                      "there is no output of view " + std::to_string(view) + ", but of " +
                          std::to_string(views) + " views",
                      "set views by crevice_effect_set_views, and render"};
}

Result<OutputTexture> outputOf(const crevice_effect& effect, const char* name, int view = 0)
{
    if (Status there = checkView(effect, view); !there) return there.diagnostics();
    const OutputTexture texture = effect.effect->outputTexture(name, view);
    if (texture.format != Format::none) return texture;
    return Diagnostic{Code::reference_missing,
                      "the effect has no output '" + std::string(name) + "'",
                      suggestName(name, effect.loaded->outputs, "outputs")};
}

Status present(crevice_effect& effect, const char* name, const crevice_target& target)
{
    if (Status there = checkView(effect, target.view); !there) return there;
    return effect.effect->present(name, framebufferOf(target), target.view);
}

Status checkOutput(const crevice_effect* effect, const char* name)
{
    return firstOf(checkGiven(effect, "the effect"), checkGiven(name, "the output's name"));
}

Status getOutput(const crevice_effect& effect, int view, const char* name, crevice_output& output)
{
    const Result<OutputTexture> texture = outputOf(effect, name, view);
    if (!texture) return texture.diagnostics();
    const FormatInfo& format = formatInfo(texture->format);
    crevice_output own = {};
    own.texture = texture->native_name;
    own.format = format.name;
    own.channels = format.channels;
    own.width = texture->extent.width;
    own.height = texture->extent.height;
    give(own, &output);
    return {};
}

Status readOutput(const crevice_effect& effect, const char* name, float* pixels, std::size_t count)
{
    const Result<OutputTexture> texture = outputOf(effect, name);
    if (!texture) return texture.diagnostics();
    const Result<Image> image = effect.device->readTexture(effect.effect->output(name));
    if (!image) return image.diagnostics();
    if (count != image->pixels.size())
        return Diagnostic{Code::image_size,
                          "the output has " + std::to_string(image->pixels.size()) +
                              " floats, and there is room for " + std::to_string(count)};
    std::copy(image->pixels.begin(), image->pixels.end(), pixels);
    return {};
}

Status getPassTime(const crevice_effect& effect, int index, crevice_pass_time* time)
{
    const int count = crevice_effect_pass_time_count(&effect);
    if (index < 0 || index >= count)
        return Diagnostic{Code::bad_input, "there is no time of pass " + std::to_string(index) +
                                               ", but of " + std::to_string(count) + " passes"};
    const auto at = static_cast<std::size_t>(index);
    crevice_pass_time own = {};
    own.name = rendererOf(effect).plan().passes[at].name.c_str();
    own.milliseconds = rendererOf(effect).times()->pass_ms[at];
    give(own, time);
    return {};
}

template <class T>
int countOf(const crevice_effect* effect, const std::vector<T> Description::*list)
{
    return effect ? static_cast<int>((effect->loaded->description.*list).size()) : 0;
}

/// Gives what `fill` writes for one of `count` entries. Errors: CV6011.
template <class Struct, class Fill>
crevice_error* getAt(const crevice_effect* effect, int index, int count, Struct* into,
                     const char* name, Fill fill)
{
    return guarded([&]() -> Status {
        const Status given = firstOf(checkGiven(effect, "the effect"), check(into, name));
        if (!given) return given;
        if (index < 0 || index >= count)
            return Diagnostic{Code::bad_input, "the index " + std::to_string(index) +
                                                   " is not below " + std::to_string(count)};
        Struct own = {};
        fill(static_cast<std::size_t>(index), own);
        give(own, into);
        return given;
    });
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
    to.label = from.label.empty() ? to.name : from.label.c_str();
    to.tooltip = from.tooltip.c_str();
}

}  // namespace

HostFramebuffer crevice::framebufferOf(const crevice_target& target)
{
    HostFramebuffer host;
    host.name = target.framebuffer;
    host.texture = target.texture;
    host.level = target.level;
    host.x = target.x;
    host.y = target.y;
    host.extent = {target.width, target.height};
    host.multiply = target.multiply;
    return host;
}

int crevice_effect_output_count(const crevice_effect* effect)
{
    return effect ? static_cast<int>(effect->loaded->outputs.size()) : 0;
}

const char* crevice_effect_output_name(const crevice_effect* effect, int index)
{
    const bool there = index >= 0 && index < crevice_effect_output_count(effect);
    return there ? effect->loaded->outputs[static_cast<std::size_t>(index)].c_str() : "";
}

crevice_error* crevice_effect_get_output(const crevice_effect* effect, const char* name,
                                         crevice_output* output)
{
    return crevice_effect_get_view_output(effect, 0, name, output);
}

crevice_error* crevice_effect_get_view_output(const crevice_effect* effect, int view,
                                              const char* name, crevice_output* output)
{
    return guarded([&] {
        const Status given = firstOf(checkOutput(effect, name), check(output, "crevice_output"));
        return given ? getOutput(*effect, view, name, *output) : given;
    });
}

crevice_error* crevice_effect_present(crevice_effect* effect, const char* name,
                                      const crevice_target* target)
{
    return onEffect(effect, [&] {
        crevice_target own = {};
        const Status given =
            firstOf(checkGiven(name, "the output's name"), take(target, "crevice_target", own));
        return given ? present(*effect, name, own) : given;
    });
}

crevice_error* crevice_effect_read_output(const crevice_effect* effect, const char* name,
                                          float* pixels, size_t count)
{
    return guarded([&] {
        const Status given =
            firstOf(checkOutput(effect, name), checkGiven(pixels, "the place for pixels"));
        return given ? readOutput(*effect, name, pixels, count) : given;
    });
}

crevice_error* crevice_effect_get_value(crevice_effect* effect, const char* name, float* value,
                                        bool* known)
{
    return onEffect(effect, [&] {
        const Status given = firstOf(checkGiven(name, "the output's name"),
                                     checkGiven(value, "the place for the value"),
                                     checkGiven(known, "the place for whether it is known"));
        if (!given) return given;
        const std::optional<float> read = effect->effect->value(name);
        *known = read.has_value();
        if (read) *value = *read;
        return given;
    });
}

crevice_error* crevice_effect_set_timing(crevice_effect* effect, bool on)
{
    return onEffect(effect, [&] { return effect->effect->renderer().setTiming(on); });
}

int crevice_effect_pass_time_count(const crevice_effect* effect)
{
    const FrameTimes* times = effect ? rendererOf(*effect).times() : nullptr;
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

int crevice_effect_param_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::params);
}

crevice_error* crevice_effect_get_param(const crevice_effect* effect, int index,
                                        crevice_param* param)
{
    return getAt(effect, index, crevice_effect_param_count(effect), param, "crevice_param",
                 [&](std::size_t at, crevice_param& own) {
                     fill(effect->loaded->description.params[at], own);
                     const auto& value = rendererOf(*effect).description().params[at].value;
                     std::copy(value.begin(), value.end(), own.value);
                 });
}

int crevice_effect_feature_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::features);
}

crevice_error* crevice_effect_get_feature(const crevice_effect* effect, int index,
                                          crevice_feature* feature)
{
    return getAt(effect, index, crevice_effect_feature_count(effect), feature, "crevice_feature",
                 [&](std::size_t at, crevice_feature& own) {
                     fill(effect->loaded->description.features[at], effect->loaded->words[at], own);
                     own.word = rendererOf(*effect).description().features[at].value;
                 });
}

int crevice_effect_import_count(const crevice_effect* effect)
{
    return countOf(effect, &Description::imports);
}

crevice_error* crevice_effect_get_import(const crevice_effect* effect, int index,
                                         crevice_import* import)
{
    return getAt(effect, index, crevice_effect_import_count(effect), import, "crevice_import",
                 [&](std::size_t at, crevice_import& own) {
                     constexpr const char* kTypes[] = {"camera", "draw_list", "lights", "texture"};
                     const ImportDesc& from = effect->loaded->description.imports[at];
                     own.name = from.name.c_str();
                     own.type = kTypes[static_cast<int>(from.type)];
                     own.format = from.type == ImportType::texture ? from.format.c_str() : "";
                     own.optional = from.optional;
                 });
}

crevice_error* crevice_effect_get_patch(crevice_effect* effect, const char** patch)
{
    return guarded([&]() -> Status {
        const Status given =
            firstOf(checkGiven(effect, "the effect"), checkGiven(patch, "the place for the patch"));
        if (!given) return given;
        Result<std::string> made = patchOf(*effect->loaded, rendererOf(*effect).description());
        if (!made) return made.diagnostics();
        effect->patch = std::move(*made);
        *patch = effect->patch.c_str();
        return {};
    });
}
