// SPDX-License-Identifier: MIT
// What the page is made of: its scene on a device, seen by a camera; configs that run; the canvas,
// which shows one or two of their pictures beside each other; and the choice between configs.
#pragma once

#include <crevice/renderer.h>

#include "tools/measure/bench/quick.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"
#include "tools/show/page/engine/answers.h"

namespace crevice::page {

// --- slot.cpp: a config that runs in the page: loaded from its texts, changed by knobs, drawn ---

/// What to load.
struct SlotRequest {
    std::string config;
    std::string variant = {};
    bool file_scene = false;
    std::vector<std::string> outputs = {};  ///< Those that the config has are kept.
    std::string look = {};                  ///< A target to be kept, too; empty for none.
    bool without_occlusion = false;
};

class Slot {
public:
    /// Loads a config and plans it for the frame. A renderer that ran the same config before
    /// compiles what changed alone. Errors: those of loadConfig, decode and Renderer::create; what
    /// ran before stays.
    Status load(Device& device, const SourceSet& sources, const SlotRequest& request, Extent extent,
                const Frame& frame);

    bool loaded() const { return renderer_ != nullptr; }

    /// Errors: those of Renderer::setParam; CV4004 for a name that no param has.
    Status setParam(const std::string& name, const std::vector<float>& values);
    /// Errors: those of Renderer::setFeature.
    Status setFeature(const std::string& name, const std::string& word);

    /// Where the pixels of an output, view or target come from. Errors: CV2209 for one that is not
    /// kept.
    Result<OutputSource> sourceOf(const std::string& show) const;

    /// Params, features, outputs, targets, views and files, for a user interface.
    nlohmann::json state() const;

    /// A config that extends the shipped one by the smallest patch that makes `sources`' of it; the
    /// text itself of a config that is not shipped. Errors: those of loadConfig and decode.
    Result<std::string> patch(const SourceSet& sources) const;

    Renderer& renderer() const { return *renderer_; }

private:
    Status start(Device& device, Description description, const CompileOptions& options,
                 const Frame& frame);
    Status putBack();

    SlotRequest request_;
    std::unique_ptr<Renderer> renderer_;
    std::map<std::string, OutputSource> shown_;  // by what was asked for
    std::vector<std::string> files_;
    std::vector<std::string> variants_;
    std::vector<std::string> changed_params_;  // since the text was loaded
    std::vector<std::string> changed_features_;
    Description text_;     // as the text has it
    Description shipped_;  // the shipped config's params and features; empty for one's own
};

// --- stage.cpp ---

/// The scene, and the cameras that see it.
class Stage {
public:
    explicit Stage(Device& device) : device_(&device) {}

    /// Uploads a scene in the place of the one before. Errors: CV7003 for one without triangles;
    /// those of UploadedScene::upload. The scene of before stays.
    Status show(Scene scene);

    const Scene& scene() const { return scene_; }

    /// {"name", "diagonal", "cameras"}.
    nlohmann::json state() const;

    /// A camera as `--camera` says it. Errors: those of chooseCamera.
    Result<SceneCamera> camera(const std::string& text, Extent extent) const;

    /// {"eye", "at", "up", "fov_deg" or "ortho_height"}: looks at what lies in the middle of the
    /// view, at the median distance. Errors: those of chooseCamera and of drawing depth.
    Result<nlohmann::json> resolve(const std::string& text, Extent extent) const;

    /// The frame that the camera sees.
    Frame frameOf(const SceneCamera& camera, Extent extent) const;

private:
    Device* device_;
    Scene scene_;
    std::optional<UploadedScene> uploaded_;
};

/// A texture and how it is shown.
struct Shown {
    TextureId texture = {};
    float scale = 1.0f;
    float offset = 0.0f;
    bool grey = false;
    bool heat = false;  ///< In its place: black, red, yellow, white.
};

/// Scale and offset that spread what an image holds over [0, 1]: of depth without the background.
Shown stretched(TextureId texture, const Image& image, bool depth);

/// What the canvas shows, by a config of its own.
class Display {
public:
    /// `config` and `shader` are the texts of display.json and display.frag. Errors: those of
    /// loadConfig, decode and Renderer::create.
    static Result<Display> create(Device& device, const std::string& config,
                                  const std::string& shader, Extent extent);

    /// Draws into the canvas. Errors: those of Renderer::render and Device::present.
    Status draw(const Shown& left, const Shown& right, float split);

    Status resize(Extent extent);

private:
    Display(Device& device, std::unique_ptr<Renderer> renderer, Extent extent);

    Device* device_;
    std::unique_ptr<Renderer> renderer_;
    Extent extent_;
};

// --- chooser.cpp: what `crevice choose` does, for what the page shows: a part at a time, and
// frames are timed by the page, since a browser says only after a while what they took ---

class Chooser {
public:
    /// Begins anew: {"camera", "radius", "budget": "2ms", "error": 0.05}, of
    /// which all may lack. Errors: CV8001 for a budget that
    /// is none; those of Stage::camera.
    Status begin(Device& device, const Stage& stage, Extent extent, const Json& wanted);

    /// Does the next part. {"ok", "diagnostics", "more", "due", "lines", "found"}: whether there is
    /// more, whether a frame is to be timed before that, what was said, and, where that is new,
    /// what is known, by rising cost.
    Json step();

    /// Takes what the frame took that was due, and gives the same.
    Json add(const FrameTimes& times);

    /// Whose frame is to be timed; null where that is nothing.
    TurnTaker* due() const;

    /// {"text"}: a config that says what {"config", "overrides"} says. Errors: those of loadConfig.
    static Json textOf(const Json& found);

private:
    Json state(Json json);
    Json found() const;
    Diagnostics leftOut() const;

    BenchView view_;
    ChoiceLimits limits_;
    std::unique_ptr<QuickBench> bench_;
    std::vector<std::string> lines_;
    int disturbed_ = 0;  // frames in a row
};

}  // namespace crevice::page
