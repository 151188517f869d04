// SPDX-License-Identifier: MIT
// Further views by the C API, on a device that draws nothing.
#include "tests/c_api/c_scene.h"

#include <numeric>

using namespace crevice;

namespace {

/// Two views of a host's depth.
struct CViews : CScene {
    CViews()
        : CScene(R"({ "format": 1, "name": "ao", "extends": ["mobile", "geometry/host_depth"] })")
    {
        texture.format = "depth24";
        need(crevice_effect_set_texture(effect, "depth", &texture));
        std::copy_n(glm::value_ptr(frame().camera.clip_from_view), 16, view.clip_from_view);
        need(crevice_effect_set_views(effect, &view, 1));
    }

    int setTexture(int of_view)
    {
        return codeOf(crevice_effect_set_view_texture(effect, of_view, "depth", &texture));
    }

    crevice_view view = sized<crevice_view>();
};

}  // namespace

TEST_CASE_METHOD(CViews, "C API: each member of a view becomes that of a frame's view")
{
    std::iota(view.clip_from_view, view.clip_from_view + 16, 1.0f);
    std::iota(view.view_from_world, view.view_from_world + 16, 2.0);
    crevice_view two[] = {sized<crevice_view>(), view};
    need(crevice_effect_set_views(effect, two, 2));
    REQUIRE(frame().other_views.size() == 2);
    CHECK(frame().other_views[0].camera.view_from_world == glm::dmat4(1.0));
    CHECK(frame().other_views[1].camera.clip_from_view == glm::make_mat4(view.clip_from_view));
    CHECK(frame().other_views[1].camera.view_from_world == glm::make_mat4(view.view_from_world));
}

TEST_CASE_METHOD(CViews, "C API: clip control holds for all views")
{
    need(crevice_effect_set_clip_control(effect, false, true));
    need(crevice_effect_render(effect));
    CHECK(frame().other_views[0].camera.clip_control == ClipControl{false, true});
}

TEST_CASE_METHOD(CViews,
                 "C API: a view has the textures that it is given, as long as there is the view")
{
    const int before = recording->live(ObjectId::Kind::texture);
    texture.name = 9;
    CHECK(setTexture(1) == 0);
    const int attempts = recording->attempts();
    CHECK(setTexture(1) == 0);
    CHECK(recording->attempts() == attempts);
    const auto& textures = frame().other_views[0].textures;
    REQUIRE(textures.size() == 1);
    CHECK(textures[0].name == "depth");
    CHECK(recording->info(textures[0].texture).native_name == 9);
    CHECK(recording->live(ObjectId::Kind::texture) == before + 1);
    need(crevice_effect_set_views(effect, nullptr, 0));
    CHECK(recording->live(ObjectId::Kind::texture) == before);
    CHECK(setTexture(0) == 0);
    CHECK(recording->live(ObjectId::Kind::texture) == before);
}

TEST_CASE_METHOD(CViews, "C API: what a host draws into a layer is copied for each view and frame")
{
    texture.kind = CREVICE_LAYER;
    texture.layer = 1;
    CHECK(setTexture(1) == 0);
    recording->clearLog();
    need(crevice_effect_render(effect));
    CHECK(recording->log().find("refresh") != std::string::npos);
}

TEST_CASE_METHOD(CViews, "C API: a texture or an output of a view that is not there is refused")
{
    auto output = sized<crevice_output>();
    const auto get = [&](int of_view) {
        return codeOf(crevice_effect_get_view_output(effect, of_view, "ao", &output));
    };
    CHECK(setTexture(2) == 6011);
    CHECK(setTexture(-1) == 6011);
    CHECK(codeOf(crevice_effect_set_view_texture(effect, 1, "dept", &texture)) == 2102);
    texture.format = "depth16";
    CHECK(setTexture(1) == 6011);
    CHECK(frame().other_views[0].textures.empty());
    CHECK(get(1) == 6011);  // before a frame
    need(crevice_effect_render(effect));
    CHECK(get(0) == 0);
    const std::uint32_t first = output.texture;
    CHECK(get(1) == 0);
    CHECK(output.texture != first);
    CHECK(get(2) == 6011);
    CHECK(get(-1) == 6011);
    auto target = sized<crevice_target>();
    target.width = target.height = 4;
    const auto present = [&](int of_view) {
        target.view = of_view;
        recording->clearLog();
        const int code = codeOf(crevice_effect_present(effect, "ao", &target));
        return code == 0 ? recording->log() : std::to_string(code);
    };
    CHECK(present(2) == "6011");
    CHECK(present(0) != present(1));
    CHECK(codeOf(crevice_effect_present(effect, "aoo", &target)) == 2209);
}
