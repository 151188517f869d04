// SPDX-License-Identifier: MIT
// The plan: passes with what they read and write, load and store operations, and programs.
#include "core/base/content_hash.h"
#include "core/compile/steps.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/frame/frame_values.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crevice::compiler {

namespace {

std::string programKey(const Shader& shader)
{
    ContentHash key;
    key.addText(shader.vertex.text);
    key.addText(shader.fragment.text);
    return key.hex();
}

// Fills one Plan from the state; its steps run in the order in which they stand here.
class Builder {
public:
    explicit Builder(const State& state) : state_(state), description_(state.description) {}

    Plan build();

private:
    void addPass(int index);
    void addTargets();
    void addInputs(const Pass& pass, PlanPass& into);
    void addUniforms(const Pass& pass, PlanPass& into);
    void addOutputs();
    PlanAttachment attachment(const Pass& pass, int target, bool depth) const;
    void addMask(const Pass& pass, PlanPass& into) const;
    void boundPasses();
    void describeStores();
    std::string storeReason(const PlanTarget& target, int index) const;

    Shader shaderOf(const Pass& pass) const;
    int program(const Pass& pass);
    void countVariants(PlanProgram& program) const;
    int constant(float value);
    int param(const ParamDesc& desc);
    int planTarget(int target) const;
    std::string nameOf(int target) const { return description_.targets[target].name; }
    void collectUsed();

    const State& state_;
    const Description& description_;
    Plan plan_;
};

// The pass's shader without the outputs that nobody reads. Those that nobody reads by a param's
// value stay, so that no such value compiles a shader.
Shader Builder::shaderOf(const Pass& pass) const
{
    Shader shader = state_.shaders[pass.shader];
    const std::vector<GlslOutput> outputs = shader.fragment.outputs;
    for (const GlslOutput& output : outputs)
        if (const Target& target = state_.targets[pass.color[output.location]];
            !target.wanted && !target.textured)
            dropOutput(shader.fragment, output.name);
    return shader;
}

int Builder::program(const Pass& pass)
{
    const Shader shader = shaderOf(pass);
    const std::string key = programKey(shader);
    for (std::size_t i = 0; i < plan_.programs.size(); ++i)
        if (plan_.programs[i].key == key) return static_cast<int>(i);
    const ShaderDesc& desc = *findNamed(description_.shaders, pass.desc->shader.name);
    plan_.programs.push_back(
        {key, pass.desc->shader.name, shader.vertex, shader.fragment, desc.place, desc.pointer});
    countVariants(plan_.programs.back());
    return static_cast<int>(plan_.programs.size()) - 1;
}

void Builder::countVariants(PlanProgram& program) const
{
    std::set<std::string> used(program.vertex.defines_used.begin(),
                               program.vertex.defines_used.end());
    used.insert(program.fragment.defines_used.begin(), program.fragment.defines_used.end());
    const auto vary = [&](const std::string& define, const std::string& name, double values) {
        if (used.count(define) == 0 || values < 2) return;
        program.varies_with.push_back(name);
        program.variants *= values;
    };
    for (const FeatureDesc& each : description_.features)
        vary(upperCase(each.name), each.name, static_cast<double>(each.values.size()));
    for (const TraitInfo& each : kTraits)
        vary(each.define, each.name, each.count ? kMaxLights + 1 : 2);
    for (const ParamDesc& each : description_.params) {
        if (each.bind != Bind::define) continue;
        const std::string define = upperCase(each.name);
        if (each.type == ParamType::int_)
            vary(define, each.name, std::floor(each.max) - std::ceil(each.min) + 1);
        else if (used.count(define) > 0)
            program.fractions.push_back(each.name);
    }
}

int Builder::constant(float value)
{
    for (std::size_t i = 0; i < plan_.constants.size(); ++i)
        if (plan_.constants[i].value == value) return static_cast<int>(i);
    plan_.constants.push_back({value});
    return static_cast<int>(plan_.constants.size()) - 1;
}

int Builder::param(const ParamDesc& desc)
{
    if (const int known = indexOf(plan_.params, desc.name); known >= 0) return known;
    plan_.params.push_back({desc.name, glslTypeOf(desc.type), desc.value});
    return static_cast<int>(plan_.params.size()) - 1;
}

int Builder::planTarget(int target) const
{
    return indexOf(plan_.targets, description_.targets[target].name);
}

// ---- what passes use besides targets

void Builder::collectUsed()
{
    const auto is_used = [this](const auto& desc) {
        return std::any_of(state_.passes.begin(), state_.passes.end(),
                           [&](const Pass& pass) { return pass.live && uses(state_, pass, desc); });
    };
    for (const GeneratedDesc& desc : description_.generated) {
        if (!is_used(desc)) continue;
        plan_.generated.push_back(desc);
        plan_.generated.back().count = generatedCount(description_, desc);
    }
    for (const ImportDesc& desc : description_.imports)
        if (is_used(desc)) plan_.imports.push_back(desc);
}

// ---- passes

// The test that passes nearer things where they have more depth rather than less.
Compare reversed(Compare test)
{
    switch (test) {
    case Compare::less: return Compare::greater;
    case Compare::less_equal: return Compare::greater_equal;
    case Compare::greater: return Compare::less;
    case Compare::greater_equal: return Compare::less_equal;
    default: return test;
    }
}

bool isScissored(const State& state, const Pass& pass)
{
    return pass.desc->scissor && state.applies("scissor");
}

PlanAttachment Builder::attachment(const Pass& pass, int target, bool depth) const
{
    PlanAttachment result;
    result.name = nameOf(target);
    result.target = planTarget(target);
    if (result.target < 0) {
        result.store = StoreOp::discard;
        result.reason = "nobody reads it";
        return result;
    }
    const PassDesc& desc = *pass.desc;
    const StateDesc& state = desc.state;
    // A fragment that fails a test or is thrown away leaves what was there.
    const bool keeps =
        desc.type == PassType::draw || state.depth_test != Compare::always ||
        (depth && !state.depth_write) || readsMask(pass) || isScissored(state_, pass) ||
        findWord(state_.shaders[pass.shader].fragment.text, "discard") != std::string::npos;
    if (!keeps) {
        result.reason = "every pixel is overwritten";
        return result;
    }
    result.load = LoadOp::clear;
    if (depth) result.clear = {1, 1, 1, 1};
    for (const ClearDesc& clear : desc.clear)
        if (clear.target.name == result.name) result.clear = clear.value;
    if (depth && desc.type == PassType::draw && state_.traits.reversed_depth)
        for (float& value : result.clear) value = 1.0f - value;
    result.reason = desc.type == PassType::draw ? "a draw does not cover every pixel"
                    : readsMask(pass) || isScissored(state_, pass)
                        ? "the pass is not drawn everywhere"
                        : "the pass leaves pixels as they are";
    return result;
}

// All of them before the first pass: the history of a target is read before the target is written.
void Builder::addTargets()
{
    int at = 0;
    for (const int index : state_.order) {
        const Pass& pass = state_.passes[index];
        if (!pass.live) continue;
        for (const int target : writtenBy(pass))
            if (state_.targets[target].textured)
                plan_.targets.push_back(
                    {nameOf(target), -1, -1, at, at, -1, formatReason(state_, target)});
        ++at;
    }
}

void Builder::addInputs(const Pass& pass, PlanPass& into)
{
    for (const Read& read : pass.reads) {
        const Source source = *resolve(state_, read.named);
        PlanInput input{read.sampler, source.kind, -1, samplingOf(read)};
        switch (source.kind) {
        case InputKind::target:
            input.index = planTarget(source.index);
            plan_.targets[input.index].last_pass = static_cast<int>(plan_.passes.size());
            break;
        case InputKind::history: input.index = planTarget(source.index); break;
        case InputKind::generated:
            input.index = indexOf(plan_.generated, description_.generated[source.index].name);
            break;
        case InputKind::imported:
            input.index = indexOf(plan_.imports, description_.imports[source.index].name);
            break;
        case InputKind::constant: input.index = constant(source.value); break;
        case InputKind::material: input.index = source.index; break;
        }
        into.inputs.push_back(std::move(input));
    }
}

void Builder::addUniforms(const Pass& pass, PlanPass& into)
{
    for (PlanUniform uniform : pass.uniforms) {
        if (uniform.source == UniformSource::param)
            uniform.index = param(description_.params[uniform.index]);
        else if (uniform.source == UniformSource::kernel)
            uniform.index = indexOf(plan_.generated, description_.generated[uniform.index].name);
        into.uniforms.push_back(std::move(uniform));
    }
}

void Builder::addPass(int index)
{
    const Pass& pass = state_.passes[index];
    const PassDesc& desc = *pass.desc;
    PlanPass result;
    result.name = desc.name;
    result.type = desc.type;
    result.program = program(pass);
    result.state = desc.state;
    if (state_.traits.reversed_depth) result.state.depth_test = reversed(desc.state.depth_test);
    result.extent = extentOf(state_, pass);
    result.samples = samplesOf(state_, pass);
    if (state_.applies("frustum_culling")) {
        const ParamDesc* within = findNamed(description_.params, desc.frustum_scale_param.name);
        result.frustum_scale = within ? within->value[0] : desc.frustum_scale;
    }
    addInputs(pass, result);
    for (const int target : pass.color) result.color.push_back(attachment(pass, target, false));
    result.has_depth = pass.depth >= 0;
    if (result.has_depth) result.depth = attachment(pass, pass.depth, true);
    addMask(pass, result);
    addUniforms(pass, result);
    plan_.passes.push_back(std::move(result));
}

// The mask is tested against, and stays as it is. Where a constant stands in for it the pass is
// drawn everywhere.
void Builder::addMask(const Pass& pass, PlanPass& into) const
{
    if (!readsMask(pass)) return;
    if (into.inputs.back().kind != InputKind::target) return into.inputs.pop_back();
    into.has_depth = true;
    into.depth.name = pass.desc->mask.name;
    into.depth.target = into.inputs.back().index;
    into.depth.load = LoadOp::load;
    into.depth.reason = "tested: the pass is drawn where it is more than 0";
}

// Those of which all that they read comes from things of the draw list, as far as a frame's bounds
// tell. Passes come after what they read.
void Builder::boundPasses()
{
    std::vector<bool> shows_things;
    const auto fromThings = [&](const PlanInput& input) {
        if (input.kind == InputKind::target)
            return bool(shows_things[plan_.targets[input.index].first_pass]);
        return input.kind != InputKind::imported && input.kind != InputKind::history;
    };
    for (PlanPass& pass : plan_.passes) {
        const PassDesc& desc = *findNamed(description_.passes, pass.name);
        const bool draws = pass.type == PassType::draw;
        shows_things.push_back(
            draws ? desc.frustum_scale > 0.0f || !desc.frustum_scale_param.empty()
                  : std::all_of(pass.inputs.begin(), pass.inputs.end(), fromThings));
        pass.scissor = desc.scissor && state_.applies("scissor") && shows_things.back();
        if (pass.scissor && !desc.cull_below_pixel.empty())
            pass.cull_below_pixel =
                param(*findNamed(description_.params, desc.cull_below_pixel.name));
    }
}

// What is remembered lasts to the next frame, and so does an output.
void Builder::addOutputs()
{
    for (PlanTarget& target : plan_.targets)
        if (state_.targets[indexOf(description_.targets, target.name)].remembered)
            target.last_pass = static_cast<int>(plan_.passes.size());
    for (const int index : state_.outputs) {
        const OutputDesc& desc = description_.outputs[index];
        const int target = indexOf(description_.targets, desc.target.name);
        const Source source = *resolveTarget(state_, target);
        PlanOutput output{desc.name};
        if (source.kind == InputKind::constant) {
            output.constant = constant(source.value);
        } else {
            output.target = planTarget(source.index);
            plan_.targets[output.target].last_pass = static_cast<int>(plan_.passes.size());
        }
        plan_.outputs.push_back(std::move(output));
    }
}

// ---- stores, once all readers are known

std::string Builder::storeReason(const PlanTarget& target, int index) const
{
    std::vector<std::string> readers;
    for (const PlanPass& pass : plan_.passes)
        for (const PlanInput& input : pass.inputs)
            if (input.kind == InputKind::target && input.index == index)
                readers.push_back(pass.name);
    readers.erase(std::unique(readers.begin(), readers.end()), readers.end());
    for (const PlanOutput& output : plan_.outputs)
        if (output.target == index) readers.push_back("output " + output.name);
    for (const PlanPass& pass : plan_.passes)
        for (const PlanInput& input : pass.inputs)
            if (input.kind == InputKind::history && input.index == index)
                readers.push_back(pass.name + " in the next frame");
    if (target.last_pass == target.first_pass) return "nobody reads it after this pass";
    return "read by " + joined(readers);
}

void Builder::describeStores()
{
    const auto describe = [this](PlanAttachment& attachment) {
        if (attachment.target < 0 || attachment.load == LoadOp::load) return;
        const PlanTarget& target = plan_.targets[attachment.target];
        if (target.last_pass == target.first_pass) attachment.store = StoreOp::discard;
        attachment.reason += "; " + storeReason(target, attachment.target);
    };
    for (PlanPass& pass : plan_.passes) {
        for (PlanAttachment& color : pass.color) describe(color);
        if (pass.has_depth) describe(pass.depth);
    }
}

Plan Builder::build()
{
    plan_.config = description_.name;
    plan_.extent = state_.options.extent;
    plan_.views = std::max(state_.traits.views, 1);
    collectUsed();
    addTargets();
    for (const int index : state_.order)
        if (state_.passes[index].live) addPass(index);
    boundPasses();
    addOutputs();
    shareTextures(state_, plan_);
    describeStores();
    estimateBytes(plan_);
    plan_.elided = elided(state_);
    if (const Elided sharing = elidedBySharing(plan_); sharing.texture_bytes > 0)
        plan_.elided.push_back(sharing);
    for (Elided& each : elidedOfFrames(plan_)) plan_.elided.push_back(std::move(each));
    return std::move(plan_);
}

}  // namespace

Plan buildPlan(const State& state) { return Builder(state).build(); }

}  // namespace crevice::compiler
