// SPDX-License-Identifier: MIT
// Every shipped config and variant, drawn for real. What else holds for them `crevice stress` asks,
// and tools/scripts/guard_bench.sh knows how far each is from the ground truth.
// Frames of two views, drawn for real: each view's picture is that of its camera alone.
// What single estimators promise, drawn for real, and that a user's own one is two files. What all
// estimators have in common is in matrix_gl_test.cpp.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/stress/scenes.h"
#include "tools/render/scene/mesh_normals.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {128, 72};

/// A floor before a wall, in such units.
struct Corner {
    Corner(Device& device, double scene_unit)
        : unit(scene_unit),
          scene(need(UploadedScene::upload(
              device, placed(cornerScene(), glm::scale(glm::dmat4(1.0), glm::dvec3(scene_unit)))))),
          frame(makeFrame(scene, SceneCamera(), kExtent))
    {
        StressView view;
        view.eye = glm::dvec3(0, 1, 4) * unit;
        view.near_distance *= unit;
        view.far_distance *= unit;
        frame.camera = cameraOf(view, kExtent);
    }

    Description inUnits(Description description) const
    {
        for (ParamDesc& param : description.params)
            if (param.unit == "scene units") param.value[0] *= static_cast<float>(unit);
        return description;
    }

    double unit;
    UploadedScene scene;
    Frame frame;
};

/// The spheres, seen from places that move with time, each off-centre by `shift` pictures.
struct Eyes : SceneRig {
    Eyes() : SceneRig("spheres", {96, 54}) {}

    Frame seen(double right, double shift, int time) const
    {
        const std::string x = std::to_string(1.0 + right + 0.05 * time);
        return frame("eye=" + x + ",1.5,4;at=" + std::to_string(right) +
                     ",0.5,0;fov=45;shift=" + std::to_string(shift) + ",0.05");
    }
};

Frame together(const Frame& left, const Frame& right)
{
    Frame both = left;
    both.other_views = {{right.camera, {}}};
    return both;
}

using Names = std::vector<std::string>;

const char* const kTowardsCorner = "eye=0,1.5,4;at=0,0,0;fov=40";
const char* const kFloat = "/targets/ao/format=[\"r32f\"]";

/// What modules over depth and normals make of a rig's scene.
Image visibility(SceneRig& rig, Names modules, const Names& overrides,
                 const char* camera = kTowardsCorner)
{
    modules.insert(modules.begin(), "geometry/depth_normal");
    return rig.draw(GivenConfig(modules).description(overrides), rig.frame(camera));
}

}  // namespace

TEST_CASE("Every shipped config darkens a corner, in any units, and nothing with an intensity of 0")
{
    DrawRig rig;
    const Corner corner(*rig.device, 1), large(*rig.device, 1000);
    for (const Subject& subject : subjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = descriptionOf(subject);
        Renderer& drawn = rig.reloaded(description, corner.frame, {kExtent, {}, {}});
        need(drawn.render(corner.frame));
        const Image ao = rig.read(drawn.output("ao"));
        CHECK(allVisibility(ao));
        CHECK(meanOfRows(ao, 13, 16) < meanOfRows(ao, 1, 6) - 0.02);
        CHECK(shareBelow(rig.read(drawn.output("color")), 0.02f) < 0.01);
        CHECK(meanChange(rig.draw(large.inUnits(description), large.frame), ao) < 0.003);
        CHECK(least(rig.draw(descriptionOf(subject, {"intensity=0"}), corner.frame)) == 1.0f);
    }
}

TEST_CASE("Each view of a frame is the picture of its camera alone, bit for bit")
{
    const std::string config = GENERATE("learnopengl", "gtao", "gtao_temporal");
    INFO(config);
    Eyes eyes;
    const Description description = descriptionOf({config});
    const auto left = [&](int time) { return eyes.seen(-0.1, 0.08, time); };
    const auto right = [&](int time) { return eyes.seen(0.1, -0.08, time); };
    auto left_alone = eyes.renderer(description, left(0));
    auto right_alone = eyes.renderer(description, right(0));
    auto both = eyes.renderer(description, together(left(0), right(0)));
    for (int time = 0; time < 4; ++time) {
        need(left_alone->render(left(time)));
        need(right_alone->render(right(time)));
        need(both->render(together(left(time), right(time))));
        for (const PlanOutput& output : both->plan().outputs) {
            INFO(output.name << " of frame " << time);
            const Image alone = eyes.read(left_alone->output(output.name));
            const Image right_eye = eyes.read(both->output(output.name, 1));
            CHECK(eyes.read(both->output(output.name, 0)).pixels == alone.pixels);
            CHECK(right_eye.pixels == eyes.read(right_alone->output(output.name)).pixels);
            CHECK(meanChange(alone, right_eye) > 0.001);
        }
    }
}

TEST_CASE("A host's depth texture for each view is seen by that view")
{
    Eyes eyes;
    const Frame left = eyes.seen(-0.2, 0.0, 0), right = eyes.seen(0.2, 0.0, 0);
    const GivenConfig drawn({"geometry/depth_normal"}, R"(, "outputs": {"depth": "depth"})");
    auto host = eyes.renderer(drawn.description(), together(left, right));
    need(host->render(together(left, right)));

    const Description hosted =
        GivenConfig({"geometry/host_depth", "ssao/hemisphere", "filter/none"}).description();
    const auto with = [&](Frame frame, int view) {
        frame.textures = {{"depth", host->output("depth", view)}};
        return frame;
    };
    Frame both = together(with(left, 0), right);
    both.other_views[0].textures = with(right, 1).textures;
    auto stereo = eyes.renderer(hosted, both);
    need(stereo->render(both));
    const Image wanted = eyes.draw(hosted, with(right, 1));
    CHECK(mean(wanted) < 0.99);
    CHECK(eyes.read(stereo->output("ao", 1)).pixels == wanted.pixels);
}

TEST_CASE("Occlusion sets in gradually as the radius grows from one pixel to two")
{
    constexpr double kPixel = 4.0 / 72;  // of a view four units high, in scene units
    SceneRig rig("corner");
    for (const char* estimator : {"ssao/gtao", "ssao/bitmask", "ssao/hbao", "ssao/sao"}) {
        const auto occlusion = [&](double pixels) {
            const std::string radius = "radius=" + std::to_string(pixels * kPixel);
            return 1 - mean(visibility(rig, {estimator}, {radius, "bias=0", kFloat},
                                       "eye=0,4,4;at=0,0,0;ortho=4"));
        };
        INFO(estimator << ' ' << occlusion(1.1) << ' ' << occlusion(2));
        CHECK(occlusion(2) > 0);
        CHECK(occlusion(1.1) < 0.1 * occlusion(2));
    }
}

TEST_CASE("Vertex normals that lean from the planes of a convex body darken nothing of it")
{
    SceneRig rig("corner");
    Scene scene;
    scene.meshes = {makeBox({-1, -0.4f, -1}, {1, 0.4f, 1})};
    smoothNormals(scene.meshes[0], 180);
    scene.instances.resize(1);
    scene.materials.resize(1);
    rig.show(std::move(scene));
    rig.extent = {192, 108};
    for (const Names& modules :
         {Names{"ssao/gtao"}, Names{"ssao/bitmask"}, Names{"ssao/bitmask", "geometry/back_faces"},
          Names{"ssao/bitmask", "geometry/back_faces", "filter/upsample"}}) {
        // The near plane of the last makes steps of depth that are not small against a texel.
        for (const char* camera : {"eye=2,2,3;at=0,0,0;fov=40", "eye=2,2,3;at=0,0,0;ortho=3",
                                   "eye=2,2,3;at=0,0,0;fov=40;near=0.005"}) {
            const Image ao = visibility(rig, modules, {"radius=0.5"}, camera);
            INFO(modules.front() << ' ' << modules.back() << ' ' << camera);
            CHECK(shareBelow(ao, 0.95f) < 0.002);  // at corners in front of the background
            CHECK(least(ao) > 0.4f);
            CHECK(mean(ao) > 0.999);
        }
    }
}

TEST_CASE("Poles that no texel of the occlusion stands for have their own, not that behind them")
{
    SceneRig rig("corner");
    Scene scene;
    scene.meshes = {makeBox({-2, -0.2f, -2}, {2, 0, 2})};
    for (int k = 0; k < 24; ++k) {
        const float x = -1.5f + 0.125f * static_cast<float>(k);
        append(scene.meshes[0], makeBox({x, 0, 0}, {x + 0.02f, 0.8f, 0.3f}));
    }
    scene.instances.resize(1);
    scene.materials.resize(1);
    rig.show(std::move(scene));
    rig.extent = {160, 90};
    for (const char* estimator : {"ssao/gtao", "ssao/bitmask", "ssao/hbao"}) {
        const auto picture = [&](const char* filter, const char* scale) {
            return visibility(rig, {estimator, filter}, {"radius=0.4", scale, "slices=4"});
        };
        const Image whole = picture("filter/upsample", "ao_scale=1");
        const double apart = meanChange(picture("filter/upsample", "ao_scale=0.3"), whole);
        const double marched = meanChange(picture("ssao/march_missing", "ao_scale=0.3"), whole);
        INFO(estimator << ' ' << apart << ' ' << marched);
        CHECK(marched < 0.85 * apart);
        // At full size every pixel has its texel.
        CHECK(meanChange(picture("ssao/march_missing", "ao_scale=1"), whole) == 0.0);
    }
}

TEST_CASE("Tiles of every fourth pixel give the occlusion of hbao, whatever the size")
{
    SceneRig rig("corner");
    for (const Extent extent : {Extent{128, 72}, Extent{126, 71}, Extent{125, 73}}) {
        rig.extent = extent;
        const Image whole = visibility(rig, {"ssao/hbao", "filter/box"}, {"radius=1"});
        const Image tiled = visibility(rig, {"ssao/hbao_plus", "filter/box"}, {"radius=1"});
        INFO(extent.width << "x" << extent.height);
        CHECK(meanChange(whole, tiled) < 0.01);
        CHECK(mean(whole) < 0.97);
    }
}

TEST_CASE("Bare OpenGL ES 3.0 draws the same occlusion where no float target is needed")
{
    const auto drawn = [](bool bare) {
        GlDeviceOptions options;
        options.ignore_extensions = bare;
        SceneRig rig(need(loadScene("spheres")), {128, 72}, options);
        return rig.draw(descriptionOf({"hemisphere_box"}), rig.frame());
    };
    CHECK(drawn(true).pixels == drawn(false).pixels);
}

TEST_CASE("An estimator is two files: a module that extends ssao/estimator, and its shader")
{
    const char* const config = CREVICE_SOURCE_DIR "/tests/data/new_estimator/mine.json";
    SceneRig rig("corner");
    const auto least_of = [&](const Names& overrides) {
        return least(rig.draw(descriptionOf({config}, overrides), rig.frame(kTowardsCorner)));
    };
    CHECK(least_of({}) < 0.9f);
    CHECK(least_of({"intensity=0"}) == 1.0f);
    rig.show("plane");
    CHECK(least_of({}) == 1.0f);
}
