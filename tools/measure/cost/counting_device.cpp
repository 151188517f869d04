// SPDX-License-Identifier: MIT
#include "tools/measure/cost/counting_device.h"

#include "core/run/uniform_values.h"
#include "tools/measure/cost/counted_fragment.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"

#include <cmath>

namespace crevice {
namespace {

/// Sums one of the two counts of countedFragment's output over all pixels.
double sumOf(const Image& image, std::size_t which)
{
    double sum = 0;
    for (std::size_t i = 2 * which; i + 1 < image.pixels.size(); i += image.channels)
        sum += std::round(image.pixels[i] * 255.0) + 256 * std::round(image.pixels[i + 1] * 255.0);
    return sum;
}

}  // namespace

CountingDevice::~CountingDevice()
{
    clearCounts();
    for (const auto& [program, twin] : twins_) device_.destroy(twin.program);
}

void CountingDevice::clearCounts()
{
    for (const Count& count : counts_) {
        device_.destroy(count.framebuffer);
        device_.destroy(count.texture);
    }
    counts_.clear();
}

Result<PassCounts> CountingDevice::counts()
{
    PassCounts all;
    for (const Count& count : counts_) {
        const Result<Image> image = device_.readTexture(count.texture);
        if (!image) return image.diagnostics();
        PassCount& pass = all[count.pass];
        if (count.which == 0)
            pass = {sumOf(*image, 0), sumOf(*image, 1), {}};
        else  // a loop that no pixel enters runs no body
            pass.runs.push_back(sumOf(*image, 1) / std::max(sumOf(*image, 0), 1.0));
    }
    return all;
}

Result<FramebufferId> CountingDevice::createFramebuffer(const FramebufferDesc& desc)
{
    Result<FramebufferId> id = device_.createFramebuffer(desc);
    if (id) depths_[id->value] = desc.depth;
    return id;
}

Result<ProgramId> CountingDevice::createProgram(const ProgramDesc& desc)
{
    Result<ProgramId> id = device_.createProgram(desc);
    if (!id) return id;
    if (const Status added = addTwin(desc, *id); !added) return added.diagnostics();
    return id;
}

Status CountingDevice::addTwin(const ProgramDesc& desc, ProgramId program)
{
    ProgramDesc counting = desc;
    const std::vector<GlslLoop> loops = loopsOf(desc.fragment.text);
    const std::optional<std::string> text = countedFragment(desc.fragment.text, loops);
    if (!text) return {};
    counting.label += " fetches";
    counting.fragment.text = *text;
    const Result<ProgramId> made = device_.createProgram(counting);
    if (!made) return made.diagnostics();
    Twin& twin = twins_[program.value];
    twin.program = *made;
    twin.loops = static_cast<int>(loops.size());
    for (const UniformInfo& other : device_.uniforms(*made))
        if (other.name == kWhich) twin.which = other.location;
    for (const UniformInfo& mine : device_.uniforms(program))
        for (const UniformInfo& other : device_.uniforms(*made))
            if (mine.name == other.name) twin.locations[mine.location] = other.location;
    return {};
}

void CountingDevice::destroy(ObjectId id)
{
    if (id.kind == ObjectId::Kind::program) {
        if (const auto found = twins_.find(id.value); found != twins_.end()) {
            device_.destroy(found->second.program);
            twins_.erase(found);
        }
    }
    device_.destroy(id);
}

Status CountingDevice::beginFrame()
{
    clearCounts();
    return device_.beginFrame();
}

void CountingDevice::beginPass(const PassInfo& pass)
{
    pass_ = pass;
    bindings_.clear();
    fullscreen_ = false;
    device_.beginPass(pass);
}

void CountingDevice::setProgram(ProgramId id, const StateDesc& state)
{
    program_ = id;
    state_ = state;
    device_.setProgram(id, state);
}

void CountingDevice::setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler)
{
    bindings_.push_back({location, unit, id, sampler});
    device_.setTexture(location, unit, id, sampler);
}

void CountingDevice::setUniform(int location, GlslType type, int count, const void* data)
{
    Uniform& uniform = twins_[program_.value].uniforms[location];
    uniform.type = type;
    uniform.count = count;
    uniform.words.resize(wordsOf(type, count));
    std::memcpy(uniform.words.data(), data, uniform.words.size() * sizeof uniform.words[0]);
    device_.setUniform(location, type, count, data);
}

void CountingDevice::drawFullscreen()
{
    fullscreen_ = true;
    device_.drawFullscreen();
}

void CountingDevice::endPass()
{
    device_.endPass();
    const Twin& twin = twins_[program_.value];
    if (!counting_ || !fullscreen_ || !twin.program) return;
    for (int which = 0; which <= twin.loops; ++which) drawTwin(twin, which);
}

/// What cannot be drawn into, as where the mask has several samples, is not counted.
void CountingDevice::drawTwin(const Twin& twin, int which)
{
    const bool masked = pass_.has_depth && pass_.depth_load == LoadOp::load;
    const Result<TextureId> texture =
        device_.createTexture({std::string(pass_.label) + " fetches", Format::rgba8, pass_.extent});
    if (!texture) return;
    const Result<FramebufferId> framebuffer = device_.createFramebuffer(
        {pass_.label, {*texture}, masked ? depths_[pass_.framebuffer.value] : TextureId()});
    if (!framebuffer) return device_.destroy(*texture);
    counts_.push_back({pass_.label, which, *texture, *framebuffer});
    PassInfo pass = pass_;
    pass.framebuffer = *framebuffer;
    pass.color_count = 1;
    pass.color_load[0] = LoadOp::clear;
    pass.color_store[0] = StoreOp::store;
    for (float& channel : pass.clear_color[0]) channel = 0;
    pass.has_depth = masked;
    device_.beginPass(pass);
    device_.setProgram(twin.program, state_);
    const auto locationOf = [&twin](int location) {
        const auto found = twin.locations.find(location);
        return found == twin.locations.end() ? -1 : found->second;
    };
    for (const Binding& each : bindings_)
        if (const int location = locationOf(each.location); location >= 0)
            device_.setTexture(location, each.unit, each.texture, each.sampler);
    for (const auto& [mine, uniform] : twin.uniforms)
        if (const int location = locationOf(mine); location >= 0)
            device_.setUniform(location, uniform.type, uniform.count, uniform.words.data());
    device_.setUniform(twin.which, GlslType::int_, 1, &which);
    device_.drawFullscreen();
    device_.endPass();
}

Result<PassCounts> countFrame(Description description, const SceneView& view)
{
    const Result<OpenDevice> open = openDevice("");
    if (!open) return open.diagnostics();
    CountingDevice device(*open->device);
    const Result<UploadedScene> scene = UploadedScene::upload(*open->device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame drawn = makeFrame(*scene, view.camera, view.extent);
    Result<HostTextures> host = HostTextures::make(*open->device, description, view.extent, drawn);
    if (!host) return host.diagnostics();
    const Result<Frame> frame = host->frameOf(drawn);
    if (!frame) return frame.diagnostics();
    // A pass that does not run is not counted.
    const Result<std::unique_ptr<Renderer>> renderer = Renderer::create(
        device, std::move(description), {view.extent, {}, {"cached"}}, traitsOf(*frame));
    if (!renderer) return renderer.diagnostics();
    // Until a history holds what it does in every later frame.
    for (int warm_up = remembers((*renderer)->plan()) ? 2 : 0; warm_up >= 0; --warm_up) {
        if (warm_up == 0) device.startCounting();
        if (const Status status = (*renderer)->render(*frame); !status) return status.diagnostics();
    }
    return device.counts();
}

}  // namespace crevice
