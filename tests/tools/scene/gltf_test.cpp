// SPDX-License-Identifier: MIT
// glTF 2.0 scenes: hierarchy, cameras, lights, materials and textures.
#include "tools/scene/scene.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

// A unit square at z = 0: four positions, four texture coordinates (v from the top down, as glTF
// has it), six indices.
const std::string kSquare =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/AACAPwAA"
    "gD8AAAAAAAAAAAAAAAAAAAEAAgAAAAIAAwA=";

// 2x2 pixels: above red and clear green, below blue and (188, 188, 188).
const std::string kPicture =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAF0lEQVR42mP4z8DwHwhB4P//PXv2/AcAPXcIL7cw"
    "ipkAAAAASUVORK5CYII=";

// A file with that square as mesh 0 and the rest as given: lists of nodes, and further members.
std::string gltf(const std::string& nodes, const std::string& more = "",
                 const std::string& primitive = "")
{
    return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"],
      "buffers": [{"byteLength": 92, "uri": "data:application/octet-stream;base64,)" +
           kSquare + R"("}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                      {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                      {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
      "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
         "min": [0, 0, 0], "max": [1, 1, 0]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
      "meshes": [{"name": "square", "primitives": [
        {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2)" +
           primitive + R"(}]}],
      )" + more +
           R"("nodes": [)" + nodes + R"(], "scenes": [{"nodes": [0]}], "scene": 0})";
}

Scene load(const std::string& text)
{
    const TemporaryFolder folder("scene_gltf_test");
    const Result<Scene> scene = importScene(folder.write("scene.gltf", text));
    INFO(toText(scene.diagnostics()));
    REQUIRE(scene.ok());
    return *scene;
}

const char* const kCameras = R"("cameras": [
  {"type": "perspective",
   "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1, "zfar": 50}},
  {"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}},
  {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0.5, "zfar": 9}}], )";

const char* const kCameraNodes = R"({"children": [1, 2, 3], "mesh": 0},
  {"camera": 0, "name": "wide", "translation": [0, 1, 5], "scale": [3, 3, 3]},
  {"camera": 1, "name": "square"}, {"camera": 2, "name": "flat"})";

}  // namespace

TEST_CASE("a node stands where all of its parents put it")
{
    const Scene scene = load(gltf(R"({"children": [1], "translation": [0, 10, 0]},
                                     {"children": [2], "scale": [2, 2, 2]},
                                     {"mesh": 0, "translation": [1, 0, 0]})"));
    REQUIRE(scene.instances.size() == 1);
    const Bounds bounds = scene.bounds();
    CHECK(bounds.min == glm::dvec3(2, 10, 0));
    CHECK(bounds.max == glm::dvec3(4, 12, 0));
}

TEST_CASE("a glTF mesh without normals has flat faces, as its specification asks")
{
    std::string folded = gltf(R"({"mesh": 0})");
    folded.replace(folded.find(kSquare) + 60, 4, "AAA/");  // the last corner rises by a half
    const Scene scene = load(folded);
    CHECK(scene.meshes[0].vertices.size() == 6);
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        const bool level = vertex.normal[2] == 1.0f;
        CHECK((level || vertex.normal[2] == Approx(std::sqrt(2.0 / 3.0))));
    }
}

TEST_CASE("a mesh used twice is kept once")
{
    const Scene scene = load(gltf(R"({"children": [1, 2]}, {"mesh": 0},
                                     {"mesh": 0, "translation": [5, 0, 0]})"));
    CHECK(scene.meshes.size() == 1);
    CHECK(scene.instances.size() == 2);
    CHECK(scene.bounds().max.x == 6);
}

TEST_CASE("a glTF camera keeps its vertical angle whatever its aspect ratio")
{
    const Scene scene = load(gltf(kCameraNodes, kCameras));
    REQUIRE(scene.cameras.size() == 3);
    CHECK(scene.cameras[0].name == "wide");
    CHECK(scene.cameras[0].fov_y_rad == Approx(0.8));
    CHECK(scene.cameras[1].fov_y_rad == Approx(0.8));
    CHECK(scene.cameras[0].near_distance == Approx(0.1));
    CHECK(scene.cameras[0].far_distance == Approx(50));
}

TEST_CASE("a glTF file is known by its extension in capitals too")
{
    const TemporaryFolder folder("scene_gltf_capitals");
    const auto scene = importScene(folder.write("SCENE.GLTF", gltf(kCameraNodes, kCameras)));
    REQUIRE(scene.ok());
    CHECK(scene->cameras[0].fov_y_rad == Approx(0.8));
    CHECK(glm::inverse(scene->cameras[0].view_from_world)[3].z == Approx(5));
}

TEST_CASE("a camera whose far plane the file leaves out sees the whole scene")
{
    Scene scene = load(gltf(kCameraNodes, kCameras));
    CHECK(scene.cameras[1].far_distance == 0);
    Bounds far_away;
    far_away.add({-1, -1, -5000});
    far_away.add({1, 1, -4000});
    const glm::mat4 clip = clipFromView(scene.cameras[1], {100, 100}, far_away);
    const glm::vec4 point = clip * glm::vec4(0, 0, -5000, 1);
    CHECK(point.z / point.w < 1.0f);
}

TEST_CASE("an orthographic glTF camera keeps its height")
{
    const SceneCamera camera = load(gltf(kCameraNodes, kCameras)).cameras[2];
    CHECK(camera.orthographic);
    CHECK(camera.half_height == Approx(2));
    CHECK(camera.near_distance == Approx(0.5));
    CHECK(camera.far_distance == Approx(9));
}

TEST_CASE("a scaled camera node moves the camera and does not stretch the view")
{
    const SceneCamera camera = load(gltf(kCameraNodes, kCameras)).cameras[0];
    const glm::vec4 origin = camera.view_from_world * glm::vec4(0, 0, 0, 1);
    CHECK(origin.y == Approx(-1));
    CHECK(origin.z == Approx(-5));
    CHECK(glm::determinant(camera.view_from_world) == Approx(1));
}

TEST_CASE("the brightest light brings 1 to the centre of the scene, in any unit")
{
    const char* const lights = R"("extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "point", "color": [1, 0.5, 0.25], "intensity": 54000},
      {"type": "point", "intensity": 540},
      {"type": "directional", "intensity": 3}]}}, )";
    const Scene scene = load(gltf(
        R"({"children": [1, 2, 3], "mesh": 0},
           {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0.5, 0.5, 10]},
           {"extensions": {"KHR_lights_punctual": {"light": 1}}, "translation": [0.5, 0.5, 1]},
           {"extensions": {"KHR_lights_punctual": {"light": 2}}})",
        lights));
    REQUIRE(scene.lights.size() == 3);
    const auto atCenter = [](const Light& light, float distance) {
        const glm::vec3 a = light.attenuation;
        return light.color.r / (a.x + a.y * distance + a.z * distance * distance);
    };
    CHECK(atCenter(scene.lights[0].light, 10) == Approx(1));
    CHECK(atCenter(scene.lights[1].light, 1) == Approx(1));
    CHECK(scene.lights[0].light.color.g == Approx(0.5));
    CHECK(scene.lights[2].light.directional);
    CHECK(scene.lights[2].light.direction.z == Approx(-1));
    CHECK(scene.lights[2].light.color.r == Approx(3.0 / 540));
}

TEST_CASE("a masked glTF material keeps its colour, texture and cutoff")
{
    const std::string more = R"("materials": [{"name": "leaf", "alphaMode": "MASK",
        "alphaCutoff": 0.4, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 0.9],
        "baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
        "images": [{"uri": "data:image/png;base64,)" +
                             kPicture + R"("}], )";
    const Scene scene = load(gltf(R"({"mesh": 0})", more, R"(, "material": 0)"));
    const SceneMaterial& material = scene.materials[scene.instances[0].material];
    CHECK(material.base_color == glm::vec4(0.5f, 0.25f, 0.125f, 0.9f));
    CHECK(material.alpha_cutoff == Approx(0.4));
    CHECK(material.specular == glm::vec3(0.0f));
    REQUIRE(material.base_color_texture == 0);

    // Linear, with the bottom row first.
    const Image& image = scene.textures[0].image;
    REQUIRE(image.extent == Extent{2, 2});
    REQUIRE(image.channels == 4);
    CHECK(image.at(0, 1, 0) == 1.0f);
    CHECK(image.at(0, 0, 2) == 1.0f);
    CHECK(image.at(1, 1, 3) == 0.0f);
    CHECK(image.at(1, 0, 0) == Approx(0.5).margin(0.003));
}

TEST_CASE("a glTF material keeps its normal and occlusion maps as plain numbers")
{
    const std::string more = R"("materials": [{"normalTexture": {"index": 0, "scale": 0.5},
        "occlusionTexture": {"index": 0, "strength": 0.75}}, {}], "textures": [{"source": 0}],
        "images": [{"uri": "data:image/png;base64,)" +
                             kPicture + R"("}], )";
    const Scene scene = load(gltf(R"({"mesh": 0})", more, R"(, "material": 0)"));
    const SceneMaterial& material = scene.materials[scene.instances[0].material];
    CHECK(material.base_color_texture == -1);
    REQUIRE(material.normal_texture == 0);
    CHECK(material.normal_scale == Approx(0.5));
    CHECK(material.occlusion_texture == 0);
    CHECK(material.occlusion_strength == Approx(0.75));
    CHECK(scene.textures[0].image.at(1, 0, 0) == Approx(188.0 / 255));
    CHECK(scene.textures.size() == 1);

    std::string stronger = more;
    stronger.replace(stronger.find("0.75"), 4, "1.75");
    const Scene most = load(gltf(R"({"mesh": 0})", stronger, R"(, "material": 0)"));
    CHECK(most.materials[most.instances[0].material].occlusion_strength == 1);
}

TEST_CASE("a glTF spot keeps its cone")
{
    const char* const lights = R"("extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.6}},
      {"type": "point"}]}}, )";
    const Scene scene = load(gltf(
        R"({"children": [1, 2], "mesh": 0},
           {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0.5, 0.5, 2]},
           {"extensions": {"KHR_lights_punctual": {"light": 1}}, "translation": [0.5, 0.5, 2]})",
        lights));
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].light.spot);
    CHECK(scene.lights[0].light.inner_angle_rad == Approx(0.2));
    CHECK(scene.lights[0].light.outer_angle_rad == Approx(0.6));
    CHECK_FALSE(scene.lights[1].light.spot);
}

TEST_CASE("texture coordinates begin at the lower left")
{
    const Scene scene = load(gltf(R"({"mesh": 0})"));
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        CHECK(vertex.uv[0] == vertex.position[0]);
        CHECK(vertex.uv[1] == vertex.position[1]);
    }
}

TEST_CASE("a missing texture is a warning and leaves the plain colour")
{
    const std::string more = R"("materials": [{"pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
        "images": [{"uri": "gone.png"}], )";
    const TemporaryFolder folder("scene_gltf_missing");
    const auto scene =
        importScene(folder.write("scene.gltf", gltf(R"({"mesh": 0})", more, R"(, "material": 0)")));
    REQUIRE(scene.ok());
    CHECK(scene->materials[scene->instances[0].material].base_color_texture == -1);
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK(scene.diagnostics()[0].code == Code::image_broken);
    CHECK(scene.diagnostics()[0].severity == Severity::warning);
}

TEST_CASE("a texture is found beside the scene, also by an escaped name")
{
    const std::string more = R"("materials": [{"pbrMetallicRoughness": {
        "baseColorTexture": {"index": 0}}}], "textures": [{"source": 0}],
        "images": [{"uri": "my%20skin.pg%6D"}], )";
    const TemporaryFolder folder("scene_gltf_escaped");
    folder.write("my skin.pgm", std::string("P5 1 1 255\n\xff"));
    const auto scene =
        importScene(folder.write("scene.gltf", gltf(R"({"mesh": 0})", more, R"(, "material": 0)")));
    REQUIRE(scene.ok());
    REQUIRE(scene->textures.size() == 1);
    CHECK(scene->textures[0].image.at(0, 0, 1) == 1.0f);
}

TEST_CASE("a glTF file whose buffer is missing or too short is reported by its reader")
{
    const TemporaryFolder folder("scene_gltf_buffer");
    std::string text = gltf(R"({"mesh": 0})");
    const auto count = text.find("\"count\": 6");
    const auto too_long = folder.write("long.gltf", text.replace(count, 10, "\"count\": 600"));
    text = gltf(R"({"mesh": 0})");
    const auto uri = text.find("data:");
    const auto missing =
        folder.write("missing.gltf", text.replace(uri, text.find('"', uri) - uri, "nowhere.bin"));
    for (const std::string& path : {too_long, missing}) {
        const auto scene = importScene(path);
        REQUIRE_FALSE(scene.ok());
        CHECK(scene.diagnostics()[0].code == Code::scene_broken);
    }
    CHECK(importScene(missing).diagnostics()[0].message.find("nowhere.bin") != std::string::npos);
}
