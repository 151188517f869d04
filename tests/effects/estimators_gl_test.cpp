// SPDX-License-Identifier: MIT
// Properties that every estimator has, drawn for real.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tools/scene/mesh_shapes.h"

#include <crevice/config.h>
#include <crevice/renderer.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <functional>
#include <utility>

using namespace crevice;

namespace {

const char* const kTowardsCorner = "eye=0,1.5,4;at=0,0,0;fov=40";
const char* const kBox = "filter/box";  // takes the noise out

/// The module's visibility, unfiltered unless a filter is named.
Image visibility(const std::string& module, PictureRequest request, const Scene& scene,
                 const char* filter = nullptr)
{
    std::vector<std::string> modules = {"geometry/depth_normal", module};
    if (filter) modules.push_back(filter);
    const GivenConfig config(modules);
    request.config = "given";
    request.sources = &config.sources();
    return picture(request, scene);
}

Image visibility(const std::string& module, const PictureRequest& request,
                 const char* filter = nullptr)
{
    return visibility(module, request, need(loadScene(request.scene)), filter);
}

/// The module's visibility of a host's distances, of which each column of pixels has one; 0 is the
/// background.
Image visibilityOf(const std::string& module, Extent extent,
                   const std::function<float(int)>& distance,
                   const std::vector<std::string>& overrides)
{
    const GivenConfig config({"geometry/host_linear_depth", module});
    const Node document = need(loadConfig(config.sources(), {"given", {}, overrides}));
    Image distances(extent, 1);
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) distances.at(x, y) = distance(x);
    GlFixture gl;
    Frame frame;
    frame.camera.clip_from_view = glm::perspective(
        0.8f * extent.height / extent.width, float(extent.width) / extent.height, 0.1f, 100.0f);
    frame.textures = {{"linear_depth", gl.texture(Format::r32f, extent)}};
    need(gl.device->writeTexture(frame.textures[0].texture, distances));
    auto renderer = need(Renderer::create(*gl.device, need(decode(document, config.sources())),
                                          {extent, {"ao"}, {}}, traitsOf(frame)));
    need(renderer->render(frame));
    return gl.read(renderer->output("ao"));
}

double meanOfColumns(const Image& image, int first, int last)
{
    double sum = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = first; x < last; ++x) sum += image.at(x, y);
    return sum / ((last - first) * double(image.extent.height));
}

float least(const Image& image)
{
    float value = 1.0f;
    for (float each : image.pixels) value = std::min(value, each);
    return value;
}

double meanOfRows(const Image& image, int first, int last)
{
    double sum = 0;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < image.extent.width; ++x) sum += image.at(x, y);
    return sum / ((last - first) * double(image.extent.width));
}

}  // namespace

TEST_CASE("A flat wall is open, however it lies to the camera")
{
    for (const Module& estimator : shippedEstimators()) {
        if (!estimator.reads_normals) continue;  // probes inside the wall, and finds it grey
        for (const char* camera : {"", "eye=0,0.4,4;at=0,0,-8;fov=60", "eye=1,9,2;at=0,0,0;fov=50",
                                   "eye=3,4,5;at=0,0,0;ortho=4"}) {
            PictureRequest request;
            request.scene = "plane";
            request.camera = camera;
            INFO(estimator.name << " " << camera);
            CHECK(least(visibility(estimator.name, request)) == 1.0f);
        }
    }
}

TEST_CASE("A corner is darker than the open floor")
{
    for (const Module& estimator : shippedEstimators()) {
        PictureRequest request;
        request.scene = "corner";
        request.camera = kTowardsCorner;
        const Image ao = visibility(estimator.name, request);
        const int middle = ao.extent.height / 2;
        INFO(estimator.name);
        CHECK(allVisibility(ao));
        CHECK(meanOfRows(ao, middle - 3, middle + 3) < meanOfRows(ao, 4, 12) - 0.05);
    }
}

TEST_CASE("The occlusion vanishes as the radius tends to 0")
{
    for (const Module& estimator : shippedEstimators()) {
        if (!estimator.reads_normals) continue;  // probes inside the wall, and finds it grey
        PictureRequest request;
        request.scene = "corner";
        request.overrides = {"radius=1e-6"};
        INFO(estimator.name);
        CHECK(least(visibility(estimator.name, request)) == 1.0f);
    }
}

TEST_CASE("Occlusion sets in gradually as the radius grows from one pixel to two")
{
    constexpr double kPixel = 4.0 / 72;  // of a view four units high, in scene units
    for (const char* estimator : {"ssao/gtao", "ssao/bitmask", "ssao/hbao", "ssao/sao"}) {
        const auto occlusion = [&](double pixels) {
            PictureRequest request;
            request.scene = "corner";
            request.camera = "eye=0,4,4;at=0,0,0;ortho=4";
            request.overrides = {"radius=" + std::to_string(pixels * kPixel), "bias=0",
                                 "/targets/ao/format=[\"r32f\"]"};
            return 1 - mean(visibility(estimator, request));
        };
        INFO(estimator << ' ' << occlusion(1.1) << ' ' << occlusion(2));
        CHECK(occlusion(2) > 0);
        CHECK(occlusion(1.1) < 0.1 * occlusion(2));
    }
}

TEST_CASE("A mirrored scene gives the mirrored picture")
{
    const Scene scene = need(loadScene("spheres"));
    for (const Module& estimator : shippedEstimators()) {
        PictureRequest request;
        request.camera = "eye=0,1.2,2.4;at=0,0.4,0;fov=45";
        request.overrides = {"radius=1"};
        const Image plain = visibility(estimator.name, request, scene, kBox);
        const Image swapped = mirrored(visibility(estimator.name, request, mirrored(scene), kBox));
        INFO(estimator.name);
        CHECK(meanChange(plain, swapped) < 0.01);
        CHECK(meanChange(plain, mirrored(plain)) > 0.01);
    }
}

TEST_CASE("Estimators see an orthographic view as the narrow perspective that tends to it")
{
    for (const Module& estimator : shippedEstimators()) {
        PictureRequest request;
        request.scene = "corner";
        request.camera = "eye=0,200,200;at=0,0,0;fov=0.81";
        const Image narrow = visibility(estimator.name, request);
        request.camera = "eye=0,200,200;at=0,0,0;ortho=4";
        const Image orthographic = visibility(estimator.name, request);
        INFO(estimator.name);
        CHECK(mean(orthographic) < 0.99);
        CHECK(meanChange(narrow, orthographic) < 0.01);
    }
}

TEST_CASE("Estimators draw visibility at odd and tiny sizes")
{
    for (const Module& estimator : shippedEstimators()) {
        for (const Extent extent : {Extent{1, 1}, Extent{3, 2}, Extent{127, 5}}) {
            PictureRequest request;
            request.extent = extent;
            INFO(estimator.name << " " << extent.width << "x" << extent.height);
            CHECK(allVisibility(visibility(estimator.name, request)));
        }
    }
}

TEST_CASE("Tiles of every fourth pixel give the occlusion of hbao, whatever the size")
{
    for (const Extent extent : {Extent{128, 72}, Extent{126, 71}, Extent{125, 73}}) {
        PictureRequest request;
        request.scene = "corner";
        request.camera = kTowardsCorner;
        request.extent = extent;
        request.overrides = {"radius=1"};
        const Image whole = visibility("ssao/hbao", request, kBox);
        const Image tiled = visibility("ssao/hbao_plus", request, kBox);
        INFO(extent.width << "x" << extent.height);
        CHECK(meanChange(whole, tiled) < 0.01);
        CHECK(mean(whole) < 0.97);
    }
}

TEST_CASE("Tiles have each pixel's own surface, also where the view is no multiple of four wide")
{
    // What the last pixels see lies behind an edge right before them.
    constexpr int kEdge = 124;
    const auto distance = [](int x) { return x < kEdge ? 4.85f : 5.0f; };
    for (const int width : {128, 127, 126}) {
        INFO(width);
        for (const char* module : {"ssao/hbao", "ssao/hbao_plus"}) {
            const Image ao = visibilityOf(module, {width, 24}, distance, {"radius=0.3"});
            CHECK(meanOfColumns(ao, kEdge, width) < 0.99);
            CHECK(meanOfColumns(ao, 0, kEdge - 12) == 1.0);
        }
    }
}

TEST_CASE("What stands far in front tells hbao no more than background where thin occluders skip")
{
    constexpr int kBar = 57, kStep = 60;
    const auto drawn = [](float bar, const char* thin) {
        const auto distance = [bar](int x) {
            return x == kBar || x == kBar + 1 ? bar : x < kStep ? 5.0f : 4.8f;
        };
        return visibilityOf("ssao/hbao", {128, 24}, distance, {"radius=0.3", thin});
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
    const Scene corner = need(loadScene("corner"));
    Scene turned = corner;
    for (MeshDesc& mesh : turned.meshes)
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i], mesh.indices[i + 1]);
    PictureRequest request;
    request.camera = kTowardsCorner;
    const Image plain = visibility("ssao/bitmask", request, corner, "geometry/second_layer");
    CHECK(mean(plain) < 0.97);
    const Image other = visibility("ssao/bitmask", request, turned, "geometry/second_layer");
    CHECK(plain.pixels == other.pixels);
    // A corner of sheets is as dark as one of thick walls.
    CHECK(meanChange(plain, visibility("ssao/bitmask", request, corner)) < 0.01);
}

TEST_CASE("Light passes behind a sheet, and not behind a body with the same front")
{
    // The floor under something that floats half a radius over it, seen from above.
    const auto floorUnder = [](const MeshDesc& mesh) {
        Scene scene = need(loadScene("plane"));
        scene.meshes.push_back(mesh);
        scene.instances.push_back(scene.instances[0]);
        scene.instances.back().mesh = static_cast<int>(scene.meshes.size()) - 1;
        PictureRequest request;
        request.camera = "eye=0,6,4;at=0,0.4,0;fov=30";
        request.overrides = {"radius=1", "slices=4", "steps=8", "max_gap=1"};
        return mean(visibility("ssao/bitmask", request, scene, "geometry/back_faces"));
    };
    const double none = floorUnder(makeBox({0, -3, 0}, {0.1f, -2, 0.1f}));
    const double sheet = floorUnder(makeQuad({-0.5f, 0.9f, 0.5f}, {1, 0, 0}, {0, 0, -1}));
    const double body = floorUnder(makeBox({-0.5f, 0.02f, -0.5f}, {0.5f, 0.9f, 0.5f}));
    CHECK(none > 0.99);
    CHECK(none - sheet < 0.5 * (none - body));
    CHECK(none - sheet > 0);
}

TEST_CASE("Light passes behind a sheet that another hides")
{
    const auto floorUnder = [](const MeshDesc& hidden) {
        Scene scene = need(loadScene("plane"));
        for (const MeshDesc& mesh :
             {makeQuad({-0.5f, 1.2f, 0.5f}, {1, 0, 0}, {0, 0, -1}), hidden}) {
            scene.meshes.push_back(mesh);
            scene.instances.push_back(scene.instances[0]);
            scene.instances.back().mesh = static_cast<int>(scene.meshes.size()) - 1;
        }
        PictureRequest request;
        request.camera = "eye=0,6,4;at=0,0.4,0;fov=30";
        request.overrides = {"radius=1", "slices=4", "steps=8", "thickness=8"};
        return mean(visibility("ssao/bitmask", request, scene, "geometry/second_layer"));
    };
    const double none = floorUnder(makeBox({0, -3, 0}, {0.1f, -2, 0.1f}));
    const double sheet = floorUnder(makeQuad({-0.5f, 0.8f, 0.5f}, {1, 0, 0}, {0, 0, -1}));
    const double body = floorUnder(makeBox({-0.5f, 0.02f, -0.5f}, {0.5f, 0.8f, 0.5f}));
    INFO(none << ' ' << sheet << ' ' << body);
    CHECK(none - sheet < 0.8 * (none - body));
    CHECK(none - sheet > 0);
}

TEST_CASE("hbao counts what stands far in front as solid where thin occluders count")
{
    PictureRequest request;
    request.overrides = {"radius=0.3"};
    const double skipped = mean(visibility("ssao/hbao", request));
    request.overrides.push_back("thin_occluders=count");
    CHECK(mean(visibility("ssao/hbao", request)) < skipped - 0.002);
}

TEST_CASE("Intensity multiplies the occlusion, and power is then taken of the visibility")
{
    const auto drawn = [](const Module& estimator, const char* intensity, const char* power) {
        PictureRequest request;
        request.scene = "corner";
        request.camera = kTowardsCorner;
        request.overrides = {intensity, power, "radius=1", "/targets/ao/format=[\"r32f\"]"};
        return visibility(estimator.name, request);
    };
    for (const Module& estimator : shippedEstimators()) {
        const Image plain = drawn(estimator, "intensity=1", "power=1");
        for (const float intensity : {0.6f, 3.0f}) {
            const char* wanted = intensity < 1 ? "intensity=0.6" : "intensity=3";
            const Image changed = drawn(estimator, wanted, "power=2");
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

TEST_CASE("A scene four times as large with four times the radius gives the same picture")
{
    const Scene scene = need(loadScene("spheres"));
    Scene large = scene;
    for (SceneInstance& instance : large.instances)
        instance.world_from_model = glm::dmat4(glm::dmat3(4.0)) * instance.world_from_model;
    for (const Module& estimator : shippedEstimators()) {
        PictureRequest request;
        request.camera = "eye=1,1.5,3;at=0,0.5,0;fov=45";
        request.overrides = {"radius=1"};
        const Image small_picture = visibility(estimator.name, request, scene);
        request.camera = "eye=4,6,12;at=0,2,0;fov=45";
        request.overrides = {"radius=4"};
        INFO(estimator.name);
        CHECK(mean(small_picture) < 0.98);
        CHECK(meanChange(small_picture, visibility(estimator.name, request, large)) < 0.001);
    }
}

TEST_CASE("The power of the occlusion lightens and contrast keeps what is open")
{
    const auto drawn = [](std::vector<std::string> overrides) {
        PictureRequest request;
        request.scene = "corner";
        request.overrides = std::move(overrides);
        return mean(visibility("ssao/hemisphere", request));
    };
    const double plain = drawn({});
    CHECK(drawn({"power_of=occlusion"}) == Approx(plain).margin(1e-4));
    CHECK(drawn({"power_of=occlusion", "power=2"}) > plain + 0.002);
    CHECK(drawn({"power=2"}) < plain - 0.002);
    CHECK(drawn({"contrast=2"}) > plain);  // all of the corner is lighter than a half
}

TEST_CASE("The bounce only adds light, and none without lights reflected")
{
    PictureRequest request;
    request.config = "ssdo";
    request.output = "color";
    request.scene = "corner";
    request.camera = kTowardsCorner;
    request.overrides = {"bounce=0"};
    const Image without = picture(request);
    request.overrides = {"indirect=false"};
    CHECK(meanChange(without, picture(request)) == 0.0);
    request.overrides = {};
    const Image with = picture(request);
    CHECK(mean(with) > mean(without) + 0.001);
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        REQUIRE(with.pixels[i] >= without.pixels[i]);
}
