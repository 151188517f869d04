// SPDX-License-Identifier: MIT
#include "tools/render/scene/builtin_scenes.h"

#include "tools/render/scene/builtin/parts.h"
#include "tools/render/scene/mesh_shapes.h"

#include "core/base/text.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cstdlib>
#include <filesystem>

namespace crevice {

namespace {

constexpr int kSphereRings = 48;
constexpr float kRoomHeight = 2.5f;
constexpr float kRoomHalf = 2.0f;  // half of its width and depth
constexpr float kWallThickness = 0.1f;

void addSphere(Scene& scene, const char* name, float radius, float x, float z, int material)
{
    addObject(scene, name, makeSphere(radius, kSphereRings), material,
              glm::translate(glm::mat4(1.0f), {x, radius - kSunk, z}));
}

std::vector<std::filesystem::path> modelFolders()
{
    std::vector<std::filesystem::path> folders;
    if (const char* models = std::getenv("CREVICE_MODELS")) folders.emplace_back(models);
    const char* data = std::getenv("XDG_DATA_DIRS");
    const std::string list = std::string(data ? data : "") + ":/usr/local/share:/usr/share";
    for (const std::string_view folder : split(list, ':'))
        if (!folder.empty()) folders.push_back(std::filesystem::path(folder) / "glmark2/models");
    return folders;
}

// The bunny alone, between -1 and 1.
Result<MeshDesc> loadBunny()
{
    for (const auto& folder : modelFolders()) {
        std::error_code error;
        const auto path = folder / "bunny.obj";
        if (!std::filesystem::is_regular_file(path, error)) continue;
        Result<Scene> bunny = importScene(path.string());
        if (!bunny) return bunny.diagnostics();
        return std::move(bunny->meshes[bunny->instances.front().mesh]);
    }
    return Diagnostic{Code::scene_missing,
                      "the scene 'room' needs the model 'bunny.obj', which was not found",
                      "install it with 'apt-get install glmark2-data', name its folder in "
                      "CREVICE_MODELS, or take the scene 'spheres'"};
}

// Walls meet edge to edge and stand on a floor that is a little wider, and deeper in it than the
// stairs beside them: no two faces share a plane.
void addRoom(Scene& scene)
{
    const float inner = kRoomHalf, outer = kRoomHalf + kWallThickness;
    const float slab = outer + kWallThickness;
    const float low = 2 * kSunk;
    const int floor = addMaterial(scene, "floor", {0.62f, 0.54f, 0.45f}, 0.08f, 24.0f);
    const int plaster = addMaterial(scene, "plaster", {0.82f, 0.8f, 0.76f});
    const int left = addMaterial(scene, "left wall", {0.72f, 0.42f, 0.36f});
    const int right = addMaterial(scene, "right wall", {0.42f, 0.55f, 0.6f});
    addObject(scene, "floor", makeBox({-slab, -kWallThickness, -slab}, {slab, 0, slab}), floor);
    addObject(scene, "back wall", makeBox({-outer, -low, -outer}, {outer, kRoomHeight, -inner}),
              plaster);
    addObject(scene, "left wall", makeBox({-outer, -low, -inner}, {-inner, kRoomHeight, inner}),
              left);
    addObject(scene, "right wall", makeBox({inner, -low, -inner}, {outer, kRoomHeight, inner}),
              right);
}

void addFurniture(Scene& scene)
{
    const int stone = addMaterial(scene, "stone", {0.6f, 0.62f, 0.6f});
    const int wood = addMaterial(scene, "wood", {0.68f, 0.5f, 0.3f}, 0.1f, 24.0f);
    const int blue = addMaterial(scene, "blue", {0.3f, 0.42f, 0.66f}, 0.15f, 32.0f);
    const int green = addMaterial(scene, "green", {0.4f, 0.6f, 0.36f}, 0.45f, 64.0f);
    constexpr float kStairsWidth = 0.8f;
    addObject(scene, "stairs", makeStairs(5, kStairsWidth, 0.18f, 0.22f), stone,
              standing(kRoomHalf - kStairsWidth / 2 + kSunk, -kRoomHalf + 5 * 0.22f - kSunk, 0));
    addObject(scene, "tall box", makeBlock(0.5f, 1.15f, 0.45f), wood, standing(0.25f, -1.4f, 18));
    addObject(scene, "cube", makeBlock(0.38f, 0.38f, 0.38f), blue, standing(-0.1f, 0.05f, 33));
    addObject(scene, "low box", makeBlock(0.7f, 0.22f, 0.4f), wood, standing(-1.35f, 0.55f, -12));
    addSphere(scene, "sphere", 0.33f, 0.85f, 0.25f, green);
}

Result<Scene> makeRoomScene()
{
    Result<MeshDesc> bunny = loadBunny();
    if (!bunny) return bunny.diagnostics();
    Scene scene;
    addRoom(scene);
    addFurniture(scene);

    constexpr float kBunnyScale = 0.48f;
    float low = 0.0f;
    for (const Vertex& vertex : bunny->vertices) low = std::min(low, vertex.position[1]);
    const glm::mat4 grown = glm::scale(standing(-1.15f, -1.2f, 20), glm::vec3(kBunnyScale));
    const glm::mat4 on_floor = glm::translate(grown, {0, -low, 0});
    addObject(scene, "bunny", std::move(*bunny),
              addMaterial(scene, "ivory", {0.84f, 0.8f, 0.7f}, 0.1f, 24.0f), on_floor);

    addCamera(scene, "main", {0.3f, 1.5f, 3.5f}, {-0.1f, 0.72f, -0.8f});
    addCamera(scene, "close", {-0.75f, 0.8f, 0.7f}, {-1.1f, 0.4f, -1.25f});
    addCamera(scene, "side", {-1.6f, 1.7f, 1.6f}, {0.8f, 0.4f, -1.2f});
    addLights(scene, {0.5f, 2.2f, 1.0f});
    return scene;
}

Scene makePlaneScene()
{
    Scene scene;
    addObject(scene, "floor", makeQuad({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}),
              addMaterial(scene, "floor", {0.7f, 0.7f, 0.7f}));
    addCamera(scene, "main", {0, 3, 4}, {0, 0, 0});
    addCamera(scene, "grazing", {0, 0.5f, 8}, {0, 0.3f, 0});
    addLights(scene, {1.5f, 2.5f, 1.5f});
    return scene;
}

Scene makeCornerScene()
{
    Scene scene;
    addObject(scene, "floor", makeQuad({-10, 0, 20}, {20, 0, 0}, {0, 0, -20}),
              addMaterial(scene, "floor", {0.7f, 0.68f, 0.64f}));
    addObject(scene, "wall", makeQuad({-10, 0, 0}, {20, 0, 0}, {0, 20, 0}),
              addMaterial(scene, "wall", {0.66f, 0.68f, 0.72f}));
    addCamera(scene, "main", {0.8f, 1.4f, 2.8f}, {0, 0.45f, 0});
    addCamera(scene, "close", {0.2f, 0.5f, 1.0f}, {0, 0.1f, 0});
    addLights(scene, {0.8f, 2.2f, 2.0f});
    return scene;
}

Scene makeSpheresScene()
{
    Scene scene;
    addObject(scene, "floor", makeQuad({-8, 0, 8}, {16, 0, 0}, {0, 0, -16}),
              addMaterial(scene, "floor", {0.72f, 0.7f, 0.66f}));
    addSphere(scene, "large", 0.8f, -0.35f, -0.4f,
              addMaterial(scene, "red", {0.72f, 0.34f, 0.28f}, 0.3f, 48.0f));
    addSphere(scene, "middle", 0.45f, 0.85f, 0.2f,
              addMaterial(scene, "white", {0.85f, 0.85f, 0.85f}));
    addSphere(scene, "small", 0.22f, 0.2f, 0.75f,
              addMaterial(scene, "blue", {0.28f, 0.42f, 0.68f}, 0.4f, 64.0f));
    addCamera(scene, "main", {1.0f, 1.7f, 3.2f}, {0.15f, 0.4f, 0});
    addCamera(scene, "close", {0.9f, 0.6f, 1.6f}, {0.3f, 0.2f, 0.3f});
    addLights(scene, {1.2f, 2.4f, 1.6f});
    return scene;
}

}  // namespace

const std::vector<std::string>& builtinSceneNames()
{
    static const std::vector<std::string> names = {"corner", "plane", "room", "spheres", "street"};
    return names;
}

bool isFileScene(const std::string& scene)
{
    return !scene.empty() && !contains(builtinSceneNames(), scene);
}

bool needsFile(std::string_view builtin_scene) { return builtin_scene == "room"; }

Result<Scene> builtinScene(std::string_view name)
{
    Result<Scene> scene =
        Diagnostic{Code::scene_missing, "there is no built-in scene '" + std::string(name) + "'",
                   suggestName(name, builtinSceneNames(), "built-in scenes")};
    if (name == "corner") scene = makeCornerScene();
    if (name == "plane") scene = makePlaneScene();
    if (name == "room") scene = makeRoomScene();
    if (name == "spheres") scene = makeSpheresScene();
    if (name == "street") scene = makeStreetScene();
    if (scene) scene->name = name;
    return scene;
}

}  // namespace crevice
