// SPDX-License-Identifier: MIT
// glTF 2.0 scenes: hierarchy, cameras, lights, materials and textures.
#include "tools/render/scene/scene.h"

#include "tests/support/need.h"
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

// The square in its first material, whose first texture is a picture.
std::string textured(const std::string& materials,
                     const std::string& uri = "data:image/png;base64," + kPicture)
{
    return gltf(R"({"mesh": 0})",
                R"("materials": [)" + materials + R"(], "textures": [{"source": 0}],
                   "images": [{"uri": ")" +
                    uri + R"("}], )",
                R"(, "material": 0)");
}

const char* const kColored = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";

// The square, and lights on a line at the given heights above its middle, turned to shine along +y.
std::string lit(const std::string& lights, const std::vector<std::string>& heights)
{
    std::string children, nodes;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const std::string index = std::to_string(k);
        children += (k == 0 ? "" : ", ") + std::to_string(k + 1);
        nodes += R"(, {"extensions": {"KHR_lights_punctual": {"light": )" + index +
                 R"(}}, "rotation": [0.70710678, 0, 0, 0.70710678], "translation": [0.5, 0.5, )" +
                 heights[k] + "]}";
    }
    return gltf(R"({"mesh": 0, "children": [)" + children + "]}" + nodes,
                R"("extensions": {"KHR_lights_punctual": {"lights": [)" + lights + "]}}, ");
}

Scene load(const std::string& text, const char* name = "scene.gltf")
{
    const TemporaryFolder folder("scene_gltf_test");
    const Result<Scene> scene = importScene(folder.write(name, text));
    CHECK(scene.diagnostics().empty());
    return need(scene);
}

const SceneMaterial& materialOf(const Scene& scene)
{
    return scene.materials[scene.instances[0].material];
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

TEST_CASE("a node stands where all of its parents put it, and a mesh used twice is kept once")
{
    const Scene nested = load(gltf(R"({"children": [1], "translation": [0, 10, 0]},
                                      {"children": [2], "scale": [2, 2, 2]},
                                      {"mesh": 0, "translation": [1, 0, 0]})"));
    REQUIRE(nested.instances.size() == 1);
    CHECK(nested.bounds().min == glm::dvec3(2, 10, 0));
    CHECK(nested.bounds().max == glm::dvec3(4, 12, 0));

    const Scene twice = load(gltf(R"({"children": [1, 2]}, {"mesh": 0},
                                     {"mesh": 0, "translation": [5, 0, 0]})"));
    CHECK(twice.meshes.size() == 1);
    CHECK(twice.instances.size() == 2);
    CHECK(twice.bounds().max.x == 6);
}

TEST_CASE("a glTF mesh without normals has flat faces, and texture coordinates from lower left")
{
    std::string folded = gltf(R"({"mesh": 0})");
    folded.replace(folded.find(kSquare) + 60, 4, "AAA/");  // the last corner rises by a half
    const Scene scene = load(folded);
    CHECK(scene.meshes[0].vertices.size() == 6);
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        const bool level = vertex.normal[2] == 1.0f;
        CHECK((level || vertex.normal[2] == Approx(std::sqrt(2.0 / 3.0))));
        CHECK(vertex.uv[0] == vertex.position[0]);
        CHECK(vertex.uv[1] == vertex.position[1]);
    }
}

TEST_CASE("a glTF camera keeps its angle or height and its planes, and its node's scale is none")
{
    // A file is known by its extension in capitals too: else angles are those of the width.
    for (const char* name : {"scene.gltf", "SCENE.GLTF"}) {
        const Scene scene = load(gltf(kCameraNodes, kCameras), name);
        REQUIRE(scene.cameras.size() == 3);
        const SceneCamera &wide = scene.cameras[0], &square = scene.cameras[1];
        CHECK(wide.name == "wide");
        CHECK(wide.fov_y_rad == Approx(0.8));
        CHECK(wide.near_distance == Approx(0.1));
        CHECK(wide.far_distance == Approx(50));
        const glm::vec4 origin = wide.view_from_world * glm::vec4(0, 0, 0, 1);
        CHECK(origin.y == Approx(-1));
        CHECK(origin.z == Approx(-5));
        CHECK(glm::determinant(wide.view_from_world) == Approx(1));
        CHECK(square.fov_y_rad == Approx(0.8));
        CHECK(square.far_distance == 0);
        CHECK(scene.cameras[2].orthographic);
        CHECK(scene.cameras[2].half_height == Approx(2));
        CHECK(scene.cameras[2].near_distance == Approx(0.5));
        CHECK(scene.cameras[2].far_distance == Approx(9));
    }
}

TEST_CASE("lights that are off stay off, and keep the default one away")
{
    for (const char* light :
         {R"({"type": "point", "intensity": 0})", R"({"type": "directional", "color": [0, 0, 0]})",
          R"({"type": "spot", "intensity": 0, "spot": {}})"}) {
        INFO(light);
        const TemporaryFolder folder("scene_gltf_test");
        const Scene scene = need(loadScene(folder.write("off.gltf", lit(light, {"2"}))));
        REQUIRE(scene.lights.size() == 1);
        CHECK(scene.lights[0].name != "default");
        CHECK(scene.lights[0].light.color == glm::vec3(0.0f));
    }
}

TEST_CASE("the brightest light brings 1 to the centre of the scene, in any unit")
{
    const Scene scene = load(lit(R"({"type": "point", "color": [1, 0.5, 0.25], "intensity": 54000},
                                    {"type": "point", "intensity": 540},
                                    {"type": "directional", "intensity": 3})",
                                 {"10", "1", "0"}));
    REQUIRE(scene.lights.size() == 3);
    const auto atCenter = [](const Light& light, float distance) {
        const glm::vec3 a = light.attenuation;
        return light.color.r / (a.x + a.y * distance + a.z * distance * distance);
    };
    CHECK(atCenter(scene.lights[0].light, 10) == Approx(1));
    CHECK(atCenter(scene.lights[1].light, 1) == Approx(1));
    CHECK(scene.lights[0].light.color.g == Approx(0.5));
    CHECK(scene.lights[2].light.directional);
    CHECK(scene.lights[2].light.direction.y == Approx(1));
    CHECK(scene.lights[2].light.color.r == Approx(3.0 / 540));
}

TEST_CASE("a glTF spot keeps its cone")
{
    const char* const lights =
        R"({"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.6}},
           {"type": "point"})";
    const Scene scene = load(lit(lights, {"2", "2"}));
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].light.spot);
    CHECK(scene.lights[0].light.inner_angle_rad == Approx(0.2));
    CHECK(scene.lights[0].light.outer_angle_rad == Approx(0.6));
    CHECK_FALSE(scene.lights[1].light.spot);
}

TEST_CASE("a masked glTF material keeps its colour, texture and cutoff")
{
    const Scene scene = load(textured(R"({"name": "leaf", "alphaMode": "MASK",
        "alphaCutoff": 0.4, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 0.9],
        "baseColorTexture": {"index": 0}}})"));
    const SceneMaterial& material = materialOf(scene);
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
    for (const auto& [strength, kept] : {std::pair("0.75", 0.75), {"1.75", 1.0}}) {
        const Scene scene = load(textured(R"({"normalTexture": {"index": 0, "scale": 0.5},
            "occlusionTexture": {"index": 0, "strength": )" +
                                          std::string(strength) + "}}, {}"));
        const SceneMaterial& material = materialOf(scene);
        CHECK(material.base_color_texture == -1);
        REQUIRE(material.normal_texture == 0);
        CHECK(material.normal_scale == Approx(0.5));
        CHECK(material.occlusion_texture == 0);
        CHECK(material.occlusion_strength == Approx(kept));
        CHECK(scene.textures[0].image.at(1, 0, 0) == Approx(188.0 / 255));
        CHECK(scene.textures.size() == 1);
    }
}

TEST_CASE("a texture is found beside the scene by an escaped name, a missing one is a warning")
{
    const TemporaryFolder folder("scene_gltf_textures");
    folder.write("my skin.pgm", std::string("P5 1 1 255\n\xff"));
    const Scene found =
        need(importScene(folder.write("a.gltf", textured(kColored, "my%20skin.pg%6D"))));
    REQUIRE(found.textures.size() == 1);
    CHECK(found.textures[0].image.at(0, 0, 1) == 1.0f);

    const auto missing = importScene(folder.write("b.gltf", textured(kColored, "gone.png")));
    REQUIRE(missing.ok());
    CHECK(materialOf(*missing).base_color_texture == -1);  // the plain colour
    REQUIRE(missing.diagnostics().size() == 1);
    CHECK(missing.diagnostics()[0].code == Code::image_broken);
    CHECK(missing.diagnostics()[0].severity == Severity::warning);
}

TEST_CASE("a glTF file whose buffer is missing or too short is reported by its reader")
{
    const TemporaryFolder folder("scene_gltf_buffer");
    std::string too_long = gltf(R"({"mesh": 0})"), missing = too_long;
    too_long.replace(too_long.find("\"count\": 6"), 10, "\"count\": 600");
    const auto uri = missing.find("data:");
    missing.replace(uri, missing.find('"', uri) - uri, "nowhere.bin");
    for (const auto& [text, said] : {std::pair(too_long, ""), {missing, "nowhere.bin"}}) {
        const auto scene = importScene(folder.write("a.gltf", text));
        REQUIRE_FALSE(scene.ok());
        CHECK(scene.diagnostics()[0].code == Code::scene_broken);
        CHECK(scene.diagnostics()[0].message.find(said) != std::string::npos);
    }
}
