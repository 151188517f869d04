// SPDX-License-Identifier: MIT
// glTF 2.0 scenes: hierarchy, cameras, lights, materials and textures.
#include "core/base/text.h"
#include "tests/support/gltf_file.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;
using nlohmann::json;

namespace {

// 2x2 pixels: above red and clear green, below blue and (188, 188, 188).
const std::string kPicture =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAF0lEQVR42mP4z8DwHwhB4P//PXv2/AcAPXcIL7cw"
    "ipkAAAAASUVORK5CYII=";

// The square, and the members of that text in place of its own.
GltfTestFile with(const std::string& members)
{
    GltfTestFile file;
    file.json.merge_patch(json::parse(members));
    return file;
}

// The square in its first material, whose first texture is a picture.
GltfTestFile textured(const std::string& material, const std::string& uri = kPicture)
{
    GltfTestFile file = with(R"({"textures": [{"source": 0}], "images": [{"uri": ")" + uri +
                             R"("}], "materials": [)" + material + "]}");
    file.primitive()["material"] = 0;
    return file;
}

const char* const kColored = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";

// The square, and lights on a line at the given heights above its middle, turned to shine along +y.
GltfTestFile lit(const std::string& lights, const std::vector<double>& heights)
{
    GltfTestFile file =
        with(R"({"extensions": {"KHR_lights_punctual": {"lights": [)" + lights + "]}}}");
    for (std::size_t k = 0; k < heights.size(); ++k) {
        file.json["nodes"].push_back({{"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                                      {"translation", {0.5, 0.5, heights[k]}}});
        file.json["nodes"].back()["extensions"]["KHR_lights_punctual"]["light"] = k;
        file.json["scenes"][0]["nodes"].push_back(k + 1);
    }
    return file;
}

}  // namespace

TEST_CASE("a node stands where all of its parents put it, and a mesh used twice is kept once")
{
    const Scene nested = load(with(R"({"nodes": [{"children": [1], "translation": [0, 10, 0]},
        {"children": [2], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [1, 0, 0]}]})"));
    REQUIRE(nested.instances.size() == 1);
    CHECK(nested.bounds().min == glm::dvec3(2, 10, 0));
    CHECK(nested.bounds().max == glm::dvec3(4, 12, 0));

    const Scene twice = load(with(R"({"nodes": [{"children": [1, 2]}, {"mesh": 0},
        {"mesh": 0, "translation": [5, 0, 0]}]})"));
    CHECK(twice.meshes.size() == 1);
    CHECK(twice.instances.size() == 2);
    CHECK(twice.bounds().max.x == 6);
}

TEST_CASE("a glTF mesh without normals has flat faces, and texture coordinates from lower left")
{
    GltfTestFile folded;  // its last corner is raised
    folded.primitive()["attributes"] = {
        {"POSITION", folded.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}, "VEC3")},
        {"TEXCOORD_0", folded.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2")}};
    const Scene scene = load(folded);
    CHECK(scene.meshes[0].vertices.size() == 4);  // both triangles share an edge
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        for (const float axis : vertex.normal) CHECK(axis == 0);  // the face's, in shaders
        CHECK(vertex.uv[0] == vertex.position[0]);
        CHECK(vertex.uv[1] == vertex.position[1]);
    }
}

TEST_CASE("a glTF camera keeps its angle or height and its planes, and its node's scale is none")
{
    const GltfTestFile file = with(R"({"cameras": [
        {"type": "perspective",
         "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1, "zfar": 50}},
        {"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0.5, "zfar": 9}}],
        "nodes": [{"children": [1, 2, 3], "mesh": 0},
        {"camera": 0, "name": "wide", "translation": [0, 1, 5], "scale": [3, 3, 3]},
        {"camera": 1, "name": "square"}, {"camera": 2, "name": "flat"}]})");
    // A file is known by its extension in capitals too: else angles are those of the width.
    for (const char* name : {"scene.gltf", "SCENE.GLTF"}) {
        const TemporaryFolder folder("gltf_cameras");
        const Scene scene = need(importScene(file.write(folder, name)));
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
        const TemporaryFolder folder("gltf_lights");
        const Scene scene = need(loadScene(lit(light, {2}).write(folder)));
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
                                 {10, 1, 0}));
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
    const Scene scene = load(lit(
        R"({"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.6}},
           {"type": "point"})",
        {2, 2}));
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
    const TemporaryFolder folder("gltf_textures");
    folder.write("my skin.pgm", std::string("P5 1 1 255\n\xff"));
    const Scene found = need(importScene(textured(kColored, "my%20skin.pg%6D").write(folder)));
    REQUIRE(found.textures.size() == 1);
    CHECK(found.textures[0].image.at(0, 0, 1) == 1.0f);

    const Result<Scene> missing = imported(textured(kColored, "gone.png"));
    onlyWarning(missing, Code::image_broken);
    CHECK(materialOf(need(missing)).base_color_texture == -1);  // the plain colour
}

TEST_CASE("a glTF file whose buffer is missing is reported by its reader")
{
    GltfTestFile file;
    file.uri = "nowhere.bin";
    CHECK(has(onlyError(imported(file), Code::scene_broken).message, "nowhere.bin"));
}
