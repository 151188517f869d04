// SPDX-License-Identifier: MIT
#include <crevice/effect.h>

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace crevice {

namespace {

constexpr const char* kOwnText = "configs/(JSON text).json";

/// A texture of the host's under an id of the device.
struct HostTexture {
    std::string name;
    std::uint32_t native_name = 0;
    Format format = Format::none;
    Extent size;
    TextureId id;
};

Result<Description> describe(std::string_view config)
{
    MemorySources own;
    LayeredSources sources({&own, &shippedSources()});
    LoadRequest request{std::string(config)};
    if (config.substr(0, 1) == "{") {
        own.add(kOwnText, std::string(config), "(JSON text)");
        request.config = "(JSON text)";
    }
    const Result<Node> document = loadConfig(sources, request);
    if (!document) return document.diagnostics();
    return decode(*document, sources);
}

/// Errors: CV2102 where the config imports no texture of that name.
Status checkImport(const Description& description, std::string_view name)
{
    std::vector<std::string> imports;
    for (const ImportDesc& import : description.imports)
        if (import.type == ImportType::texture) imports.push_back(import.name);
    if (std::count(imports.begin(), imports.end(), name) > 0) return {};
    Diagnostic unknown{Code::reference_missing,
                       "the config imports no texture '" + std::string(name) + "'"};
    unknown.help = suggestName(name, std::move(imports), "textures");
    return unknown;
}

}  // namespace

struct Effect::State {
    Device& device;
    Frame frame = {};
    bool has_view = false;
    std::vector<HostTexture> textures = {};
    std::unique_ptr<Renderer> renderer = nullptr;

    explicit State(Device& of) : device(of) {}
    ~State()
    {
        renderer.reset();
        for (const HostTexture& texture : textures) device.destroy(texture.id);
    }

    /// That of the name, with a null id where it is new.
    HostTexture& texture(std::string_view name)
    {
        for (HostTexture& each : textures)
            if (each.name == name) return each;
        textures.push_back({std::string(name), 0, Format::none, {}, {}});
        return textures.back();
    }

    void importTextures()
    {
        frame.textures.clear();
        for (const HostTexture& each : textures)
            if (each.id) frame.textures.push_back({each.name, each.id, 0});
    }
};

Effect::Effect(std::unique_ptr<State> state) : state_(std::move(state)) {}
Effect::Effect(Effect&&) noexcept = default;
Effect& Effect::operator=(Effect&&) noexcept = default;
Effect::~Effect() = default;

Result<Effect> Effect::create(Device& device, std::string_view config, Extent size,
                              std::vector<std::string> outputs)
{
    Result<Description> description = describe(config);
    if (!description) return description.diagnostics();
    auto state = std::make_unique<State>(device);
    CompileOptions options;
    options.extent = size;
    options.outputs = std::move(outputs);
    auto renderer =
        Renderer::create(device, std::move(*description), options, traitsOf(state->frame));
    if (!renderer) return renderer.diagnostics();
    state->renderer = std::move(*renderer);
    return {Effect(std::move(state)), renderer.diagnostics()};
}

void Effect::setProjection(const float* clip_from_view)
{
    Camera& camera = state_->frame.camera;
    camera.clip_from_view = glm::make_mat4(clip_from_view);
    if (state_->has_view) return;
    const bool left_handed = camera.clip_from_view[2][3] > 0.0f;
    camera.view_from_world[2][2] = left_handed ? -1.0 : 1.0;
}

void Effect::setView(const double* view_from_world)
{
    state_->frame.camera.view_from_world = glm::make_mat4(view_from_world);
    state_->has_view = true;
}

Status Effect::setTexture(std::string_view name, std::uint32_t native_name, Format format,
                          Extent size)
{
    const Status known = checkImport(state_->renderer->description(), name);
    if (!known) return known;
    HostTexture& texture = state_->texture(name);
    if (texture.id && texture.native_name == native_name && texture.format == format &&
        texture.size == size)
        return {};
    TextureDesc desc;
    desc.label = name;
    desc.format = format;
    desc.extent = size;
    const Result<TextureId> adopted = state_->device.adoptTexture(native_name, desc);
    if (!adopted) return adopted.diagnostics();
    state_->device.destroy(texture.id);
    texture = {texture.name, native_name, format, size, *adopted};
    state_->importTextures();
    return {};
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

Status Effect::render() { return state_->renderer->render(state_->frame); }

std::uint32_t Effect::nativeName(std::string_view name) const
{
    return state_->device.nativeName(output(name));
}

TextureId Effect::output(std::string_view name) const { return state_->renderer->output(name); }

Frame& Effect::frame() { return state_->frame; }

Renderer& Effect::renderer() { return *state_->renderer; }

}  // namespace crevice
