// SPDX-License-Identifier: MIT
// Compiling: the steps in their order, and what they share.
#include "core/compile/steps.h"

#include "core/base/text.h"
#include "core/config/values.h"

#include <tuple>

namespace crevice {

namespace compiler {
namespace {

State begin(const Description& description, const SceneTraits& traits, const DeviceCaps& caps,
            const CompileOptions& options)
{
    State state{description, traits, caps, options, {description, options.extent}};
    state.shaders.resize(description.shaders.size());
    state.targets.resize(description.targets.size());
    const auto target = [&](const Reference& to) { return indexOf(description.targets, to.name); };
    for (const PassDesc& desc : description.passes) {
        Pass pass;
        pass.desc = &desc;
        pass.shader = indexOf(description.shaders, desc.shader.name);
        for (const Reference& color : desc.color) pass.color.push_back(target(color));
        pass.depth = target(desc.depth);
        state.passes.push_back(std::move(pass));
    }
    return state;
}

void checkRules(State& state)
{
    std::vector<std::string> names = namesOf(kOptimizations);
    names.push_back("all");
    for (const std::string& optimization : state.options.disable) {
        if (contains(names, optimization)) continue;
        report(state, Code::bad_enum,
               "'" + optimization + "' is no optimization that can be switched off", Named{},
               suggestName(optimization, names, "optimizations"));
    }
}

void chooseOutputs(State& state)
{
    const auto& outputs = state.description.outputs;
    const auto& wanted = state.options.outputs;
    if (outputs.empty())
        report(state, Code::no_outputs, "the config exports no output, so nothing would run",
               state.description,
               "add: \"outputs\": {\"ao\": \"name of a target\"}, or \"extends\": [\"balanced\"]");
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (wanted.empty() ? !outputs[i].on_request : contains(wanted, outputs[i].name))
            state.outputs.push_back(static_cast<int>(i));
    if (wanted.empty() && state.outputs.empty() && !outputs.empty())
        report(state, Code::no_outputs, "all outputs are drawn on request, so nothing would run",
               outputs.front(), "ask for one by name, or take `on_request` off it");
    for (const std::string& name : wanted) {
        if (outputs.empty() || findNamed(outputs, name)) continue;
        report(state, Code::output_missing,
               "output '" + name + "' was asked for, which '" + state.description.name +
                   "' does not export",
               Named{}, suggestName(name, namesOf(outputs), "outputs"));
    }
}

// A mistake in GLSL that several passes or shaders share is one mistake.
void dropRepeats(State& state)
{
    const auto in_glsl = [&](const Place& place) {
        const auto& files = state.description.files;
        return anyOf(files, [&](const auto& file) { return file.second == place.source; });
    };
    std::set<std::tuple<Code, SourceRef, int, int>> reported;
    Diagnostics kept;
    for (Diagnostic& each : state.diagnostics) {
        const bool noted = !each.notes.empty() && in_glsl(each.notes.front().place);
        const Place& place = noted ? each.notes.front().place : each.place;
        if (!in_glsl(place) ||
            reported.insert({each.code, place.source, place.line, place.column}).second)
            kept.push_back(std::move(each));
    }
    state.diagnostics = std::move(kept);
}

}  // namespace

bool isFull(const State& state)
{
    return state.diagnostics.size() > kMaxDiagnostics && hasErrors(state.diagnostics);
}

bool State::applies(std::string_view optimization) const
{
    return !contains(options.disable, optimization) && !contains(options.disable, "all");
}

Diagnostic& report(State& state, Code code, std::string message, const Named& at, std::string help)
{
    state.diagnostics.push_back({code, std::move(message), std::move(help), at.place, at.pointer});
    return state.diagnostics.back();
}

Diagnostic& report(State& state, Code code, std::string message, const Reference& at,
                   std::string help)
{
    const Named& where = at;
    Diagnostic& error = report(state, code, std::move(message), where, std::move(help));
    for (const Place& origin : at.origins)
        error.notes.push_back({origin, "the base value was set here"});
    return error;
}

Diagnostic& reportGlsl(State& state, Code code, std::string message, const Pass& pass,
                       const Place& declared, std::string help)
{
    Diagnostic& error = report(state, code, std::move(message), pass.desc->shader, std::move(help));
    if (declared.source) blame(error, declared, "the pass names its shader here");
    return error;
}

SamplerDesc samplingOf(const State& state, const Read& read)
{
    const bool material = read.named.kind == InputKind::material;
    const bool tiled = material || read.named.kind == InputKind::generated;
    const std::optional<Source> source = resolve(state, read.named);
    const bool mips = source && source->isTarget() && state.description.targets[source->index].mips;
    SamplerDesc sampling = {material ? Filter::linear
                            : mips   ? Filter::trilinear
                                     : Filter::nearest,
                            tiled ? Wrap::repeat : Wrap::clamp};
    if (read.input && read.input->has_filter) sampling.filter = read.input->filter;
    if (read.input && read.input->has_wrap) sampling.wrap = read.input->wrap;
    return sampling;
}

std::vector<int> writtenBy(const Pass& pass)
{
    std::vector<int> targets;
    for (const int target : pass.color)
        if (target >= 0 && std::count(targets.begin(), targets.end(), target) == 0)
            targets.push_back(target);
    if (pass.depth >= 0) targets.push_back(pass.depth);
    return targets;
}

bool drawsOver(const State& state, const Pass& pass, int target)
{
    if (pass.over < 0) return false;
    return anyOf(state.passes[pass.over].color, [target](int each) { return each == target; });
}

const Reference& referenceTo(const Pass& pass, const std::string& target)
{
    const Reference* color = findNamed(pass.desc->color, target);
    return color ? *color : pass.desc->depth;
}

}  // namespace compiler

Result<Plan> compile(const Description& given, const SceneTraits& traits, const DeviceCaps& caps,
                     const CompileOptions& options)
{
    using namespace compiler;
    if (given.planner && given.planner != compilingPlanMaker())
        return given.planner->plan(given, traits, caps, options);
    Description description = given;
    for (ParamDesc& param : description.params)
        param.value = sceneUnits(param, traits, options.extent.height);
    std::vector<Elided> elided;
    for (const Description::LeftOut& each : description.left_out)
        elided.push_back({"module " + each.module, "replaced", each.reason});
    const std::optional<Description> fitted = fitBorders(description, options, caps, elided);
    State state = begin(fitted ? *fitted : description, traits, caps, options);
    state.elided = std::move(elided);
    checkRules(state);
    chooseOutputs(state);
    decideConditions(state);
    chooseFormats(state);
    readShaders(state);
    findWriters(state);
    orderPasses(state);
    chooseLive(state);
    chooseExtents(state);
    checkFormats(state);
    chooseSamples(state);
    lintDeadPasses(state);
    lintPrecision(state);
    dropRepeats(state);
    if (!hasErrors(state.diagnostics)) append(state.diagnostics, description.unused);
    cutShort(state.diagnostics);
    if (hasErrors(state.diagnostics)) return std::move(state.diagnostics);
    Plan plan = buildPlan(state);
    if (const Status fits = checkBytes(plan, description); !fits) return fits.diagnostics();
    return {std::move(plan), std::move(state.diagnostics)};
}

std::shared_ptr<const PlanMaker> compilingPlanMaker()
{
    struct Compiler : PlanMaker {
        Result<Plan> plan(const Description& description, const SceneTraits& traits,
                          const DeviceCaps& caps, const CompileOptions& options) const override
        {
            return compile(description, traits, caps, options);
        }
    };
    static const auto made = std::make_shared<const Compiler>();
    return made;
}

}  // namespace crevice
