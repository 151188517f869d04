// SPDX-License-Identifier: MIT
// Further views of the same scene.
#include <crevice/frame.h>
#include <crevice/renderer.h>

#include "effects/c_api/effect.h"
#include "effects/c_api/structs.h"
#include "effects/c_api/textures.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

using namespace crevice;

namespace {

std::vector<FrameView>& viewsOf(crevice_effect& effect)
{
    return effect.effect->frame().other_views;
}

/// Hands the textures to the frame.
void importTextures(crevice_effect& effect)
{
    for (FrameView& view : viewsOf(effect)) view.textures.clear();
    for (const ViewTexture& each : effect.scene.view_textures)
        if (each.map.id.id())
            viewsOf(effect)[each.view - 1].textures.push_back({each.import, each.map.id.id(), 0});
}

Status setViews(crevice_effect& effect, const crevice_view* views, int count)
{
    const auto nothing = [](std::size_t, const crevice_view&) { return Status(); };
    if (Status fine = takeEach(views, count, "crevice_view", nothing); !fine) return fine;
    std::vector<FrameView>& own = viewsOf(effect);
    if (own.size() != static_cast<std::size_t>(count)) {
        own.resize(static_cast<std::size_t>(count));
        std::vector<ViewTexture>& textures = effect.scene.view_textures;
        const auto gone = [count](const ViewTexture& each) { return each.view > count; };
        textures.erase(std::remove_if(textures.begin(), textures.end(), gone), textures.end());
        importTextures(effect);
    }
    return takeEach(views, count, "crevice_view", [&own](std::size_t i, const crevice_view& view) {
        own[i].camera.clip_from_view = glm::make_mat4(view.clip_from_view);
        own[i].camera.view_from_world = matrixOf(view.view_from_world);
        return Status();
    });
}

/// Errors: CV6011 for a view that there is not; CV2102; CV6011 for another format than view 0's.
Status checkViewTexture(crevice_effect& effect, int view, const char* import, Format format)
{
    const int count = 1 + static_cast<int>(viewsOf(effect).size());
    if (view < 0 || view >= count)
        return Diagnostic{Code::bad_input,
                          "there is no view " + std::to_string(view) + ", but " +
                              std::to_string(count) + " views",
                          "set it by crevice_effect_set_views first"};
    const ImportDesc* desc =
        findNamed(effect.effect->renderer().description().imports, std::string_view(import));
    if (!desc || desc->type != ImportType::texture)
        return Diagnostic{Code::reference_missing,
                          "the config imports no texture '" + std::string(import) + "'"};
    if (desc->format == formatInfo(format).name) return {};
    return Diagnostic{Code::bad_input,
                      std::string(import) + " of view " + std::to_string(view) + " is " +
                          formatInfo(format).name + ", and that of view 0 is " + desc->format,
                      "take one format for all views, and set view 0's texture first"};
}

ViewTexture& textureOf(std::vector<ViewTexture>& all, int view, const char* import)
{
    for (ViewTexture& each : all)
        if (each.view == view && each.import == import) return each;
    return all.emplace_back(ViewTexture{view, import, {}});
}

Status setViewTexture(crevice_effect& effect, int view, const char* import, HostTexture host)
{
    if (Status fine = checkViewTexture(effect, view, import, host.format); !fine) return fine;
    HostMap& map = textureOf(effect.scene.view_textures, view, import).map;
    if (map.id.id() && map.host == host) return {};
    host.label = import;
    const Result<TextureId> id = effect.device->adoptTexture(host);
    if (!id) return id.diagnostics();
    map = {std::move(host), {*effect.device, *id}};
    importTextures(effect);
    return {};
}

}  // namespace

namespace crevice {

Status prepareViews(crevice_effect& effect)
{
    for (FrameView& view : viewsOf(effect))
        view.camera.clip_control = effect.effect->frame().camera.clip_control;
    for (const ViewTexture& each : effect.scene.view_textures)
        if (each.map.host.copied())
            if (Status status = effect.device->refresh(each.map.id.id()); !status) return status;
    return {};
}

}  // namespace crevice

crevice_error* crevice_effect_set_views(crevice_effect* effect, const crevice_view* views,
                                        int count)
{
    return onEffect(effect, [&] { return setViews(*effect, views, count); });
}

crevice_error* crevice_effect_set_view_texture(crevice_effect* effect, int view, const char* import,
                                               const crevice_texture* texture)
{
    return onEffect(effect, [&] {
        HostTexture host;
        const Status given =
            firstOf(checkGiven(import, "the import's name"), takeTexture(texture, host));
        if (!given) return given;
        return view == 0 ? effect->effect->setTexture(import, host)
                         : setViewTexture(*effect, view, import, std::move(host));
    });
}
