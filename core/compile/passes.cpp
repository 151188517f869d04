// SPDX-License-Identifier: MIT
// The plan: passes, what they read and write, load and store operations, programs, shared textures.
#include "core/compile/steps.h"

#include "core/base/content_hash.h"
#include "core/frame/frame_math.h"

namespace crevice {

const Optimization kOptimizations[7] = {
    {"dead_pass", "passes, attachments and shader outputs that no requested output needs"},
    {"no_op",
     "passes whose outputs are known without running them: by the value of a param, or a constant "
     "input"},
    {"aliasing", "separate textures for targets that are not alive at the same time"},
    {"depth_mask", "pixels of a pass that its mask excludes, by a depth test"},
    {"frustum_culling", "per frame, draws whose bounds are outside the view"},
    {"scissor", "per frame, pixels of a pass outside the bounds of all draws"},
    {"cached", "per frame, passes whose inputs have not changed"},
};

namespace compiler {
namespace {

// Of the pass's shader without the outputs that no pass reads. Those that no pass reads by a
// param's value stay, so that no such value compiles a shader.
int addProgram(const State& state, const Pass& pass, Plan& plan)
{
    Shader shader = state.shaders[pass.shader];
    for (const GlslOutput& output : state.shaders[pass.shader].fragment.outputs)
        if (const Target& target = state.targets[pass.color[output.location]];
            !target.wanted && !target.textured)
            dropOutput(shader.fragment, output.name);
    ContentHash hash;
    hash.addText(shader.vertex.text);
    hash.addText(shader.fragment.text);
    const std::string key = hash.hex();
    for (std::size_t i = 0; i < plan.programs.size(); ++i)
        if (plan.programs[i].key == key) return static_cast<int>(i);
    const ShaderDesc& desc = state.description.shaders[pass.shader];
    plan.programs.push_back(
        {key, desc.name, shader.vertex, shader.fragment, desc.place, desc.pointer});
    return static_cast<int>(plan.programs.size()) - 1;
}

int addConstant(float value, Plan& plan)
{
    const auto known = std::find(plan.constants.begin(), plan.constants.end(), value);
    const int index = static_cast<int>(known - plan.constants.begin());
    if (known == plan.constants.end()) plan.constants.push_back(value);
    return index;
}

int addParam(const ParamDesc& desc, Plan& plan)
{
    if (const int known = indexOf(plan.params, desc.name); known >= 0) return known;
    plan.params.push_back({desc.name, glslTypeOf(desc.type), desc.value});
    return static_cast<int>(plan.params.size()) - 1;
}

int addBox(const State& state, const BoxDesc& desc, Plan& plan)
{
    if (const int known = indexOf(plan.boxes, desc.name); known >= 0) return known;
    PlanBox box{desc.name, desc.edge.factor, {}, desc.steps};
    for (const Reference& each : desc.edge.params)
        box.params.push_back(addParam(*findNamed(state.description.params, each.name), plan));
    plan.boxes.push_back(std::move(box));
    return static_cast<int>(plan.boxes.size()) - 1;
}

// Those that some pass uses.
void addGeneratedAndImports(const State& state, Plan& plan)
{
    std::set<std::string> used;                    // generated, textures
    std::set<std::optional<ImportType>> supplied;  // imports that give values
    for (const Pass& pass : state.passes) {
        if (!pass.live) continue;
        for (const Read& read : pass.reads) {
            const std::optional<Source> source = resolve(state, read.named);
            if (source->kind == InputKind::generated)
                used.insert(state.description.generated[source->index].name);
            if (source->kind == InputKind::imported)
                used.insert(state.description.imports[source->index].name);
        }
        for (const PlanUniform& each : pass.uniforms) {
            if (each.source == UniformSource::kernel) used.insert(each.name);
            if (each.source == UniformSource::frame || each.source == UniformSource::draw)
                supplied.insert(kFrameValues[each.index].import);
        }
        if (pass.desc->type == PassType::draw) supplied.insert(ImportType::draw_list);
    }
    for (const GeneratedDesc& desc : state.description.generated) {
        if (used.count(desc.name) == 0) continue;
        plan.generated.push_back(desc);
    }
    for (const ImportDesc& desc : state.description.imports)
        if (used.count(desc.name) > 0 || supplied.count(desc.type) > 0)
            plan.imports.push_back(desc);
}

// The same depth test for reversed depth, where nearer surfaces have the larger depth.
Compare reversed(Compare test)
{
    constexpr Compare kReversed[] = {Compare::always, Compare::greater,    Compare::greater_equal,
                                     Compare::less,   Compare::less_equal, Compare::equal};
    return kReversed[static_cast<int>(test)];  // in the order of Compare
}

bool isScissored(const State& state, const PassDesc& pass)
{
    return pass.scissor && state.applies("scissor");
}

PlanAttachment attachment(const State& state, const Pass& pass, int target, bool depth,
                          const Plan& plan)
{
    PlanAttachment result;
    result.name = nameOf(state, target);
    result.target = indexOf(plan.targets, result.name);
    if (result.target < 0) {
        result.store = StoreOp::discard;
        return result;
    }
    if (drawsOver(state, pass, target)) {
        result.load = LoadOp::load;
        return result;
    }
    const PassDesc& desc = *pass.desc;
    // A fragment that fails a test or is thrown away leaves what was there.
    const bool keeps =
        desc.type == PassType::draw || desc.state.depth_test != Compare::always ||
        (depth && !desc.state.depth_write) || readsMask(pass) || isScissored(state, desc) ||
        findWord(state.shaders[pass.shader].fragment.text, "discard") != std::string::npos;
    if (!keeps) return result;
    result.load = LoadOp::clear;
    if (depth) result.clear = {1, 1, 1, 1};
    if (const ClearDesc* clear = findNamed(desc.clear, result.name)) result.clear = clear->value;
    if (depth && desc.type == PassType::draw && state.traits.reversed_depth)
        for (float& value : result.clear) value = 1.0f - value;
    return result;
}

// All of them before the first pass: the history of a target is read before the target is written.
void addTargets(const State& state, Plan& plan)
{
    int at = 0;
    for (const int index : state.order) {
        const Pass& pass = state.passes[index];
        if (!pass.live) continue;
        for (const int target : writtenBy(pass))
            if (state.targets[target].textured && !findNamed(plan.targets, nameOf(state, target)))
                plan.targets.push_back({nameOf(state, target), -1, -1, at, at});
        ++at;
    }
}

void addInputs(const State& state, const Pass& pass, PlanPass& into, Plan& plan)
{
    const Description& description = state.description;
    for (const Read& read : pass.reads) {
        const Source source = *resolve(state, read.named);
        PlanInput input{read.name, source.kind, source.index, samplingOf(state, read)};
        if (source.isTarget())
            input.index = indexOf(plan.targets, nameOf(state, source.index));
        else if (source.kind == InputKind::generated)
            input.index = indexOf(plan.generated, description.generated[source.index].name);
        else if (source.kind == InputKind::imported)
            input.index = indexOf(plan.imports, description.imports[source.index].name);
        else if (source.kind == InputKind::constant)
            input.index = addConstant(source.value, plan);
        if (source.kind == InputKind::target)
            plan.targets[input.index].last_pass = static_cast<int>(plan.passes.size());
        into.inputs.push_back(std::move(input));
    }
}

// The mask is tested against, and stays. Where a constant stands in for it, all is drawn.
void addMask(const Pass& pass, PlanPass& into)
{
    if (!readsMask(pass)) return;
    if (into.inputs.back().kind != InputKind::target) return into.inputs.pop_back();
    into.has_depth = true;
    into.depth.name = pass.desc->mask.name;
    into.depth.target = into.inputs.back().index;
    into.depth.load = LoadOp::load;
}

void addPass(const State& state, const Pass& pass, Plan& plan)
{
    const PassDesc& desc = *pass.desc;
    PlanPass result;
    result.name = desc.name;
    result.type = desc.type;
    result.program = addProgram(state, pass, plan);
    result.blended = desc.blended;
    result.state = desc.state;
    if (state.traits.reversed_depth) result.state.depth_test = reversed(desc.state.depth_test);
    result.over = indexOf(plan.passes, desc.over.name);
    if (!pass.color.empty()) result.layers_at_once = layersAtOnce(pass);
    if (const BoxDesc* box = findNamed(state.description.boxes, desc.box.name))
        result.box = addBox(state, *box, plan);
    addInputs(state, pass, result, plan);
    for (const int target : pass.color)
        result.color.push_back(attachment(state, pass, target, false, plan));
    result.has_depth = pass.depth >= 0;
    if (result.has_depth) result.depth = attachment(state, pass, pass.depth, true, plan);
    addMask(pass, result);
    for (PlanUniform uniform : pass.uniforms) {
        const Description& description = state.description;
        if (uniform.source == UniformSource::param)
            uniform.index = addParam(description.params[uniform.index], plan);
        else if (uniform.source == UniformSource::box)
            uniform.index = addBox(state, description.boxes[uniform.index], plan);
        else if (uniform.source == UniformSource::kernel)
            uniform.index = indexOf(plan.generated, description.generated[uniform.index].name);
        result.uniforms.push_back(std::move(uniform));
    }
    plan.passes.push_back(std::move(result));
}

// A pass gets a scissor where all that it reads, in passes before it, is of draws with bounds.
void boundPasses(const State& state, Plan& plan)
{
    std::vector<bool> from_draws;
    const auto fromDraws = [&](const PlanInput& input) {
        if (input.kind == InputKind::target)
            return bool(from_draws[plan.targets[input.index].first_pass]);
        return input.kind != InputKind::imported && input.kind != InputKind::history;
    };
    for (PlanPass& pass : plan.passes) {
        const PassDesc& desc = *findNamed(state.description.passes, pass.name);
        const bool draws = pass.type == PassType::draw;
        from_draws.push_back(draws ? desc.frustum_scale > 0.0f || !desc.frustum_scale_param.empty()
                                   : allOf(pass.inputs, fromDraws));
        pass.scissor = isScissored(state, desc) && from_draws.back();
        const ParamDesc* length = findNamed(state.description.params, desc.cull_below_pixel.name);
        if (pass.scissor && length) pass.cull_below_pixel = addParam(*length, plan);
    }
}

// What is remembered lasts to the next frame, and so does an output, and what a box's pass drew
// that others read.
void addOutputs(const State& state, Plan& plan)
{
    const int end = static_cast<int>(plan.passes.size());
    for (const PlanPass& pass : plan.passes)
        for (const PlanInput& input : pass.inputs) {
            if (input.kind != InputKind::target || pass.box >= 0) continue;
            PlanTarget& target = plan.targets[input.index];
            if (plan.passes[target.first_pass].box >= 0) target.last_pass = end;
        }
    for (PlanTarget& target : plan.targets)
        if (state.targets[indexOf(state.description.targets, target.name)].remembered)
            target.last_pass = end, target.history_texture = 0;
    for (const int index : state.outputs) {
        const OutputDesc& desc = state.description.outputs[index];
        const int target = indexOf(state.description.targets, desc.target.name);
        const Source source = *resolveTarget(state, target);
        PlanOutput output{desc.name};
        if (source.kind == InputKind::constant) {
            output.constant = addConstant(source.value, plan);
        } else {
            output.target = indexOf(plan.targets, nameOf(state, source.index));
            plan.targets[output.target].last_pass = end;
        }
        plan.outputs.push_back(std::move(output));
    }
}

// Requires that all readers are known.
void discardUnread(Plan& plan)
{
    const auto discard = [&plan](PlanAttachment& attachment) {
        if (attachment.target < 0 || attachment.load == LoadOp::load) return;
        const PlanTarget& target = plan.targets[attachment.target];
        if (target.last_pass == target.first_pass) attachment.store = StoreOp::discard;
    };
    for (PlanPass& pass : plan.passes) {
        for (PlanAttachment& color : pass.color) discard(color);
        if (pass.has_depth) discard(pass.depth);
    }
}

}  // namespace

Plan buildPlan(const State& state)
{
    Plan plan;
    plan.config = state.description.name;
    plan.reruns = !state.applies("cached");
    addGeneratedAndImports(state, plan);
    addTargets(state, plan);
    for (const int index : state.order)
        if (state.passes[index].live) addPass(state, state.passes[index], plan);
    boundPasses(state, plan);
    addOutputs(state, plan);
    discardUnread(plan);
    fitPlan(plan, state.description, state.traits, state.caps, state.options);
    plan.elided = elided(state);
    return plan;
}

}  // namespace compiler
}  // namespace crevice
