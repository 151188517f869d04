// SPDX-License-Identifier: MIT
#include <crevice/effect.h>

#include <crevice/baked.h>
#include <crevice/governor.h>
#include <crevice/renderer.h>

#include "effects/api/front.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace crevice {
namespace {

/// Errors: CV2102 where neither the config nor a level imports a texture of that name.
Status checkImport(const Renderer& renderer, std::string_view name)
{
    if (renderer.import(name)) return {};
    std::vector<std::string> imports;
    for (const ImportDesc& import : renderer.description().imports)
        if (import.type == ImportType::texture) imports.push_back(import.name);
    Diagnostic unknown{Code::reference_missing,
                       "the config imports no texture '" + std::string(name) + "'"};
    unknown.help = imports.empty()
                       ? "lay a module over it that takes textures of the host's, as in "
                         "'mobile+geometry/host_depth'"
                       : suggestName(name, std::move(imports), "textures");
    return unknown;
}

/// A warning where a config asks for the camera, and the projection is what nobody sets.
Diagnostics checkProjection(const Description& description, const Camera& camera)
{
    if (camera.clip_from_view != Camera().clip_from_view) return {};
    for (const ImportDesc& import : description.imports) {
        if (import.type != ImportType::camera) continue;
        Diagnostic unset{Code::missing_import,
                         "the projection was never set: occlusion is that of an orthographic view "
                         "of the cube [-1, 1]"};
        unset.help = "set the matrix that drew the depth, by Effect::setProjection";
        unset.severity = Severity::warning;
        return {unset};
    }
    return {};
}

}  // namespace

struct Effect::State {
    /// A texture of the host's under an id of the device.
    struct SetTexture {
        int view;
        std::string import;
        HostTexture host;
        TextureId id;
    };

    Device& device;
    Frame frame = {};
    bool has_projection = false, has_view = false, has_drawn = false;
    std::vector<SetTexture> textures = {};
    std::unique_ptr<Renderer> renderer = nullptr;
    std::optional<Governor> governor = {};
    int warm_levels = 0;            ///< From the first on; one more where the governor's is too.
    std::uint64_t times_taken = 0;  ///< FrameTimes::count of those that the governor has.

    explicit State(Device& of) : device(of) {}
    ~State()
    {
        renderer.reset();
        for (const SetTexture& texture : textures) device.destroy(texture.id);
    }

    /// That of the view and name, with a null id where it is new.
    SetTexture& texture(int view, std::string_view name)
    {
        for (SetTexture& each : textures)
            if (each.view == view && each.import == name) return each;
        textures.push_back({view, std::string(name), {}, {}});
        return textures.back();
    }

    std::vector<ImportedTexture>& texturesOf(int view)
    {
        return view == 0 ? frame.textures
                         : frame.other_views[static_cast<std::size_t>(view - 1)].textures;
    }

    int views() const { return 1 + static_cast<int>(frame.other_views.size()); }

    /// Errors: CV6011 for a view that there is not, and for another format than view 0's.
    Status checkView(int view, std::string_view name, Format format) const
    {
        if (view < 0 || view >= views())
            return Diagnostic{Code::bad_input,
                              "there is no view " + std::to_string(view) + ", but " +
                                  std::to_string(views()) + " views",
                              "give the frame that view first"};
        const std::string& first = renderer->import(name)->format;
        if (view == 0 || first == formatInfo(format).name) return {};
        return Diagnostic{Code::bad_input,
                          std::string(name) + " of view " + std::to_string(view) + " is " +
                              formatInfo(format).name + ", and that of view 0 is " + first,
                          "take one format for all views, and set view 0's texture first"};
    }

    /// Of views that are no longer there.
    void dropTextures()
    {
        const auto gone = [this](const SetTexture& each) {
            if (each.view < views()) return false;
            device.destroy(each.id);
            return true;
        };
        textures.erase(std::remove_if(textures.begin(), textures.end(), gone), textures.end());
    }

    /// Null without one, and where a reload took its levels away.
    Governor* governing() { return governor && renderer->level() >= 0 ? &*governor : nullptr; }

    /// Goes to a level; one that cannot be drawn is a warning, and the old one stays.
    Diagnostics goTo(int level)
    {
        const int drawn = renderer->level();
        Diagnostics found = renderer->setLevel(level).diagnostics();
        if (hasErrors(found) && level == governor->level()) governor->stayAt(drawn);
        for (Diagnostic& each : found) each.severity = Severity::warning;
        return found;
    }

    bool levelsAreWarm() const { return warm_levels > static_cast<int>(governor->levels().size()); }

    /// Renderer::warm of each level in turn, and of the governor's last.
    Result<bool> warmLevels()
    {
        const int levels = static_cast<int>(governor->levels().size());
        Diagnostics all = goTo(warm_levels < levels ? warm_levels : governor->level());
        const Result<bool> ready = renderer->warm(frame);
        if (!ready) return ready;
        if (*ready && !levelsAreWarm()) ++warm_levels;
        append(all, ready.diagnostics());
        return {*ready && levelsAreWarm(), std::move(all)};
    }

    /// Draws the level that the latest time leads to.
    Status drawGoverned()
    {
        Diagnostics all;
        while (!levelsAreWarm()) {
            const Result<bool> warm = warmLevels();
            if (!warm) return warm.diagnostics();
            append(all, warm.diagnostics());
        }
        renderer->takeTimes();
        const FrameTimes* const times = renderer->times();
        if (times && times->count != std::exchange(times_taken, times->count))
            governor->addTime(times->total_ms, renderer->level());
        const std::array<float, 4>* const estimate = renderer->value(kErrorEstimate);
        governor->setEstimate(estimate ? (*estimate)[0] : 0.0);
        append(all, goTo(governor->level()));
        const Status drawn = renderer->render(frame);
        if (!drawn) return drawn;
        append(all, drawn.diagnostics());
        return all;
    }

    /// Makes the frame ready to be drawn.
    Status prepare()
    {
        if (has_projection && !has_view) chooseView();
        dropTextures();
        for (const SetTexture& texture : textures)
            if (texture.id && texture.host.copied())
                if (Status status = device.refresh(texture.id); !status) return status;
        return {};
    }

    /// A view of the projection's own hand.
    void chooseView()
    {
        Camera seen = frame.camera;
        if (!seen.clip_control) seen.clip_control = device.clipControl();
        frame.camera.view_from_world[2][2] = seen.leftHanded() ? -1.0 : 1.0;
    }
};

Effect::Effect(std::unique_ptr<State> state) : state_(std::move(state)) {}
Effect::Effect(Effect&&) noexcept = default;
Effect& Effect::operator=(Effect&&) noexcept = default;
Effect::~Effect() = default;

Result<Effect> Effect::create(Device& device, const BakedConfig& baked, Extent size,
                              std::vector<std::string> outputs)
{
    return create(device, baked.description, baked.scene, size, std::move(outputs));
}

Result<Effect> Effect::create(Device& device, Description description, const SceneTraits& expected,
                              Extent size, std::vector<std::string> outputs)
{
    auto state = std::make_unique<State>(device);
    auto renderer = Renderer::createPlanned(device, std::move(description),
                                            {size, std::move(outputs), {}}, expected);
    if (!renderer) return renderer.diagnostics();
    state->renderer = std::move(*renderer);
    return {Effect(std::move(state)), renderer.diagnostics()};
}

void Effect::setProjection(const float* clip_from_view)
{
    state_->frame.camera.clip_from_view = glm::make_mat4(clip_from_view);
    state_->has_projection = true;
}

void Effect::setView(const double* view_from_world)
{
    state_->frame.camera.view_from_world = glm::make_mat4(view_from_world);
    state_->has_view = true;
}

void Effect::setClipControl(const ClipControl& control)
{
    state_->frame.camera.clip_control = control;
}

void Effect::setDepthRange(const DepthRange& range) { state_->frame.camera.depth_range = range; }

void Effect::setScale(double diagonal, double median_distance)
{
    state_->frame.scale = {diagonal, median_distance};
}

Status Effect::setTexture(std::string_view name, const HostTexture& host)
{
    return setViewTexture(0, name, host);
}

Status Effect::setViewTexture(int view, std::string_view name, const HostTexture& host)
{
    Status known = checkImport(*state_->renderer, name);
    if (known) known = state_->checkView(view, name, host.format);
    if (!known) return known;
    std::vector<ImportedTexture>& textures = state_->texturesOf(view);
    State::SetTexture& texture = state_->texture(view, name);
    if (texture.id && texture.host == host && findNamed(textures, name)) return {};
    HostTexture labelled = host;
    labelled.label = name;
    const Result<TextureId> adopted = state_->device.adoptTexture(labelled);
    if (!adopted) return adopted.diagnostics();
    const Format format = state_->device.info(*adopted).format;
    const Status planned = view == 0 ? state_->renderer->setImportFormat(name, format) : Status();
    if (!planned) {
        state_->device.destroy(*adopted);
        return planned;
    }
    state_->device.destroy(texture.id);
    texture = {view, texture.import, std::move(labelled), *adopted};
    for (ImportedTexture& each : textures) {
        if (each.name != name) continue;
        each = {texture.import, texture.id};
        return planned;
    }
    textures.push_back({texture.import, texture.id});
    return planned;
}

Status Effect::setTexture(std::string_view name, std::uint32_t native_name, Format format,
                          Extent size)
{
    return setTexture(name, HostTexture{native_name, "", format, size});
}

Status Effect::setParam(std::string_view name, float value) { return setParam(name, &value, 1); }

Status Effect::setParam(std::string_view name, const float* values, int count)
{
    return state_->renderer->setParam(name, values, count);
}

Status Effect::setFeature(std::string_view name, std::string_view value)
{
    return state_->renderer->setFeature(name, value);
}

Status Effect::resize(Extent size) { return state_->renderer->resize(size); }

Status Effect::render()
{
    if (Status status = state_->prepare(); !status) return status;
    const Status status =
        state_->governing() ? state_->drawGoverned() : state_->renderer->render(state_->frame);
    if (!status || std::exchange(state_->has_drawn, true) || state_->has_projection) return status;
    Diagnostics diagnostics = status.diagnostics();
    append(diagnostics, checkProjection(state_->renderer->description(), state_->frame.camera));
    return diagnostics;
}

Result<bool> Effect::warm()
{
    if (Status status = state_->prepare(); !status) return status.diagnostics();
    return state_->governing() ? state_->warmLevels() : state_->renderer->warm(state_->frame);
}

Status Effect::govern(const std::vector<BakedConfig>& levels, const GovernorOptions& options)
{
    Result<std::vector<FrontLevel>> front = frontOf(levels);
    if (!front) return front.diagnostics();
    Result<Governor> governor = Governor::create(std::move(*front), options);
    if (!governor) return governor.diagnostics();
    std::vector<Description> descriptions;
    for (const BakedConfig& each : levels) descriptions.push_back(each.description);
    return govern(std::move(*governor), std::move(descriptions));
}

Status Effect::govern(Governor governor, std::vector<Description> levels)
{
    const Status status = state_->renderer->setLevels(std::move(levels), governor.level());
    if (!status) return status;
    state_->governor = std::move(governor);
    state_->renderer->follow(kErrorEstimate);
    state_->warm_levels = 0;
    Diagnostics all = status.diagnostics();
    append(all, state_->renderer->setTiming(true).diagnostics());
    for (Diagnostic& each : all)
        if (each.code == Code::no_timers)
            each.help = "hand over times of your own, by Governor::addTime";
    return all;
}

Governor* Effect::governor() { return state_->governing(); }

std::uint32_t Effect::nativeName(std::string_view name, int view) const
{
    return state_->device.nativeName(output(name, view));
}

OutputTexture Effect::outputTexture(std::string_view name, int view) const
{
    const Plan& plan = state_->renderer->plan();
    const PlanOutput* output = findNamed(plan.outputs, name);
    if (!output) return {};
    OutputTexture texture{nativeName(name, view), Format::rgba8, {1, 1}};
    if (output->constant >= 0) return texture;
    const PlanTexture& drawn = plan.textures[plan.targets[output->target].texture];
    return {texture.native_name, drawn.format, drawn.extent};
}

Status Effect::present(std::string_view output, const HostFramebuffer& target, int view)
{
    const Plan& plan = state_->renderer->plan();
    if (findNamed(plan.outputs, output))
        return state_->device.present(state_->renderer->output(output, view), target);
    Diagnostic unknown{Code::output_missing, "there is no output '" + std::string(output) + "'"};
    unknown.help = suggestName(output, namesOf(plan.outputs), "outputs");
    return unknown;
}

std::optional<float> Effect::value(std::string_view output)
{
    state_->renderer->follow(output);
    const std::array<float, 4>* const texel = state_->renderer->value(output);
    return texel ? std::optional<float>((*texel)[0]) : std::nullopt;
}

TextureId Effect::output(std::string_view name, int view) const
{
    return state_->renderer->output(name, view);
}

Frame& Effect::frame() { return state_->frame; }

Renderer& Effect::renderer() { return *state_->renderer; }

}  // namespace crevice
