// SPDX-License-Identifier: MIT
#include "tools/measure/bench/entrant.h"

#include "core/base/text.h"
#include "tools/commands/cli/load_config.h"
#include "tools/measure/bench/choice.h"
#include "tools/measure/taps.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace crevice {
namespace {

/// The small picture's part of each side, and the least that it has of the height.
constexpr int kSmallPart = 4;
constexpr int kSmallestHeight = 90;

constexpr std::size_t kSmallPixels = 2000;
constexpr int kTraceRays = 256;  // as a bench has
constexpr int kTimedTurns = 3;
constexpr int kWholeFrames = 5;

}  // namespace

std::string Entrant::label() const
{
    BenchSample sample;
    sample.config = config;
    sample.overrides = overrides;
    return sampleLabel(sample);
}

std::vector<double> Look::milliseconds() const
{
    if (ratios.empty()) return costs;
    std::vector<double> all = ratios;
    const double unit_ms = timeFigures(unit->costs()).median;
    for (double& ratio : all) ratio *= unit_ms;
    return all;
}

Status ViewMeter::begin(Entrant& first)
{
    Result<UploadedScene> uploaded = UploadedScene::upload(device_, *seen_.scene);
    if (!uploaded) return uploaded.diagnostics();
    scene_.emplace(std::move(*uploaded));
    const glm::dvec3 eye = glm::inverse(seen_.camera.view_from_world)[3];
    Result<std::unique_ptr<RayScene>> rays = makeRayScene(*seen_.scene, eye);
    if (!rays) return rays.diagnostics();
    rays_ = std::move(*rays);
    full_.view = seen_;
    full_.frame = makeFrame(*scene_, seen_.camera, seen_.extent);
    if (const Status known = load(first); !known) return known;
    const int part = std::clamp(seen_.extent.height / kSmallestHeight, 1, kSmallPart);
    const Extent small = {std::max(1, seen_.extent.width / part), seen_.extent.height / part};
    if (const Status opened = open(small_, small); !opened) return opened;
    if (const Status known = small_.truth->grow(kSmallPixels); !known) return known;
    return options_.motion ? beginMotion() : Status();
}

Status ViewMeter::openFull() { return open(full_, seen_.extent); }

Result<bool> ViewMeter::grow(std::size_t pixels)
{
    const std::size_t known = full_.truth->pixels().size();
    if (known >= pixels) return false;
    if (const Status more = full_.truth->grow(known + 1); !more) return more.diagnostics();
    return full_.truth->pixels().size() > known;
}

Look& ViewMeter::lookOf(Entrant& entrant, const Picture& picture) const
{
    return &picture == &small_ ? entrant.small : entrant.full;
}

Status ViewMeter::open(Picture& picture, Extent extent)
{
    picture.view = {seen_.scene, seen_.bounds, seen_.camera, extent};
    picture.frame = makeFrame(*scene_, seen_.camera, extent);
    Result<SparseTruth> truth =
        SparseTruth::begin(*rays_, picture.view.matrices(), extent, {radius_, kTraceRays});
    if (!truth) return truth.diagnostics();
    picture.truth.emplace(std::move(*truth));
    picture.unit = Yardstick(device_, sources_, extent, picture.frame, radius_);
    return {};
}

/// Where the points of the paths are in the next frames.
Status ViewMeter::beginMotion()
{
    const Result<double> depth = medianDepth();
    const PathView end = {seen_.camera, small_.view.extent, depth ? *depth : 1.0};
    motion_view_.emplace(MotionView{*seen_.scene, seen_.bounds, end, radius_, {}});
    motion_view_->paths = {std::begin(kFlickerPaths), std::end(kFlickerPaths)};
    motion_view_->rays = 0;
    Result<MotionTruth> traced = traceMotion(*motion_view_, options_.interrupted);
    if (traced) motion_ = std::move(*traced);
    return traced.diagnostics();
}

Result<double> ViewMeter::medianDepth()
{
    if (!distance_) distance_ = crevice::medianDistance(device_, full_.frame, seen_.extent);
    return *distance_;
}

Result<Description> ViewMeter::describe(const Entrant& entrant)
{
    Result<Description> loaded =
        loadDescription({entrant.config, {}, entrant.overrides, {}, options_.roots}, sources_,
                        isFileScene(options_.scene));
    if (!loaded) return loaded;
    const Result<std::string> lengths =
        resolveLengths(*loaded, full_.view.matrices(), seen_.extent, seen_.bounds.diagonal(),
                       [&] { return medianDepth(); });
    if (!lengths) return lengths.diagnostics();
    return loaded;
}

Status ViewMeter::load(Entrant& entrant)
{
    Result<Description> loaded = describe(entrant);
    if (!loaded) return loaded.diagnostics();
    const ParamDesc* radius = findNamed(loaded->params, "radius");
    if (!radius || !findNamed(loaded->outputs, kOcclusionOutput))
        return Diagnostic{Code::unknown_param,
                          "'" + entrant.config + "' has no param 'radius' or no output 'ao'"};
    if (radius_ == 0.0) radius_ = radius->value[0];
    if (static_cast<float>(radius_) != radius->value[0]) {
        entrant.overrides.push_back("radius=" + shortest(static_cast<float>(radius_)));
        loaded = describe(entrant);
        if (!loaded) return loaded.diagnostics();
    }
    const Result<Plan> plan = compile(*loaded, traitsOf(full_.frame), device_.caps(),
                                      {seen_.extent, {kOcclusionOutput}, {}});
    if (!plan) return plan.diagnostics();
    entrant.passes = toText(*plan);
    entrant.programs.clear();
    for (const PlanProgram& program : plan->programs) entrant.programs += program.key;
    entrant.description = std::move(*loaded);
    return {};
}

Status ViewMeter::lookSmall(Entrant& entrant, bool rough)
{
    const Status drawn = look(entrant, small_, rough);
    return drawn && options_.motion ? measureFlicker(entrant) : drawn;
}

Status ViewMeter::look(Entrant& entrant, Picture& picture, bool rough)
{
    Drawn& drawn = entrant.drawn;
    const Extent extent = picture.view.extent;
    const Status ready =
        drawn.prepare(device_, entrant.description, picture.frame, {extent, {kOcclusionOutput}});
    if (!ready) return ready;
    const Result<Image> ao = drawSettled(device_, *drawn.renderer, drawn.frame, kOcclusionOutput);
    if (!ao) return ao.diagnostics();
    Result<SparseError> error = sparseError(*ao, *picture.truth);
    if (!error) return error.diagnostics();
    Look& seen = lookOf(entrant, picture);
    seen.error = std::move(*error);
    seen.with_flicker = std::hypot(seen.error.rmse, flickerOf(entrant.motion));
    if (&picture == &full_) entrant.texture_bytes = drawn.renderer->plan().texture_bytes;
    looking_ = std::make_unique<Looking>(entrant, picture, rough ? 1 : kTimedTurns);
    return {};
}

void ViewMeter::finish()
{
    Look& seen = lookOf(looking_->entrant, looking_->picture);
    const TurnTaker& taker = looking_->taker;
    const std::vector<double> ratios = looking_->turns.ratios();
    seen.costs.insert(seen.costs.end(), taker.costs().begin(), taker.costs().end());
    seen.ratios.insert(seen.ratios.end(), ratios.begin(), ratios.end());
    seen.unit = looking_->picture.unit.turns();
    if (!taker.frames().empty()) looking_->entrant.clock = taker.frames().back().method;
    looking_->entrant.drawn.rest();
    looking_.reset();
}

Status ViewMeter::measureFlicker(Entrant& entrant)
{
    const MotionStage stage = {device_, *entrant.drawn.renderer, *entrant.drawn.host, small_.frame};
    Result<MotionFigures> moved =
        measureMotion(stage, *motion_view_, motion_, options_.interrupted);
    if (!moved) return moved.diagnostics();
    entrant.motion = std::move(*moved);
    entrant.small.with_flicker = std::hypot(entrant.small.error.rmse, flickerOf(entrant.motion));
    return entrant.drawn.handOver(small_.frame);  // as before the camera moved
}

Result<FrameShares> ViewMeter::sharesOf(Entrant& entrant)
{
    const Status ready = entrant.drawn.prepare(device_, entrant.description, full_.frame,
                                               {seen_.extent, {kOcclusionOutput}});
    if (!ready) return ready.diagnostics();
    const Frame& frame = entrant.drawn.frame;
    const SceneTraits traits = traitsOf(frame);
    const auto made =
        Renderer::create(device_, entrant.description, {seen_.extent, {}, {}}, traits);
    if (!made) return made.diagnostics();
    const Plan &whole = (*made)->plan(), &occlusion = entrant.drawn.renderer->plan();
    const auto own =
        ownGeometry(whole, entrant.description, traits, device_.caps(), {seen_.extent});
    if (!own) return own.diagnostics();
    std::vector<std::vector<double>> times(whole.passes.size());
    for (int i = 0; i <= kWholeFrames; ++i) {
        const Result<FrameTimes> timed = timeFrame(**made, frame);
        if (!timed) return timed.diagnostics();
        for (std::size_t pass = 0; i > 0 && pass < times.size(); ++pass)
            times[pass].push_back(timed->pass_ms[pass]);
    }
    FrameShares shares;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const PlanPass& pass = whole.passes[i];
        const bool draws = pass.type == PassType::draw;
        double& share = !findNamed(occlusion.passes, pass.name) ? shares.lighting
                        : !draws                                ? shares.occlusion
                        : (*own)[i]                             ? shares.own_geometry
                                                                : shares.geometry;
        share += timeFigures(times[i]).median;
    }
    return shares;
}

BenchSample ViewMeter::sampleOf(const Entrant& entrant) const
{
    const SparseError& error = entrant.full.error;
    BenchSample sample;
    sample.key = entrant.label();
    sample.config = sample.family = entrant.config;
    sample.overrides = entrant.overrides;
    sample.scene = options_.scene;
    sample.camera = seen_.camera.name;
    sample.extent = seen_.extent;
    sample.radius = radius_;
    sample.rays = kTraceRays;
    sample.samples = samplesOf(entrant.description);
    sample.triangles = triangleCount(*seen_.scene);
    sample.device = device_.caps().name;
    sample.software = device_.caps().software;
    sample.version = options_.version;
    sample.error.rmse = error.rmse;
    sample.error.bias = error.bias;
    sample.error.p99 = error.p99;
    sample.error.pixels = static_cast<long long>(error.squares.size());
    sample.error_without_ao = error.without_ao;
    sample.motion = entrant.motion;
    sample.clock = clockName(entrant.clock);
    sample.repeats = static_cast<int>(entrant.full.costs.size());
    sample.cost = timeFigures(entrant.full.milliseconds());
    if (!entrant.full.ratios.empty())
        sample.ratio_learnopengl = timeFigures(entrant.full.ratios).median;
    sample.texture_bytes = entrant.texture_bytes;
    return sample;
}

}  // namespace crevice
