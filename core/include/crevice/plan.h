// SPDX-License-Identifier: MIT
// A plan: what will run, in which order, on which textures, and what was left out and why.
//
// It holds all that running needs and knows no config: `compile` makes one, or a host fills one.
#pragma once

#include <crevice/frame.h>

#include <array>

namespace crevice {

struct Optimization {
    const char* name;     ///< As CompileOptions::disable and Elided::optimization have it.
    const char* meaning;  ///< What it leaves out.
};

/// Those that may be switched off.
extern const Optimization kOptimizations[7];

/// A texture that the renderer creates. Targets whose lifetimes do not meet share one.
struct PlanTexture {
    Format format = Format::none;
    Extent extent;
    int samples = 1;
    int depth = 0;                     ///< Layers, of a volume.
    bool mips = false;                 ///< With smaller levels.
    std::vector<std::string> targets;  ///< In the order in which they use it.
    /// One for all views in turn; or one a view, of what outlives its passes: an output, a history.
    int copies = 1;
};

/// Bytes of a texture, with all its copies.
double textureBytes(const PlanTexture& texture);

/// A target that some active pass writes.
struct PlanTarget {
    std::string name;
    int texture = -1;  ///< Index into Plan::textures.
    /// What the writer draws into: `texture`, unless that is resolved from one of several samples.
    int drawn_texture = -1;
    int first_pass = -1;  ///< The writer.
    int last_pass = -1;   ///< The last reader; the number of passes when an output or remembered.
    /// What it held last frame, where someone reads that; the two change places before each frame.
    int history_texture = -1;
};

/// Where a sampler's texture comes from. `history` is what a target held in the last frame.
enum class InputKind { target, history, generated, imported, material, constant };

struct PlanInput {
    std::string name;  ///< Of the sampler in GLSL; empty for what the pass is `mask`.
    InputKind kind = InputKind::target;
    int index = -1;  ///< Into targets (of history too), generated, imports, constants, maps.
    SamplerDesc sampling;
};

struct PlanAttachment {
    int target = -1;  ///< Into Plan::targets; -1: no pass reads it, so no texture stands behind it.
    std::string name;
    LoadOp load = LoadOp::discard;
    StoreOp store = StoreOp::store;
    std::array<float, 4> clear = {0, 0, 0, 0};
};

/// A value that may change from frame to frame without another plan.
struct PlanParam {
    std::string name;
    GlslType type = GlslType::float_;             ///< float, int or a vector of floats.
    std::array<float, 4> initial = {0, 0, 0, 0};  ///< Until `setParam`; as many as the type has.
};

/// A cube around the camera, see BoxDesc.
struct PlanBox {
    std::string name;
    double factor = 1;        ///< An edge is this times
    std::vector<int> params;  ///< ... the first component of each of these of Plan::params.
    int steps = 8;
};

/// Where a uniform's value comes from: of `frame` the same for a pass, of `draw` for each item.
enum class UniformSource { param, frame, draw, kernel, box };

/// A uniform of a pass and the value that it is fed from.
struct PlanUniform {
    std::string name;  ///< In GLSL.
    GlslType type = GlslType::float_;
    int count = 1;  ///< Elements; more than 1 is an array.
    UniformSource source = UniformSource::param;
    int index = -1;  ///< Into Plan::params, kFrameValues (of frame and draw), generated or boxes.
};

struct PlanPass {
    std::string name;
    PassType type = PassType::fullscreen;
    int program = -1;  ///< Into Plan::programs.
    std::vector<PlanAttachment> color;
    bool has_depth = false;
    PlanAttachment depth;  ///< Written; or only tested, where its load is LoadOp::load.
    Extent extent;
    /// Into Plan::boxes: what it draws is seen by that, not by the camera, and stays until that or
    /// what lies in it changes; then one such pass a frame is drawn, in turn. -1: none.
    int box = -1;
    int layers = 0;  ///< Of the volumes that it draws; 0: none.
    int layers_at_once = 1;
    int frames = 1;        ///< Over which its layers are spread when they are drawn again.
    int over = -1;         ///< Into Plan::passes: the one on whose outputs it draws; -1: none.
    int samples = 1;       ///< Of each attachment's pixels.
    bool blended = false;  ///< Draws what is blended, and nothing else.
    StateDesc state;
    float frustum_scale = 0;    ///< Sizes of the view; what lies outside is not drawn. 0: all is.
    bool scissor = false;       ///< It is drawn within the bounds of the frame's draws alone ...
    int cull_below_pixel = -1;  ///< ... at which this of Plan::params comes to a pixel; -1: of all.
    std::vector<PlanInput> inputs;
    std::vector<PlanUniform> uniforms;
};

/// Whether the pass is tested against a mask (`mask`): its depth attachment is read, not written.
bool isMasked(const PlanPass& pass);

/// A program: the same key means the same text, compiled once.
struct PlanProgram {
    std::string key;    ///< 16 hex digits of a hash over the text.
    std::string label;  ///< The shader's name in the config.
    GlslStage vertex;
    GlslStage fragment;
    Place place;  ///< Of the shader in the config.
    std::string pointer;
};

/// One part of the work that the plan leaves out.
struct Elided {
    std::string what;  ///< "pass filter_x", "attachment albedo"
    /// Of kOptimizations; or "condition", "replaced" (`Description::left_out`), "device" (what
    /// it cannot hold), which are meaning and cannot be switched off.
    std::string optimization;
    std::string reason;  ///< One sentence.
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
    int views = 1;        ///< Every pass runs once for each, all passes of one before the next.
    bool reruns = false;  ///< Passes run also where nothing they read has changed: no "cached".
    std::vector<PlanPass> passes;
    std::vector<PlanTarget> targets;
    std::vector<PlanTexture> textures;
    std::vector<PlanProgram> programs;
    std::vector<float> constants;          ///< Each in all four channels of a 1x1 texture.
    std::vector<PlanBox> boxes;            ///< Those that a pass uses.
    std::vector<PlanParam> params;         ///< Those that a pass uses.
    std::vector<GeneratorDesc> generated;  ///< Those that a pass uses.
    std::vector<ImportDesc> imports;       ///< Those that a pass uses.
    std::vector<PlanOutput> outputs;
    std::vector<Elided> elided;
    double texture_bytes = 0;  ///< Of `textures`, with all their copies.
};

/// What a plan is made for, beside a description, a scene and a device.
struct CompileOptions {
    Extent extent;
    std::vector<std::string> outputs = {};  ///< Names; empty means all but OutputDesc::on_request.
    std::vector<std::string> disable = {};  ///< Names of optimizations to switch off, or "all".
    bool strict = false;  ///< What of a frame no shader could draw is an error, not a warning.
};

struct Description;

/// Makes plans of a description: `compile`, or a baked effect (<crevice/baked.h>).
class PlanMaker {
public:
    virtual ~PlanMaker() = default;

    /// Errors and warnings: those of `compile`, or of readBaked.
    virtual Result<Plan> plan(const Description& description, const SceneTraits& traits,
                              const DeviceCaps& caps, const CompileOptions& options) const = 0;
};

}  // namespace crevice
