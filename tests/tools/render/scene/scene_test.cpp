// SPDX-License-Identifier: MIT
// Scenes: bounds, projections, files that are fine and files that are not.
// Built-in scenes: what their pictures and benches do not show.
#include "tools/render/scene/scene.h"

#include "core/base/text.h"
#include "tests/support/gltf_file.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/builtin_scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>

using namespace crevice;

namespace {

Result<Scene> importText(const std::string& name, const std::string& text)
{
    const TemporaryFolder folder("scene_test");
    return importScene(folder.write(name, text));
}

// Twelve corners that share eight positions, as cubes without normals come.
const char* const kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

std::string vertexLine(double x, const char* y, double z)
{
    return "v " + std::to_string(x) + y + std::to_string(z) + "\n";
}

double depthAt(const glm::mat4& clip_from_view, double distance)
{
    const glm::vec4 clip = clip_from_view * glm::vec4(0, 0, -distance, 1);
    return clip.z / clip.w;
}

Bounds boundsBetween(double near_distance, double far_distance)
{
    Bounds bounds;
    bounds.add({-0.01, -0.01, -near_distance});
    bounds.add({0.01, 0.01, -far_distance});
    return bounds;
}

// With a model of a few triangles in the bunny's place, for tests of all else.
Result<Scene> roomWith(const std::string& bunny)
{
    const TemporaryFolder folder("builtin_room");
    folder.write("bunny.obj", bunny);
    ::setenv("CREVICE_MODELS", folder.path.c_str(), 1);
    Result<Scene> room = builtinScene("room");
    ::unsetenv("CREVICE_MODELS");
    return room;
}

const char* const kTetrahedron =
    "v -1 -1 -1\nv 1 -1 -1\nv 0 -1 1\nv 0 1 0\n"
    "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

}  // namespace

TEST_CASE("bounds hold every instance and ignore vertices that no triangle uses")
{
    Scene scene;
    MeshDesc mesh;
    mesh.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{99, 99, 99}}};
    mesh.indices = {0, 1, 2};
    scene.meshes = {mesh};
    scene.instances = {{0}, {0, glm::translate(glm::mat4(1), {0, 0, -5}), 0}};
    CHECK(scene.bounds().min == glm::dvec3(0, 0, -5));
    CHECK(scene.bounds().max == glm::dvec3(1, 1, 0));
    CHECK(Scene().bounds().empty());
}

TEST_CASE("bounds of turned instances are those of their corners, not of their boxes' corners")
{
    Scene scene;
    MeshDesc mesh;
    mesh.vertices = {{{1, 0, 0}}, {{0, 1, 0}}, {{-1, -1, 0}}};
    mesh.indices = {0, 1, 2};
    scene.meshes = {mesh};
    Bounds each;  // corner by corner
    for (int k = 0; k < 100; ++k) {
        const glm::dvec3 to = {k % 10, k / 10, 0};
        const glm::dvec3 axis = {1, 2, k % 3};
        scene.instances.push_back(
            {0, glm::rotate(glm::translate(glm::dmat4(1), to), k * 0.7, glm::normalize(axis))});
        for (const glm::vec3& corner : MeshCorners(mesh).places)
            each.add(scene.instances.back().place(corner));
    }
    CHECK(scene.bounds() == each);
}

TEST_CASE("bounds of many instances do not walk all of their triangles")
{
    struct Counted : Bounds {
        long long added = 0;
        void add(const glm::dvec3& point) { Bounds::add(point), ++added; }
    };
    Scene scene;
    scene.meshes.resize(1);
    constexpr int kCorners = 3000, kInstances = 5000;
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const auto x = static_cast<float>(std::cos(k * 0.1)), y = static_cast<float>(std::sin(k));
        scene.meshes[0].vertices.push_back({{x, y, 0}});
        scene.meshes[0].indices.push_back(k);
    }
    for (int k = 0; k < kInstances; ++k)
        scene.instances.push_back(
            {0, glm::translate(glm::dmat4(1), glm::dvec3(k % 70, k / 70, 0))});
    Counted hull;
    scene.addCorners(hull);
    CHECK(hull == scene.bounds());
    CHECK(hull.max.x > 69.9);
    CHECK(hull.added < kCorners * kInstances / 10);
}

TEST_CASE("depth planes that are left open hold the whole scene, and little more")
{
    SceneCamera camera;
    for (const bool orthographic : {false, true}) {
        camera.orthographic = orthographic;
        const glm::mat4 clip = clipFromView(camera, {16, 9}, boundsBetween(4, 9));
        CHECK(depthAt(clip, 4) > -1);
        CHECK(depthAt(clip, 9) < 1);
        CHECK(depthAt(clip, 3.7) < -1);
        CHECK(depthAt(clip, 9.3) > 1);
    }
    // Inside of the scene the near plane is one that depth can bear.
    const glm::mat4 inside = clipFromView(SceneCamera(), {16, 9}, boundsBetween(-10, 10));
    CHECK(depthAt(inside, 0.02) > -1);
    CHECK(depthAt(inside, 0.005) < -1);
    CHECK(std::isfinite(depthAt(inside, 10)));
}

TEST_CASE("every projection is finite, whatever the bounds")
{
    for (const Bounds& bounds : {Bounds(), boundsBetween(5, 5), boundsBetween(-9, -4),
                                 boundsBetween(1e-9, 2e-9), boundsBetween(1e9, 2e9)}) {
        for (const bool orthographic : {false, true}) {
            SceneCamera camera;
            camera.orthographic = orthographic;
            const glm::mat4 clip = clipFromView(camera, {16, 9}, bounds);
            CHECK(std::isfinite(glm::determinant(glm::dmat4(clip))));
            CHECK(glm::determinant(glm::dmat4(clip)) != 0);
        }
    }
}

TEST_CASE("a missing scene suggests what was meant")
{
    const TemporaryFolder folder(
        "scene_suggest_in_a_folder_whose_name_is_much_longer_than_any_file_in_it");
    folder.write("teapot.obj", kCube);
    for (const auto& [name, meant] : {std::pair<std::string, const char*>("rom", "'room'"),
                                      {(folder.path / "teepot.obj").string(), "teapot.obj'"},
                                      {"/no/such/folder/teapot.obj", ""}})
        CHECK(has(onlyError(loadScene(name), Code::scene_missing).help, meant));
}

TEST_CASE("what is no scene is broken, and what has no surface is empty")
{
    struct Row {
        Code code;
        const char* name;
        std::string text;
    };
    const Row rows[] = {
        {Code::scene_broken, "empty.obj", ""},
        {Code::scene_broken, "cut.gltf", "{\"asset\""},
        {Code::scene_broken, "cut.glb", std::string("glTF\x02\0\0\0\xff\0\0\0", 12)},
        {Code::scene_broken, "index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"},
        {Code::scene_broken, "scene.unheard_of", "What is this?\n"},
        {Code::scene_empty, "noise.obj", "\x01\x02 what is this\n"},
        {Code::scene_empty, "line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
        {Code::scene_empty, "none.obj", "v nan 0 0\nv 1 nan 0\nv 0 1 nan\nf 1 2 3\n"}};
    for (const Row& row : rows) {
        INFO(row.name);
        onlyError(importText(row.name, row.text), row.code);
    }
    const TemporaryFolder folder("scene_is_folder");
    onlyError(importScene(folder.path.string()), Code::scene_broken);
}

TEST_CASE("OBJ materials bring their colour and highlight, and a lost .mtl does no harm")
{
    const TemporaryFolder folder("scene_mtl");
    folder.write("shiny.mtl", "newmtl shiny\nKd .1 .2 .3\nKs .4 .5 .6\nNs 50\n");
    const std::string body = std::string("usemtl shiny\n") + kCube;
    const Scene scene = need(importScene(folder.write("a.obj", "mtllib shiny.mtl\n" + body)));
    const SceneMaterial& material = materialOf(scene);
    CHECK(material.base_color == glm::vec4(0.1f, 0.2f, 0.3f, 1));
    CHECK(material.specular == glm::vec3(0.4f, 0.5f, 0.6f));
    CHECK(material.shininess == 50);
    const Result<Scene> lost = importScene(folder.write("b.obj", "mtllib lost.mtl\n" + body));
    CHECK(has(onlyWarning(lost, Code::scene_features).message, "lost.mtl'"));
}

TEST_CASE("the alpha of map_Kd cuts holes where it is clear or solid, and is named where it is not")
{
    const TemporaryFolder folder("scene_alpha");
    const auto read = [&](int alpha) {
        std::filesystem::create_directories(folder.path / "images");
        Image picture({1, 2}, 4, 1.0f);
        picture.at(0, 0, 3) = static_cast<float>(alpha) / 255;
        need(writePng((folder.path / "images/a.png").string(), picture));
        folder.write("a.mtl", "newmtl a\nmap_Kd images\\a.png \n");
        return importScene(folder.write("a.obj", std::string("mtllib a.mtl\nusemtl a\n") + kCube));
    };
    CHECK(materialOf(need(read(0))).alpha_cutoff > 0);
    const Result<Scene> vague = read(100);
    CHECK(has(onlyWarning(vague, Code::scene_features).message, "alpha of map_Kd"));
    CHECK(materialOf(*vague).alpha_cutoff == 0);
    CHECK(materialOf(*vague).base_color_texture >= 0);
}

TEST_CASE("faces that are strips or lack, and colours of facets, are named as what they are")
{
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n";
    const auto strips = importText(
        "a.ply", head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n");
    CHECK(has(onlyError(strips, Code::scene_broken).message, "strips"));
    onlyError(importText("b.ply", head + "end_header\n0\n"), Code::scene_empty);
    std::string facet(134, '\0');  // of a coloured STL: a header, a count, and one facet
    facet.replace(0, 10, "COLOR=\x10\x20\x30\xff");
    facet[80] = 1;
    facet[133] = '\x80';  // it has a colour of its own, or has none
    for (const auto& [corner, axis] : {std::pair(1, 0), {2, 1}}) {
        const float one = 1;
        std::memcpy(&facet[84 + 12 + 12 * corner + 4 * axis], &one, sizeof one);
    }
    const Diagnostic colored = onlyWarning(importText("c.stl", facet), Code::scene_features);
    CHECK(has(colored.message, "colours of facets"));
}

TEST_CASE("a file without lights can be seen, and importing it adds none")
{
    const TemporaryFolder folder("scene_lights");
    const std::string path = folder.write("cube.obj", kCube);
    REQUIRE(loadScene(path).ok());
    CHECK(loadScene(path)->lights.size() == 1);
    CHECK(importScene(path)->lights.empty());
}

TEST_CASE("a file has one warning that counts what faces the wrong way, or none")
{
    const std::string cube = kCube, corners = cube.substr(0, cube.find('f'));
    const std::string inside_out =
        "f 2 3 4 1\nf 8 7 6 5\nf 5 6 2 1\nf 3 7 8 4\nf 4 8 5 1\nf 6 7 3 2\n";
    const std::string away =
        "v 0 0 -3\nv 5 0 -3\nv 5 5 -3\nv 0 1 -3\nvn 0 0 1\nvn 0 0 -1\n"
        "f -4//1 -3//1 -2//1\nf -4//2 -2//2 -1//2\n";
    const Result<Scene> wrong = importText("wrong.obj", corners + inside_out + away);
    const std::string message = onlyWarning(wrong, Code::scene_features).message;
    for (const char* const count : {" 1 of its triangles", " 1 of its closed surfaces"})
        CHECK(has(message, count));
    CHECK(importText("right.obj", cube).diagnostics().empty());
}

TEST_CASE("a fan around one vertex does not cost its square")
{
    constexpr int kBlades = 30000;  // a quadratic import took a minute for these
    std::string text = "v 0 1 0\n";
    for (int k = 0; k < kBlades; ++k)
        text +=
            vertexLine(std::cos(k * 6.2831853 / kBlades), " 0 ", std::sin(k * 6.2831853 / kBlades));
    for (int k = 0; k < kBlades; ++k)
        text += "f 1 " + std::to_string((k + 1) % kBlades + 2) + " " + std::to_string(k + 2) + "\n";
    const auto begin = std::chrono::steady_clock::now();
    const Scene scene = need(importText("fan.obj", text));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    CHECK(scene.meshes[0].indices.size() == 3 * kBlades);
    CHECK(taken.count() < 30);
}

TEST_CASE("a bunny of one's own is taken first, and a broken one is reported")
{
    const Scene room = need(roomWith(kTetrahedron));
    CHECK(room.meshes[room.instances.back().mesh].indices.size() == 12);
    onlyError(roomWith("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), Code::scene_broken);
}

TEST_CASE("a built-in scene of no known name is missing")
{
    const Diagnostic missing = onlyError(builtinScene("plan"), Code::scene_missing);
    CHECK(missing.help.find("'plane'") != std::string::npos);
}
