// SPDX-License-Identifier: MIT
// A plan's objects on a device, and the commands that a frame of it consists of.
//
// Knows the plan alone. All that can fail or allocate is in `create`; `run` walks flat lists.
#pragma once

#include "core/gpu/owned.h"
#include "core/run/dirty_passes.h"
#include "core/run/pass_timers.h"
#include "core/run/view_draws.h"

namespace crevice {

/// Programs that are kept though the plan does not need them, so that a pass or feature that was
/// switched off comes back at once; beyond, the oldest go.
constexpr std::size_t kMaxIdlePrograms = 32;

class Execution {
public:
    using SharedProgram = std::shared_ptr<Owned<ProgramId>>;

    /// Programs by the key of their text.
    using Programs = std::vector<std::pair<std::string, SharedProgram>>;

    /// Makes the plan's textures, programs and framebuffers. Programs that `previous` has under the
    /// same key are shared with it, not compiled again, and so are the last kMaxIdlePrograms that
    /// no plan needs now; it may be null and may die at any time. With `remember` its histories go
    /// on, where it has all those of the plan: of the same name, format, size and views.
    ///
    /// Errors: the device's; CV5003 and CV5004 where a linked program has a uniform that the plan
    /// knows nothing of. Then nothing is left behind.
    static Result<std::unique_ptr<Execution>> create(Device& device, Plan plan,
                                                     const Execution* previous = nullptr,
                                                     bool remember = false);

    /// Makes programs that another plan has and this has not, and keeps them: all of that plan's
    /// come back. Errors: the device's.
    Result<Programs> prepare(const Plan& other);

    /// Keeps programs that `prepare` made for the next plan to find, whatever was dropped since.
    void keep(const Programs& programs);

    /// Takes a frame's textures, of the plan's views. Errors: CV6010, CV6011; then nothing changed.
    Status setImports(const Frame& frame);

    /// Whether draws, materials and lights can be drawn, and the former are those of the last
    /// frame: by Frame::draws_revision, or else one by one. `run` takes the answer for its frame.
    bool sameDraws(const Frame& frame);

    /// Draws what has changed of the plan since the last frame. Requires that `checkFrame` had
    /// nothing against the frame and that its imports were set. What cannot be drawn of it is left
    /// out with a warning CV6011. Errors: CV6004 and then nothing changed, CV6005, CV6009, CV6016.
    Status run(const Frame& frame);

    /// Draws one pixel of the next pass that was not drawn yet, into what the next frame draws
    /// over. True once there is none. Requires what `run` does. Errors: those of `run`; then the
    /// pass is to be drawn yet.
    Result<bool> warm(const Frame& frame);

    /// All passes of it, changed or not, with a wait before the frame and the time of each pass.
    Result<FrameTimes> runTimed(const Frame& frame);

    /// Has `run` measure passes from now on, read some frames later. False without timers.
    bool setTiming(bool on);

    /// What the latest frame took whose results are in; null before there are any.
    const FrameTimes* times() const { return timers_.latest(); }
    void takeTimes() { timers_.collect(); }

    /// Has `run` read the first texel of these outputs from now on.
    void follow(const std::vector<std::string>& outputs);

    /// What it was in the latest frame whose read is through; nothing before there is one.
    const std::array<float, 4>* value(std::string_view output) const;

    /// Sets a param of the plan to as many floats as its type has. Does nothing if no pass uses it.
    void setParam(std::string_view name, const float* values);

    TextureId output(std::string_view name, int view) const;
    const Plan& plan() const { return plan_; }

    /// The labels of the programs that had to be compiled for this plan.
    const std::vector<std::string>& compiled() const { return compiled_; }

private:
    using SharedTexture = std::shared_ptr<Owned<TextureId>>;

    struct UniformBinding {
        int location;
        GlslType type;
        int count;
        std::size_t offset;  // in the value table
    };

    struct TextureBinding {
        int location;
        int unit;
        TextureId texture;
        TextureId odd_frame;  // that takes its place in every second frame; null when none does
        SamplerDesc sampling;
        bool multisampled = false;   // what the shader's sampler reads
        int import = -1;             // into the plan's imports; the texture is then set a frame
        std::uint64_t revision = 0;  // of what it holds; only an import's changes
        int map = -1;                // of the material; set for each draw
    };

    struct PreparedPass {
        const PlanPass* plan;
        int view;
        bool reads_box = false;  // a uniform of it is a box's
        PassInfo info;
        ProgramId program;
        StateDesc state;
        std::vector<TextureBinding> textures;
        std::vector<TextureBinding> material_textures;  // set for each draw
        std::vector<UniformBinding> uniforms;
        std::vector<UniformBinding> draw_uniforms;  // sent for each draw
        std::vector<std::uint32_t> sent;            // what `uniforms` were when it ran last
        bool imports_changed = true;                // since then
        Owned<FramebufferId> framebuffer;
        Owned<FramebufferId> odd_frame;  // in every second frame; null likewise
    };

    // What a pass has sent of the draw before, so that it sends of the next what differs.
    struct SentDraw {
        const std::uint32_t* values = nullptr;  // null where nothing is known to be as it was sent
        const Material* material = nullptr;     // whose textures are bound; null likewise
    };

    struct Followed : Named {
        TextureId in_flight = {};  ///< Null while nothing is read.
        std::optional<std::array<float, 4>> value = {};
    };

    struct PreparedView {
        FrameHistory history;  // for the next frame
        FrameHistory before;   // for this one
        CameraMatrices camera = {};
        int turns = 0;  // frames in a row in which two cameras took turns
    };

    // A box of the plan: where it is for its passes, and for those that read what they drew.
    struct PreparedBox {
        ViewDraws draws;
        glm::dvec3 center = glm::dvec3(0.0);  // for the next time that it is drawn
        double edge = 0;                      // likewise
        bool moved = false;                   // since the last frame
        CameraMatrices drawn = {}, read = {};
        std::size_t last_pass = 0;  // of the plan, of the passes of this box
    };

    Execution(Device& device, Plan plan) : device_(device), plan_(std::move(plan)) {}

    // execution_build.cpp
    void takeHistories(const Execution& previous);
    Status createTextures();
    Status createGenerated();
    Status createPrograms(const Execution* previous);
    Status createProgram(const PlanProgram& program);
    Status createPasses(int view);
    Status createFilled(const std::string& label, Format format, const Image& image,
                        Owned<TextureId>& texture);
    Status createFramebuffer(PreparedPass& prepared, bool swapped);
    SharedProgram programOf(const std::string& key) const;
    void bindUniform(const UniformInfo& active, PreparedPass& prepared, Diagnostics& errors);
    Diagnostic unbound(const PlanPass& pass, const UniformInfo& active,
                       const PlanUniform* uniform) const;
    void bindTexture(const PlanInput& input, const UniformInfo& uniform, PreparedPass& prepared);
    TextureId textureOf(const PlanInput& input, int view, bool swapped) const;
    TextureId targetTexture(int target, int view, bool swapped) const;
    TextureId texture(int index, int view) const;

    // execution.cpp
    bool beginsView(std::size_t run) const { return run % plan_.passes.size() == 0; }
    Status draw(const Frame& frame, PassTimers& timers, bool all);
    const std::vector<char>& begin(const Frame& frame, bool all);
    bool beginView(const Frame& frame, PreparedView& view, const Camera& camera);
    void setView(const Frame& frame, const PreparedView& view);
    Status end(const Frame& frame);
    Status beginReads();
    void takeReads();
    void placeBoxes(const Frame& frame, bool draws_changed);
    void boundDraws();
    void takeBoxes(const Frame& frame, const std::vector<char>& chosen);
    bool takeUniforms(PreparedPass& pass);
    void swapHistories();
    void clearHistory(const PreparedPass& pass);
    void clearHistories();
    Status checkImports(const Frame& frame) const;
    void runPass(const PreparedPass& pass, PassCache::Share share, const CameraMatrices& camera,
                 ViewDraws& draws);
    void drawLayer(const PreparedPass& pass, const PassInfo& info, const CameraMatrices& camera,
                   ViewDraws& draws);
    void setTextures(const std::vector<TextureBinding>& textures);
    void setUniforms(const std::vector<UniformBinding>& uniforms);

    // execution_draws.cpp
    bool takeDraws(const Frame& frame);
    bool takeDraw(const Frame& frame, std::size_t index);
    void runDraws(const PreparedPass& pass, const CameraMatrices& camera, ViewDraws& draws);
    void setDraw(const PreparedPass& pass, std::size_t draw, ViewDraws& draws, SentDraw& sent);
    void drawByHost(const PreparedPass& pass, const DrawItem& item);

    Device& device_;
    Plan plan_;
    ValueTable values_{plan_};
    PassCache cache_{plan_};
    FrameClock clock_{device_.caps().software};
    PassTimers timers_{device_};  // of `run`,
    PassTimers waited_{device_};  // ... and of `runTimed`
    std::vector<Followed> followed_;
    std::vector<char> changed_ = std::vector<char>(plan_.passes.size() * plan_.views);  // by run
    DrawnList drawn_;  // what draw passes drew last
    ViewDraws view_draws_{drawn_};
    DrawWarnings warnings_{plan_};
    bool same_draws_ = false;  // those of the frame to be run
    bool swapped_ = false;     // whether histories and their targets have changed places
    bool remembers_ = false;   // whether histories hold anything
    std::size_t warm_ = 0;     // passes that were drawn, from the first on
    std::vector<std::string> compiled_;

    // Destroyed from the last to the first: framebuffers before the textures that they draw into.
    std::vector<std::vector<SharedTexture>> textures_ =  // the plan's, with their copies
        std::vector<std::vector<SharedTexture>>(plan_.textures.size());
    std::vector<Owned<TextureId>> constants_;
    std::vector<Owned<TextureId>> generated_;  // null where it is a kernel
    Owned<TextureId> white_;                   // for materials without a map
    Owned<TextureId> black_;                   // for optional imports that are absent
    // By key: the plan's, then the idle ones, the latest first.
    Programs programs_;
    std::vector<PreparedPass> runs_;  // the plan's passes for each view in turn
    std::vector<PreparedView> views_ = std::vector<PreparedView>(plan_.views);
    std::vector<PreparedBox> boxes_;
    // What boxes need not reach beyond: a cube about all draws, whose edge is infinite where bounds
    // are unknown.
    glm::dvec3 draws_center_ = glm::dvec3(0.0);
    double draws_edge_ = std::numeric_limits<double>::infinity();
};

}  // namespace crevice
