// SPDX-License-Identifier: MIT
// Scene files that crash, hang or mislead their reader, and what they may not open.
#include "core/base/text.h"
#include "tests/support/gltf_file.h"

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

// The one error of a scene, with a way out, and that code.
Diagnostic errorOf(const Result<Scene>& scene, Code code = Code::scene_broken)
{
    const Diagnostic error = onlyError(scene, code);
    CHECK_FALSE(error.help.empty());
    return error;
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
    onlyWarning(quad, Code::not_finite);
    CHECK(quad->meshes[0].indices.size() == 3);
    const auto two = importScene(folder.write(
        "two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 nan 0\no one\nf 1 2 3\no two\nf 1 2 3 4\n"));
    CHECK(need(two).bounds().max == glm::dvec3(1, 1, 0));
}

TEST_CASE("a scene whose triangles have no area is an error")
{
    const TemporaryFolder folder("scene_flat");
    for (const char* text : {"v 0 0 0\nf 1 1 1\n", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n",
                             "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"})
        errorOf(importScene(folder.write("flat.obj", text)), Code::scene_empty);
}

TEST_CASE("more primitives or lights than a file of its size may have are refused")
{
    constexpr int kMany = 50000;
    GltfTestFile parts, lit;
    const nlohmann::json primitive = parts.primitive(), light = {{"type", "point"}};
    parts.json["meshes"][0]["primitives"] = std::vector<nlohmann::json>(kMany, primitive);
    CHECK(has(errorOf(imported(parts)).message, "50000 primitives"));
    lit.json["extensions"]["KHR_lights_punctual"]["lights"] =
        std::vector<nlohmann::json>(kMany, light);
    CHECK(has(errorOf(imported(lit)).message, "50000 lights"));
}

TEST_CASE("a PLY file that ends within its header is an error at once")
{
    const TemporaryFolder folder("scene_cut");
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n";
    for (const std::size_t length : {3u, 30u, 60u, 64u}) {
        const auto cut = importScene(folder.write("cut.ply", header.substr(0, length)));
        CHECK(has(errorOf(cut).message, "ends within its header"));
    }
}

TEST_CASE("a file that its reader never returns from is an error at the time limit")
{
    const TemporaryFolder folder("scene_hang");
    const std::string header =
        "ply\nformat ascii 1.0\ncomment element face end_header\nelement vertex 3\n";
    for (const std::size_t length : {53u, 68u}) {
        const Diagnostic error =
            errorOf(importScene(folder.write("cut.ply", header.substr(0, length)), soon()));
        CHECK(has(error.message, "longer than 1 s"));
        CHECK(has(error.help, "--import-time"));
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
    errorOf(ply);
    std::string stl(80, ' ');
    stl += "\xff\xff\xff\x7f";
    errorOf(importScene(folder.write("lies.stl", stl), soon()));
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
        const std::string message = errorOf(importScene(folder.write(name, text))).message;
        CHECK(has(message, name + "' has "));
        CHECK(has(message, " may have "));
    }
}

TEST_CASE("triangles in more meshes or at more nodes than the files' size allows are refused")
{
    const auto counted = [](std::size_t primitives, std::size_t nodes) {
        GltfTestFile file;
        const int flat = file.floats(std::vector<float>(180000), "VEC3");  // 20,000 triangles
        file.primitive() = {{"attributes", {{"POSITION", flat}}}};
        const nlohmann::json primitive = file.primitive(), node = file.json["nodes"][0];
        file.json["meshes"][0]["primitives"] = std::vector<nlohmann::json>(primitives, primitive);
        file.json["nodes"] = std::vector<nlohmann::json>(nodes, node);
        for (std::size_t k = 1; k < nodes; ++k) file.json["scenes"][0]["nodes"].push_back(k);
        return imported(file);
    };
    errorOf(counted(1, 10), Code::scene_empty);  // all of them lie at one place
    CHECK(has(errorOf(counted(1, 1000)).message, " triangles at all nodes, "));
    CHECK(has(errorOf(counted(200, 1)).message, " triangles, "));
}

TEST_CASE("a texture of more texels than the files' size allows is left out, with the way out")
{
    const Textured set("inside.png");
    set.folder.write(
        "scene/inside.png",
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x20\0\0\0\x20\0\10\6\0\0\0", 29) +
            std::string(64, '\0'));
    const auto scene = importScene(set.scene);
    const Diagnostic warning = onlyWarning(scene, Code::image_broken);
    CHECK(scene->textures.empty());
    CHECK(has(warning.message, "inside.png"));
    CHECK(has(warning.message, "8192x8192 pixels, more than"));
    CHECK(has(warning.help, "scale it down"));
}

TEST_CASE("a format that is not asked for is not tried, whatever the file is called")
{
    const TemporaryFolder folder("scene_formats");
    const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    ImportOptions any;
    any.any_format = true;
    const std::string named = folder.write("a.off", off);
    CHECK(has(errorOf(importScene(named)).help, "--any-format"));
    CHECK(importScene(named, any).ok());
    CHECK_FALSE(importScene(folder.write("off.glb", off)).ok());
}

TEST_CASE("a texture outside the scene's folder is not read unless its folder is allowed")
{
    const Textured set("../outside.pgm");
    const auto refused = importScene(set.scene);
    const Diagnostic warning = onlyWarning(refused, Code::module_escape);
    CHECK(refused->textures.empty());
    CHECK(has(warning.message, "outside.pgm"));
    CHECK(has(warning.help, "--root"));

    ImportOptions options;
    options.roots = {set.folder.path.string()};
    const auto allowed = importScene(set.scene, options);
    CHECK(need(allowed).textures.size() == 1);
    CHECK(allowed.diagnostics().empty());
}

TEST_CASE("a symlink does not lead out of the scene's folder")
{
    const Textured set("link.pgm");
    std::filesystem::create_symlink(set.folder.path / "outside.pgm",
                                    set.folder.path / "scene/link.pgm");
    const auto scene = importScene(set.scene);
    onlyWarning(scene, Code::module_escape);
    CHECK(scene->textures.empty());
}

TEST_CASE("a path of the exporter's machine is looked for beside the scene, without a word")
{
    const Textured set("C:\\artists\\inside.pgm");
    const auto scene = importScene(set.scene);
    CHECK(need(scene).textures.size() == 1);
    CHECK(scene.diagnostics().empty());
}

TEST_CASE("a texture that is no regular file is left out and not waited for")
{
    const Textured set("pipe.pgm");
    REQUIRE(mkfifo((set.folder.path / "scene/pipe.pgm").c_str(), 0600) == 0);
    ImportOptions patient;
    patient.time_s = 20;
    onlyWarning(importScene(set.scene, patient), Code::image_broken);
    CHECK(importScene(Textured("/dev/zero").scene, patient).ok());
}

TEST_CASE("materials outside the scene's folder are not read")
{
    const TemporaryFolder folder("scene_materials");
    folder.write("secret.mtl", "newmtl m\nKd .1 .2 .3\n");
    const auto scene =
        importScene(folder.write("scene/a.obj", "mtllib ../secret.mtl\nusemtl m\n" + kTriangle));
    onlyWarning(scene, Code::module_escape);
    for (const SceneMaterial& material : scene->materials) CHECK(material.base_color.r != 0.1f);
}

TEST_CASE("a buffer outside the scene's folder is an error that names it and the way out")
{
    const TemporaryFolder folder("scene_buffers");
    GltfTestFile file;
    folder.write("outside.bin", file.bytes);
    file.uri = "../outside.bin";
    const Diagnostic error = errorOf(importScene(file.write(folder, "scene/a.gltf")));
    CHECK(has(error.message, "outside.bin"));
    CHECK(has(error.help, "--root"));
}

TEST_CASE("what is reported of a broken file is no longer than a few lines")
{
    const TemporaryFolder folder("scene_long");
    const std::string text = "{\"asset\": \"" + std::string(100000, 'x') + "\n\"}";
    CHECK(errorOf(importScene(folder.write("long.gltf", text))).message.size() < 1000);
}
