// SPDX-License-Identifier: MIT
// Effects: made, set, drawn, and their outputs.
#include "effects/c_api/effect.h"

#include <crevice/renderer.h>

#include "effects/c_api/device.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

using namespace crevice;

namespace {

/// What an effect begins as, before its own description takes this one's place: nothing is drawn
/// where the intensity is 0.
constexpr const char* kBlank = R"({ "format": 1, "name": "blank", "params": { "intensity": 0 },
    "extends": ["geometry/host_depth", "ssao/hemisphere"] })";

std::string textOf(const char* text) { return text ? text : ""; }

/// Runs a call on an effect that is not null, and keeps its warnings.
template <class Call>
crevice_error* onEffect(crevice_effect* effect, const Call& call) noexcept
{
    return guarded([&]() -> Status {
        if (Status given = checkGiven(effect, "the effect"); !given) return given;
        effect->warnings.reset();
        const Status status = call();
        if (status && !status.diagnostics().empty())
            effect->warnings = std::make_unique<crevice_error>(status.diagnostics());
        return status;
    });
}

Result<EffectRequest> requestOf(const crevice_effect_desc& desc)
{
    EffectRequest request{textOf(desc.config), textOf(desc.folder), textOf(desc.patch), {}};
    if (Status given = checkGiven(desc.config, "the config"); !given) return given.diagnostics();
    if (desc.output_count < 0) return Diagnostic{Code::bad_input, "output_count is below 0"};
    for (int i = 0; i < desc.output_count; ++i) {
        Status given = checkGiven(desc.outputs, "the list of outputs");
        if (given) given = checkGiven(desc.outputs[i], "the name of an output");
        if (!given) return given.diagnostics();
        request.outputs.push_back(desc.outputs[i]);
    }
    return request;
}

CompileOptions optionsOf(const EffectRequest& request, Extent size)
{
    CompileOptions options;
    options.extent = size;
    options.outputs = request.outputs;
    return options;
}

/// Loads and puts what was loaded in the place of what `effect` draws, or changes nothing.
Status load(crevice_effect& effect, EffectRequest request, Extent size)
{
    auto loaded = loadEffect(request);
    if (!loaded) return loaded.diagnostics();
    const Status status =
        effect.effect->renderer().reload((*loaded)->description, optionsOf(request, size));
    if (!status) return status;
    effect.request = std::move(request);
    effect.loaded = std::move(*loaded);
    Diagnostics all = loaded.diagnostics();
    append(all, status.diagnostics());
    return all;
}

Status create(const crevice_device& device, const crevice_effect_desc& desc,
              crevice_effect** effect)
{
    Result<EffectRequest> request = requestOf(desc);
    if (!request) return request.diagnostics();
    auto blank = Effect::create(*device.device, kBlank, {1, 1});
    if (!blank) return blank.diagnostics();
    auto made = std::make_unique<crevice_effect>();
    made->device = device.device;
    made->effect = std::move(*blank);
    const Status loaded = load(*made, std::move(*request), {desc.width, desc.height});
    if (!loaded) return loaded;
    if (!loaded.diagnostics().empty())
        made->warnings = std::make_unique<crevice_error>(loaded.diagnostics());
    *effect = made.release();
    return {};
}

/// Errors: CV6011 for a name that is no format's, and for an unknown kind.
Status checkTexture(const crevice_texture& texture)
{
    if (Status given = checkGiven(texture.format, "the texture's format"); !given) return given;
    if (formatFromName(texture.format) == Format::none)
        return Diagnostic{Code::bad_input,
                          "there is no format '" + std::string(texture.format) + "'",
                          suggestName(texture.format, formatNames(), "formats")};
    const int kind = texture.kind;
    if (kind >= CREVICE_TEXTURE && kind <= CREVICE_FRAMEBUFFER) return {};
    return Diagnostic{Code::bad_input, "there is no texture kind " + std::to_string(kind),
                      "take one of crevice_texture_kind, such as CREVICE_LAYER"};
}

HostTexture::Kind kindOf(crevice_texture_kind kind)
{
    switch (kind) {
    case CREVICE_LAYER: return HostTexture::Kind::layer;
    case CREVICE_RENDERBUFFER: return HostTexture::Kind::renderbuffer;
    case CREVICE_FRAMEBUFFER: return HostTexture::Kind::framebuffer;
    default: return HostTexture::Kind::texture;
    }
}

HostTexture hostTexture(const crevice_texture& texture)
{
    HostTexture host;
    host.name = texture.name;
    host.format = formatFromName(texture.format);
    host.extent = {texture.width, texture.height};
    host.samples = texture.samples == 0 ? 1 : texture.samples;
    host.kind = kindOf(texture.kind);
    host.layer = texture.layer;
    host.part = texture.part;
    host.x = texture.x;
    host.y = texture.y;
    return host;
}

HostFramebuffer hostFramebuffer(const crevice_target& target)
{
    HostFramebuffer host;
    host.name = target.framebuffer;
    host.texture = target.texture;
    host.level = target.level;
    host.x = target.x;
    host.y = target.y;
    host.extent = {target.width, target.height};
    return host;
}

Result<OutputTexture> outputOf(const crevice_effect& effect, const char* name)
{
    const OutputTexture texture = effect.effect->outputTexture(name);
    if (texture.format != Format::none) return texture;
    return Diagnostic{Code::reference_missing,
                      "the effect has no output '" + std::string(name) + "'",
                      suggestName(name, effect.loaded->outputs, "outputs")};
}

Status checkOutput(const crevice_effect* effect, const char* name)
{
    return firstOf(checkGiven(effect, "the effect"), checkGiven(name, "the output's name"));
}

Status getOutput(const crevice_effect& effect, const char* name, crevice_output& output)
{
    const Result<OutputTexture> texture = outputOf(effect, name);
    if (!texture) return texture.diagnostics();
    const FormatInfo& format = formatInfo(texture->format);
    output.texture = texture->native_name;
    output.format = format.name;
    output.channels = format.channels;
    output.width = texture->extent.width;
    output.height = texture->extent.height;
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

}  // namespace

crevice_error* crevice_effect_create(crevice_device* device, const crevice_effect_desc* desc,
                                     crevice_effect** effect)
{
    if (effect) *effect = nullptr;
    return guarded([&]() -> Status {
        const Status given =
            firstOf(checkGiven(device, "the device"), checkStruct(desc, "crevice_effect_desc"),
                    checkGiven(effect, "the place for the effect"));
        return given ? create(*device, *desc, effect) : given;
    });
}

crevice_error* crevice_effect_reload(crevice_effect* effect, const char* config)
{
    return onEffect(effect, [&] {
        EffectRequest request = effect->request;
        if (config) request.config = config;
        return load(*effect, std::move(request), effect->effect->renderer().plan().extent);
    });
}

crevice_error* crevice_effect_resize(crevice_effect* effect, int width, int height)
{
    return onEffect(effect, [&] { return effect->effect->resize({width, height}); });
}

void crevice_effect_destroy(crevice_effect* effect) { delete effect; }

const crevice_error* crevice_effect_warnings(const crevice_effect* effect)
{
    return effect ? effect->warnings.get() : nullptr;
}

crevice_error* crevice_effect_set_projection(crevice_effect* effect, const float* clip_from_view)
{
    return onEffect(effect, [&] {
        Status given = checkGiven(clip_from_view, "the projection");
        if (given) effect->effect->setProjection(clip_from_view);
        return given;
    });
}

crevice_error* crevice_effect_set_view(crevice_effect* effect, const double* view_from_world)
{
    return onEffect(effect, [&] {
        Status given = checkGiven(view_from_world, "the view");
        if (given) effect->effect->setView(view_from_world);
        return given;
    });
}

crevice_error* crevice_effect_cut(crevice_effect* effect)
{
    return onEffect(effect, [&] {
        effect->effect->frame().camera_cut = true;
        return Status();
    });
}

crevice_error* crevice_effect_shift_origin(crevice_effect* effect, const double* shift)
{
    return onEffect(effect, [&] {
        Status given = checkGiven(shift, "the shift");
        if (given) effect->effect->frame().origin_shift += glm::make_vec3(shift);
        return given;
    });
}

crevice_error* crevice_effect_set_clip_control(crevice_effect* effect, bool zero_to_one,
                                               bool upper_left)
{
    return onEffect(effect, [&] {
        effect->effect->setClipControl({zero_to_one, upper_left});
        return Status();
    });
}

crevice_error* crevice_effect_set_texture(crevice_effect* effect, const char* import,
                                          const crevice_texture* texture)
{
    return onEffect(effect, [&] {
        Status given = firstOf(checkGiven(import, "the import's name"),
                               checkStruct(texture, "crevice_texture"));
        if (given) given = checkTexture(*texture);
        return given ? effect->effect->setTexture(import, hostTexture(*texture)) : given;
    });
}

crevice_error* crevice_effect_set_param(crevice_effect* effect, const char* name,
                                        const float* values, int count)
{
    return onEffect(effect, [&] {
        const Status given =
            firstOf(checkGiven(name, "the param's name"), checkGiven(values, "the value"));
        return given ? effect->effect->setParam(name, values, count) : given;
    });
}

crevice_error* crevice_effect_set_feature(crevice_effect* effect, const char* name,
                                          const char* word)
{
    return onEffect(effect, [&] {
        const Status given =
            firstOf(checkGiven(name, "the feature's name"), checkGiven(word, "the word"));
        return given ? effect->effect->setFeature(name, word) : given;
    });
}

crevice_error* crevice_effect_render(crevice_effect* effect)
{
    return onEffect(effect, [&] {
        Status status = effect->effect->render();
        Frame& frame = effect->effect->frame();
        if (!status) return status;
        frame.camera_cut = false;
        frame.origin_shift = glm::dvec3(0.0);
        return status;
    });
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
    return guarded([&] {
        const Status given =
            firstOf(checkOutput(effect, name), checkStruct(output, "crevice_output"));
        return given ? getOutput(*effect, name, *output) : given;
    });
}

crevice_error* crevice_effect_present(crevice_effect* effect, const char* name,
                                      const crevice_target* target)
{
    return onEffect(effect, [&] {
        const Status given =
            firstOf(checkGiven(name, "the output's name"), checkStruct(target, "crevice_target"));
        return given ? effect->effect->present(name, hostFramebuffer(*target)) : given;
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
