// SPDX-License-Identifier: MIT
// Running a prepared plan: no allocation, no creation, no decision that could be made before.
#include "core/execution.h"

#include <algorithm>

#include "core/frame_values.h"

namespace crevice {
namespace {

// The state that culls what `state` keeps, for things that are mirrored.
StateDesc turned(StateDesc state)
{
    state.cull = state.cull == Cull::back ? Cull::front : Cull::back;
    return state;
}

TextureId findTexture(const std::vector<ImportedTexture>& textures, std::string_view name)
{
    for (const ImportedTexture& texture : textures)
        if (texture.name == name) return texture.texture;
    return {};
}

TextureId findTexture(const Frame& frame, std::size_t view, std::string_view name)
{
    const TextureId own =
        view > 0 ? findTexture(frame.other_views[view - 1].textures, name) : TextureId{};
    return own ? own : findTexture(frame.textures, name);
}

Diagnostic missing(const ImportDesc& import)
{
    Diagnostic error{Code::missing_import,
                     "the frame has no texture for import '" + import.name + "'"};
    error.place = import.place;
    error.pointer = import.pointer;
    error.help = "add one of that name to Frame::textures, or make the import optional";
    return error;
}

Diagnostic otherSamples(const ImportDesc& import, const char* pass, int samples)
{
    const std::string found = samples == 1 ? "one sample" : std::to_string(samples) + " samples";
    Diagnostic error{Code::bad_input, "the frame's texture '" + import.name + "' has " + found +
                                          " a pixel, and pass '" + pass + "' reads it as " +
                                          (samples == 1 ? "sampler2DMS" : "sampler2D")};
    error.place = import.place;
    error.pointer = import.pointer;
    error.help = samples == 1 ? "adopt it with its TextureDesc::samples, or take a module for one"
                              : "resolve it, or take a module that reads samples";
    return error;
}

}  // namespace

Status Execution::checkImports(const Frame& frame) const
{
    for (const ImportDesc& import : plan_.imports)
        if (import.type == ImportType::texture && !import.optional &&
            !findTexture(frame.textures, import.name)) return missing(import);
    for (std::size_t view = 0; view < views_.size(); ++view) {
        for (const PreparedPass& pass : views_[view].passes) {
            for (const TextureBinding& binding : pass.textures) {
                if (binding.import < 0) continue;
                const ImportDesc& import = plan_.imports[binding.import];
                const TextureId texture = findTexture(frame, view, import.name);
                const int samples = texture ? device_.samples(texture) : 1;
                if (binding.multisampled != (samples > 1))
                    return otherSamples(import, pass.info.label, samples);
            }
        }
    }
    return {};
}

Status Execution::setImports(const Frame& frame)
{
    if (Status status = checkImports(frame); !status) return status;
    for (std::size_t view = 0; view < views_.size(); ++view) {
        for (PreparedPass& pass : views_[view].passes) {
            for (TextureBinding& binding : pass.textures) {
                if (binding.import < 0) continue;
                const TextureId texture =
                    findTexture(frame, view, plan_.imports[binding.import].name);
                binding.texture = texture ? texture : black_.id();
            }
        }
    }
    return {};
}

Status Execution::run(const Frame& frame)
{
    begin();
    for (std::size_t view = 0; view < views_.size(); ++view) {
        const CameraMatrices camera = beginView(frame, view);
        for (const PreparedPass& pass : views_[view].passes) runPass(pass, frame, camera);
    }
    return end();
}

void Execution::begin()
{
    swapHistories();
    device_.beginFrame();
    if (!remembers_) clearHistories();
    remembers_ = true;
}

/// Puts the view's values into the table.
CameraMatrices Execution::beginView(const Frame& frame, std::size_t view)
{
    const CameraMatrices camera = cameraMatrices(cameraOf(frame, view));
    FrameHistory& history = views_[view].history;
    history.valid = history.valid && !frame.camera_cut;
    if (!history.valid) history.camera = camera;
    values_.setFrame(frame, camera);
    values_.setHistory(history, camera);
    history = {true, (history.frame_index + 1) % kFrameIndices, camera};
    return camera;
}

Status Execution::end()
{
    Status status = device_.endFrame();
    for (PreparedView& view : views_) view.history.valid = status.ok();
    return status;
}

// What was written last frame is now read, and the other way round.
void Execution::swapHistories()
{
    swapped_ = !swapped_;
    for (PreparedView& view : views_) {
        for (PreparedPass& pass : view.passes) {
            for (TextureBinding& binding : pass.textures)
                if (binding.other) std::swap(binding.texture, binding.other);
            if (pass.other.id())
                pass.info.framebuffer = (swapped_ ? pass.other : pass.framebuffer).id();
        }
    }
}

// Before the first frame histories hold whatever the memory held: not even a shader that multiplies
// by `history_valid` could read that, for it may be no number.
void Execution::clearHistories()
{
    for (const PreparedView& view : views_)
        for (const PreparedPass& pass : view.passes)
            if (pass.other.id()) clearHistory(pass);
}

void Execution::clearHistory(const PreparedPass& pass)
{
    PassInfo info = pass.info;
    info.framebuffer = (swapped_ ? pass.framebuffer : pass.other).id();
    for (int i = 0; i < info.color_count; ++i) {
        info.color_load[i] = LoadOp::clear;
        info.color_store[i] = StoreOp::store;
        std::fill(std::begin(info.clear_color[i]), std::end(info.clear_color[i]), 0.0f);
    }
    info.depth_load = LoadOp::clear;
    info.depth_store = StoreOp::store;
    device_.beginPass(info);
    device_.endPass();
}

void Execution::runPass(const PreparedPass& pass, const Frame& frame, const CameraMatrices& camera)
{
    values_.setViewport(pass.info.extent);
    device_.beginPass(pass.info);
    device_.setProgram(pass.program, pass.state);
    setTextures(pass.textures);
    setUniforms(pass.uniforms);
    if (pass.type == PassType::draw)
        runDraws(pass, frame, camera);
    else
        device_.drawFullscreen();
    device_.endPass();
}

void Execution::runDraws(const PreparedPass& pass, const Frame& frame, const CameraMatrices& camera)
{
    bool mirrored = false;
    for (const DrawItem& item : frame.draws) {
        if (item.count == 0) continue;
        if (pass.state.cull != Cull::none && isMirrored(item, camera) != mirrored) {
            mirrored = !mirrored;
            device_.setProgram(pass.program, mirrored ? turned(pass.state) : pass.state);
            setTextures(pass.textures);
        }
        const Material& material = frame.materials[item.material];
        values_.setDraw(item, material, camera);
        setUniforms(pass.draw_uniforms);
        for (const TextureBinding& binding : pass.material_textures) {
            const TextureId map = material.*kMaterialMaps[binding.map].texture;
            device_.setTexture(binding.location, binding.unit, map ? map : white_.id(),
                               binding.sampling);
        }
        device_.draw(item.mesh, item.first, item.count);
    }
}

void Execution::setTextures(const std::vector<TextureBinding>& textures)
{
    for (const TextureBinding& binding : textures)
        device_.setTexture(binding.location, binding.unit, binding.texture, binding.sampling);
}

void Execution::setUniforms(const std::vector<UniformBinding>& uniforms)
{
    for (const UniformBinding& uniform : uniforms)
        device_.setUniform(uniform.location, uniform.type, uniform.count,
                           values_.data(uniform.offset));
}

TextureId Execution::output(std::string_view name, int view) const
{
    if (view < 0 || view >= plan_.views) return {};
    for (const PlanOutput& output : plan_.outputs) {
        if (output.name != name) continue;
        if (output.constant >= 0) return constants_[output.constant].id();
        return targetTexture(output.target, view, swapped_);
    }
    return {};
}

}  // namespace crevice
