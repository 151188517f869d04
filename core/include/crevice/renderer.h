// SPDX-License-Identifier: MIT
// The renderer: a description running on a device.
//
//     auto document = loadConfig(shippedSources(), {"learnopengl"});
//     auto description = decode(*document, shippedSources());
//     auto renderer = Renderer::create(device, *description, {{1920, 1080}}, traitsOf(frame));
//     (*renderer)->render(frame);
//     TextureId ao = (*renderer)->output("ao");
//
// After the first frame, `render` allocates no memory and creates no GL object, until a size, a
// trait or a param that is bound as a define changes.
#pragma once

#include <crevice/config.h>

namespace crevice {

class Renderer {
public:
    /// Compiles the plan and creates every object that it needs. The device must outlive it.
    ///
    /// A feature's words that set values, levels of quality, are prepared too. One that this device
    /// cannot run is a warning, and an error when it is set.
    ///
    /// Errors: those of `compile`, CV5001 to CV5004 from the driver, CV6004 where the device's
    /// context is not current, CV6005 to CV6009, CV6016.
    static Result<std::unique_ptr<Renderer>> create(Device& device, Description description,
                                                    const CompileOptions& options,
                                                    const SceneTraits& traits);

    /// The same of a description that has its planner, as baked ones have: links no compiler.
    static Result<std::unique_ptr<Renderer>> createPlanned(Device& device, Description description,
                                                           const CompileOptions& options,
                                                           const SceneTraits& traits);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Runs those passes of the plan whose input has changed since the last frame (Frame says how
    /// that is known), and those after them. A frame with other traits than the plan was made for
    /// is planned again first; where that fails, the old plan and its pictures stay. The warnings
    /// of a new plan come back with the frame that it was made for: look at `diagnostics()` always.
    ///
    /// What of a frame no shader could draw is left out with a warning CV6011, in every frame that
    /// has it: draws with a mesh or texture that the device does not have, with indices past the
    /// mesh's, or with a matrix, bounds or material that are not finite or not there, and lights
    /// that are not finite. With CompileOptions::strict that is an error instead, before anything
    /// is drawn. A draw without normals, uv or the buffer of a uniform block that its pass reads is
    /// a warning, once for each plan: CV6019, CV6020.
    ///
    /// Errors: CV6010 and CV6011 for the frame's textures, scale and cameras; CV6004 where the
    /// device's context is not current, and the frame then counts as not drawn; CV6005 and CV6009
    /// from the driver, and CV6016 where the context is lost: destroy the renderer, and make
    /// another on a new device from the same `description()`.
    Status render(const Frame& frame);

    /// The same, but runs every pass and measures how long each takes: by the GPU's timer where the
    /// device has one, else waiting for the GPU after each pass: by the processor time of the
    /// process on a software renderer, by the wall clock elsewhere. Slower than `render`, and
    /// allocates.
    ///
    /// Errors: those of `render`. A void measurement is no error, see FrameTimes.
    Result<FrameTimes> renderTimed(const Frame& frame);

    /// Has the driver compile now what it would compile in the first frame, as it does where
    /// shaders depend on state, formats and vertices: each call draws one pixel of one pass, so
    /// that a loading screen goes on between calls. True once all is ready, at once where a frame
    /// was drawn. The first frame comes out as without it; `output` has no picture before that.
    ///
    /// `frame` is what `render` will get: its textures, draws and materials decide what is
    /// compiled, and a plan that it needs is made here. Draw callbacks are called. What a new plan
    /// compiles, after another size, feature, config or kind of scene, is to be warmed again.
    ///
    /// Errors: those of `render`; the next call tries again.
    Result<bool> warm(const Frame& frame);

    /// Has `render` measure from now on what its passes take on the GPU, without a wait and without
    /// allocating once the first frames are through: `times` has it some frames later. Which passes
    /// run does not change. Default: off.
    ///
    /// Warns with CV6018 where nothing can be measured: the device has no timer that can be
    /// trusted, as on software renderers.
    Status setTiming(bool on);

    /// What the latest frame took whose results are in. Null before there are any: after
    /// `setTiming` and after each new plan. Good until the next `render`.
    const FrameTimes* times() const;

    /// Takes the results that are in by now, as `render` does before it draws.
    void takeTimes();

    /// Has `render` read the first texel of an output from now on, without a wait: a mean or an
    /// estimate that the plan computed. Costs a draw of one pixel a frame. Does nothing while
    /// the output is not drawn.
    void follow(std::string_view output);

    /// That texel's channels, those that the format lacks as GLSL has them, in the latest frame
    /// whose read is through: two or three frames ago. Null before there is one, after each new
    /// plan, and for outputs that are not followed. Good until the next `render`.
    const std::array<float, 4>* value(std::string_view output) const;

    /// Sets a param's value: as many floats as it has components, or the three of a length
    /// (ParamDesc::value). Costs nothing, but for params bound as defines, those that a count or
    /// size is taken from, values at which a pass is or was a no-op and a radius that other formats
    /// serve better: those plan again. Only a define, or a pass that never ran, compiles a shader,
    /// which a warning CV5010 names; what was compiled is kept for when the value comes back.
    ///
    /// Errors: CV4001, CV4003, CV4004, CV3006; the old value stays.
    Status setParam(std::string_view name, const float* values, int count);
    Status setParam(std::string_view name, float value) { return setParam(name, &value, 1); }

    /// Says which format the host's texture for an import has, where it is another than the
    /// config's: shaders allow for its steps. Plans again.
    ///
    /// Errors: CV2102; those of `create`, and then the old format stays.
    Status setImportFormat(std::string_view name, Format format);

    /// Sets a feature ("true", "false" or an enum's word), and what that word sets; plans again.
    /// Warns with CV5010 where that compiled a shader. The words of a feature that sets values,
    /// such as `quality`, compile none: all that they run was compiled by `create`, `reload` or the
    /// first frame of a scene of other traits. After a change of another define they do, once each.
    ///
    /// Errors: CV2105, CV2106; the old value stays.
    Status setFeature(std::string_view name, std::string_view value);

    /// Puts another description, such as an edited config, in the place of the present one. What
    /// `setParam` and `setFeature` changed stays changed; a warning CV4006 names what the new
    /// description has no place for. Programs of the same text are not compiled again, so a variant
    /// that ran before is there within a frame. Histories are cleared, and there are no levels.
    ///
    /// Errors: those of `create`; the old description and its pictures stay.
    Status reload(Description description, const CompileOptions& options);

    /// Takes descriptions, one at least, between which `setLevel` chooses, and draws one. Programs
    /// of all are made here, and again where size or traits change. What is set at run time, or was
    /// before, holds for all levels that have a place for it; a warning CV4006 names what has none.
    ///
    /// Errors: those of `create` for any of them, and CV2102 where they do not take the same of the
    /// host; the old description and its pictures stay.
    Status setLevels(std::vector<Description> levels, int level);

    /// Draws another level. Costs a plan, textures and framebuffers, and compiles no shader.
    /// Histories of the same names, formats and sizes go on. Errors: those of `create`; the old
    /// level stays.
    Status setLevel(int index);

    /// That is drawn; -1 without levels.
    int level() const;

    /// The texture that the config, or a level, imports under that name; null where there is none.
    const ImportDesc* import(std::string_view name) const;

    /// Plans again for another size. Errors: those of `create`; the old size stays. Warns of levels
    /// that cannot be drawn at it.
    Status resize(Extent extent);

    /// The texture behind an output of a view, 0 up to `plan().views`: owned by the renderer, valid
    /// until the next plan, or the next frame where the output is a target with a history. Null
    /// when there is none. Plans are made by resize, reload, setFeature and setParam as they say,
    /// and by a frame of other traits: so ask after each frame. Its format and size are those of
    /// the plan's target, and 1x1 rgba8 where the plan found the output to be constant.
    /// `Device::nativeName` has the API's name of it.
    TextureId output(std::string_view name, int view = 0) const;

    const Plan& plan() const;
    const Description& description() const;

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);

    /// The frame, with the host's clip control and depth range where its cameras have none.
    const Frame& asHostDraws(const Frame& frame);

    std::unique_ptr<State> state_;
    Frame clipped_;  // the last frame that had to take it
};

}  // namespace crevice
