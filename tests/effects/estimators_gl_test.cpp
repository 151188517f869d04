// SPDX-License-Identifier: MIT
// What single estimators and params promise, drawn for real. What all estimators have in common is
// in shipped_properties_gl_test.cpp.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <functional>
#include <utility>

using namespace crevice;

namespace {

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

/// The module's visibility of a host's distances, of which each column of pixels has one; 0 is the
/// background.
Image visibilityOf(DrawRig& rig, const std::string& module, const Names& overrides,
                   const std::function<float(int)>& distance)
{
    const Extent extent = rig.extent;
    Image distances(extent, 1);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) distances.at(x, y) = distance(x);
    Frame frame;
    frame.camera.clip_from_view = glm::perspective(
        0.8f * extent.height / extent.width, float(extent.width) / extent.height, 0.1f, 100.0f);
    frame.textures = {{"linear_depth", rig.texture(Format::r32f, extent)}};
    need(rig.device->writeTexture(frame.textures[0].texture, distances));
    return rig.draw(GivenConfig({"geometry/host_linear_depth", module}).description(overrides),
                    frame);
}

void addMesh(Scene& scene, const MeshDesc& mesh)
{
    scene.meshes.push_back(mesh);
    scene.instances.push_back(scene.instances[0]);
    scene.instances.back().mesh = static_cast<int>(scene.meshes.size()) - 1;
}

}  // namespace

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

TEST_CASE("Tiles have each pixel's own surface, also where the view is no multiple of four wide")
{
    // What the last pixels see lies behind an edge right before them.
    constexpr int kEdge = 124;
    DrawRig rig;
    for (const int width : {128, 127, 126}) {
        INFO(width);
        rig.extent = {width, 24};
        for (const char* module : {"ssao/hbao", "ssao/hbao_plus"}) {
            const Image ao = visibilityOf(rig, module, {"radius=0.3"},
                                          [](int x) { return x < kEdge ? 4.85f : 5.0f; });
            CHECK(meanOfColumns(ao, kEdge, width) < 0.99);
            CHECK(meanOfColumns(ao, 0, kEdge - 12) == 1.0);
        }
    }
}

TEST_CASE("What stands far in front tells hbao no more than background where thin occluders skip")
{
    constexpr int kBar = 57, kStep = 60;
    DrawRig rig;
    rig.extent = {128, 24};
    const auto drawn = [&](float bar, const char* thin) {
        return visibilityOf(rig, "ssao/hbao", {"radius=0.3", thin}, [bar](int x) {
            return x == kBar || x == kBar + 1 ? bar : x < kStep ? 5.0f : 4.8f;
        });
    };
    const Image none = drawn(0, "thin_occluders=skip");
    const Image skipped = drawn(1, "thin_occluders=skip");
    for (const auto& [first, last] : {std::pair(0, kBar), std::pair(kStep, 128)})
        for (int x = first; x < last; ++x)
            for (int y = 0; y < 24; ++y) REQUIRE(skipped.at(x, y) == none.at(x, y));
    CHECK(meanOfColumns(none, kBar - 4, kBar) < 0.99);
    const Image counted = drawn(1, "thin_occluders=count");
    CHECK(meanOfColumns(counted, kBar - 4, kBar) < meanOfColumns(none, kBar - 4, kBar) - 0.05);
}

TEST_CASE("The winding of sheets changes nothing for the bitmask with back faces")
{
    const Names bitmask = {"ssao/bitmask", "geometry/second_layer"};
    SceneRig corner("corner");
    Scene scene = corner.scene;
    for (MeshDesc& mesh : scene.meshes)
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i], mesh.indices[i + 1]);
    SceneRig turned(scene);
    const Image plain = visibility(corner, bitmask, {});
    CHECK(mean(plain) < 0.97);
    CHECK(plain.pixels == visibility(turned, bitmask, {}).pixels);
    // A corner of sheets is as dark as one of thick walls.
    CHECK(meanChange(plain, visibility(corner, {"ssao/bitmask"}, {})) < 0.01);
}

TEST_CASE(
    "Light passes behind a sheet, also one that another hides, and not behind a body with the same "
    "front")
{
    struct Case {
        const char* layer;
        const char* setting;
        float height;  ///< Of the sheet over the floor.
        bool hidden;   ///< By another sheet over it.
        double most;   ///< Occlusion of a sheet, over that of the body.
    };
    for (const Case& each : {Case{"geometry/back_faces", "max_gap=1", 0.9f, false, 0.5},
                             Case{"geometry/second_layer", "thickness=8", 0.8f, true, 0.8}}) {
        SceneRig rig("plane");
        const Scene plane = rig.scene;
        const auto occlusion = [&](const MeshDesc& mesh) {
            Scene scene = plane;
            if (each.hidden) addMesh(scene, makeQuad({-0.5f, 1.2f, 0.5f}, {1, 0, 0}, {0, 0, -1}));
            addMesh(scene, mesh);
            rig.show(scene);
            return 1 - mean(visibility(rig, {"ssao/bitmask", each.layer},
                                       {"radius=1", "slices=4", "steps=8", each.setting},
                                       "eye=0,6,4;at=0,0.4,0;fov=30"));
        };
        const double none = occlusion(makeBox({0, -3, 0}, {0.1f, -2, 0.1f}));
        const double sheet = occlusion(makeQuad({-0.5f, each.height, 0.5f}, {1, 0, 0}, {0, 0, -1}));
        const double body = occlusion(makeBox({-0.5f, 0.02f, -0.5f}, {0.5f, each.height, 0.5f}));
        INFO(each.layer << ' ' << none << ' ' << sheet << ' ' << body);
        if (!each.hidden) CHECK(none < 0.01);
        CHECK(sheet - none < each.most * (body - none));
        CHECK(sheet > none);
    }
}

TEST_CASE("Intensity multiplies the occlusion, and power is then taken of the visibility")
{
    SceneRig rig("corner");
    for (const Module& estimator : shippedEstimators()) {
        const auto drawn = [&](const char* intensity, const char* power) {
            return visibility(rig, {estimator.name}, {intensity, power, "radius=1", kFloat});
        };
        const Image plain = drawn("intensity=1", "power=1");
        for (const float intensity : {0.6f, 3.0f}) {
            const char* wanted = intensity < 1 ? "intensity=0.6" : "intensity=3";
            const Image changed = drawn(wanted, "power=2");
            Image expected = plain;
            for (float& open : expected.pixels) {
                const float left = std::clamp(1 - intensity * (1 - open), 0.0f, 1.0f);
                open = left * left;
            }
            INFO(estimator.name << " " << wanted);
            CHECK(allVisibility(changed));
            CHECK(meanChange(changed, expected) < 0.002);
        }
    }
}

TEST_CASE("The power of the occlusion lightens and contrast keeps what is open")
{
    SceneRig rig("corner");
    const auto drawn = [&](const Names& overrides) {
        return mean(visibility(rig, {"ssao/hemisphere"}, overrides, ""));
    };
    const double plain = drawn({});
    CHECK(drawn({"power_of=occlusion"}) == Approx(plain).margin(1e-4));
    CHECK(drawn({"power_of=occlusion", "power=2"}) > plain + 0.002);
    CHECK(drawn({"power=2"}) < plain - 0.002);
    CHECK(drawn({"contrast=2"}) > plain);  // all of the corner is lighter than a half
}

TEST_CASE("250 offsets without rotation draw what 16 with rotation and a filter do")
{
    SceneRig rig("spheres");
    const auto drawn = [&](const Names& overrides) {
        return rig.draw(descriptionOf({"hemisphere_box"}, overrides), rig.frame());
    };
    const Image many = drawn({"samples=250", "/generated/rotation_noise/count=1", "blur_size=1"});
    CHECK(mean(many) < 0.99);
    CHECK(meanChange(drawn({"samples=16"}), many) < 0.01);
}

TEST_CASE("The bounce only adds light, and none without lights reflected")
{
    SceneRig rig("corner");
    const auto color = [&](const Names& overrides) {
        return rig.draw(descriptionOf({"ssdo"}, overrides), rig.frame(kTowardsCorner), "color");
    };
    const Image without = color({"bounce=0"}), with = color({});
    CHECK(meanChange(without, color({"indirect=false"})) == 0.0);
    CHECK(mean(with) > mean(without) + 0.001);
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        REQUIRE(with.pixels[i] >= without.pixels[i]);
}

TEST_CASE("The three display modes agree with each other")
{
    SceneRig rig("spheres");
    const auto drawn = [&](const Names& overrides, const char* output = "color") {
        return rig.draw(descriptionOf({"learnopengl"}, overrides), rig.frame(), output);
    };
    const Image ao = drawn({}, "ao"), shown = drawn({"display=ao_only"});
    for (int x = 0; x < ao.extent.width; ++x) CHECK(shown.at(x, 30) == ao.at(x, 30));
    const double with = mean(drawn({}));
    CHECK(with < mean(drawn({"display=no_ao"})));
    CHECK(mean(drawn({"ao_on=everything"})) < with);
}

TEST_CASE("Bare OpenGL ES 3.0 draws the same occlusion where no float target is needed")
{
    PictureRequest request;
    const Image full = picture(request);
    request.ignore_extensions = true;
    CHECK(meanChange(full, picture(request)) == 0.0);
}
