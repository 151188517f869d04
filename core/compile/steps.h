// SPDX-License-Identifier: MIT
// The compiler's working state and its steps, private to core/compile. They fill it in this order:
//
//   graph         which passes run, once borders fit
//   formats       formats, which shaders allow for; at the end whether they fit and are fine enough
//   shaders       defines, stages, outputs, and what feeds the uniforms
//   graph         writers and order; what is needed, and what stands in for what is not
//   target_sizes  sizes and samples
//   passes        the plan itself
//
// Indices are into the description's lists unless they say otherwise. Every step works on what the
// steps before could make sense of, so that one run finds all errors.
#pragma once

#include <crevice/compile.h>

#include "core/plan/sizes.h"

#include <set>

namespace crevice::compiler {

/// What a name that a pass reads stands for.
struct Source {
    InputKind kind = InputKind::target;
    int index = -1;      ///< Into targets, generated or imports.
    float value = 0.0f;  ///< Of a constant.

    bool isTarget() const { return kind == InputKind::target || kind == InputKind::history; }
};

/// A sampler of a pass.
struct Read {
    std::string name;                  ///< Of the sampler; empty for what `mask` names.
    const InputDesc* input = nullptr;  ///< What the config says of it, if it does.
    Source named = {};                 ///< What the name stands for before passes are left out.
};

/// A shader with the defines in force. `ok` is false when it could not be assembled.
struct Shader {
    bool assembled = false;
    bool ok = false;
    GlslStage vertex = {};
    GlslStage fragment = {};
};

struct Pass {
    const PassDesc* desc = nullptr;
    int shader = -1;                  ///< Into State::shaders.
    bool active = true;               ///< Its condition holds.
    std::string off_reason = {};      ///< Why not.
    bool live = false;                ///< Some output needs it.
    const NoOpDesc* no_op = nullptr;  ///< What stands in for it, when something does.
    bool preserves_constant = false;  ///< What it reads is constant, and so stands in for it.
    bool indispensable = false;       ///< ... but not for all that is needed of it.
    std::vector<Read> reads = {};
    std::vector<PlanUniform> uniforms = {};  ///< With indices into the description's lists.
    std::vector<int> color = {};             ///< Targets.
    int depth = -1;                          ///< A target, or -1 for none.
    int over = -1;                           ///< The pass that it draws over, or -1.

    bool replaced() const { return no_op != nullptr || preserves_constant; }
};

struct Target {
    int writer = -1;          ///< The active pass that writes it.
    bool textured = false;    ///< It needs a texture.
    bool wanted = false;      ///< It would with params of other values.
    bool remembered = false;  ///< Someone reads what it held last frame: it needs two.
    Format format = Format::none;
    Extent extent = {};
    int depth = 0;  ///< Layers, of a volume.
    int samples = 1;
};

/// Everything that the steps share.
struct State {
    const Description& description;
    const SceneTraits& traits;
    const DeviceCaps& caps;
    const CompileOptions& options;
    TargetSizes sizes;
    std::vector<Shader> shaders = {};  ///< The description's.
    std::vector<Pass> passes = {};
    std::vector<Target> targets = {};
    GlslDefines defines = {};              ///< Of every shader.
    std::vector<int> order = {};           ///< Active passes by data flow.
    std::vector<int> outputs = {};         ///< Those asked for.
    std::set<std::string> unwritten = {};  ///< Targets that no pass writes, as an error says.
    std::vector<Elided> elided = {};       ///< Before there were passes.
    Diagnostics diagnostics = {};

    /// False when the options switch the optimization off.
    bool applies(std::string_view optimization) const;
};

/// Whether so many errors were found that no further ones need be looked for.
bool isFull(const State& state);

/// Adds an error and returns it, for its notes. The reference is valid until the next one.
Diagnostic& report(State& state, Code code, std::string message, const Named& at,
                   std::string help = {});
Diagnostic& report(State& state, Code code, std::string message, const Reference& at,
                   std::string help = {});

/// Adds an error at `declared` in the GLSL, with a note at the shader that the pass names.
Diagnostic& reportGlsl(State& state, Code code, std::string message, const Pass& pass,
                       const Place& declared, std::string help = {});

/// What a shader declares to read that param, texture or value: "it is a param: write uniform
/// float intensity;". Empty where there is none of that name.
std::string declarationOf(const Description& description, const std::string& name);

/// "pass 'ssao'", as messages name it.
inline std::string quoted(const Pass& pass) { return "pass '" + pass.desc->name + "'"; }

inline const std::string& nameOf(const State& state, int target)
{
    return state.description.targets[target].name;
}

/// As the config says, or as is usual for what the name stands for.
SamplerDesc samplingOf(const State& state, const Read& read);

/// Whether a mask of its own says where the pass is drawn.
inline bool readsMask(const Pass& pass) { return findNamed(pass.reads, "") != nullptr; }

/// Targets that a pass writes: colour, then depth.
std::vector<int> writtenBy(const Pass& pass);

/// Whether a pass goes on to draw on this target, which another one wrote.
bool drawsOver(const State& state, const Pass& pass, int target);

/// Where the pass names a target that it writes.
const Reference& referenceTo(const Pass& pass, const std::string& target);

// formats.cpp
void chooseFormats(State& state);
void checkFormats(State& state);
/// The warning CV6015.
void lintPrecision(State& state);

// shaders.cpp
void readShaders(State& state);

// graph.cpp
void findWriters(State& state);
void orderPasses(State& state);
void decideConditions(State& state);
std::vector<Elided> elided(const State& state);
void chooseLive(State& state);
/// The warning CV2212.
void lintDeadPasses(State& state);

/// What a reader gets, with passes that do not run looked through; nothing behind no active pass.
std::optional<Source> resolve(const State& state, const Source& source);
inline std::optional<Source> resolveTarget(const State& state, int target)
{
    return resolve(state, {InputKind::target, target});
}

// target_sizes.cpp
/// Layers of volumes that a pass draws at once: as often as `color` names each of them.
int layersAtOnce(const Pass& pass);
void chooseExtents(State& state);
void chooseSamples(State& state);

// passes.cpp
Plan buildPlan(const State& state);

}  // namespace crevice::compiler
