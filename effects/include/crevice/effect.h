// SPDX-License-Identifier: MIT
// An effect: a config running on a device, with everything set by name. It is all that an
// application needs which has a depth texture and wants its ambient occlusion.
//
//     auto device = makeGlDevice(loader);
//     auto effect = Effect::create(**device, "mobile+geometry/host_depth", {1920, 1080});
//     effect->setProjection(clip_from_view);
//     effect->setTexture("depth", depth_texture, Format::depth24, {1920, 1080});
//     effect->render();
//     GLuint ao = effect->nativeName("ao");
//
// Below it lie loadConfig, decode, compile and Renderer, for applications that want a single step.
#pragma once

#include <crevice/device.h>

namespace crevice {

class Governor;
class Renderer;
struct BakedConfig;
struct Description;
struct Frame;
struct FrontLevel;
struct GovernorOptions;
struct Limits;
struct SceneTraits;

/// What an output is drawn into.
struct OutputTexture {
    std::uint32_t native_name = 0;  ///< The API's (GLuint), a GL_TEXTURE_2D; 0 for no such output.
    Format format = Format::none;
    /// In pixels: 1x1 where the output is known to be constant, so sample it with texture().
    Extent extent = {};
};

class Effect {
public:
    /// Loads a config and creates every object that it needs on the device, which must outlive the
    /// effect. Its context must be current here and in all calls below.
    ///
    /// `config` is the name of a shipped config ("balanced"), or with modules laid over it
    /// ("balanced+geometry/host_depth"); the path of a file that ends in ".json"; or JSON text that
    /// begins with '{'. Files that a JSON text names are found as those of a file in the current
    /// folder. `outputs` names those that are wanted, such as {"ao"}; passes that none of them
    /// needs are left out. Empty means all but those that are drawn on request, such as "doubt". A
    /// config that asks for more than `limits` is refused (<crevice/config.h>); null means those
    /// there.
    ///
    /// Errors: those of loadConfig, decode and Renderer::create.
    static Result<Effect> create(Device& device, std::string_view config, Extent size,
                                 std::vector<std::string> outputs = {},
                                 const Limits* limits = nullptr);

    /// The same of what was baked (<crevice/baked.h>): a program links nothing that reads configs.
    /// Errors: those of Renderer::create, and CV2301.
    static Result<Effect> create(Device& device, const BakedConfig& baked, Extent size,
                                 std::vector<std::string> outputs = {});

    /// The same of a description that has its planner. `expected` is what its first frame is likely
    /// to be of, for which programs are made here; one of another kind plans again.
    static Result<Effect> create(Device& device, Description description,
                                 const SceneTraits& expected, Extent size,
                                 std::vector<std::string> outputs = {});

    Effect(Effect&&) noexcept;
    Effect& operator=(Effect&&) noexcept;
    ~Effect();

    /// The projection, without the view: 16 floats by columns, as for glUniformMatrix4fv. It may be
    /// off-centre, flipped, turned or left-handed. Default: orthographic, of the cube [-1, 1].
    void setProjection(const float* clip_from_view);

    /// Where the camera stands: 16 doubles by columns. Default: at the origin, looking along -z,
    /// or along +z under a left-handed projection; such a view mirrors. Without perspective that is
    /// one whose box lies along +z. What draws nothing and keeps no history does not depend on it.
    void setView(const double* view_from_world);

    /// The clip control (glClipControl) that the projection is made for and the host's textures
    /// were drawn with. Default: as it is when `render` is called.
    void setClipControl(const ClipControl& control);

    /// The depth range (glDepthRange) of the host's depth. Default: as it is in `render`.
    void setDepthRange(const DepthRange& range);

    /// What lengths such as "5%" and "40px" are relative to, in scene units: the diagonal of the
    /// box around the scene, and the median distance, along the view's axis, of what is seen. It
    /// may change with every frame. Default: 0, unknown; `render` fails where a length needs it.
    void setScale(double diagonal, double median_distance);

    /// Hands over a picture for an import of the config: a texture, a layer or part of one, a
    /// renderbuffer or the depth of a framebuffer. It stays the host's, and must be what it is said
    /// to be. Its content may change with every frame. A texture is read where it is; of all else
    /// `render` takes a copy, one blit a frame. Costs nothing where all is as before; hand it over
    /// again after giving it other storage. Another format plans again: shaders know its steps.
    ///
    /// Errors: CV2102 for a name that the config does not import; those of Device::adoptTexture and
    /// Renderer::setImportFormat; the texture of before stays.
    Status setTexture(std::string_view name, const HostTexture& texture);

    /// The same of a GL_TEXTURE_2D with one sample a pixel, by its API's name (GLuint).
    Status setTexture(std::string_view name, std::uint32_t native_name, Format format, Extent size);

    /// The same for one view, from 0: 1 is the first of Frame::other_views, which must be there.
    /// Views without a texture of their own take that of view 0, whose format is that of all.
    /// Errors: also CV6011 for a view that there is not, and for another format.
    Status setViewTexture(int view, std::string_view name, const HostTexture& texture);

    /// Sets a param: as many floats as it has components, or of a length three, two of them 0:
    /// scene units, percents of the scene's diagonal and pixels ({0, 5, 0} is "5%"); or a feature:
    /// "true", "false" or an enum's word. Errors and costs: those of Renderer::setParam and
    /// Renderer::setFeature.
    Status setParam(std::string_view name, float value);
    Status setParam(std::string_view name, const float* values, int count);
    Status setFeature(std::string_view name, std::string_view value);

    /// Draws the level of a front that fits a budget from now on, in place of the config
    /// (<crevice/governor.h>). Makes the programs of all, and the first frame warms each, so that
    /// a change of level compiles nothing. What was set, or is set, holds for all that have it.
    /// `render` changes the level before it draws; one that cannot be drawn is a warning, and the
    /// old one stays.
    ///
    /// Warns with CV6018 where the GPU's time cannot be measured, as on software renderers: hand
    /// over times of your own then, by Governor::addTime.
    ///
    /// Errors: those of `create` for each level, those of Governor::create, and CV2102 for levels
    /// that do not take the same textures or draws; what was drawn before stays.
    Status govern(std::vector<FrontLevel> levels, const GovernorOptions& options,
                  const Limits* limits = nullptr);

    /// The same with levels that were baked of a front. Errors: as above.
    Status govern(const std::vector<BakedConfig>& levels, const GovernorOptions& options);

    /// The same with levels that are loaded and have their planners, one for each of the
    /// governor's.
    Status govern(Governor governor, std::vector<Description> levels);

    /// For its report, budget and times. Null before `govern`, and after Renderer::reload.
    Governor* governor();

    /// Costs nothing where the size is as before. Errors: those of Renderer::resize; the old size
    /// stays.
    Status resize(Extent size);

    /// Draws what has changed since the last frame. Errors and warnings: those of Renderer::render;
    /// a warning CV6010 with the first frame where the projection is still the default.
    Status render();

    /// Has the driver compile what the first frame would wait for, one pass a call:
    ///
    ///     Result<bool> ready = effect->warm();
    ///     for (; ready && !*ready; ready = effect->warm()) drawLoadingScreen();
    ///
    /// True once all is ready. Call it when all is set that a frame is drawn from: textures,
    /// matrices and draws. Of a governed effect it warms all levels. Errors and more:
    /// Renderer::warm.
    Result<bool> warm();

    /// The API's name of an output's texture of one view, which is the device's: sample it, and
    /// neither write nor delete it. Ask again after each frame. 0 for an output that is not drawn.
    std::uint32_t nativeName(std::string_view output, int view = 0) const;

    /// The same with format and size. Good until the next call of `render`, `warm`, `resize`,
    /// `setParam` or `setFeature`, and as long as the effect.
    OutputTexture outputTexture(std::string_view name, int view = 0) const;

    /// The red of an output's first pixel two or three frames ago: of outputs that are one number,
    /// such as "doubt_rmse". Never waits: the first call has `render` read it from then on and
    /// gives nothing, later ones give it two or three frames on. Never gives anything where the
    /// output is not drawn: ask for it in `create`.
    std::optional<float> value(std::string_view output);

    /// Draws an output into a framebuffer or texture of the host's, scaled to a rectangle in it;
    /// AO, which has one channel, as grey.
    /// Errors: CV2209 for an output that the config does not have; those of Device::present.
    Status present(std::string_view output, const HostFramebuffer& target, int view = 0);

    /// The same as an id of the device, for Device::present and Device::readTexture.
    TextureId output(std::string_view name, int view = 0) const;

    /// Draw list, materials, lights, all that the next frame is drawn from (<crevice/frame.h>).
    Frame& frame();

    /// What runs below: the plan, times of passes, params as a patch (<crevice/renderer.h>).
    Renderer& renderer();

private:
    struct State;
    explicit Effect(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace crevice
