// SPDX-License-Identifier: MIT
// One sample of a bench, from its description to its figures.
#include "tools/measure/bench/measure.h"

#include "tools/measure/bench/run.h"
#include "tools/measure/motion/measure.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/scene_upload.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace crevice {
namespace {

/// Turns end at so many times the least, settled or not.
constexpr int kMostPatience = 4;

Image withOpenBackground(Image ground_truth)
{
    for (float& value : ground_truth.pixels)
        if (std::isnan(value)) value = 1.0f;
    return ground_truth;
}

/// Puts the frames' times into the sample, in all and pass by pass.
void describeFrames(const std::vector<FrameTimes>& frames, const Plan& plan, BenchSample& sample)
{
    sample.clock = clockName(frames[0].method);
    sample.repeats = static_cast<int>(frames.size());
    std::vector<double> times(frames.size());
    const auto figuresOf = [&frames, &times](auto time) {
        std::transform(frames.begin(), frames.end(), times.begin(), time);
        return timeFigures(times);
    };
    sample.total = figuresOf([](const FrameTimes& frame) { return frame.total_ms; });
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        sample.passes.push_back({plan.passes[pass].name, figuresOf([pass](const FrameTimes& frame) {
                                     return frame.pass_ms[pass];
                                 })});
}

}  // namespace

/// What tasks of one view and one ground truth share.
struct BenchMeter::Setting {
    Setting(const BenchView& seen, UploadedScene uploaded)
        : view(seen),
          scene(std::move(uploaded)),
          frame(makeFrame(scene, seen.camera, seen.extent))
    {
    }

    /// The radius on screen, at the median depth.
    Status findRadius(Device& device, double radius)
    {
        const Result<Image> depth = drawDepth(device, frame, view.extent);
        if (!depth) return depth.diagnostics();
        distance = medianDistance(*depth, frame.camera);
        if (distance) radius_px = pixelsOf(radius, *distance, frame.camera, view.extent);
        return {};
    }

    const BenchView& view;
    std::string reference;
    UploadedScene scene;
    Frame frame;
    Result<Image> ground_truth = Image();              ///< Or why there is none.
    std::optional<double> distance;                    ///< Median, in view.
    std::optional<MotionView> motion;                  ///< None until it is asked for.
    Result<MotionTruth> motion_truth = MotionTruth();  ///< Of `motion`, or why there is none.
    double radius_px = 0;
    Yardstick yardstick;
};

BenchMeter::BenchMeter(Device& device, const BenchPlan& plan, const SourceSet& sources,
                       MeasureOptions options)
    : device_(device),
      plan_(plan),
      sources_(sources),
      options_(std::move(options))
{
}

BenchMeter::~BenchMeter() = default;

/// Makes the setting of the task, unless it is the one of the task before.
Status BenchMeter::enter(const BenchTask& task)
{
    const BenchView& view = plan_.views[task.view];
    if (setting_ && setting_->reference == task.reference && &setting_->view == &view) return {};
    setting_.reset();
    Result<UploadedScene> scene = UploadedScene::upload(device_, *view.scene);
    if (!scene) return scene.diagnostics();
    auto setting = std::make_unique<Setting>(view, std::move(*scene));
    setting->reference = task.reference;

    const TraceOptions trace = {task.sample.radius, options_.rays, 0, options_.tracing};
    setting->ground_truth =
        cachedReference(*view.scene, view.matrices(), view.extent, trace, options_.cache_folder);

    if (const Status found = setting->findRadius(device_, task.sample.radius); !found) return found;
    setting->yardstick =
        Yardstick(device_, sources_, view.extent, setting->frame, task.sample.radius);
    setting_ = std::move(setting);
    return {};
}

Result<BenchSample> BenchMeter::measure(const BenchTask& task)
{
    if (const Status ready = enter(task); !ready) return ready.diagnostics();
    if (!setting_->ground_truth) return setting_->ground_truth.diagnostics();
    BenchSample sample = task.sample;
    sample.radius_px = setting_->radius_px;
    sample.device = device_.caps().name;
    sample.software = device_.caps().software;

    Drawn drawn;
    const auto prepare = [&](const std::string& output) {
        return drawn.prepare(device_, task.description, setting_->frame,
                             {sample.extent, {output}, sample.disable});
    };
    if (const Status ready = prepare(kOcclusionOutput); !ready) return ready.diagnostics();
    const Result<Image> ao = drawSettled(device_, *drawn.renderer, drawn.frame, kOcclusionOutput);
    if (!ao) return ao.diagnostics();
    if (options_.motion) measureMotion(task, drawn, sample);
    Status ready;
    if (sample.output != kOcclusionOutput) {
        drawn.renderer.reset();
        ready = prepare(sample.output);
    } else if (options_.motion) {
        ready = drawn.handOver(setting_->frame);  // as before the camera moved
    }
    if (!ready) return ready.diagnostics();
    if (const Status timed = measureTimes(task, drawn, sample); !timed) return timed.diagnostics();
    if (const Status known = measureErrors(*ao, sample); !known) return known.diagnostics();
    if (const Status kept = writePictures(task, *ao, sample); !kept) return kept.diagnostics();

    const MovedBytes bytes = movedBytes(drawn.renderer->plan());
    sample.texture_bytes = drawn.renderer->plan().texture_bytes;
    sample.bytes_read = bytes.read;
    sample.bytes_written = bytes.written;
    return sample;
}

Status BenchMeter::measureTimes(const BenchTask& task, Drawn& drawn, BenchSample& sample)
{
    Renderer& renderer = *drawn.renderer;
    const auto own = ownGeometry(renderer.plan(), task.description, traitsOf(drawn.frame),
                                 device_.caps(), {sample.extent});
    if (!own) return own.diagnostics();
    TurnTaker taker(renderer, drawn.frame, *own);
    TurnTaker* unit = setting_->yardstick.turns();
    Turns turns(taker, unit, options_.repeats, kMostPatience * options_.repeats);
    const Status taken = turns.take(options_.interrupted);
    if (!taken || turns.next()) return taken;
    if (unit) {
        sample.ratio_learnopengl = ratioFigures(taker.costs(), unit->costs()).median;
        sample.ratio_with_geometry = ratioFigures(taker.costsWithGeometry(), unit->costs()).median;
    }
    sample.cost = timeFigures(taker.costs());
    sample.cost_with_geometry = timeFigures(taker.costsWithGeometry());
    describeFrames(taker.frames(), renderer.plan(), sample);
    return {};
}

Status BenchMeter::measureErrors(const Image& ao, BenchSample& sample)
{
    const Result<ImageDifference> figures = compareImages(ao, *setting_->ground_truth);
    if (!figures) return figures.diagnostics();
    if (figures->non_finite > 0)
        return Diagnostic{Code::not_finite, "the occlusion is not a number in " +
                                                std::to_string(figures->non_finite) + " pixels"};
    sample.error = {figures->rmse,     figures->bias,      figures->p99,   figures->pattern,
                    figures->rmse_fit, figures->power_fit, figures->pixels};
    const Image open(ao.extent, 1, 1.0f);
    if (const auto without = compareImages(open, *setting_->ground_truth))
        sample.error_without_ao = without->rmse;
    return {};
}

/// Whatever keeps it from being measured goes to the sample, whose other figures stay.
void BenchMeter::measureMotion(const BenchTask& task, Drawn& drawn, BenchSample& sample)
{
    Setting& setting = *setting_;
    const BenchView& view = setting.view;
    if (!setting.motion) {
        const PathView end = {view.camera, view.extent, setting.distance.value_or(1.0)};
        setting.motion.emplace(
            MotionView{*view.scene, view.bounds, end, task.sample.radius, options_.cache_folder});
        setting.motion_truth = traceMotion(*setting.motion, options_.interrupted, options_.tracing);
    }
    const Result<MotionTruth>& truth = setting.motion_truth;
    const auto figures = [&]() -> Result<MotionFigures> {
        if (!truth) return truth.diagnostics();
        const MotionStage stage = {device_, *drawn.renderer, *drawn.host, setting.frame};
        return crevice::measureMotion(stage, *setting.motion, *truth, options_.interrupted);
    }();
    if (figures)
        sample.motion = *figures;
    else
        sample.motion_failure = failureText(figures.diagnostics());
}

Status BenchMeter::writePictures(const BenchTask& task, const Image& ao, BenchSample& sample)
{
    if (options_.out_folder.empty()) return {};
    const Result<Image> difference = differencePicture(ao, *setting_->ground_truth);
    if (!difference) return difference.diagnostics();
    std::error_code ignored;  // the first file reports it
    fs::create_directories(options_.out_folder + "/pictures", ignored);
    const std::string key = keyOnDevice(task.sample.key, device_.caps().name);
    const auto write = [this](std::string& name, const std::string& file, const Image& image) {
        name = "pictures/" + file + ".png";
        return writePng(options_.out_folder + "/" + name, image);
    };
    if (const Status s = write(sample.ao_picture, key + "_ao", ao); !s) return s;
    if (const Status s = write(sample.difference_picture, key + "_difference", *difference); !s)
        return s;
    return write(sample.ground_truth_picture, "ground_truth_" + task.reference,
                 withOpenBackground(*setting_->ground_truth));
}

}  // namespace crevice
