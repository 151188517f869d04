// SPDX-License-Identifier: MIT
// What glTF files require and use that is not read.
#include "tools/render/scene/file/gltf_check.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace {

std::string littleEndian(std::size_t value)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

Status check(const std::string& members, const char* version = "2.0")
{
    const TemporaryFolder folder("gltf_check");
    const std::string json =
        std::string(R"({"asset": {"version": ")") + version + "\"}" + members + "}";
    const Status text = checkGltf(folder.write("a.gltf", json), false);
    const std::string glb = "glTF" + littleEndian(2) + littleEndian(20 + json.size()) +
                            littleEndian(json.size()) + "JSON" + json;
    const Status binary = checkGltf(folder.write("a.glb", glb), false);
    CHECK(text.diagnostics().size() == binary.diagnostics().size());
    return text;
}

bool contains(const Diagnostic& diagnostic, const std::string& text)
{
    return (diagnostic.message + diagnostic.help).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("what is read, or is JSON of any shape, passes without a word")
{
    for (const char* members :
         {"",
          R"(, "extensionsRequired": ["KHR_draco_mesh_compression"],
               "extensionsUsed": ["KHR_draco_mesh_compression", "KHR_lights_punctual"])",
          R"(, "materials": [{"occlusionTexture": {"texCoord": 0}}, 5])",
          R"(, "extensionsRequired": 3)", R"(, "extensionsUsed": [[], 1, null])",
          R"(, "meshes": {"a": 1}, "accessors": 7)",
          R"(, "meshes": [1, [2], "x", {"primitives": 4}])",
          R"(, "meshes": [{"primitives": [{"attributes": [0]}]}], "accessors": [1])",
          R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 9e9}}]}])"}) {
        INFO(members);
        CHECK(check(members).diagnostics().empty());
    }
    const TemporaryFolder folder("gltf_shapes");
    for (const auto& [name, bytes] :
         {std::pair<const char*, std::string>("cut.gltf", "{\"asset\""), {"cut.glb", "glTF\x02"}})
        CHECK(checkGltf(folder.write(name, bytes), false).diagnostics().empty());
}

TEST_CASE("what is not read is one error or warning a file, with its way out")
{
    struct Row {
        std::string members;
        bool ok;  ///< A warning, or else an error.
        std::vector<std::string> named;
        std::string not_named = "nothing of this name";
        const char* version = "2.0";
    };
    std::vector<Row> rows = {
        {"", false, {"glTF 1.0"}, "nothing of this name", "1.0"},
        {R"(, "extensionsRequired": ["KHR_mesh_quantization", "EXT_meshopt_compression",
              "KHR_texture_transform", "ACME_anvil"])",
         false,
         {"KHR_mesh_quantization", "EXT_meshopt_compression", "ACME_anvil", "gltfpack -noq",
          "gltf-transform dequantize"},
         "KHR_texture_transform"},
        {R"(, "extensionsUsed": ["KHR_texture_transform", "KHR_materials_clearcoat",
              "EXT_texture_webp", "KHR_lights_punctual"])",
         true,
         {"KHR_texture_transform", "KHR_materials_clearcoat", "EXT_texture_webp"},
         "KHR_lights_punctual"},
        {R"(, "extensionsRequired": ["KHR_materials_transmission"])",
         true,
         {"KHR_materials_transmission"}},
        // Integers where Assimp wants floats, though no extension is named.
        {R"(, "meshes": [{"primitives": [{"attributes": {"NORMAL": 1, "POSITION": 0}}]}],
              "accessors": [{"componentType": 5123}, {"componentType": 5126}])",
         false,
         {"KHR_mesh_quantization"}},
        {R"(, "meshes": [{"primitives": [{"attributes": {"TEXCOORD_0": 0}}]}],
              "accessors": [{"componentType": 5121}])",
         true,
         {"texture coordinates"}}};
    for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif"})
        rows.push_back({R"(, "extensionsRequired": [")" + std::string(name) + "\"]",
                        false,
                        {"gltf-transform"}});
    for (const char* material :
         {R"({"occlusionTexture": {"index": 0, "texCoord": 1}})",
          R"({"normalTexture": {"texCoord": 1}})",
          R"({"pbrMetallicRoughness": {"baseColorTexture": {"texCoord": 1}}})"})
        rows.push_back({R"(, "materials": [)" + std::string(material) + "]",
                        true,
                        {"second set of texture coordinates"}});
    for (const Row& row : rows) {
        INFO(row.members);
        const Status status = check(row.members, row.version);
        CHECK(status.ok() == row.ok);
        REQUIRE(status.diagnostics().size() == 1);
        const Diagnostic& found = status.diagnostics()[0];
        CHECK(found.code == (row.ok ? Code::scene_features : Code::scene_broken));
        CHECK((found.severity == Severity::warning) == row.ok);
        CHECK_FALSE(found.help.empty());
        for (const std::string& name : row.named) CHECK(contains(found, name));
        CHECK_FALSE(contains(found, row.not_named));
    }
}
