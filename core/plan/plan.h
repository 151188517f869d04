// SPDX-License-Identifier: MIT
// A plan: what will run, in which order, on which textures, and what was left out and why.
//
// `compile` is a pure and deterministic function: no GL, no clock, no files. The same input gives
// the same plan on every machine, so tests compare plans as text.
#pragma once

#include "core/config/description.h"
#include "core/frame/frame.h"
#include "core/glsl/stage.h"
#include "core/gpu/device.h"
#include "core/plan/optimizations.h"

#include <string>
#include <vector>

namespace crevice {

/// A texture that the renderer creates. Targets whose lifetimes do not meet share one.
struct PlanTexture {
    Format format = Format::none;
    Extent extent;
    int samples = 1;
    std::vector<std::string> targets;  ///< In the order in which they use it.
    int copies = 1;  ///< One for all views, which use it in turn; or one a view, where what it
                     ///< holds outlives the view's passes: an output, a history.
};

/// Bytes of a texture, with all its copies.
double textureBytes(const PlanTexture& texture);

/// A target that some active pass writes.
struct PlanTarget {
    std::string name;
    int texture = -1;          ///< Index into Plan::textures.
    int drawn_texture = -1;    ///< What the writer draws into: `texture`, unless that is resolved
                               ///< from one with several samples.
    int first_pass = -1;       ///< The writer.
    int last_pass = -1;        ///< The last reader; the number of passes when an output or remembered.
    int history_texture = -1;  ///< What it held last frame, where someone reads that; the two
                               ///< textures change places before each frame.
    std::string format_reason = {};  ///< Why its format is not the list's first; mostly empty.
};

/// Where a sampler's texture comes from. `history` is what a target held in the last frame.
enum class InputKind { target, history, generated, imported, material, constant };

struct PlanInput {
    std::string sampler;  ///< GLSL name; empty for what the pass is `drawn_where`.
    InputKind kind = InputKind::target;
    int index = -1;  ///< Into targets (of history too), generated, imports, constants, maps.
    SamplerDesc sampling;
};

struct PlanAttachment {
    int target = -1;  ///< Into Plan::targets; -1: nobody reads it, so no texture stands behind it.
    std::string name;
    LoadOp load = LoadOp::discard;
    StoreOp store = StoreOp::store;
    std::array<float, 4> clear = {0, 0, 0, 0};
    std::string reason;  ///< Why this load and store.
};

/// What a uniform is fed from: a name of the value table (a param, a camera matrix, ...).
struct PlanUniform {
    std::string glsl;
    std::string value;
};

struct PlanPass {
    std::string name;
    PassType type = PassType::fullscreen;
    int program = -1;  ///< Into Plan::programs.
    std::vector<PlanAttachment> color;
    bool has_depth = false;
    PlanAttachment depth;     ///< Written; or only tested, where its load is LoadOp::load.
    Extent extent;
    int samples = 1;  ///< Of each attachment's pixels.
    StateDesc state;
    float draws_within = 0;  ///< Sizes of the view; what lies outside is not drawn. 0: all is.
    bool bounded = false;    ///< It is drawn within the bounds of the frame's things alone ...
    std::string shown_length = {};  ///< ... and of those at which this param comes to a pixel; may be empty.
    std::vector<PlanInput> inputs;
    std::vector<PlanUniform> renamed_uniforms;  ///< Only those whose names differ.
    std::vector<std::string> notes;  ///< What could have been left out and is not: "runs also where ...".
    double bytes_read = 0;     ///< An estimate a frame: one texel of each input a pixel and view.
    double bytes_written = 0;  ///< An estimate a frame.
};

/// Whether the pass is tested against a mask (`drawn_where`): its depth attachment is read, not written.
bool isMasked(const PlanPass& pass);

/// A program: the same key means the same text, compiled once.
struct PlanProgram {
    std::string key;    ///< 16 hex digits of a hash over the text.
    std::string label;  ///< The shader's name in the config.
    GlslStage vertex;
    GlslStage fragment;
    Place place;         ///< Of the shader in the config.
    std::string pointer;
    std::vector<std::string> varies_with = {};  ///< Features, traits and whole-number defines in its text.
    double variants = 1;                        ///< How many texts their values make, for each value ...
    std::vector<std::string> fractions = {};    ///< ... of these defines, which are no whole numbers.
};

/// One thing that the plan does not do.
struct LeftOut {
    std::string what;    ///< "pass filter_x", "attachment albedo"
    std::string rule;    ///< Of kRules; or "condition", which is meaning and cannot be switched off.
    std::string reason;  ///< One sentence.
    double bytes = 0;    ///< Estimated bytes a frame that are not moved.
    double texture_bytes = 0;  ///< Of textures that are not there.
    double ms = -1;            ///< What a pass takes where it runs, once someone has measured that.
    bool by_frame = false;     ///< What is left out, and what that saves, depends on the frame.
};

struct PlanConstant {
    float value = 0.0f;  ///< In all four channels of a 1x1 texture.
};

/// An exported output: a target, or a constant when `constant` is not -1.
struct PlanOutput {
    std::string name;
    int target = -1;
    int constant = -1;
};

struct Plan {
    std::string config;
    Extent extent;
    int views = 1;  ///< Every pass runs once for each, all passes of one before the next.
    bool reruns = false;  ///< Passes run in every frame, also where nothing that they read has changed:
                          ///< the rule "unchanged" is off.
    std::vector<PlanPass> passes;
    std::vector<PlanTarget> targets;
    std::vector<PlanTexture> textures;
    std::vector<PlanProgram> programs;
    std::vector<PlanConstant> constants;
    std::vector<GeneratedDesc> generated;  ///< Those that a pass uses, with `count` resolved.
    std::vector<ImportDesc> imports;       ///< Those that a pass uses.
    std::vector<PlanOutput> outputs;
    std::vector<LeftOut> left_out;
    double texture_bytes = 0;  ///< Of `textures`, with all their copies.
};

struct CompileOptions {
    Extent extent;
    std::vector<std::string> outputs = {};  ///< Names of outputs; empty means all.
    std::vector<std::string> keep = {};     ///< Names of rules to switch off, or "all".
};

/// Plans a description for a scene, a device and a size. The description's param and feature values
/// are the ones in force. Warnings come with the plan. Requires a description that `decode` made.
///
/// Errors: CV2xxx graph rules, CV4005 and CV6xxx for what the device cannot do, CV5xxx for what
/// GLSL and config disagree about; all of them, each at its place in the config or the shader.
Result<Plan> compile(const Description& description, const SceneTraits& traits,
                     const DeviceCaps& caps, const CompileOptions& options);

/// Text for people, stable enough to compare in tests.
std::string toText(const Plan& plan);
std::string toJson(const Plan& plan);
std::string toDot(const Plan& plan);
std::string toMermaid(const Plan& plan);

}  // namespace crevice
