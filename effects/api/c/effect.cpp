// SPDX-License-Identifier: MIT
// Effects: made, set and drawn, with the views and textures that they see.
#include <crevice/renderer.h>

#include "effects/api/c/handles.h"

#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

Result<EffectRequest> requestOf(const crevice_effect_desc& desc)
{
    EffectRequest request{textOf(desc.config), textOf(desc.folder), textOf(desc.patch), {}, {}};
    Limits& limits = request.limits;
    for (const auto& [limit, asked] :
         {std::pair(&limits.files, desc.max_files), std::pair(&limits.passes, desc.max_passes),
          std::pair(&limits.targets, desc.max_targets)}) {
        if (asked < 0) return Diagnostic{Code::bad_input, "a limit of the config is below 0"};
        if (asked > 0) *limit = asked;
    }
    if (!(desc.max_bytes >= 0))
        return Diagnostic{Code::bad_input, "a limit of the config is below 0"};
    if (desc.max_bytes > 0) limits.bytes = desc.max_bytes;
    if (desc.baked) {
        auto baked = readBaked(desc.baked, desc.baked_size);
        if (!baked) return baked.diagnostics();
        request.baked = std::make_shared<const std::vector<BakedConfig>>(std::move(*baked));
    } else if (Status given = checkGiven(desc.config, "the config"); !given) {
        return given.diagnostics();
    }
    if (desc.output_count < 0) return Diagnostic{Code::bad_input, "output_count is below 0"};
    for (int i = 0; i < desc.output_count; ++i) {
        Status given = checkGiven(desc.outputs, "the list of outputs");
        if (given) given = checkGiven(desc.outputs[i], "the name of an output");
        if (!given) return given.diagnostics();
        request.outputs.push_back(desc.outputs[i]);
    }
    return request;
}

/// Loads and puts what was loaded in the place of what `effect` draws, or changes nothing.
Status load(crevice_effect& effect, EffectRequest request, Extent size)
{
    auto loaded = loadEffect(request);
    if (!loaded) return loaded.diagnostics();
    const Status status =
        effect.effect->renderer().reload((*loaded)->description, {size, request.outputs, {}});
    if (!status) return status;
    effect.request = std::move(request);
    effect.levels.clear();
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
    auto loaded = loadEffect(*request);
    if (!loaded) return loaded.diagnostics();
    auto drawn = Effect::create(*device.device, (*loaded)->description, (*loaded)->scene,
                                {desc.width, desc.height}, request->outputs);
    if (!drawn) return drawn.diagnostics();
    auto made = std::make_unique<crevice_effect>();
    made->device = device.device;
    made->request = std::move(*request);
    made->loaded = std::move(*loaded);
    made->effect = std::move(*drawn);
    made->effect->frame().materials.resize(1);
    Diagnostics all = loaded.diagnostics();
    append(all, drawn.diagnostics());
    if (!all.empty()) made->warnings = std::make_unique<crevice_error>(all);
    *effect = made.release();
    return {};
}

/// The status of what drew, with what it left behind.
Status settle(crevice_effect& effect, const Status& status)
{
    if (effect.effect->governor())
        effect.loaded = effect.levels[static_cast<std::size_t>(rendererOf(effect).level())];
    if (!std::exchange(effect.scene.callback_threw, false)) return status;
    ++effect.effect->frame().revision;  // draw again what it left undone
    if (!status) return status;
    return Diagnostic{Code::bad_input, "a draw callback threw an exception",
                      "make callbacks that do not throw"};
}

Status render(crevice_effect& effect)
{
    const Status status = settle(effect, effect.effect->render());
    if (!status) return status;
    Frame& frame = effect.effect->frame();
    frame.camera_cut = false;
    frame.origin_shift = glm::dvec3(0.0);
    return status;
}

Status warm(crevice_effect& effect, bool& ready)
{
    const Result<bool> warmed = effect.effect->warm();
    const Status status = settle(effect, warmed.diagnostics());
    ready = status && *warmed;
    return status;
}

/// What views 1 and up have of view 0.
void takeClip(const Frame& frame, Camera& camera)
{
    camera.clip_control = frame.camera.clip_control;
    camera.depth_range = frame.camera.depth_range;
}

Status shareClip(crevice_effect& effect)
{
    Frame& frame = effect.effect->frame();
    for (FrameView& view : frame.other_views) takeClip(frame, view.camera);
    return {};
}

Status setViews(crevice_effect& effect, const crevice_view* views, int count)
{
    const auto nothing = [](std::size_t, const crevice_view&) { return Status(); };
    if (Status fine = takeEach(views, count, "crevice_view", nothing); !fine) return fine;
    Frame& frame = effect.effect->frame();
    frame.other_views.resize(static_cast<std::size_t>(count));
    return takeEach(views, count, "crevice_view", [&frame](std::size_t i, const auto& view) {
        Camera& camera = frame.other_views[i].camera;
        camera.clip_from_view = glm::make_mat4(view.clip_from_view);
        camera.view_from_world = matrixOf(view.view_from_world);
        takeClip(frame, camera);
        return Status();
    });
}

}  // namespace

namespace crevice {

static_assert(static_cast<int>(HostTexture::Kind::framebuffer) == CREVICE_FRAMEBUFFER,
              "crevice_texture_kind is HostTexture::Kind");

Status takeTexture(const crevice_texture* given, HostTexture& host)
{
    crevice_texture texture = {};
    Status status = take(given, "crevice_texture", texture);
    if (status) status = checkEnum(texture.kind, CREVICE_FRAMEBUFFER, "crevice_texture_kind");
    if (!status) return status;
    host.format = texture.format ? formatFromName(texture.format) : Format::none;
    if (texture.format && host.format == Format::none)
        return Diagnostic{Code::bad_input,
                          "there is no format '" + std::string(texture.format) + "'",
                          suggestName(texture.format, formatNames(), "formats")};
    host.name = texture.name;
    host.extent = {texture.width, texture.height};
    host.samples = texture.samples == 0 ? 1 : texture.samples;
    host.kind = static_cast<HostTexture::Kind>(texture.kind);
    host.layer = texture.layer;
    host.part = texture.part;
    host.x = texture.x;
    host.y = texture.y;
    return status;
}

}  // namespace crevice

crevice_error* crevice_effect_create(crevice_device* device, const crevice_effect_desc* desc,
                                     crevice_effect** effect)
{
    if (effect) *effect = nullptr;
    return guarded([&]() -> Status {
        crevice_effect_desc own = {};
        const Status given =
            firstOf(checkGiven(device, "the device"), take(desc, "crevice_effect_desc", own),
                    checkGiven(effect, "the place for the effect"));
        return given ? create(*device, own, effect) : given;
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
        return shareClip(*effect);
    });
}

crevice_error* crevice_effect_set_depth_range(crevice_effect* effect, float near_depth,
                                              float far_depth)
{
    return onEffect(effect, [&] {
        effect->effect->setDepthRange({near_depth, far_depth});
        return shareClip(*effect);
    });
}

crevice_error* crevice_effect_set_views(crevice_effect* effect, const crevice_view* views,
                                        int count)
{
    return onEffect(effect, [&] { return setViews(*effect, views, count); });
}

crevice_error* crevice_effect_set_texture(crevice_effect* effect, const char* import,
                                          const crevice_texture* texture)
{
    return crevice_effect_set_view_texture(effect, 0, import, texture);
}

crevice_error* crevice_effect_set_view_texture(crevice_effect* effect, int view, const char* import,
                                               const crevice_texture* texture)
{
    return onEffect(effect, [&] {
        HostTexture host;
        const Status given =
            firstOf(checkGiven(import, "the import's name"), takeTexture(texture, host));
        return given ? effect->effect->setViewTexture(view, import, host) : given;
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

crevice_error* crevice_effect_set_scale(crevice_effect* effect, double diagonal,
                                        double median_distance)
{
    return onEffect(effect, [&] {
        effect->effect->setScale(diagonal, median_distance);
        return Status();
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
    return onEffect(effect, [&] { return render(*effect); });
}

crevice_error* crevice_effect_warm(crevice_effect* effect, bool* ready)
{
    return onEffect(effect, [&] {
        const Status given = checkGiven(ready, "the place for the answer");
        return given ? warm(*effect, *ready) : given;
    });
}
