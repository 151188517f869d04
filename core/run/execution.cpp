// SPDX-License-Identifier: MIT
// Running a prepared plan: no allocation, no creation, no decision that could be made before.
#include "core/run/execution.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice {
namespace {

/// Null where there is none of that name, or a null id behind it.
const ImportedTexture* findTexture(const std::vector<ImportedTexture>& textures,
                                   std::string_view name)
{
    const ImportedTexture* found = findNamed(textures, name);
    return found && found->texture ? found : nullptr;
}

const ImportedTexture* findTexture(const Frame& frame, std::size_t view, std::string_view name)
{
    const ImportedTexture* own =
        view > 0 ? findTexture(frame.other_views[view - 1].textures, name) : nullptr;
    return own ? own : findTexture(frame.textures, name);
}

/// The revision of what is always there: no host's, for they count from 1.
constexpr std::uint64_t kNeverChanges = ~std::uint64_t{0};

Diagnostic refused(const ImportDesc& import, Code code, const std::string& what, const char* help)
{
    return {code, "the frame" + what, help, import.place, import.pointer};
}

Diagnostic otherSamples(const ImportDesc& import, const std::string& pass, int samples)
{
    const bool one = samples == 1;
    return refused(import, Code::bad_input,
                   "'s texture '" + import.name + "' has " +
                       (one ? "one sample" : std::to_string(samples) + " samples") +
                       " a pixel, and pass '" + pass + "' reads it as " +
                       (one ? "sampler2DMS" : "sampler2D"),
                   one ? "adopt it with its TextureDesc::samples, or take a module for one"
                       : "resolve it, or take a module that reads samples");
}

}  // namespace

Status Execution::checkImports(const Frame& frame) const
{
    for (const ImportDesc& import : plan_.imports)
        if (import.type == ImportType::texture && !import.optional &&
            !findTexture(frame.textures, import.name))
            return refused(
                import, Code::missing_import, " has no texture for import '" + import.name + "'",
                "hand one over by Effect::setTexture or in Frame::textures; the command "
                "reads --texture NAME=FILE, or NAME.png, .hdr or .exr beside the config");
    for (const PreparedPass& pass : runs_) {
        for (const TextureBinding& binding : pass.textures) {
            if (binding.import < 0) continue;
            const ImportDesc& import = plan_.imports[binding.import];
            const ImportedTexture* found = findTexture(frame, pass.view, import.name);
            const ObjectInfo info = device_.info(found ? found->texture : black_.id());
            if (!info.exists)
                return refused(import, Code::bad_input,
                               "'s texture '" + import.name + "' is texture " +
                                   std::to_string(found->texture.value) +
                                   ", which is none of this device",
                               "take an id that adoptTexture or createTexture gave and that is "
                               "not destroyed yet");
            if (binding.multisampled != (info.samples > 1))
                return otherSamples(import, pass.info.label, info.samples);
        }
    }
    return {};
}

Status Execution::setImports(const Frame& frame)
{
    if (Status status = checkImports(frame); !status) return status;
    for (PreparedPass& pass : runs_) {
        for (TextureBinding& binding : pass.textures) {
            if (binding.import < 0) continue;
            const std::string& name = plan_.imports[binding.import].name;
            const ImportedTexture* found = findTexture(frame, pass.view, name);
            const TextureId texture = found ? found->texture : black_.id();
            const std::uint64_t revision = found ? found->revision : kNeverChanges;
            pass.imports_changed = pass.imports_changed || revision == 0 ||
                                   revision != binding.revision ||
                                   texture.value != binding.texture.value;
            binding.texture = texture;
            binding.revision = revision;
        }
    }
    return {};
}

void Execution::setParam(std::string_view name, const float* values)
{
    if (const int index = indexOf(plan_.params, name); index >= 0) values_.setParam(index, values);
}

Status Execution::run(const Frame& frame)
{
    takeTimes();
    return draw(frame, timers_, false);
}

Result<FrameTimes> Execution::runTimed(const Frame& frame)
{
    waited_.start(runs_.size(), plan_.passes.size(), &clock_);
    device_.finish();
    const double start = clock_.now();
    const Status status = draw(frame, waited_, true);
    if (!status) return status.diagnostics();
    device_.finish();
    const double total_ms = clock_.now() - start;
    FrameTimes times = waited_.wait();
    if (times.method != TimingMethod::gpu_timer) times.total_ms = total_ms;
    return {std::move(times), status.diagnostics()};
}

bool Execution::setTiming(bool on)
{
    const bool able = device_.caps().timers;
    timers_.start(on && able ? runs_.size() : 0, plan_.passes.size());
    return able;
}

/// Draws a frame, all passes of it or those that must run.
Status Execution::draw(const Frame& frame, PassTimers& timers, bool all)
{
    if (Status status = device_.beginFrame(); !status) return status;
    takeReads();
    const std::vector<char>& chosen = begin(frame, all);
    clearHistories();
    remembers_ = true;
    timers.beginFrame();
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const PreparedView& view = views_[runs_[run].view];
        if (beginsView(run)) setView(frame, view);
        if (!chosen[run]) continue;
        const int of_box = runs_[run].plan->box;
        PreparedBox* const box = of_box >= 0 ? &boxes_[of_box] : nullptr;
        timers.beginRun(run);
        if (box) values_.setFrame(frame, box->drawn);
        runPass(runs_[run], cache_.shareOf(run % plan_.passes.size()),
                box ? box->drawn : view.camera, box ? box->draws : view_draws_);
        if (box) setView(frame, view);
        timers.endRun(run);
    }
    const Status status = end(frame);
    if (status) warm_ = plan_.passes.size();
    return status;
}

Result<bool> Execution::warm(const Frame& frame)
{
    if (warm_ == plan_.passes.size()) return true;
    if (Status status = device_.beginFrame(); !status) return status.diagnostics();
    swapHistories();  // to what the next frame draws over
    if (warm_ == 0) clearHistories();
    (void)takeDraws(frame);
    PreparedView view = views_.front();
    view.camera = view.before.camera = cameraMatrices(frame.camera);
    setView(frame, view);
    const PreparedPass& pass = runs_[warm_];
    PassInfo info = pass.info;
    info.within_area = true;
    info.area = {0, 0, {1, 1}};
    values_.setViewport(info.extent);
    drawLayer(pass, info, view.camera, view_draws_);
    drawn_ = {};
    swapHistories();
    if (Status status = device_.endFrame(); !status) return status.diagnostics();
    return ++warm_ == plan_.passes.size();
}

/// Takes the frame's values, and says which passes must run: by view and pass.
const std::vector<char>& Execution::begin(const Frame& frame, bool all)
{
    swapHistories();
    const bool same_draws = std::exchange(same_draws_, false);
    const bool draws_changed = !same_draws && takeDraws(frame);
    placeBoxes(frame, draws_changed);
    bool camera_changed = false;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        PreparedPass& pass = runs_[run];
        if (beginsView(run))
            camera_changed = beginView(frame, views_[pass.view], cameraOf(frame, pass.view));
        values_.setViewport(pass.info.extent);
        const int box = pass.plan->box;
        const bool view_changed = box < 0 ? camera_changed : boxes_[box].moved;
        const bool geometry_changed =
            pass.plan->type == PassType::draw && (draws_changed || view_changed);
        const bool uniforms_changed = takeUniforms(pass);
        changed_[run] = (all && box < 0) || plan_.reruns || geometry_changed || uniforms_changed ||
                        pass.imports_changed;
        pass.imports_changed = false;
    }
    const std::vector<char>& chosen = cache_.choose(changed_);
    bool drawn = false;
    for (std::size_t run = 0; run < runs_.size(); ++run)
        drawn = drawn || (chosen[run] && runs_[run].plan->type == PassType::draw);
    // What the host says has not changed may still name a mesh that is gone.
    if (same_draws && drawn) (void)takeDraws(frame);
    takeBoxes(frame, chosen);
    return chosen;
}

/// Finds a cube about all draws. It stays while it has them and is not much too large, so that
/// voxels of what does not move stay as they are.
void Execution::boundDraws()
{
    constexpr double kMargin = 1.05, kTooLarge = 1.5;
    constexpr double kNone = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kNone), high(-kNone);
    for (const DrawItem& item : drawn_.draws) {
        if (!drawsSomething(item)) continue;
        const ViewSphere sphere = boundsInView(item, item.world_from_model);
        if (sphere.radius < 0) low = glm::dvec3(-kNone);
        low = glm::min(low, sphere.center - sphere.radius);
        high = glm::max(high, sphere.center + sphere.radius);
    }
    const glm::dvec3 size = high - low;
    const double longest = std::max({size.x, size.y, size.z});
    const glm::dvec3 off = glm::max(high - draws_center_, draws_center_ - low);
    const bool holds = 2 * std::max({off.x, off.y, off.z}) <= draws_edge_;
    if (holds && draws_edge_ < kTooLarge * longest) return;
    const bool bounded = longest > 0 && std::isfinite(longest);  // points, or nothing, need no box
    draws_edge_ = bounded ? longest * kMargin : kNone;
    draws_center_ = bounded ? (low + high) / 2.0 : glm::dvec3(0.0);
}

constexpr double kSmallestBox = 1e-12;  // scene units

/// Has boxes follow the first camera, for whenever their passes are drawn, or hold all draws.
void Execution::placeBoxes(const Frame& frame, bool draws_changed)
{
    if (boxes_.empty()) return;
    const glm::dvec3 shift = isFinite(frame.origin_shift) ? frame.origin_shift : glm::dvec3(0.0);
    draws_center_ -= shift;
    if (draws_changed) boundDraws();
    const glm::dmat4 world_from_view = glm::inverse(frame.camera.view_from_world);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const PlanBox& plan = plan_.boxes[i];
        PreparedBox& box = boxes_[i];
        double edge = plan.factor;
        for (const int param : plan.params) edge *= double{values_.param(param)};
        edge = std::max(edge, kSmallestBox);
        const bool whole = draws_edge_ < edge;
        edge = std::min(edge, draws_edge_);
        const glm::dvec3 at =
            whole ? draws_center_ : snappedTo(glm::dvec3(world_from_view[3]), edge / plan.steps);
        box.moved = box.edge != edge || at != box.center;
        box.center = at;
        box.edge = edge;
        for (CameraMatrices* each : {&box.drawn, &box.read})
            each->view_from_world = glm::translate(each->view_from_world, shift);
    }
}

/// Boxes are where their passes draw them; and where the last of those has drawn, for readers.
void Execution::takeBoxes(const Frame& frame, const std::vector<char>& chosen)
{
    bool moved = false;
    for (std::size_t i = 0; i < plan_.passes.size(); ++i) {
        if (!chosen[i] || plan_.passes[i].box < 0) continue;
        PreparedBox& box = boxes_[plan_.passes[i].box];
        const PassCache::Share share = cache_.shareOf(i);
        if (plan_.passes[i].type == PassType::draw) {
            if (share.isFirst()) box.drawn = boxMatrices(box.center, box.edge);
            box.draws.begin(box.drawn);
        }
        if (i != box.last_pass || !share.isLast()) continue;
        box.read = box.drawn;
        moved = true;
    }
    if (!moved) return;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
        const PreparedView& view = views_[runs_[run].view];
        if (beginsView(run)) setView(frame, view);
        if (!runs_[run].reads_box || !chosen[run]) continue;
        values_.setViewport(runs_[run].info.extent);
        takeUniforms(runs_[run]);
    }
}

/// Puts the view's values into the table. Whether its camera is another than in the last frame.
bool Execution::beginView(const Frame& frame, PreparedView& view, const Camera& camera)
{
    const CameraMatrices matrices = cameraMatrices(camera);
    const bool changed = matrices.clip_from_view != view.camera.clip_from_view ||
                         matrices.view_from_world != view.camera.view_from_world;
    FrameHistory& history = view.history;
    history.valid = history.valid && !frame.camera_cut && isFinite(frame.origin_shift);
    if (history.valid)
        history.camera.view_from_world =
            glm::translate(history.camera.view_from_world, frame.origin_shift);
    else
        history.camera = matrices;
    view.camera = matrices;
    warnings_.look(view.before, history, matrices, view.turns);
    view.before = history;
    setView(frame, view);
    history = {true, (history.frame_index + 1) % kFrameIndices, matrices};
    return changed;
}

/// Puts the values of a view that has begun into the table.
void Execution::setView(const Frame& frame, const PreparedView& view)
{
    values_.setFrame(frame, view.camera);
    values_.setHistory(view.before, view.camera);
    for (std::size_t i = 0; i < boxes_.size(); ++i) values_.setBox(i, boxes_[i].read, view.camera);
    view_draws_.begin(view.camera);
}

/// Whether the pass's values are others than when it ran last.
bool Execution::takeUniforms(PreparedPass& pass)
{
    bool changed = false;
    std::size_t at = 0;
    for (const UniformBinding& uniform : pass.uniforms) {
        const std::size_t words = wordsOf(uniform.type, uniform.count);
        const std::size_t bytes = words * sizeof(std::uint32_t);
        const void* value = values_.data(uniform.offset);
        changed = changed || std::memcmp(&pass.sent[at], value, bytes) != 0;
        std::memcpy(&pass.sent[at], value, bytes);
        at += words;
    }
    return changed;
}

Status Execution::end(const Frame& frame)
{
    const Status read = beginReads();
    Status status = device_.endFrame();
    if (status && !read) status = read;
    for (PreparedView& view : views_) view.history.valid = status.ok();
    if (!status) cache_.clear();
    if (!status) return status;
    Diagnostics warnings = status.diagnostics();
    append(warnings, warnings_.take());
    if (drawn_.elided) append(warnings, warnElided(frame, device_));
    return warnings;
}

void Execution::follow(const std::vector<std::string>& outputs)
{
    for (const std::string& name : outputs)
        if (!findNamed(followed_, name)) followed_.push_back({{name}});
}

const std::array<float, 4>* Execution::value(std::string_view output) const
{
    const Followed* found = findNamed(followed_, output);
    return found && found->value ? &*found->value : nullptr;
}

void Execution::takeReads()
{
    for (Followed& each : followed_) {
        const auto value = device_.takeRead(each.in_flight);
        if (!value) continue;
        each.in_flight = {};
        each.value = value;
    }
}

Status Execution::beginReads()
{
    for (Followed& each : followed_) {
        const TextureId read = output(each.name, 0);
        if (!read || each.in_flight) continue;
        if (Status status = device_.beginRead(read); !status) return status;
        each.in_flight = read;
    }
    return {};
}

// What was written last frame is now read, and the other way round.
void Execution::swapHistories()
{
    swapped_ = !swapped_;
    for (PreparedPass& pass : runs_) {
        for (TextureBinding& binding : pass.textures)
            if (binding.odd_frame) std::swap(binding.texture, binding.odd_frame);
        if (pass.odd_frame.id())
            pass.info.framebuffer = (swapped_ ? pass.odd_frame : pass.framebuffer).id();
    }
}

/// Before the first frame histories hold what the memory held, which may be no number: not even a
/// shader that multiplies by `history_valid` could read that.
void Execution::clearHistories()
{
    for (const PreparedPass& pass : runs_)
        if (!remembers_ && pass.odd_frame.id()) clearHistory(pass);
}

void Execution::clearHistory(const PreparedPass& pass)
{
    PassInfo info = pass.info;
    info.framebuffer = (swapped_ ? pass.framebuffer : pass.odd_frame).id();
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

void Execution::runPass(const PreparedPass& pass, PassCache::Share share,
                        const CameraMatrices& camera, ViewDraws& draws)
{
    values_.setViewport(pass.info.extent);
    PassInfo info = pass.info;
    info.within_area = pass.plan->scissor;
    if (pass.plan->scissor) {
        const int length = pass.plan->cull_below_pixel;
        constexpr double kAny = std::numeric_limits<double>::infinity();
        const double least = length >= 0 ? values_.param(length) : kAny;
        info.area = pixelsOf(draws.area(info.extent, least), info.extent);
    }
    const int at_once = pass.plan->layers_at_once;
    const int times = std::max(pass.plan->layers / at_once, 1);
    for (int i = times * share.index / share.count; i < times * (share.index + 1) / share.count;
         ++i) {
        info.first_layer = i * at_once;
        info.makes_mips = pass.info.makes_mips && i + 1 == times;
        values_.setLayer(info.first_layer);
        drawLayer(pass, info, camera, draws);
    }
    values_.setLayer(0);
}

/// Draws a pass, or of one that draws volumes the layers from `info` on that it draws at once.
void Execution::drawLayer(const PreparedPass& pass, const PassInfo& info,
                          const CameraMatrices& camera, ViewDraws& draws)
{
    device_.beginPass(info);
    if (!info.within_area || (info.area.extent.width > 0 && info.area.extent.height > 0)) {
        device_.setProgram(pass.program, pass.state);
        setTextures(pass.textures);
        setUniforms(pass.uniforms);
        if (pass.plan->type == PassType::draw)
            runDraws(pass, camera, draws);
        else
            device_.drawFullscreen();
    }
    device_.endPass();
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
    const PlanOutput* output = findNamed(plan_.outputs, name);
    if (!output || view < 0 || view >= plan_.views) return {};
    return output->constant >= 0 ? constants_[output->constant].id()
                                 : targetTexture(output->target, view, swapped_);
}

}  // namespace crevice
