// SPDX-License-Identifier: MIT
// Scenes and cameras of stress cases.
#include "tools/measure/stress/scenes.h"

#include "tools/render/host_textures.h"
#include "tools/render/scene/mesh_shapes.h"
#include "tools/render/scene_upload.h"

#include "core/frame/frame_math.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <tuple>

namespace crevice {
namespace {

constexpr float kSunk = 0.01f;  // what stands on the floor reaches that far into it

void add(Scene& scene, MeshDesc mesh, const glm::dmat4& placed_at = glm::dmat4(1.0))
{
    mesh.label = "object";
    const glm::mat3 turn = normalMatrix(placed_at);
    for (Vertex& vertex : mesh.vertices) {
        const glm::dvec4 at(vertex.position[0], vertex.position[1], vertex.position[2], 1.0);
        const glm::vec3 position(placed_at * at);
        const glm::vec3 normal =
            turn * glm::vec3(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
        for (int i = 0; i < 3; ++i) {
            vertex.position[i] = position[i];
            vertex.normal[i] = normal[i];
        }
    }
    if (glm::determinant(glm::dmat3(placed_at)) < 0.0)  // front faces stay front faces
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    scene.meshes.push_back(std::move(mesh));
    SceneInstance instance;
    instance.mesh = static_cast<int>(scene.meshes.size()) - 1;
    scene.instances.push_back(instance);
}

/// The matte material and the lights that all scenes have.
Scene emptyScene()
{
    Scene scene;
    scene.materials.resize(1);
    scene.materials[0].specular = glm::vec3(0.2f);
    SceneLight scene_light;
    scene_light.light.position = {1, 2.5f, 2};
    scene_light.light.attenuation = {1.0f, 0.09f, 0.032f};
    SceneLight sky;
    sky.light.directional = true;
    sky.light.direction = glm::normalize(glm::vec3(-0.4f, -0.8f, -0.6f));
    scene.lights = {scene_light, sky};
    return scene;
}

glm::dmat4 turned(double x, double z, double degrees)
{
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), {x, -kSunk, z});
    return glm::rotate(moved, glm::radians(degrees), {0, 1, 0});
}

/// Half of the picture's height at distance 1.
double halfHeight(const StressView& view) { return std::tan(glm::radians(view.fov_degrees) / 2); }

double aspectOf(Extent size) { return static_cast<double>(size.width) / size.height; }

glm::dmat4 perspective(const StressView& view, Extent size)
{
    const double half = halfHeight(view), near = view.near_distance, far = view.far_distance;
    glm::dmat4 clip(0.0);
    clip[0][0] = 1 / (half * aspectOf(size));
    clip[1][1] = 1 / half;
    clip[2][3] = -1;
    clip[2][2] = view.infinite ? -1 : -(far + near) / (far - near);
    clip[3][2] = view.infinite ? -2 * near : -2 * far * near / (far - near);
    return clip;
}

/// Where the plane ends, off its middle: to the sides, and up or down its slope.
struct PlaneReach {
    double across, along;
};

PlaneReach planeReach(const StressView& view, Extent size, double distance, double cosine)
{
    constexpr double kMargin = 1.5;
    if (view.half_height > 0) {
        const double along = kMargin * view.half_height / cosine;
        return {kMargin * view.half_height * aspectOf(size), along};
    }
    const double half = halfHeight(view) * distance * kMargin;
    const double along = std::min(half / cosine, std::max(15 * distance, half));
    return {half * aspectOf(size) * (1 + along / distance), along};
}

const char* const kWhite = R"(#version 300 es
precision mediump float;
layout(location = 0) out vec4 albedo;
void main()
{
    albedo = vec4(0.8);
}
)";

const char* const kNoGuardBand =
    R"("guard_band": {"type": "float", "default": 1, "min": 1, "max": 2, "bind": "define"})";

// The host's textures have no guard band; its albedo is the same everywhere.
std::string overHost(const std::string& module)
{
    return R"({"format": 1, "name": ")" + module + R"(", "description": "A host's own.",
        "extends": [")" +
           module + R"("], "params": {)" + kNoGuardBand + R"(},
        "targets": {"albedo": {"format": ["rgba8"]}},
        "shaders": {"host_albedo": {"vertex": "common/fullscreen.vert", "fragment": "host/albedo.frag"}},
        "passes": {"host_albedo": {
            "type": "fullscreen", "shader": "host_albedo", "color": ["albedo"]}}})";
}

MemorySources hostModules()
{
    MemorySources modules;
    modules.add("geometry/depth_normal.json", overHost("geometry/host_depth_normal"));
    modules.add("geometry/depth_only.json", overHost("geometry/host_depth"));
    modules.add("host/albedo.frag", kWhite);
    return modules;
}

// The module that stores linear depth extends the one that it stands in for.
MemorySources linearModules(const SourceSet& sources)
{
    const char* const kDrawn = "geometry/depth_normal";
    const std::string path = std::string(kDrawn) + ".json";
    MemorySources modules;
    const SourceRef drawn = sources.find(path);
    const SourceRef linear = sources.find("geometry/linear_depth_normal.json");
    if (!drawn || !linear) return modules;
    std::string text = linear->text;
    text.replace(text.find(kDrawn), std::string(kDrawn).size(), "geometry/drawn");
    modules.add(path, text);
    modules.add("geometry/drawn.json", drawn->text);
    return modules;
}

// In the finest formats, so that what differs is the way to the points.
MemorySources positionModules()
{
    MemorySources modules;
    modules.add(
        "geometry/depth_normal.json", std::string(R"({"format": 1, "name": "geometry/depth_normal",
        "description": "Stored positions.", "extends": ["geometry/position_normal"],
        "params": {)") + kNoGuardBand + R"(},
        "targets": {"position": {"format": ["rgba32f", "rgba16f"]}}})");
    return modules;
}

MemorySources depthModules()
{
    MemorySources modules;
    modules.add("geometry/position_normal.json",
                R"({"format": 1, "name": "geometry/position_normal",
        "description": "Depth and normals.", "extends": ["geometry/depth_normal"],
        "targets": {"depth": {"format": ["depth32f", "depth24"]},
                    "normal": {"format": ["rgba16f", "rgb10_a2"]}}})");
    return modules;
}

}  // namespace

Camera cameraOf(const StressView& view, Extent size)
{
    const double wide = view.half_height * aspectOf(size), high = view.half_height;
    glm::dmat4 clip = view.half_height > 0 ? glm::orthoRH_NO(-wide, wide, -high, high,
                                                             view.near_distance, view.far_distance)
                                           : perspective(view, size);
    if (view.reversed)
        for (int column = 0; column < 4; ++column) clip[column][2] = -clip[column][2];
    const double shift = 2.0 * view.shift_px / size.width;
    for (int column = 0; column < 4; ++column) clip[column][0] -= shift * clip[column][3];
    return {glm::translate(glm::dmat4(1.0), -view.eye), glm::mat4(clip)};
}

PlaneView planeView(const StressView& view, Extent size, double distance, double tilt_degrees)
{
    const double s = std::sin(glm::radians(tilt_degrees)), c = std::cos(glm::radians(tilt_degrees));
    const PlaneReach reach = planeReach(view, size, distance, c);
    PlaneView plane = {emptyScene(), Image(size, 1)};
    const glm::dvec3 middle = {0, 0, -distance}, up = glm::dvec3(0, c, -s) * reach.along;
    const glm::dvec3 right = {reach.across, 0, 0};
    add(plane.scene, makeQuad(middle - right - up, right * 2.0, up * 2.0));
    for (Vertex& vertex : plane.scene.meshes[0].vertices) {
        vertex.normal[1] = static_cast<float>(s);
        vertex.normal[2] = static_cast<float>(c);
    }
    const double half = view.half_height > 0 ? view.half_height : halfHeight(view);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double at_x = ((x + 0.5) / size.width * 2 - 1) * half * aspectOf(size);
            const double at_y = ((y + 0.5) / size.height * 2 - 1) * half;
            const bool flat = view.half_height > 0;
            const double z = flat ? distance + at_y * s / c : distance * c / (c - s * at_y);
            const double across = flat ? at_x : at_x * z;
            const double along = ((flat ? at_y : at_y * z) * c + (z - distance) * s);
            const bool seen = z > view.near_distance && z < view.far_distance &&
                              std::abs(across) < reach.across && std::abs(along) < reach.along;
            plane.distances.at(x, y) = seen ? static_cast<float>(z) : 0.0f;
        }
    return plane;
}

Scene testScene()
{
    Scene scene = emptyScene();
    add(scene, makeBox({-6, -0.5f, -3}, {6, 0, 6}));
    add(scene, makeBox({-6, -kSunk, -3.5f}, {6, 6, -2.5f}));
    add(scene, makeBox({-3.5f, -kSunk, -2.6f}, {-2.5f, 6, 6}));
    add(scene, makeBox({-0.5f, 0, -0.4f}, {0.5f, 1.2f, 0.4f}), turned(-1.4, -1.4, 25));
    add(scene, makeBox({-0.4f, 0, -0.4f}, {0.4f, 0.5f, 0.4f}), turned(0.9, 0.6, -15));
    add(scene, makeBox({-0.6f, 0, -0.2f}, {0.6f, 0.3f, 0.2f}), turned(-0.9, 0.9, 60));
    add(scene, makeBox({-0.3f, 0, -0.3f}, {0.3f, 2.2f, 0.3f}), turned(1.9, -1.9, 40));
    add(scene, makeBox({-0.04f, 0, -0.04f}, {0.04f, 1.8f, 0.04f}), turned(1.5, -0.4, 0));
    glm::dmat4 ball = turned(0.3, -1.1, 0);
    ball[3][1] = 0.6 - kSunk;
    add(scene, makeSphere(0.6f, 24), ball);
    return scene;
}

Scene cornerScene()
{
    Scene scene = emptyScene();
    add(scene, makeQuad({-10, 0, 20}, {20, 0, 0}, {0, 0, -20}));
    add(scene, makeQuad({-10, 0, 0}, {20, 0, 0}, {0, 20, 0}));
    return scene;
}

Scene placed(Scene scene, const glm::dmat4& first)
{
    for (SceneInstance& instance : scene.instances)
        instance.world_from_model = first * instance.world_from_model;
    for (SceneLight& scene_light : scene.lights)
        scene_light.light.position =
            glm::dvec3(first * glm::dvec4(scene_light.light.position, 1.0));
    return scene;
}

Scene baked(Scene scene)
{
    Scene all = scene;
    all.meshes.clear();
    all.instances.clear();
    for (const SceneInstance& instance : scene.instances)
        add(all, scene.meshes[instance.mesh], instance.world_from_model);
    return all;
}

Substitutes::Layer::Layer(MemorySources substitutes, const SourceSet& sources)
    : modules(std::move(substitutes)),
      all({&modules, &sources})
{
}

Substitutes::Substitutes(const SourceSet& sources) : own_(sources)
{
    over_.try_emplace(kHostGeometry, hostModules(), sources);
    over_.try_emplace(kPositionGeometry, positionModules(), sources);
    over_.try_emplace(kLinearGeometry, linearModules(sources), sources);
    over_.try_emplace(kDepthGeometry, depthModules(), sources);
}

const SourceSet& Substitutes::over(const std::string& geometry) const
{
    const auto found = over_.find(geometry);
    return found == over_.end() ? own_ : found->second.all;
}

Result<std::shared_ptr<const std::vector<ImportedTexture>>> changedTextures(Device& device,
                                                                            const StressShot& shot)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, shot.scene);
    if (!scene) return scene.diagnostics();
    Frame frame = makeFrame(*scene, SceneCamera(), shot.extent);
    frame.camera = shot.host_camera;
    Description wanted;
    for (const auto& [name, format] :
         {std::pair{"depth", Format::depth32f}, {"normal", Format::rgba16f}}) {
        ImportDesc import;
        import.name = name;
        import.type = ImportType::texture;
        import.format = formatInfo(format).name;
        wanted.imports.push_back(import);
    }
    Result<HostTextures> host = HostTextures::make(device, wanted, shot.extent, frame);
    if (!host) return host.diagnostics();
    const Result<Frame> drawn = host->frameOf(frame);
    if (!drawn) return drawn.diagnostics();
    Result<Image> depth = device.readTexture(drawn->textures[0].texture);
    if (!depth) return depth.diagnostics();
    Result<Image> normal = device.readTexture(drawn->textures[1].texture);
    if (!normal) return normal.diagnostics();
    shot.host(*depth, *normal);

    const std::shared_ptr<std::vector<ImportedTexture>> textures(
        new std::vector<ImportedTexture>, [&device](std::vector<ImportedTexture>* all) {
            for (const ImportedTexture& each : *all) device.destroy(each.texture);
            delete all;
        });
    for (const auto& [name, format, image] :
         {std::tuple{"depth", Format::r32f, &*depth}, {"normal", Format::rgba32f, &*normal}}) {
        const Result<TextureId> id = device.createTexture({name, format, image->extent});
        if (!id) return id.diagnostics();
        textures->push_back({name, *id});
        if (const Status written = device.writeTexture(*id, *image); !written)
            return written.diagnostics();
    }
    return {textures};
}

}  // namespace crevice
