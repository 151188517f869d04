// SPDX-License-Identifier: MIT
// What glTF files of strangers have: packed and moved geometry, colours, holes, and what is not
// read.
#include "core/base/text.h"
#include "tests/support/gltf_file.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <cmath>

using namespace crevice;
using nlohmann::json;

namespace {

using Strings = std::vector<std::string>;

std::string warningOf(const GltfTestFile& file)
{
    return onlyWarning(imported(file), Code::scene_features).message;
}

void checkBox(const Scene& scene, const glm::dvec3& min, const glm::dvec3& max)
{
    const Bounds box = scene.bounds();
    CHECK(glm::distance(box.min, min) < 1e-4);
    CHECK(glm::distance(box.max, max) < 1e-4);
}

// One picture element, which is an own file's.
void addTexture(GltfTestFile& file, const std::string& pgm)
{
    const int view = file.view(pgm.data(), pgm.size());
    file.json["images"] = {{{"bufferView", view}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = json::array({json::object()});
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    file.primitive()["material"] = 0;
}

const std::string kTwoColumns("P5 2 1 255\n\x00\xff", 13);  // black and white

}  // namespace

TEST_CASE("a binary file is read as its parts are")
{
    const TemporaryFolder folder("gltf_binary");
    GltfTestFile file;
    const std::string path = file.writeBinary(folder);
    checkBox(need(importScene(path)), {0, 0, 0}, {1, 1, 0});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 8);
    CHECK_FALSE(importScene(path).ok());
}

TEST_CASE("a byte order mark, a URI with %20 and bytes to spare are read")
{
    const TemporaryFolder folder("gltf_mark");
    GltfTestFile file;
    file.bytes += "spare";
    checkBox(need(importScene(file.write(folder, "scene.gltf", "\xef\xbb\xbf"))), {0, 0, 0},
             {1, 1, 0});
}

TEST_CASE("positions in bytes, sparse ones, strips and fans are where the file says")
{
    GltfTestFile bytes;
    bytes.primitive()["attributes"]["POSITION"] = bytes.numbers<std::uint8_t>(
        {0, 0, 0, 0, 255, 0, 0, 0, 255, 255, 0, 0, 0, 255, 0, 0}, "VEC4", 5121, true);
    bytes.json["accessors"].back()["type"] = "VEC3";
    bytes.json["bufferViews"].back()["byteStride"] = 4;
    checkBox(load(bytes), {0, 0, 0}, {1, 1, 0});

    GltfTestFile sparse;
    const std::uint8_t changed = 2;
    const float place[] = {1, 5, 0};
    sparse.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", sparse.view(&changed, 1)}, {"componentType", 5121}}},
        {"values", {{"bufferView", sparse.view(place, sizeof place)}}}};
    checkBox(load(sparse), {0, 0, 0}, {1, 5, 0});

    for (const auto& [mode, order] : {std::pair(5, std::vector<std::uint16_t>{0, 1, 3, 2}),
                                      std::pair(6, std::vector<std::uint16_t>{0, 1, 2, 3})}) {
        GltfTestFile file;
        file.primitive()["mode"] = mode;
        file.primitive()["indices"] = file.numbers(order, "SCALAR", 5123);
        const MeshDesc mesh = load(file).meshes[0];
        REQUIRE(mesh.indices.size() == 6);
        for (int first : {0, 3}) {  // each triangle is wound towards +z
            const auto at = [&](int corner) {
                return mesh.vertices[mesh.indices[first + corner]].position;
            };
            CHECK((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) >
                  (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]));
        }
    }
}

TEST_CASE("geometry that meshopt or Draco packed is unfolded")
{
    GltfTestFile file;
    const std::vector<float> places = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    std::string packed(meshopt_encodeVertexBufferBound(4, 12), '\0');
    packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()),
                                             packed.size(), places.data(), 4, 12));
    const int view = file.view(packed.data(), packed.size());
    const std::size_t at = file.json["bufferViews"][std::size_t(view)]["byteOffset"];
    file.json["bufferViews"][0] = {{"buffer", 1},
                                   {"byteLength", 48},
                                   {"extensions",
                                    {{"EXT_meshopt_compression",
                                      {{"buffer", 0},
                                       {"byteOffset", at},
                                       {"byteLength", packed.size()},
                                       {"byteStride", 12},
                                       {"count", 4},
                                       {"mode", "ATTRIBUTES"}}}}}};
    file.json["buffers"] = {json::object(), {{"byteLength", 48}}};  // a fallback that is not there
    file.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    checkBox(load(file), {0, 0, 0}, {2, 2, 0});
    file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 400;
    CHECK(has(imported(file).diagnostics().at(0).message, "damaged"));

    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const float corners[3][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
    builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), corners[0], corners[1], corners[2]);
    draco::EncoderBuffer coded;
    REQUIRE(draco::Encoder().EncodeMeshToBuffer(*builder.Finalize(), &coded).ok());
    GltfTestFile draco;
    draco.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", draco.view(coded.data(), coded.size())}, {"attributes", {{"POSITION", 0}}}};
    draco.json["accessors"][0].erase("bufferView");
    draco.json["accessors"][1].erase("bufferView");
    checkBox(load(draco), {0, 0, 0}, {3, 3, 0});
}

TEST_CASE("a mesh is drawn at each place of EXT_mesh_gpu_instancing")
{
    GltfTestFile file;
    const int moved = file.floats({0, 0, 0, 10, 0, 0}, "VEC3"),
              scaled = file.floats({1, 1, 1, 2, 2, 2}, "VEC3");
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", moved}, {"SCALE", scaled}};
    const Scene scene = load(file);
    CHECK(scene.meshes.size() == 1);
    checkBox(scene, {0, 0, 0}, {12, 2, 0});
}

TEST_CASE("morph targets, skins and nodes stand as at rest, or at a time")
{
    GltfTestFile morphed;
    const int away = morphed.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    morphed.primitive()["targets"] = {{{"POSITION", away}}};
    morphed.json["meshes"][0]["weights"] = {0.5};
    checkBox(load(morphed), {0, 0, 0.5}, {1, 1, 0.5});

    // The joint is moved by 4; the node of the mesh, by 100, does not count.
    GltfTestFile skinned;
    skinned.primitive()["attributes"]["JOINTS_0"] =
        skinned.numbers<std::uint8_t>(std::vector<std::uint8_t>(16, 0), "VEC4", 5121);
    skinned.primitive()["attributes"]["WEIGHTS_0"] =
        skinned.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    skinned.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                             {{"translation", {4, 0, 0}}}};
    skinned.json["scenes"][0]["nodes"] = {0, 1};
    skinned.json["skins"] = {{{"joints", {1}}}};
    checkBox(load(skinned), {4, 0, 0}, {5, 1, 0});

    ImportOptions options;
    options.pose_s = 1;
    CHECK(has(imported(skinned, options).diagnostics().at(0).message, "no animation"));
    const int times = skinned.floats({1, 3}, "SCALAR"),
              places = skinned.floats({0, 0, 0, 8, 0, 0}, "VEC3");
    skinned.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", places}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}};
    CHECK(has(warningOf(skinned), "--time"));
    for (const auto& [time_s, x] : {std::pair(0.0, 0.0), {1.5, 2.0}, {9.0, 8.0}}) {
        options.pose_s = time_s;
        checkBox(load(skinned, options), {x, 0, 0}, {x + 1, 1, 0});
    }

    skinned.json["animations"].push_back(skinned.json["animations"][0]);
    skinned.json["animations"][1]["name"] = "still";
    skinned.json["animations"][1]["channels"] = json::array();
    skinned.json["scenes"].push_back({{"nodes", {1}}, {"name", "bones"}});
    for (const char* animation : {"still", "1"}) {
        options.animation = animation;
        options.file_scene = "0";
        checkBox(load(skinned, options), {4, 0, 0}, {5, 1, 0});
    }
    options.animation = "run";
    CHECK(has(imported(skinned, options).diagnostics().at(0).help, "0, 'still'"));
    options.animation = "0";
    options.file_scene = "bones";
    CHECK(has(imported(skinned, options).diagnostics().at(0).message, "no triangle"));
}

TEST_CASE("textures that are moved, clamped or mirrored are laid out so that they may repeat")
{
    const auto columns = [](const char* wrap, int mode, const std::vector<float>& uv) {
        GltfTestFile file;
        addTexture(file, kTwoColumns);
        file.json["samplers"][0][wrap] = mode;
        file.primitive()["attributes"]["TEXCOORD_0"] = file.floats(uv, "VEC2");
        return load(file);
    };
    const Scene clamped = columns("wrapS", 33071, {-1, 0, 2, 0, 2, 1, -1, 1});
    const Image& wide = clamped.textures.back().image;
    REQUIRE(wide.extent == Extent{6, 1});
    for (int x = 0; x < 6; ++x) CHECK(wide.at(x, 0, 0) == (x < 3 ? 0.0f : 1.0f));
    CHECK(clamped.meshes[0].vertices[0].uv[0] == Approx(0));
    CHECK(clamped.meshes[0].vertices[1].uv[0] == Approx(1));
    const Scene large = [&] {
        GltfTestFile file;
        addTexture(file, "P5 12000 1 255\n" + std::string(12000, '\xff'));
        file.json["samplers"][0]["wrapS"] = 33648;
        file.primitive()["attributes"]["TEXCOORD_0"] =
            file.floats({0, 0, 4, 0, 4, 1, 0, 1}, "VEC2");
        return need(imported(file));
    }();
    CHECK(large.meshes[0].vertices[1].uv[0] == Approx(4));  // as a texture that repeats
    const Scene mirrored = columns("wrapS", 33648, {0, 0, 4, 0, 4, 1, 0, 1});
    REQUIRE(mirrored.textures.back().image.extent == Extent{4, 1});
    CHECK(mirrored.textures.back().image.at(2, 0, 0) == 1.0f);
    CHECK(mirrored.meshes[0].vertices[1].uv[0] == Approx(2));
    CHECK(columns("magFilter", 9728, {0, 0, 1, 0, 1, 1, 0, 1}).textures.back().image.extent.width ==
          16);

    GltfTestFile moved;
    addTexture(moved, kTwoColumns);
    moved.primitive()["attributes"]["TEXCOORD_1"] = moved.floats({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2");
    moved.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
              ["KHR_texture_transform"] = {
        {"offset", {0.25, 0}}, {"scale", {2, 1}}, {"rotation", std::acos(0.0)}, {"texCoord", 1}};
    const Vertex corner = load(moved).meshes[0].vertices[1];  // (1, 0), which becomes (0.25, -2)
    CHECK(corner.uv[0] == Approx(0.25));
    CHECK(corner.uv[1] == Approx(3));
}

TEST_CASE("colours of vertices run straight between the corners of each triangle")
{
    GltfTestFile file;
    file.primitive()["attributes"]["COLOR_0"] =
        file.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const Scene scene = load(file);
    const Image& image = scene.textures.at(0).image;
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        const int x = int(vertex.uv[0] * float(image.extent.width)),
                  y = int(vertex.uv[1] * float(image.extent.height));
        CHECK(image.at(x, y, 0) == vertex.position[0]);
        CHECK(image.at(x, y, 1) == vertex.position[1]);
    }
    file.json["meshes"][0]["primitives"].push_back(file.primitive());
    file.json["meshes"][0]["primitives"][1]["attributes"].erase("COLOR_0");
    const Scene mixed = load(file);
    CHECK(mixed.materials[std::size_t(mixed.instances[1].material)].base_color_texture == -1);
    GltfTestFile same;
    same.primitive()["attributes"]["COLOR_0"] =
        same.numbers<std::uint8_t>(std::vector<std::uint8_t>(16, 51), "VEC4", 5121, true);
    CHECK(materialOf(load(same)).base_color.r == Approx(0.2));
}

TEST_CASE("what is seen through is set apart, unless it is cut out, solid, or all there is")
{
    const auto blended = [](double alpha, double transmission, bool solid) {
        GltfTestFile file;
        file.json["nodes"].push_back({{"mesh", 1}, {"translation", {9, 0, 0}}});
        file.json["meshes"].push_back(file.json["meshes"][0]);
        file.json["scenes"][0]["nodes"] = {0, 1};
        file.primitive()["material"] = 0;
        file.json["materials"] = {
            {{"alphaMode", "BLEND"},
             {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, alpha}}}},
             {"extensions",
              {{"KHR_materials_transmission", {{"transmissionFactor", transmission}}}}}}};
        ImportOptions options;
        options.blended_solid = solid;
        const Result<Scene> scene = imported(file, options);
        CHECK(scene.diagnostics().empty());
        CHECK(need(scene).instances.size() + need(scene).blended.size() == 2);
        checkBox(*scene, {0, 0, 0}, {10, 1, 0});
        return need(scene).instances.size();
    };
    CHECK(blended(0.3, 0, false) == 1);
    CHECK(blended(1, 1, false) == 1);
    CHECK(blended(1, 0, false) == 2);
    CHECK(blended(0.3, 0, true) == 2);

    GltfTestFile cut_out;
    addTexture(cut_out, "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 2\nMAXVAL 255\nENDHDR\n");
    cut_out.json["materials"][0]["alphaMode"] = "BLEND";
    cut_out.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.1};
    cut_out.json.erase("images");
    CHECK(has(warningOf(cut_out), "drawn solid"));
    CHECK(need(imported(cut_out)).instances.size() == 1);
}

TEST_CASE("what metallic-roughness lighting shows of a material, glTF gives with its defaults")
{
    const auto read = [](const json& material) {
        GltfTestFile file;
        file.primitive()["material"] = 0;
        file.json["materials"] = json::array({material});
        return materialOf(load(file));
    };
    const SceneMaterial plain = read({{"name", "plain"}});
    CHECK(plain.metallic == 1);
    CHECK(plain.roughness == 1);
    CHECK(plain.reflectance == Approx(0.04f));
    CHECK(plain.emission == glm::vec3(0.0f));
    CHECK_FALSE(plain.unlit);
    const SceneMaterial set =
        read({{"pbrMetallicRoughness", {{"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}},
              {"emissiveFactor", {1, 0.5, 0}},
              {"extensions",
               {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                {"KHR_materials_ior", {{"ior", 3}}},
                {"KHR_materials_specular", {{"specularFactor", 0.5}}},
                {"KHR_materials_unlit", json::object()}}}});
    CHECK(set.metallic == 0.25f);
    CHECK(set.roughness == 0.5f);
    CHECK(set.reflectance == Approx(0.125f));
    CHECK(set.emission == glm::vec3(4, 2, 0));
    CHECK(set.unlit);
    const SceneMaterial older = read(
        {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"glossinessFactor", 0.75}}}}}});
    CHECK(older.metallic == 0);
    CHECK(older.roughness == 0.25f);
}

TEST_CASE("nodes that share a name or a camera are cameras of their own; hidden nodes are none")
{
    GltfTestFile file;
    file.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    for (int x = 1; x < 4; ++x)
        file.json["nodes"].push_back({{"name", "eye"}, {"camera", 0}, {"translation", {x, 0, 9}}});
    file.json["nodes"][3]["extensions"]["KHR_node_visibility"]["visible"] = false;
    file.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const Scene scene = load(file);
    REQUIRE(scene.cameras.size() == 2);
    CHECK(scene.cameras[0].name != scene.cameras[1].name);
    CHECK(scene.cameras[0].view_from_world[3].x != scene.cameras[1].view_from_world[3].x);
}

TEST_CASE("each key and extension that is not read is named, once a file")
{
    const std::pair<const char*, const char*> rows[] = {
        {R"({"materials": [{"extensions": {"KHR_materials_specular": {"specularTexture": {}}}}]})",
         "specularTexture"},
        {R"({"materials": [{"extensions": {"KHR_materials_clearcoat": {}}}]})",
         "KHR_materials_clearcoat"},
        {R"({"materials": [{"bumpiness": 3}]})", "'bumpiness' of material"},
        {R"({"nodes": [{"mesh": 0, "instances": 4}]})", "'instances' of node"},
        {R"({"extensions": {"ACME_anvil": {}}})", "ACME_anvil"},
        {R"({"scenes": [{"nodes": [0, 0]}]})", "second parent"},
        {R"({"scenes": [{"nodes": [0]}, {"nodes": []}]})", "its other scenes, 1 (--file-scene)"},
        {R"({"textures": [{"extensions": {"KHR_texture_basisu": {}}}]})", "KHR_texture_basisu"}};
    for (const auto& [members, named] : rows) {
        INFO(members);
        GltfTestFile file;
        file.json.merge_patch(json::parse(members));
        CHECK(has(warningOf(file), named));
    }
    GltfTestFile points;
    points.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    CHECK(has(warningOf(points), "points and lines"));
    GltfTestFile quiet;
    quiet.json["extras"] = {{"anything", 1}};
    quiet.json["asset"]["generator"] = "a test";
    quiet.json["extensionsUsed"] = {"KHR_lights_punctual"};
    load(quiet);
}

TEST_CASE(
    "an extension that is required and not read, or another version, is an error that says so")
{
    for (const auto& [required, way_out] : {std::pair("KHR_texture_basisu", "ktxdecompress"),
                                            {"ACME_anvil", "export the scene without it"}}) {
        GltfTestFile file;
        file.json["extensionsRequired"] = {"KHR_mesh_quantization", required};
        const Diagnostic error = onlyError(imported(file), Code::scene_broken);
        CHECK(has(error.message, required));
        CHECK_FALSE(has(error.message, "quantization"));
        CHECK(has(error.help, way_out));
    }
    GltfTestFile older;
    older.json["asset"]["version"] = "1.0";
    CHECK(has(imported(older).diagnostics().at(0).message, "glTF 1.0"));
}

TEST_CASE("accessors that read past what there is are errors that name them")
{
    const std::pair<const char*, const char*> rows[] = {
        {R"({"bufferViews": [{"buffer": 0, "byteLength": 40},
             {"buffer": 0, "byteOffset": 48, "byteLength": 12}]})",
         "bufferView 0 is shorter"},
        {R"({"bufferViews": [{"buffer": 0, "byteLength": 4000},
             {"buffer": 0, "byteOffset": 48, "byteLength": 12}]})",
         "bufferView 0 reaches past"},
        {R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 7}}]}]})", "accessor 7"},
        {R"({"nodes": [{"mesh": 5}]})", "node 0"}};
    for (const auto& [members, named] : rows) {
        GltfTestFile file;
        file.json.merge_patch(json::parse(members));
        CHECK(has(onlyError(imported(file), Code::scene_broken).message, named));
    }
}
