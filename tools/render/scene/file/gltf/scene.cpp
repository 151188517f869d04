// SPDX-License-Identifier: MIT
// A glTF file as a scene: meshes at nodes, cameras and lights.
#include "core/frame/frame_math.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/gltf/file.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace crevice {

namespace {

struct Made {
    int mesh = 0, material = 0;
};

class Builder {
public:
    Builder(const GltfFile& file, const std::string& path, SceneFolder& folder, ReadScene& to,
            Diagnostics& warnings, LeftOut& left_out)
        : file_(file),
          path_(path),
          bytes_(folder.bytes()),
          to_(to),
          textures_(path, folder, to.scene, warnings),
          materials_(file, textures_, to.scene, left_out)
    {
    }

    Status addNodes(const std::vector<PosedNode>& nodes)
    {
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (nodes[k].drawn)
                if (Status added = addMesh(int(k), nodes); !added) return added;
        return {};
    }

private:
    Status addMesh(int index, const std::vector<PosedNode>& nodes)
    {
        const tinygltf::Node& node = file_.model().nodes[std::size_t(index)];
        if (node.mesh < 0) return {};
        if (std::size_t(node.mesh) >= file_.model().meshes.size())
            throw BrokenGltf("node " + std::to_string(index) + " has a mesh that is not there");
        const tinygltf::Mesh& mesh = file_.model().meshes[std::size_t(node.mesh)];
        const PosedNode& posed = nodes[std::size_t(index)];
        Bending bending = {posed.weights.empty() ? mesh.weights : posed.weights,
                           jointsOf(file_, node.skin, nodes)};
        const bool skinned = !bending.joints.empty();
        const std::vector<glm::dmat4> places =
            instances(index, skinned ? glm::dmat4(1.0) : posed.world_from_node);
        for (std::size_t k = 0; k < mesh.primitives.size(); ++k) {
            const std::optional<Made> made = meshFor(node.mesh, int(k), bending);
            if (!made) continue;
            const MeshDesc& drawn = to_.scene.meshes[std::size_t(made->mesh)];
            drawn_ += static_cast<double>(drawn.indices.size() / 3 * places.size());
            for (const glm::dmat4& place : places)
                if (isFinite(place))
                    to_.scene.instances.push_back({made->mesh, place, made->material});
            if (Status fits = checkCounts(); !fits) return fits;
        }
        return {};
    }

    Status checkCounts() const
    {
        const SceneLimits limits = sceneLimits(bytes_);
        const std::tuple<const char*, double, double> counts[] = {
            {"triangles at all nodes", drawn_, limits.drawn},
            {"meshes at all places", double(to_.scene.instances.size()), limits.nodes}};
        for (const auto& [what, count, limit] : counts)
            if (count > limit) return overLimit(path_, what, count, limit, bytes_);
        return {};
    }

    // Bent ones are each their own.
    std::optional<Made> meshFor(int mesh, int primitive, const Bending& bending)
    {
        const bool bent = !bending.joints.empty() || !bending.weights.empty();
        const auto key = std::pair(mesh, primitive);
        const auto known = made_.find(key);
        if (!bent && known != made_.end()) return known->second;
        std::optional<GltfMesh> read = gltfMesh(file_, mesh, primitive, bending, materials_);
        std::optional<Made> made;
        if (read) {
            to_.dropped += read->dropped;
            to_.turned += read->turned;
            made = Made{static_cast<int>(to_.scene.meshes.size()), read->material};
            to_.scene.meshes.push_back(std::move(read->mesh));
        }
        if (!bent) made_[key] = made;
        return made;
    }

    std::vector<glm::dmat4> instances(int index, const glm::dmat4& world_from_node) const
    {
        const json& attributes =
            member(extensionOf(entryOf(file_.list("nodes"), index), "EXT_mesh_gpu_instancing"),
                   "attributes");
        if (!attributes.is_object()) return {world_from_node};
        const auto numbers = [&](const char* name, int components) {
            const int accessor = indexOf(member(attributes, name));
            return accessor < 0 ? std::vector<float>() : file_.numbers(accessor, components);
        };
        const std::vector<float> moved = numbers("TRANSLATION", 3), turned = numbers("ROTATION", 4),
                                 scaled = numbers("SCALE", 3);
        const std::size_t count =
            std::max({moved.size() / 3, turned.size() / 4, scaled.size() / 3});
        std::vector<glm::dmat4> places(count, world_from_node);
        for (std::size_t k = 0; k < count; ++k) {
            glm::dmat4& place = places[k];
            if (moved.size() >= 3 * (k + 1))
                place = glm::translate(place, glm::dvec3(glm::make_vec3(&moved[3 * k])));
            if (turned.size() >= 4 * (k + 1)) {
                const float* const q = &turned[4 * k];
                place *= glm::mat4_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
            }
            if (scaled.size() >= 3 * (k + 1))
                place = glm::scale(place, glm::dvec3(glm::make_vec3(&scaled[3 * k])));
        }
        return places;
    }

    const GltfFile& file_;
    const std::string& path_;
    std::uint64_t bytes_;
    ReadScene& to_;
    SceneTextures textures_;
    GltfMaterials materials_;
    std::map<std::pair<int, int>, std::optional<Made>> made_ = {};
    double drawn_ = 0;
};

// Where a camera or light looks: along -z of its node, whose scale is none.
struct Looking {
    glm::dvec3 eye, forward, up;
};

Looking lookingFrom(const glm::dmat4& world_from_node)
{
    const auto along = [&](const glm::dvec3& axis) {
        const glm::dvec3 world = glm::dmat3(world_from_node) * axis;
        const double length = glm::length(world);
        return length > 0 && std::isfinite(length) ? world / length : axis;
    };
    return {glm::dvec3(world_from_node[3]), along({0, 0, -1}), along({0, 1, 0})};
}

// Names that several cameras have get a number, so that each can be chosen.
std::string cameraName(const tinygltf::Node& node, const tinygltf::Camera& camera,
                       const Scene& scene)
{
    const std::string name = !node.name.empty()     ? node.name
                             : !camera.name.empty() ? camera.name
                                                    : "camera";
    std::string numbered = name;
    for (int k = 2; findNamed(scene.cameras, numbered); ++k)
        numbered = name + "#" + std::to_string(k);
    return numbered;
}

void addCameras(const GltfFile& file, const std::vector<PosedNode>& nodes, Scene& scene)
{
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const tinygltf::Node& node = file.model().nodes[k];
        if (node.camera < 0 || std::size_t(node.camera) >= file.model().cameras.size()) continue;
        if (!nodes[k].drawn) continue;
        const tinygltf::Camera& from = file.model().cameras[std::size_t(node.camera)];
        SceneCamera camera;
        camera.name = cameraName(node, from, scene);
        const auto& [eye, forward, up] = lookingFrom(nodes[k].world_from_node);
        camera.view_from_world = viewAlong(eye, forward, up);
        camera.orthographic = from.type == "orthographic";
        const auto& [flat, deep] = std::tie(from.orthographic, from.perspective);
        if (std::abs(flat.ymag) > 0) camera.half_height = std::abs(flat.ymag);
        if (deep.yfov > 0 && deep.yfov < 3.14) camera.fov_y_rad = deep.yfov;
        camera.near_distance = std::max(camera.orthographic ? flat.znear : deep.znear, 0.0);
        camera.far_distance = camera.orthographic ? flat.zfar : deep.zfar;
        scene.cameras.push_back(std::move(camera));
    }
}

void addLights(const GltfFile& file, const std::vector<PosedNode>& nodes, Scene& scene)
{
    constexpr const char* kLights = "KHR_lights_punctual";
    const json& lights = member(extensionOf(file.document(), kLights), "lights");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const json& use = extensionOf(entryOf(file.list("nodes"), int(k)), kLights);
        const json& from = entryOf(lights, member(use, "light"));
        if (!from.is_object() || !nodes[k].drawn) continue;
        const Looking at = lookingFrom(nodes[k].world_from_node);
        const json &type = member(from, "type"), &spot = member(from, "spot");
        SceneLight light;
        light.name = file.model().nodes[k].name;
        light.light.directional = type == "directional";
        light.light.spot = type == "spot";
        light.light.position = at.eye;
        light.light.direction = at.forward;
        light.light.attenuation = {0, 0, 1};
        const double outer = numberOf(member(spot, "outerConeAngle"), glm::pi<double>() / 4);
        const double inner = numberOf(member(spot, "innerConeAngle"), 0);
        if (light.light.spot) {
            light.light.outer_angle_rad =
                static_cast<float>(std::clamp(outer, 0.0, glm::pi<double>()));
            light.light.inner_angle_rad = static_cast<float>(std::clamp(inner, 0.0, outer));
        }
        const double intensity = numberOf(member(from, "intensity"), 1);
        for (int c = 0; c < 3; ++c)
            light.light.color[c] =
                static_cast<float>(intensity * numberOf(entryOf(member(from, "color"), c), 1));
        scene.lights.push_back(std::move(light));
    }
}

}  // namespace

Result<ReadScene> readGltf(const std::string& path, const ImportOptions& options,
                           SceneFolder& folder, Diagnostics& warnings)
{
    Result<GltfFile> file = GltfFile::parse(path);
    if (!file) return file.diagnostics();
    Status readable = checkRequired(file->document(), path);
    if (readable) readable = file->load(path, folder);
    if (!readable) return readable.diagnostics();
    LeftOut left_out = leftOutOf(file->document());
    const Result<std::vector<PosedNode>> posed = posedNodes(*file, options, left_out);
    if (!posed) return posed.diagnostics();
    const std::vector<PosedNode>& nodes = *posed;
    ReadScene read;
    Builder builder(*file, path, folder, read, warnings, left_out);
    if (Status added = builder.addNodes(nodes); !added) return added.diagnostics();
    addCameras(*file, nodes, read.scene);
    addLights(*file, nodes, read.scene);
    if (left_out.any()) warnings.push_back(left_out.warning(path));
    return read;
}

}  // namespace crevice
