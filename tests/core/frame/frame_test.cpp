// SPDX-License-Identifier: MIT
// What a plan may depend on, drawn from a frame; and the least device.
#include <crevice/frame.h>

#include "core/frame/frame_math.h"
#include "tests/support/catch.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

using namespace crevice;

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

namespace {

const glm::dmat4 kLens = glm::frustum(-0.2, 0.4, -0.1, 0.3, 0.5, 50.0);
const glm::dmat4 kBox = glm::ortho(-2.0, 3.0, -1.0, 1.0, 0.1, 50.0);
const glm::dmat4 kView =
    glm::lookAt(glm::dvec3(1, 2, 3), glm::dvec3(-1, 0.5, 0), glm::dvec3(0, 1, 0));

/// A picture's plane turned or flipped: columns of x and y.
glm::dmat4 ofPicture(const glm::dvec2& x, const glm::dvec2& y)
{
    return glm::dmat4(glm::dmat2(x, y));
}

bool isTurned(const Camera& camera)
{
    Frame frame;
    frame.camera = camera;
    return traitsOf(frame).turned;
}

double largestDifference(const glm::dmat4& a, const glm::dmat4& b)
{
    double largest = 0;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) largest = std::max(largest, std::abs(a[i][k] - b[i][k]));
    return largest;
}

}  // namespace

TEST_CASE("Shaders see x to the right, y up and the view along -z, whatever the projection does")
{
    const glm::dmat4 to_picture =
        GENERATE(ofPicture({1, 0}, {0, 1}), ofPicture({-1, 0}, {0, 1}), ofPicture({1, 0}, {0, -1}),
                 ofPicture({-1, 0}, {0, -1}), ofPicture({0, 1}, {-1, 0}),
                 ofPicture({0, -1}, {1, 0}), ofPicture({0, 1}, {1, 0}),
                 ofPicture({0.8, 0.6}, {-0.6, 0.8}), ofPicture({0.96, -0.28}, {-0.28, -0.96}));
    const glm::dmat4 of_view = GENERATE(glm::dmat4(1.0), glm::scale(glm::dmat4(1.0), {1, 1, -1}));
    const glm::dmat4 lens = GENERATE(as<glm::dmat4>(), kLens, kBox);
    // A roll of a wide picture shears it; this one is square.
    const glm::dmat4 square = glm::scale(glm::dmat4(1.0), {1 / lens[0][0], 1 / lens[1][1], 1.0});
    const Camera camera = {of_view * kView, glm::mat4(to_picture * square * lens * of_view)};

    const CameraMatrices seen = cameraMatrices(camera);
    CHECK(seen.clip_from_view[0][0] > 0.99);
    CHECK(seen.clip_from_view[1][1] > 0.99);
    CHECK(std::abs(seen.clip_from_view[0][1]) < 1e-6);
    CHECK(std::abs(seen.clip_from_view[1][0]) < 1e-6);
    CHECK((camera.orthographic() || seen.clip_from_view[2][3] < 0));
    CHECK((seen.clip_from_view * glm::dvec4(0, 0, -10, 1)).w > 0);
    CHECK_FALSE(camera.reversedDepth());

    INFO("the world lands where the host's matrices put it");
    CHECK(largestDifference(seen.clip_from_view * seen.view_from_world,
                            glm::dmat4(camera.clip_from_view) * camera.view_from_world) < 1e-12);
    CHECK(largestDifference(seen.view_from_world,
                            glm::dmat4(seen.view_from_host) * camera.view_from_world) < 1e-12);
    const bool turned = to_picture != glm::dmat4(1.0) || of_view != glm::dmat4(1.0);
    CHECK(isTurned(camera) == turned);
    CHECK(rangeOf(camera) == rangeOf(Camera{kView, glm::mat4(square * lens)}));
}

TEST_CASE("Of an upright camera no bit is turned")
{
    const glm::dmat4 lens =
        GENERATE(as<glm::dmat4>(), kLens, kBox, glm::infinitePerspective(1.0, 1.5, 1e-3));
    const bool mirrored = GENERATE(false, true);
    Camera camera = {kView, glm::mat4(lens)};
    if (mirrored) camera.view_from_world[0] *= -1.0;  // a planar reflection
    const CameraMatrices seen = cameraMatrices(camera);
    CHECK(seen.clip_from_view == glm::dmat4(camera.clip_from_view));
    CHECK(seen.view_from_world == camera.view_from_world);
    CHECK(seen.view_from_host == glm::dmat3(1.0));
    CHECK_FALSE(isTurned(camera));
}

TEST_CASE("A projection is left-handed where it is made for a view along +z")
{
    const auto leftHanded = [](const glm::dmat4& clip) {
        return Camera{kView, glm::mat4(clip)}.leftHanded();
    };
    CHECK_FALSE(leftHanded(kLens));
    CHECK_FALSE(leftHanded(kBox));
    CHECK(leftHanded(glm::perspectiveLH(1.0, 1.5, 0.1, 10.0)));
    CHECK(leftHanded(glm::orthoLH_NO(-2.0, 2.0, -1.0, 1.0, 0.0, 50.0)));
    CHECK_FALSE(leftHanded(glm::orthoLH_NO(-2.0, 2.0, -1.0, 1.0, -9.0, 50.0)));
    Camera from_zero = {kView, glm::mat4(glm::orthoLH_ZO(-2.0, 2.0, -1.0, 1.0, 0.1, 50.0))};
    from_zero.clip_control = ClipControl{true, false};
    CHECK(from_zero.leftHanded());
}

TEST_CASE("A box is looked at along +z where the view mirrors and all of it lies there")
{
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), {1, 1, -1});
    const double near = GENERATE(0.0, 0.1, 5.0);
    Camera camera = {mirror * kView, glm::mat4(glm::orthoLH_NO(-2.0, 2.0, -1.0, 1.0, near, 50.0))};
    CHECK(isTurned(camera));
    CHECK_FALSE(camera.reversedDepth());
    camera.view_from_world = kView;
    CHECK_FALSE(isTurned(camera));
    camera.view_from_world = mirror * kView;
    INFO("reversed depth of a reflection");
    camera.clip_from_view = glm::mat4(mirror * glm::orthoRH_NO(-2.0, 2.0, -1.0, 1.0, near, 50.0));
    CHECK_FALSE(isTurned(camera));
    CHECK(camera.reversedDepth());
    INFO("a box around the eye");
    camera.clip_from_view = glm::mat4(glm::orthoLH_NO(-2.0, 2.0, -1.0, 1.0, -9.0, 50.0));
    CHECK_FALSE(isTurned(camera));
}

TEST_CASE("A projection that shears the picture keeps the nearest right angles")
{
    const glm::dmat4 shear(glm::dmat2({1, 0.25}, {0.5, 1}));
    for (const glm::dmat4& turn : {ofPicture({1, 0}, {0, 1}), ofPicture({0, 1}, {-1, 0}),
                                   ofPicture({0, -1}, {-1, 0}), ofPicture({-1, 0}, {0, 1})}) {
        const Camera camera = {kView, glm::mat4(turn * shear * kLens)};
        const CameraMatrices seen = cameraMatrices(camera);
        const glm::dmat3 square = seen.view_from_host * glm::transpose(seen.view_from_host);
        CHECK(square == glm::dmat3(1.0));
        CHECK(seen.clip_from_view[0][0] > std::abs(seen.clip_from_view[1][0]));
        CHECK(seen.clip_from_view[1][1] > std::abs(seen.clip_from_view[0][1]));
    }
}

TEST_CASE("Traits come from the materials that something draws")
{
    const struct {
        void (*change)(Material&);
        bool SceneTraits::*trait;
        bool holds;
    } rows[] = {
        {[](Material& m) { m.alpha_cutoff = 0.5f; }, &SceneTraits::alpha_tested, true},
        {[](Material& m) {
             m.specular = {0, 0, 0.1f};
         },
         &SceneTraits::specular, true},
        {[](Material& m) { m.base_color_map = TextureId{7}; }, &SceneTraits::textured, true},
        {[](Material& m) { m.normal_map = TextureId{7}; }, &SceneTraits::normal_mapped, true},
        {[](Material& m) { m.occlusion_map = TextureId{7}; }, &SceneTraits::baked_occlusion, true},
        {[](Material& m) { m.ambient = 0.99f; }, &SceneTraits::material_ambient, true},
        {[](Material& m) { m.ambient = 2.0f; }, &SceneTraits::material_ambient, false},
    };
    const SceneTraits none = traitsOf(Frame{});
    Frame frame;
    frame.draws = {DrawItem{}};
    for (const int material : {0, 1, -3}) {  // the latter are not there
        frame.draws[0].material = material;
        CHECK(traitsOf(frame) == none);
    }
    for (const auto& [change, trait, holds] : rows) {
        frame.materials = {Material{}, Material{}};
        change(frame.materials[1]);
        frame.draws[0].material = 0;
        CHECK(traitsOf(frame) == none);
        frame.draws[0].material = 1;
        CHECK(traitsOf(frame).*trait == holds);
        CHECK((traitsOf(frame) == none) == !holds);
    }
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

TEST_CASE("Two materials differ where any of their members does")
{
    const std::function<void(Material&)> changes[] = {
        [](Material& m) { m.base_color.y = 0.5f; },
        [](Material& m) { m.base_color_map.value = 7; },
        [](Material& m) { m.specular = glm::vec3(0.25f); },
        [](Material& m) { m.shininess = 3; },
        [](Material& m) { m.ambient = 0.25f; },
        [](Material& m) { m.alpha_cutoff = 0.25f; },
        [](Material& m) { m.normal_map.value = 7; },
        [](Material& m) { m.normal_scale = 0.5f; },
        [](Material& m) { m.occlusion_map.value = 7; },
        [](Material& m) { m.occlusion_strength = 0.5f; },
    };
    for (const auto& change : changes) {
        INFO("change " << &change - changes);
        Material changed;
        change(changed);
        CHECK_FALSE(changed == Material());
    }
    CHECK(Material() == Material());
}
