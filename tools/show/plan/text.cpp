// SPDX-License-Identifier: MIT
// Plans as text for people, and as drawings. Nothing in it changes with the wording of a shader, so
// that tests can keep it.
#include "tools/show/plan/print.h"

#include "core/base/text.h"
#include "core/config/field_types.h"

#include <cmath>
#include <set>

namespace crevice {

const char* nameOf(LoadOp load)
{
    const char* const names[] = {"load", "clear", "discard"};
    return names[static_cast<int>(load)];
}

const char* nameOf(StoreOp store) { return store == StoreOp::store ? "store" : "discard"; }

const char* nameOf(InputKind kind)
{
    const char* const names[] = {"target", "history",  "generated",
                                 "import", "material", "constant"};
    return names[static_cast<int>(kind)];
}

const char* nameOf(UniformSource source)
{
    const char* const names[] = {"param", "frame value", "draw value", "kernel", "box"};
    return names[static_cast<int>(source)];
}

std::string sourceName(const Plan& plan, const PlanInput& input)
{
    switch (input.kind) {
    case InputKind::target:
    case InputKind::history: return plan.targets[input.index].name;
    case InputKind::generated: return plan.generated[input.index].name;
    case InputKind::imported: return plan.imports[input.index].name;
    case InputKind::constant: return shortest(plan.constants[input.index]);
    case InputKind::material: break;
    }
    return input.name;
}

std::string sizeText(const Extent& extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

std::string samplesText(int samples)
{
    return samples == 1 ? "" : ", " + std::to_string(samples) + " samples";
}

std::string bytesText(double bytes)
{
    const char* const units[] = {" KiB", " MiB", " GiB", " TiB"};
    if (bytes < 1024) return std::to_string(std::llround(bytes)) + " bytes";
    int unit = 0;
    for (bytes /= 1024; bytes >= 1024 && unit < 3; bytes /= 1024) ++unit;
    const long long tenths = std::llround(bytes * 10);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + units[unit];
}

std::string counted(std::size_t count, const std::string& what)
{
    return std::to_string(count) + " " + what + (count == 1 ? "" : what == "pass" ? "es" : "s");
}

const PlanTexture& textureOf(const Plan& plan, int target)
{
    return plan.textures[plan.targets[target].texture];
}

namespace {

// Within what a pass with a scissor is drawn.
std::string boundsText(const Plan& plan, const PlanPass& pass)
{
    if (pass.cull_below_pixel < 0) return "the bounds of all draws";
    return "the bounds of draws at which " + plan.params[pass.cull_below_pixel].name +
           " is a pixel or more";
}

// Of a pass that draws volumes.
std::string layersText(const PlanPass& pass)
{
    if (pass.layers == 0) return "";
    return ", drawn " + std::to_string(pass.layers / pass.layers_at_once) + " times for " +
           counted(std::size_t(pass.layers), "layer") +
           (pass.frames > 1 ? ", over " + counted(std::size_t(pass.frames), "frame") : "");
}

std::string readText(const Plan& plan, const PlanInput& input)
{
    const std::string source = sourceName(plan, input);
    if (input.name.empty()) return "    drawn   where " + source + " is more than 0\n";
    std::string text = "    reads   " + input.name;
    if (input.kind == InputKind::material) return text + " of the material\n";
    text += input.kind == InputKind::target && source == input.name
                ? ""
                : std::string(" from ") + nameOf(input.kind) + " " + source;
    if (input.kind == InputKind::constant) return text + "\n";
    return text + " (" + table::word(input.sampling.filter) + ", " +
           table::word(input.sampling.wrap) + ")\n";
}

std::string clearText(const PlanAttachment& attachment, bool depth)
{
    const auto& c = attachment.clear;
    std::string text = "clear to " + shortest(c[0]);
    if (depth || (c[0] == c[1] && c[0] == c[2] && c[0] == c[3])) return text;
    for (int i = 1; i < 4; ++i) text += " " + shortest(c[i]);
    return text;
}

std::string writeText(const Plan& plan, const PlanAttachment& attachment, bool depth)
{
    std::string text = "    writes  " + attachment.name;
    if (attachment.target < 0) return text + ": no texture, no pass reads it\n";
    const PlanTarget& target = plan.targets[attachment.target];
    text += ": " + std::string(formatInfo(textureOf(plan, attachment.target).format).name) +
            " texture " + std::to_string(target.texture);
    if (target.drawn_texture != target.texture)
        text += " resolved from " + std::to_string(target.drawn_texture);
    const std::string load =
        attachment.load == LoadOp::clear ? clearText(attachment, depth) : nameOf(attachment.load);
    return text + ", " + load + ", " + nameOf(attachment.store) + "\n";
}

std::string boxText(const Plan& plan, const PlanBox& box)
{
    double edge = box.factor;
    for (const int param : box.params) edge *= double{plan.params[param].initial[0]};
    return box.name + " (edge " + significant(edge, 4) + ", or that of all draws if less)";
}

std::string passText(const Plan& plan, const PlanPass& pass)
{
    const MovedBytes bytes = movedBytes(plan, pass);
    std::string text = "  " + pass.name + ": " + table::word(pass.type) + " " +
                       sizeText(pass.extent) + samplesText(pass.samples) + layersText(pass) +
                       ", program " + plan.programs[pass.program].label + ", " +
                       bytesText(bytes.read) + " read, " + bytesText(bytes.written) + " written\n";
    for (const PlanInput& input : pass.inputs) text += readText(plan, input);
    if (pass.box >= 0)
        text += "    cached  until what lies in the box " + boxText(plan, plan.boxes[pass.box]) +
                " changes or it moves; then drawn in turn, one such pass a frame\n";
    if (pass.scissor) text += "    drawn   within " + boundsText(plan, pass) + "\n";
    for (const PlanAttachment& color : pass.color)
        if (findNamed(pass.color, color.name) == &color)  // of a volume once
            text += writeText(plan, color, false);
    if (pass.has_depth && !isMasked(pass)) text += writeText(plan, pass.depth, true);
    return text;
}

std::string textureText(const Plan& plan, std::size_t index)
{
    const PlanTexture& texture = plan.textures[index];
    std::string text = "  " + std::to_string(index) + ": " + formatInfo(texture.format).name + " " +
                       sizeText(texture.extent) + samplesText(texture.samples);
    if (texture.depth > 0) text += ", " + counted(std::size_t(texture.depth), "layer");
    if (texture.mips) text += ", with mips";
    if (texture.copies > 1) text += ", one a view";
    return text + ", " + bytesText(textureBytes(texture)) + ": " +
           joined(texture.targets, ", then ") + "\n";
}

std::string outputText(const Plan& plan, const PlanOutput& output)
{
    const bool constant = output.constant >= 0;
    return "  " + output.name + ": " +
           (constant ? "constant " + shortest(plan.constants[output.constant])
                     : "target " + plan.targets[output.target].name) +
           "\n";
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

std::string toText(const Plan& plan)
{
    std::string text = "plan " + printableLine(plan.config) + " " + sizeText(plan.extent) + ": " +
                       counted(plan.passes.size(), "pass") +
                       (plan.views > 1 ? " for each of " + counted(plan.views, "view") : "") +
                       ", " + counted(textureCount(plan), "texture") + ", " +
                       bytesText(plan.texture_bytes) + "\npasses\n";
    for (const PlanPass& pass : plan.passes) text += passText(plan, pass);
    text += "textures\n";
    for (std::size_t i = 0; i < plan.textures.size(); ++i) text += textureText(plan, i);
    text += "outputs\n";
    for (const PlanOutput& output : plan.outputs) text += outputText(plan, output);
    if (!plan.generated.empty()) text += "generated\n";
    for (const GeneratorDesc& each : plan.generated)
        text += "  " + each.name + ": " + each.generator + " " + std::to_string(each.count) + "\n";
    if (!plan.imports.empty()) text += "imports\n";
    for (const ImportDesc& each : plan.imports)
        text += "  " + each.name + ": " + table::word(each.type) +
                (each.optional ? ", optional\n" : "\n");
    const std::vector<Elided> elided = allElided(plan);
    if (!elided.empty()) text += "left out\n";
    std::string last;  // how the line ends, which those share that are left out alike
    for (const Elided& each : elided) {
        const std::string end = " (" + each.optimization + "): " + each.reason + "\n";
        text += end == last ? ", " + each.what : last + "  " + each.what;
        last = end;
    }
    return text + last;
}

std::string toDot(const Plan& plan)
{
    Drawing drawing(plan);
    for (const PlanPass& pass : plan.passes) drawing.addPass(pass);
    for (const PlanOutput& output : plan.outputs) drawing.addOutput(output);
    return drawing.text();
}

}  // namespace crevice
