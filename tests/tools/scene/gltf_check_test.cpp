// SPDX-License-Identifier: MIT
// What glTF files require and use that is not read.
#include "tools/scene/file/gltf_check.h"

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

const Diagnostic& only(const Status& status)
{
    REQUIRE(status.diagnostics().size() == 1);
    CHECK_FALSE(status.diagnostics()[0].help.empty());
    return status.diagnostics()[0];
}

bool names(const Diagnostic& diagnostic, const std::string& text)
{
    return (diagnostic.message + diagnostic.help).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("a file without extensions, or with those that are read, passes without a word")
{
    CHECK(check("").diagnostics().empty());
    CHECK(check(R"(, "extensionsRequired": ["KHR_draco_mesh_compression"],
                     "extensionsUsed": ["KHR_draco_mesh_compression", "KHR_lights_punctual"])")
              .diagnostics()
              .empty());
}

TEST_CASE("textures at a second set of coordinates are reported")
{
    for (const char* material :
         {R"({"occlusionTexture": {"index": 0, "texCoord": 1}})",
          R"({"normalTexture": {"texCoord": 1}})",
          R"({"pbrMetallicRoughness": {"baseColorTexture": {"texCoord": 1}}})"}) {
        const Status status = check(R"(, "materials": [)" + std::string(material) + "]");
        CHECK(names(only(status), "second set of texture coordinates"));
    }
    CHECK(check(R"(, "materials": [{"occlusionTexture": {"texCoord": 0}}, 5])")
              .diagnostics()
              .empty());
}

TEST_CASE("every required extension that is not read is in one error with its way out")
{
    const Status status = check(R"(, "extensionsRequired": ["KHR_mesh_quantization",
        "EXT_meshopt_compression", "KHR_texture_transform", "ACME_anvil"])");
    REQUIRE_FALSE(status.ok());
    const Diagnostic& error = only(status);
    CHECK(error.code == Code::scene_broken);
    for (const char* name : {"KHR_mesh_quantization", "EXT_meshopt_compression", "ACME_anvil",
                             "gltfpack -noq", "gltf-transform dequantize"})
        CHECK(names(error, name));
    CHECK_FALSE(names(error, "KHR_texture_transform"));
}

TEST_CASE("textures in formats that are not read say how to convert them")
{
    for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif"}) {
        const Status status = check(std::string(R"(, "extensionsRequired": [")") + name + "\"]");
        CHECK_FALSE(status.ok());
        CHECK(names(only(status), "gltf-transform"));
    }
}

TEST_CASE("what is used and not drawn is one warning a file")
{
    const Status status = check(R"(, "extensionsUsed": ["KHR_texture_transform",
        "KHR_materials_clearcoat", "EXT_texture_webp", "KHR_lights_punctual"])");
    CHECK(status.ok());
    const Diagnostic& warning = only(status);
    CHECK(warning.code == Code::scene_features);
    CHECK(warning.severity == Severity::warning);
    for (const char* name :
         {"KHR_texture_transform", "KHR_materials_clearcoat", "EXT_texture_webp"})
        CHECK(names(warning, name));
    CHECK_FALSE(names(warning, "KHR_lights_punctual"));
}

TEST_CASE("a required extension of materials alone is a warning")
{
    const Status status = check(R"(, "extensionsRequired": ["KHR_materials_transmission"])");
    CHECK(status.ok());
    CHECK(names(only(status), "KHR_materials_transmission"));
}

TEST_CASE("integers where Assimp wants floats are found though no extension is named")
{
    const char* const more =
        R"(, "meshes": [{"primitives": [{"attributes": {"NORMAL": 1, "POSITION": 0}}]}],
        "accessors": [{"componentType": 5123}, {"componentType": 5126}])";
    const Status status = check(more);
    CHECK_FALSE(status.ok());
    CHECK(names(only(status), "KHR_mesh_quantization"));
    const Status texture =
        check(R"(, "meshes": [{"primitives": [{"attributes": {"TEXCOORD_0": 0}}]}],
        "accessors": [{"componentType": 5121}])");
    CHECK(texture.ok());
    CHECK(names(only(texture), "texture coordinates"));
}

TEST_CASE("another version of glTF is an error that names it")
{
    CHECK(names(only(check("", "1.0")), "glTF 1.0"));
}

TEST_CASE("JSON of any shape does the check no harm")
{
    for (const char* members :
         {R"(, "extensionsRequired": 3)", R"(, "extensionsUsed": [[], 1, null])",
          R"(, "meshes": {"a": 1}, "accessors": 7)",
          R"(, "meshes": [1, [2], "x", {"primitives": 4}])",
          R"(, "meshes": [{"primitives": [{"attributes": [0]}]}], "accessors": [1])",
          R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 9e9}}]}])"})
        CHECK(check(members).diagnostics().empty());
    const TemporaryFolder folder("gltf_shapes");
    CHECK(checkGltf(folder.write("cut.gltf", "{\"asset\""), false).diagnostics().empty());
    CHECK(checkGltf(folder.write("cut.glb", "glTF\x02"), false).diagnostics().empty());
    CHECK(checkGltf(folder.write("lies.glb", "glTF" + littleEndian(2) + littleEndian(20) +
                                                 littleEndian(0xfffffff0u) + "JSON{"),
                    false)
              .diagnostics()
              .empty());
}
