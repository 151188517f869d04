// SPDX-License-Identifier: MIT
// Plans as drawings: passes are boxes, textures are ellipses, edges follow the data.
#include "tools/show/plan/names.h"
#include "tools/show/plan/print.h"

#include "core/base/text.h"

#include <set>

namespace crevice {

namespace {

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

// Nodes and edges as Graphviz reads them.
class Drawing {
public:
    explicit Drawing(const Plan& plan) : plan_(plan) {}

    void addPass(const PlanPass& pass)
    {
        const std::string views =
            plan_.views > 1 ? ", " + std::to_string(plan_.views) + " views" : std::string();
        const std::string box = node("pass_" + pass.name, "box",
                                     pass.name + "\n" + plan_.programs[pass.program].label + " " +
                                         sizeText(pass.extent) + samplesText(pass.samples) + views);
        for (const PlanInput& input : pass.inputs) edge(source(input), box);
        const auto write = [&](const PlanAttachment& attachment) {
            if (attachment.target >= 0) edge(box, target(attachment.target));
        };
        for (const PlanAttachment& color : pass.color) write(color);
        if (pass.has_depth && !isMasked(pass)) write(pass.depth);
    }

    void addOutput(const PlanOutput& output)
    {
        const bool constant = output.constant >= 0;
        const std::string name = node("output_" + output.name, "plaintext", output.name);
        edge(constant ? source({"", InputKind::constant, output.constant, {}})
                      : target(output.target),
             name);
    }

    std::string text() const
    {
        return "digraph " + quoted(printableLine(plan_.config)) + " {\n  rankdir=LR;\n" + nodes_ +
               edges_ + "}\n";
    }

private:
    // The quoted name of a node, which is drawn once.
    std::string node(const std::string& id, const char* shape, const std::string& label)
    {
        if (drawn_.insert(id).second)
            nodes_ += "  " + quoted(id) + " [shape=" + shape + ", label=" + quoted(label) + "];\n";
        return quoted(id);
    }

    std::string target(int index)
    {
        const std::string& name = plan_.targets[index].name;
        const PlanTexture& texture = textureOf(plan_, index);
        return node("target_" + name, "ellipse",
                    name + "\n" + formatInfo(texture.format).name + " " + sizeText(texture.extent) +
                        ", texture " + std::to_string(plan_.targets[index].texture) +
                        (texture.copies > 1 ? ", one a view" : ""));
    }

    std::string source(const PlanInput& input)
    {
        if (input.kind == InputKind::target) return target(input.index);
        const std::string name = sourceName(plan_, input), kind = nameOf(input.kind);
        const bool history = input.kind == InputKind::history;
        return node(kind + "_" + name, "ellipse",
                    name + "\n" + (history ? "of the last frame" : kind));
    }

    void edge(const std::string& from, const std::string& to)
    {
        edges_ += "  " + from + " -> " + to + ";\n";
    }

    const Plan& plan_;
    std::set<std::string> drawn_;
    std::string nodes_, edges_;
};

}  // namespace

std::string toDot(const Plan& plan)
{
    Drawing drawing(plan);
    for (const PlanPass& pass : plan.passes) drawing.addPass(pass);
    for (const PlanOutput& output : plan.outputs) drawing.addOutput(output);
    return drawing.text();
}

}  // namespace crevice
