// SPDX-License-Identifier: MIT
// What a plan may depend on, drawn from a frame; and the least device.
#include <crevice/frame.h>

#include "tests/support/catch.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

TEST_CASE("A camera is orthographic by its last row alone")
{
    Camera camera;
    camera.clip_from_view = glm::ortho(-2.0f, 3.0f, -1.0f, 1.0f, 0.1f, 50.0f);
    CHECK(camera.orthographic());
    camera.clip_from_view = glm::perspective(1.0f, 1.5f, 0.1f, 50.0f);
    CHECK_FALSE(camera.orthographic());
    camera.clip_from_view = glm::frustum(-0.1f, 0.3f, -0.1f, 0.1f, 0.1f, 50.0f);
    CHECK_FALSE(camera.orthographic());
}

TEST_CASE("A camera reverses depth when what is farther has less of it")
{
    Camera camera;
    CHECK_FALSE(camera.reversedDepth());
    const glm::mat4 flip = glm::scale(glm::mat4(1), glm::vec3(1, 1, -1));
    for (const glm::mat4& clip : {glm::ortho(-2.0f, 3.0f, -1.0f, 1.0f, 0.1f, 50.0f),
                                  glm::perspective(1.0f, 1.5f, 0.1f, 50.0f),
                                  glm::frustum(-0.1f, 0.3f, -0.1f, 0.1f, 0.1f, 50.0f),
                                  glm::infinitePerspective(1.0f, 1.5f, 1e-6f)}) {
        camera.clip_from_view = clip;
        CHECK_FALSE(camera.reversedDepth());
        camera.clip_from_view = flip * clip;
        CHECK(camera.reversedDepth());
    }
}

TEST_CASE("Traits come from the materials that something draws")
{
    Frame frame;
    Material material;
    SECTION("alpha test")
    {
        material.alpha_cutoff = 0.5f;
        frame.materials = {Material{}, material};
        frame.draws = {DrawItem{}};
        CHECK_FALSE(traitsOf(frame).alpha_tested);
        frame.draws[0].material = 1;
        CHECK(traitsOf(frame).alpha_tested);
    }
    SECTION("highlights, of any colour")
    {
        material.specular = {0, 0, 0.1f};
        frame.materials = {material};
        CHECK_FALSE(traitsOf(frame).specular);
        frame.draws = {DrawItem{}};
        CHECK(traitsOf(frame).specular);
    }
    SECTION("textures")
    {
        material.base_color_map = TextureId{7};
        frame.materials = {material};
        frame.draws = {DrawItem{}};
        CHECK(traitsOf(frame).textured);
    }
    SECTION("normal maps and baked occlusion")
    {
        material.normal_map = TextureId{7};
        frame.materials = {material, Material{}};
        frame.draws = {DrawItem{}};
        CHECK(traitsOf(frame).normal_mapped);
        CHECK_FALSE(traitsOf(frame).baked_occlusion);
        CHECK_FALSE(traitsOf(frame) == traitsOf(Frame{}));
        frame.materials[0] = Material{};
        frame.materials[0].occlusion_map = TextureId{7};
        CHECK(traitsOf(frame).baked_occlusion);
        CHECK_FALSE(traitsOf(frame).normal_mapped);
    }
    SECTION("materials that reflect less of the ambient light")
    {
        material.ambient = 2.0f;
        frame.materials = {material};
        frame.draws = {DrawItem{}};
        CHECK_FALSE(traitsOf(frame).material_ambient);
        frame.materials[0].ambient = 0.99f;
        CHECK(traitsOf(frame).material_ambient);
        CHECK_FALSE(traitsOf(frame) == traitsOf(Frame{}));
    }
    SECTION("a material that is not there counts for nothing")
    {
        frame.draws = {DrawItem{}};
        frame.draws[0].material = -3;
        CHECK(traitsOf(frame) == traitsOf(Frame{}));
    }
}

TEST_CASE("No more lights count than a shader holds")
{
    Frame frame;
    frame.lights.resize(kMaxLights + 5);
    CHECK(traitsOf(frame).lights == kMaxLights);
}

TEST_CASE("Traits differ when any of them does")
{
    const SceneTraits none;
    CHECK(none == SceneTraits{});
    CHECK_FALSE(none == SceneTraits{1, false, false, false, false});
    CHECK_FALSE(none == SceneTraits{0, true, false, false, false});
    CHECK_FALSE(none == SceneTraits{0, false, true, false, false});
    CHECK_FALSE(none == SceneTraits{0, false, false, true, false});
    CHECK_FALSE(none == SceneTraits{0, false, false, false, true});
}

TEST_CASE("The least device renders to what OpenGL ES 3.0 promises and to nothing else")
{
    const DeviceCaps caps = minimumCaps();
    for (const FormatInfo& info : allFormats()) {
        CAPTURE(info.name);
        CHECK(caps.canRender(info.format) == info.core_renderable);
    }
    CHECK(caps.canRender(Format::rgba8));
    CHECK_FALSE(caps.canRender(Format::rgba32f));
    CHECK(caps.max_color_attachments == 4);
}

TEST_CASE("The range of draws is of those in view, by what they cover, and unknown without bounds")
{
    Frame frame;
    frame.camera.clip_from_view = glm::mat4(glm::perspective(1.0, 1.0, 0.1, 100.0));
    const auto add = [&frame](double distance, float radius) {
        DrawItem item;
        item.count = 3;
        item.world_from_model[3] = {0, 0, -distance, 1};
        item.bounds_radius = radius;
        frame.draws.push_back(item);
    };
    CHECK(traitsOf(frame).draws.distance == 0);
    add(10, 1);
    CHECK(traitsOf(frame).draws.distance == Approx(10).epsilon(1e-3));
    add(-10, 1);  // behind the camera
    add(50, 1);   // covers a 25th
    CHECK(traitsOf(frame).draws.distance == Approx(10 + 40.0 / 26).epsilon(1e-3));
    frame.draws.push_back(frame.draws[0]);
    frame.draws.back().world_from_model[3].z = 0;  // about the camera
    frame.draws.back().bounds_radius = 6;
    std::swap(frame.draws.front(), frame.draws.back());
    frame.draws.resize(1);
    CHECK(traitsOf(frame).draws.distance == Approx((0.1 + 6) / 2).epsilon(1e-3));
    frame.draws.clear();
    add(10, 1);
    frame.draws[0].bounds_center = {0, 0, 1e6f};
    frame.draws[0].world_from_model[3].z -= 1e6;
    CHECK(traitsOf(frame).draws.vertex_step == 0.0625);
    add(10, -1);
    CHECK(traitsOf(frame).draws.distance == 0);
    CHECK(traitsOf(frame).draws.vertex_step == 0);
}
