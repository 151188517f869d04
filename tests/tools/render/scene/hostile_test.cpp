// SPDX-License-Identifier: MIT
// Scene files that crash, hang or mislead their reader, and what they may not open.
#include "tools/render/scene/scene.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <sys/stat.h>

using namespace crevice;

namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

// A texture of one white pixel.
const std::string kWhite = "P5 1 1 255\n\xff";

ImportOptions soon()
{
    ImportOptions options;
    options.time_s = 1;
    return options;
}

const Diagnostic& onlyError(const Result<Scene>& scene)
{
    REQUIRE_FALSE(scene.ok());
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK_FALSE(scene.diagnostics()[0].help.empty());
    return scene.diagnostics()[0];
}

// A folder with scene/a.obj, whose material takes `texture`, and a picture beside the scene's
// folder.
struct Textured {
    TemporaryFolder folder;
    std::string scene;

    explicit Textured(const std::string& texture) : folder("scene_textured")
    {
        folder.write("outside.pgm", kWhite);
        folder.write("scene/inside.pgm", kWhite);
        folder.write("scene/a.mtl", "newmtl m\nmap_Kd " + texture + "\n");
        scene = folder.write("scene/a.obj", "mtllib a.mtl\nusemtl m\n" + kTriangle);
    }
};

}  // namespace

TEST_CASE("a broken face is left out, of four corners too, and the last one of its mesh")
{
    const TemporaryFolder folder("scene_faces");
    const auto quad = importScene(folder.write(
        "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 nan 0\nv 0 0 1\nf 1 2 3 4\nf 1 2 5\n"));
    REQUIRE(quad.ok());
    CHECK(quad->meshes[0].indices.size() == 3);
    REQUIRE(quad.diagnostics().size() == 1);
    CHECK(quad.diagnostics()[0].code == Code::not_finite);
    const auto two = importScene(folder.write(
        "two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 nan 0\no one\nf 1 2 3\no two\nf 1 2 3 4\n"));
    REQUIRE(two.ok());
    CHECK(two->bounds().max == glm::dvec3(1, 1, 0));
}

TEST_CASE("a scene whose triangles have no area is an error")
{
    const TemporaryFolder folder("scene_flat");
    for (const char* text : {"v 0 0 0\nf 1 1 1\n", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n",
                             "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"}) {
        const Diagnostic error = onlyError(importScene(folder.write("flat.obj", text)));
        CHECK(error.code == Code::scene_empty);
    }
}

TEST_CASE("more primitives or lights than a file of its size may have are refused")
{
    const TemporaryFolder folder("scene_parts");
    const auto refused = [&](const std::string& primitives, const std::string& lights) {
        const std::string text =
            R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
            std::string("AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA") +
            R"("}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [)" +
            lights + R"(]}},
            "meshes": [{"primitives": [)" +
            primitives + R"(]}], "nodes": [{"mesh": 0}],
            "scenes": [{"nodes": [0]}], "scene": 0})";
        return onlyError(importScene(folder.write("parts.gltf", text))).message;
    };
    const auto many = [](int count, const std::string& text) {
        std::string all = text;
        for (int i = 1; i < count; ++i) all += ", " + text;
        return all;
    };
    const std::string triangle = R"({"attributes": {"POSITION": 0}})";
    CHECK_THAT(refused(many(50000, triangle), R"({"type": "point"})"),
               Catch::Contains("50000 primitives"));
}

TEST_CASE("a PLY file that ends within its header is an error at once")
{
    const TemporaryFolder folder("scene_cut");
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n";
    for (const std::size_t length : {3u, 30u, 60u, 64u}) {
        const Diagnostic error =
            onlyError(importScene(folder.write("cut.ply", header.substr(0, length))));
        CHECK(error.code == Code::scene_broken);
        CHECK(error.message.find("ends within its header") != std::string::npos);
    }
}

TEST_CASE("a file that its reader never returns from is an error at the time limit")
{
    const TemporaryFolder folder("scene_hang");
    const std::string header =
        "ply\nformat ascii 1.0\ncomment element face end_header\nelement vertex 3\n";
    for (const std::size_t length : {53u, 68u}) {
        const Diagnostic error =
            onlyError(importScene(folder.write("cut.ply", header.substr(0, length)), soon()));
        CHECK(error.code == Code::scene_broken);
        CHECK(error.message.find("longer than 1 s") != std::string::npos);
        CHECK(error.help.find("--import-time") != std::string::npos);
    }
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("a file that lies about its counts does not fill the memory")
{
    const TemporaryFolder folder("scene_lies");
    const std::string count = "1000000000";
    const auto ply = importScene(
        folder.write("lies.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                                     "\nproperty float x\nproperty float y\nproperty float z\n"
                                     "element face " +
                                     count +
                                     "\nproperty list uchar int vertex_indices\nend_header\nabc"),
        soon());
    CHECK(onlyError(ply).code == Code::scene_broken);
    std::string stl(80, ' ');
    stl += "\xff\xff\xff\x7f";
    CHECK(onlyError(importScene(folder.write("lies.stl", stl), soon())).code == Code::scene_broken);
}
#endif

TEST_CASE("a file that counts more than it has bytes for is refused before it is read")
{
    const std::string huge = "\xf0\xff\xff\xff", head("glTF\2\0\0\0\x20\0\0\0", 12);
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex ";
    const std::string accessor = R"("accessors": [{"componentType": 5126, "count": 200000000,
        "type": "VEC3", "sparse": {"count": 1, "indices": {}, "values": {}}}])";
    const std::pair<std::string, std::string> files[] = {
        {"json.glb", head + huge + "JSON"},
        {"binary.glb", head + std::string("\2\0\0\0JSON{}", 10) + huge + std::string("BIN\0", 4)},
        {"vertices.ply", ply + "268435456\nproperty float x\nend_header\n0\n"},
        {"faces.ply", ply + "1\nproperty float x\nelement\tface  268435456\nend_header\n0\n"},
        {"sparse.gltf", "{" + accessor + "}"}};
    const TemporaryFolder folder("scene_claims");
    for (const auto& [name, text] : files) {
        INFO(name);
        const Diagnostic error = onlyError(importScene(folder.write(name, text)));
        CHECK(error.code == Code::scene_broken);
        CHECK(error.message.find(name + "' has ") != std::string::npos);
        CHECK(error.message.find(" may have ") != std::string::npos);
    }
}

TEST_CASE("triangles in more meshes or at more nodes than the files' size allows are refused")
{
    constexpr int kTriangles = 20000;
    const TemporaryFolder folder("scene_unfolds");
    folder.write("a.bin", std::string(kTriangles * 36, '\0'));
    const auto imported = [&](int primitives, int nodes) {
        const std::string bytes = std::to_string(kTriangles * 36);
        std::string parts, all, roots;
        for (int k = 0; k < primitives; ++k)
            parts += std::string(k ? "," : "") + R"({"attributes": {"POSITION": 0}})";
        for (int k = 0; k < nodes; ++k) {
            all += std::string(k ? "," : "") + R"({"mesh": 0})";
            roots += (k ? "," : "") + std::to_string(k);
        }
        return importScene(folder.write(
            "a.gltf",
            R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin", "byteLength": )" + bytes +
                R"(}], "bufferViews": [{"buffer": 0, "byteLength": )" + bytes +
                R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": )" +
                std::to_string(kTriangles * 3) +
                R"(, "type": "VEC3"}], "meshes": [{"primitives": [)" + parts +
                R"(]}], "nodes": [)" + all + R"(], "scenes": [{"nodes": [)" + roots + "]}]}"));
    };
    CHECK(onlyError(imported(1, 10)).code == Code::scene_empty);  // all of them lie at one place
    const Diagnostic drawn = onlyError(imported(1, 1000));
    CHECK(drawn.message.find(" triangles at all nodes, ") != std::string::npos);
    const Diagnostic meshes = onlyError(imported(200, 1));
    CHECK(meshes.message.find(" triangles, ") != std::string::npos);
}

TEST_CASE("a texture of more texels than the files' size allows is left out, with the way out")
{
    const Textured set("inside.png");
    set.folder.write(
        "scene/inside.png",
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x20\0\0\0\x20\0\10\6\0\0\0", 29) +
            std::string(64, '\0'));
    const auto scene = importScene(set.scene);
    REQUIRE(scene.ok());
    CHECK(scene->textures.empty());
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK(scene.diagnostics()[0].code == Code::image_broken);
    CHECK(scene.diagnostics()[0].message.find("inside.png") != std::string::npos);
    CHECK(scene.diagnostics()[0].message.find("8192x8192 pixels, more than") != std::string::npos);
    CHECK(scene.diagnostics()[0].help.find("scale it down") != std::string::npos);
}

TEST_CASE("a format that is not asked for is not tried, whatever the file is called")
{
    const TemporaryFolder folder("scene_formats");
    const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    ImportOptions any;
    any.any_format = true;
    const std::string named = folder.write("a.off", off);
    CHECK(onlyError(importScene(named)).help.find("--any-format") != std::string::npos);
    CHECK(importScene(named, any).ok());
    const std::string disguised = folder.write("off.glb", off);
    CHECK_FALSE(importScene(disguised).ok());
}

TEST_CASE("a texture outside the scene's folder is not read unless its folder is allowed")
{
    const Textured set("../outside.pgm");
    const auto refused = importScene(set.scene);
    REQUIRE(refused.ok());
    CHECK(refused->textures.empty());
    REQUIRE(refused.diagnostics().size() == 1);
    CHECK(refused.diagnostics()[0].code == Code::module_escape);
    CHECK(refused.diagnostics()[0].severity == Severity::warning);
    CHECK(refused.diagnostics()[0].message.find("outside.pgm") != std::string::npos);
    CHECK(refused.diagnostics()[0].help.find("--root") != std::string::npos);

    ImportOptions options;
    options.roots = {set.folder.path.string()};
    const auto allowed = importScene(set.scene, options);
    REQUIRE(allowed.ok());
    CHECK(allowed->textures.size() == 1);
    CHECK(allowed.diagnostics().empty());
}

TEST_CASE("a symlink does not lead out of the scene's folder")
{
    const Textured set("link.pgm");
    std::filesystem::create_symlink(set.folder.path / "outside.pgm",
                                    set.folder.path / "scene/link.pgm");
    const auto scene = importScene(set.scene);
    REQUIRE(scene.ok());
    CHECK(scene->textures.empty());
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK(scene.diagnostics()[0].code == Code::module_escape);
}

TEST_CASE("a path of the exporter's machine is looked for beside the scene, without a word")
{
    const Textured set("C:\\artists\\inside.pgm");
    const auto scene = importScene(set.scene);
    REQUIRE(scene.ok());
    CHECK(scene->textures.size() == 1);
    CHECK(scene.diagnostics().empty());
}

TEST_CASE("a texture that is no regular file is left out and not waited for")
{
    const Textured set("pipe.pgm");
    REQUIRE(mkfifo((set.folder.path / "scene/pipe.pgm").c_str(), 0600) == 0);
    ImportOptions patient;
    patient.time_s = 20;
    const auto scene = importScene(set.scene, patient);
    REQUIRE(scene.ok());
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK(scene.diagnostics()[0].code == Code::image_broken);
    CHECK(importScene(Textured("/dev/zero").scene, patient).ok());
}

TEST_CASE("materials outside the scene's folder are not read")
{
    const TemporaryFolder folder("scene_materials");
    folder.write("secret.mtl", "newmtl m\nKd .1 .2 .3\n");
    const auto scene =
        importScene(folder.write("scene/a.obj", "mtllib ../secret.mtl\nusemtl m\n" + kTriangle));
    REQUIRE(scene.ok());
    for (const SceneMaterial& material : scene->materials) CHECK(material.base_color.r != 0.1f);
    REQUIRE(scene.diagnostics().size() == 1);
    CHECK(scene.diagnostics()[0].code == Code::module_escape);
}

TEST_CASE("a buffer outside the scene's folder is an error that names it and the way out")
{
    const TemporaryFolder folder("scene_buffers");
    folder.write("outside.bin", std::string(36, '\0'));
    const auto error = onlyError(importScene(folder.write("scene/a.gltf", R"({
        "asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "../outside.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}], "scene": 0})")));
    CHECK(error.code == Code::scene_broken);
    CHECK(error.message.find("outside.bin") != std::string::npos);
    CHECK(error.help.find("--root") != std::string::npos);
}

TEST_CASE("what is reported of a broken file is no longer than a few lines")
{
    const TemporaryFolder folder("scene_long");
    const auto error = onlyError(
        importScene(folder.write("long.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"scene\": \"" +
                                                  std::string(100000, 'x') + "\"}")));
    CHECK(error.message.size() < 1000);
}
