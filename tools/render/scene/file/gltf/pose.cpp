// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/gltf/file.h"

#include "core/base/text.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace crevice {

namespace {

// What an animation may change of a node.
struct Placement {
    std::vector<double> translation, rotation, scale, weights;
};

// The values of a channel at a time. Cubic splines have a tangent before and after each value.
std::vector<double> valueAt(const GltfFile& file, const tinygltf::AnimationSampler& sampler,
                            bool rotates, double time_s)
{
    const std::vector<float> times = file.numbers(sampler.input, 1);
    const int components =
        tinygltf::GetNumComponentsInType(std::uint32_t(file.accessor(sampler.output).type));
    const std::vector<float> values = file.numbers(sampler.output, components);
    const bool cubic = sampler.interpolation == "CUBICSPLINE";
    const std::size_t parts = cubic ? 3 : 1;
    const std::size_t width = times.empty() ? 0 : values.size() / times.size() / parts;
    if (width == 0) throw BrokenGltf("an animation has no values");
    const auto part = [&](std::size_t key, std::size_t which) {
        const float* const at = &values[(key * parts + which) * width];
        return std::vector<double>(at, at + width);
    };
    const std::size_t middle = cubic ? 1 : 0;
    const auto after = std::upper_bound(times.begin(), times.end(), time_s);
    if (after == times.begin()) return part(0, middle);
    const auto from = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end() || sampler.interpolation == "STEP") return part(from, middle);
    const double span = double{*after} - times[from], t = (time_s - times[from]) / span;
    std::vector<double> a = part(from, middle);
    const std::vector<double> b = part(from + 1, middle);
    if (rotates && !cubic && width == 4) {
        const glm::dquat turned =
            glm::slerp(glm::dquat(a[3], a[0], a[1], a[2]), glm::dquat(b[3], b[0], b[1], b[2]), t);
        return {turned.x, turned.y, turned.z, turned.w};
    }
    const std::vector<double> out = part(from, parts - 1), in = part(from + 1, 0);
    for (std::size_t k = 0; k < width; ++k) {
        const double t2 = t * t, t3 = t2 * t;
        a[k] = cubic ? (2 * t3 - 3 * t2 + 1) * a[k] + span * (t3 - 2 * t2 + t) * out[k] +
                           (3 * t2 - 2 * t3) * b[k] + span * (t3 - t2) * in[k]
                     : a[k] + t * (b[k] - a[k]);
    }
    return a;
}

template <class T>
std::vector<std::string> namesOf(const std::vector<T>& list)
{
    std::vector<std::string> names;
    for (std::size_t k = 0; k < list.size(); ++k)
        names.push_back(list[k].name.empty() ? std::to_string(k) : "'" + list[k].name + "'");
    return names;
}

// The index of that name, or that number; `otherwise` where nothing is wanted.
template <class T>
Result<std::size_t> chosen(const std::vector<T>& list, const std::string& wanted, const char* kind,
                           int otherwise)
{
    if (wanted.empty()) return static_cast<std::size_t>(std::max(otherwise, 0));
    for (std::size_t k = 0; k < list.size(); ++k)
        if (list[k].name == wanted) return k;
    for (std::size_t k = 0; k < list.size(); ++k)
        if (std::to_string(k) == wanted) return k;
    return Diagnostic{Code::usage, std::string("the file has no ") + kind + " '" + wanted + "'",
                      list.empty() ? "it has none" : "it has " + joined(namesOf(list))};
}

// Of several, what may be chosen instead, and how.
template <class T>
void nameOthers(const std::vector<T>& list, const std::string& wanted, std::size_t taken,
                const char* kind, const char* option, LeftOut& left_out)
{
    if (list.size() < 2 || !wanted.empty()) return;
    std::vector<std::string> others = namesOf(list);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(std::min(taken, list.size() - 1)));
    constexpr std::size_t kMostNames = 6;
    const std::size_t more = others.size() - std::min(others.size(), kMostNames);
    others.resize(others.size() - more);
    left_out.shape.insert(std::string("its other ") + kind + "s, " + joined(others) +
                          (more > 0 ? " and " + std::to_string(more) + " more (" : " (") + option +
                          ")");
}

void animate(const GltfFile& file, const tinygltf::Animation& animation, double time_s,
             std::vector<Placement>& nodes)
{
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
        const auto node = static_cast<std::size_t>(channel.target_node);
        const auto sampler = static_cast<std::size_t>(channel.sampler);
        if (node >= nodes.size() || sampler >= animation.samplers.size()) continue;
        const std::string& path = channel.target_path;
        std::vector<double> value =
            valueAt(file, animation.samplers[sampler], path == "rotation", time_s);
        std::vector<double>* const changed = path == "translation" ? &nodes[node].translation
                                             : path == "rotation"  ? &nodes[node].rotation
                                             : path == "scale"     ? &nodes[node].scale
                                             : path == "weights"   ? &nodes[node].weights
                                                                   : nullptr;
        if (changed) *changed = std::move(value);
    }
}

glm::dmat4 matrixOf(const tinygltf::Node& node, const Placement& at)
{
    const bool placed = !at.translation.empty() || !at.rotation.empty() || !at.scale.empty();
    if (node.matrix.size() == 16 && !placed) return glm::make_mat4(node.matrix.data());
    glm::dmat4 matrix(1.0);
    if (at.translation.size() == 3)
        matrix = glm::translate(matrix, glm::make_vec3(at.translation.data()));
    if (at.rotation.size() == 4) {
        const glm::dquat turned(at.rotation[3], at.rotation[0], at.rotation[1], at.rotation[2]);
        if (glm::length(turned) > 0) matrix *= glm::mat4_cast(glm::normalize(turned));
    }
    if (at.scale.size() == 3) matrix = glm::scale(matrix, glm::make_vec3(at.scale.data()));
    return matrix;
}

// Roots of the scene; without any, of nodes that are no child.
std::vector<int> rootsOf(const tinygltf::Model& model, std::size_t scene)
{
    if (scene < model.scenes.size()) return model.scenes[scene].nodes;
    std::vector<bool> child(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes)
        for (const int below : node.children)
            if (std::size_t(below) < child.size()) child[std::size_t(below)] = true;
    std::vector<int> roots;
    for (std::size_t k = 0; k < child.size(); ++k)
        if (!child[k]) roots.push_back(static_cast<int>(k));
    return roots;
}

}  // namespace

Result<std::vector<PosedNode>> posedNodes(const GltfFile& file, const ImportOptions& options,
                                          LeftOut& left_out)
{
    const tinygltf::Model& model = file.model();
    const std::vector<tinygltf::Node>& nodes = model.nodes;
    const auto animation = chosen(model.animations, options.animation, "animation", 0);
    const auto scene = chosen(model.scenes, options.file_scene, "scene", model.defaultScene);
    if (!animation) return animation.diagnostics();
    if (!scene) return scene.diagnostics();
    nameOthers(model.animations, options.animation, *animation, "animation", "--animation",
               left_out);
    nameOthers(model.scenes, options.file_scene, *scene, "scene", "--file-scene", left_out);
    const bool moves = options.pose_s || !options.animation.empty();
    std::vector<Placement> placements;
    for (const tinygltf::Node& node : nodes)
        placements.push_back({node.translation, node.rotation, node.scale, node.weights});
    const bool any = !model.animations.empty();
    if (any && moves)
        animate(file, model.animations[*animation], options.pose_s.value_or(0), placements);
    if (!any && moves) left_out.shape.insert("the moment of --time: it has no animation");
    if (any && !moves) left_out.shape.insert("its animation (--time SECONDS draws a moment of it)");

    std::vector<PosedNode> posed(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        posed[k].parent_from_node = matrixOf(nodes[k], placements[k]);
        posed[k].weights = placements[k].weights;
    }
    struct Open {
        int node;
        glm::dmat4 world_from_parent;
        bool drawn;
    };
    std::vector<Open> open;
    std::vector<bool> seen(nodes.size());
    for (const int root : rootsOf(model, *scene)) open.push_back({root, glm::dmat4(1.0), true});
    while (!open.empty()) {
        const Open at = open.back();
        open.pop_back();
        const auto index = static_cast<std::size_t>(at.node);
        if (index < nodes.size() && seen[index]) left_out.shape.insert("nodes at a second parent");
        if (index >= nodes.size() || seen[index]) continue;
        seen[index] = true;
        const json& shown = member(
            extensionOf(entryOf(file.list("nodes"), at.node), "KHR_node_visibility"), "visible");
        posed[index].world_from_node = at.world_from_parent * posed[index].parent_from_node;
        posed[index].drawn = at.drawn && shown != false;
        for (const int child : nodes[index].children)
            open.push_back({child, posed[index].world_from_node, posed[index].drawn});
    }
    return posed;
}

std::vector<glm::dmat4> jointsOf(const GltfFile& file, int skin,
                                 const std::vector<PosedNode>& nodes)
{
    if (skin < 0 || std::size_t(skin) >= file.model().skins.size()) return {};
    const tinygltf::Skin& from = file.model().skins[std::size_t(skin)];
    std::vector<float> inverse;
    if (from.inverseBindMatrices >= 0) inverse = file.numbers(from.inverseBindMatrices, 16);
    std::vector<glm::dmat4> joints;
    for (std::size_t k = 0; k < from.joints.size(); ++k) {
        const auto joint = static_cast<std::size_t>(from.joints[k]);
        if (joint >= nodes.size()) throw BrokenGltf("a skin has a joint that is no node");
        glm::dmat4 joint_from_model(1.0);
        if (inverse.size() >= 16 * (k + 1)) joint_from_model = glm::make_mat4(&inverse[16 * k]);
        joints.push_back(nodes[joint].world_from_node * joint_from_model);
    }
    return joints;
}

}  // namespace crevice
