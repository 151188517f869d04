// SPDX-License-Identifier: MIT
// Plans as drawings: passes are boxes, textures are ellipses, edges follow the data.
#include "tools/show/plan/names.h"
#include "tools/show/plan/print.h"

#include "core/base/text.h"

#include <algorithm>

namespace crevice {

namespace {

enum class Shape { pass, texture, output };

struct GraphNode {
    std::string id;
    Shape shape;
    std::string label;
    std::string detail = {};
};

struct Graph {
    std::vector<GraphNode> nodes;
    std::vector<std::pair<std::string, std::string>> edges;

    std::string add(GraphNode node);
};

std::string Graph::add(GraphNode node)
{
    const auto same = [&](const GraphNode& each) { return each.id == node.id; };
    const auto known = std::find_if(nodes.begin(), nodes.end(), same);
    if (known != nodes.end()) return known->id;
    nodes.push_back(std::move(node));
    return nodes.back().id;
}

GraphNode targetNode(const Plan& plan, int index)
{
    const PlanTarget& target = plan.targets[index];
    const PlanTexture& texture = textureOf(plan, index);
    return {"target_" + target.name, Shape::texture, target.name,
            std::string(formatInfo(texture.format).name) + " " + sizeText(texture.extent) +
                ", texture " + std::to_string(target.texture) +
                (texture.copies > 1 ? ", one a view" : "")};
}

GraphNode constantNode(const Plan& plan, int index)
{
    const PlanInput input{"", InputKind::constant, index, {}};
    const std::string id = "constant_" + std::to_string(index);
    return {id, Shape::texture, sourceName(plan, input), "constant"};
}

GraphNode inputNode(const Plan& plan, const PlanInput& input)
{
    if (input.kind == InputKind::target) return targetNode(plan, input.index);
    if (input.kind == InputKind::constant) return constantNode(plan, input.index);
    const std::string name = sourceName(plan, input);
    if (input.kind == InputKind::history)
        return {"history_" + name, Shape::texture, name, "of the last frame"};
    const std::string kind = nameOf(input.kind);
    return {kind + "_" + name, Shape::texture, name, kind};
}

void addPass(const Plan& plan, const PlanPass& pass, Graph& graph)
{
    std::string detail =
        plan.programs[pass.program].label + " " + sizeText(pass.extent) + samplesText(pass.samples);
    if (plan.views > 1) detail += ", " + std::to_string(plan.views) + " views";
    const std::string id = graph.add({"pass_" + pass.name, Shape::pass, pass.name, detail});
    for (const PlanInput& input : pass.inputs)
        graph.edges.emplace_back(graph.add(inputNode(plan, input)), id);
    const auto write = [&](const PlanAttachment& attachment) {
        if (attachment.target < 0) return;
        graph.edges.emplace_back(id, graph.add(targetNode(plan, attachment.target)));
    };
    for (const PlanAttachment& color : pass.color) write(color);
    if (pass.has_depth && !isMasked(pass)) write(pass.depth);
}

Graph graphOf(const Plan& plan)
{
    Graph graph;
    for (const PlanPass& pass : plan.passes) addPass(plan, pass, graph);
    for (const PlanOutput& output : plan.outputs) {
        const std::string id = graph.add({"output_" + output.name, Shape::output, output.name});
        graph.edges.emplace_back(
            graph.add(output.constant >= 0 ? constantNode(plan, output.constant)
                                           : targetNode(plan, output.target)),
            id);
    }
    return graph;
}

// `text` in double quotes, as Graphviz reads it.
std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c == '\n' ? "\\n" : std::string(1, c);
    }
    return result + "\"";
}

std::string dotNode(const GraphNode& node)
{
    const char* const shape = node.shape == Shape::pass      ? "box"
                              : node.shape == Shape::texture ? "ellipse"
                                                             : "plaintext";
    const std::string label = node.detail.empty() ? node.label : node.label + "\n" + node.detail;
    return "  \"" + node.id + "\" [shape=" + shape + ", label=" + quoted(label) + "];\n";
}

}  // namespace

std::string toDot(const Plan& plan)
{
    const Graph graph = graphOf(plan);
    std::string text = "digraph " + quoted(printableLine(plan.config)) + " {\n  rankdir=LR;\n";
    for (const GraphNode& node : graph.nodes) text += dotNode(node);
    for (const auto& [from, to] : graph.edges) text += "  \"" + from + "\" -> \"" + to + "\";\n";
    return text + "}\n";
}

}  // namespace crevice
