// SPDX-License-Identifier: MIT
// One point of a bench, from its description to its figures.
#include "tools/bench_measure.h"

#include "tools/bench_times.h"
#include "tools/image_file.h"
#include "tools/image_metrics.h"
#include "tools/read_output.h"
#include "tools/reference_cache.h"
#include "tools/scene_upload.h"

#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

const char* const kFloorModule = "bench/depth_copy.json";
const char* const kYardstick = "learnopengl";

Image withOpenBackground(Image truth)
{
    for (float& value : truth.pixels)
        if (std::isnan(value)) value = 1.0f;
    return truth;
}

/// The median over repeats of what the passes other than draw passes took.
double medianCost(const Plan& plan, const std::vector<FrameTimes>& frames)
{
    std::vector<double> costs;
    for (const FrameTimes& frame : frames) costs.push_back(occlusionCost(plan, frame));
    return timeFigures(std::move(costs)).median;
}

double ratio(double cost, double unit) { return unit > 0.0 ? cost / unit : 0.0; }

}  // namespace

/// What tasks of one view and one truth share.
struct BenchMeter::Setting {
    Setting(const BenchView& seen, UploadedScene uploaded)
        : view(seen),
          scene(std::move(uploaded)),
          frame(makeFrame(scene, seen.camera, seen.extent))
    {
    }

    Result<std::unique_ptr<Renderer>> makeRenderer(Device& device, Description description,
                                                   std::vector<std::string> outputs) const
    {
        return Renderer::create(device, std::move(description),
                                {view.extent, std::move(outputs), {}}, traitsOf(frame));
    }

    const BenchView& view;
    std::string reference;
    UploadedScene scene;
    Frame frame;
    Result<Image> truth = Image();  ///< Or why there is none.
    double radius_px = 0;
    std::unique_ptr<Renderer> floor;
    std::unique_ptr<Renderer> yardstick;  ///< Null where the device cannot draw it.
    std::map<std::string, Image> converged;  ///< By family.
};

BenchMeter::BenchMeter(Device& device, const BenchPlan& plan, const SourceSet& sources,
                       MeasureOptions options)
    : device_(device), plan_(plan), sources_(sources), options_(std::move(options))
{
}

BenchMeter::~BenchMeter() = default;

/// Makes the setting of the task, unless it is the one of the task before.
Status BenchMeter::enter(const BenchTask& task)
{
    const BenchView& view = plan_.views[task.view];
    if (setting_ && setting_->reference == task.reference && &setting_->view == &view)
        return setting_->truth.ok() ? Status() : Status(setting_->truth.diagnostics());
    setting_.reset();
    Result<UploadedScene> scene = UploadedScene::upload(device_, *view.scene);
    if (!scene) return scene.diagnostics();
    auto setting = std::make_unique<Setting>(view, std::move(*scene));
    setting->reference = task.reference;

    TraceOptions trace;
    trace.radius = task.point.radius;
    trace.rays = options_.rays;
    trace.progress = options_.tracing;
    setting->truth =
        cachedReference(*view.scene, view.matrices(), view.extent, trace, options_.cache_folder);

    const Result<Description> floor = loadDescription({kFloorModule, {}, {}, {}}, sources_);
    if (!floor) return floor.diagnostics();
    auto copy = setting->makeRenderer(device_, *floor, {"copy", "depth"});
    if (!copy) return copy.diagnostics();
    setting->floor = std::move(*copy);
    if (const Status drawn = setting->floor->render(setting->frame); !drawn) return drawn;
    const Result<Image> depth = readOutput(device_, *setting->floor, "depth");
    if (!depth) return depth.diagnostics();
    setting->radius_px = radiusOnScreen(task.point.radius, setting->frame.camera, *depth);

    const Result<Description> yardstick = loadDescription({kYardstick, {}, {}, {}}, sources_);
    auto drawn = yardstick ? setting->makeRenderer(device_, *yardstick, {"ao"})
                           : Result<std::unique_ptr<Renderer>>(yardstick.diagnostics());
    if (drawn && (*drawn)->setParam("radius", static_cast<float>(task.point.radius)))
        setting->yardstick = std::move(*drawn);
    setting_ = std::move(setting);
    return setting_->truth.ok() ? Status() : Status(setting_->truth.diagnostics());
}

Result<BenchPoint> BenchMeter::measure(const BenchTask& task)
{
    if (const Status ready = enter(task); !ready) return ready.diagnostics();
    BenchPoint point = task.point;
    point.radius_px = setting_->radius_px;
    point.device = device_.caps().name;
    point.software = device_.caps().software;

    const auto renderer = setting_->makeRenderer(device_, task.description, {"ao"});
    if (!renderer) return renderer.diagnostics();
    if (const Status timed = measureTimes(**renderer, point); !timed) return timed.diagnostics();
    const Result<Image> ao = readOutput(device_, **renderer, "ao");
    if (!ao) return ao.diagnostics();
    if (const Status known = measureErrors(task, *ao, point); !known) return known.diagnostics();
    if (const Status kept = writePictures(task, *ao, point); !kept) return kept.diagnostics();

    const Plan& plan = (*renderer)->plan();
    point.texture_bytes = plan.texture_bytes;
    for (const PlanPass& pass : plan.passes) {
        point.bytes_read += pass.bytes_read;
        point.bytes_written += pass.bytes_written;
    }
    return point;
}

Status BenchMeter::measureTimes(Renderer& renderer, BenchPoint& point)
{
    struct Timed {
        Renderer* renderer;
        std::vector<FrameTimes> frames;
    };
    std::vector<Timed> turns = {{&renderer, {}}, {setting_->floor.get(), {}}};
    if (setting_->yardstick) turns.push_back({setting_->yardstick.get(), {}});
    for (int repeat = -1; repeat < options_.repeats && !options_.interrupted(); ++repeat) {
        for (Timed& turn : turns) {
            const Result<FrameTimes> cost = timeFrame(*turn.renderer, setting_->frame);
            if (!cost) return cost.diagnostics();
            if (repeat >= 0) turn.frames.push_back(*cost);  // the first is the warm-up
        }
    }
    if (turns[0].frames.empty()) return {};  // interrupted
    point.clock = turns[0].frames[0].method == TimingMethod::gpu_timer ? "query" : "wall";
    point.repeats = static_cast<int>(turns[0].frames.size());
    std::vector<double> totals;
    for (const FrameTimes& frame : turns[0].frames) totals.push_back(frame.total_ms);
    point.total = timeFigures(std::move(totals));
    const Plan& plan = renderer.plan();
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass) {
        std::vector<double> times;
        for (const FrameTimes& frame : turns[0].frames) times.push_back(frame.pass_ms[pass]);
        point.passes.push_back({plan.passes[pass].name, timeFigures(std::move(times))});
    }
    const double cost = medianCost(plan, turns[0].frames);
    point.ratio_floor = ratio(cost, medianCost(turns[1].renderer->plan(), turns[1].frames));
    if (turns.size() > 2)
        point.ratio_learnopengl = ratio(cost, medianCost(turns[2].renderer->plan(), turns[2].frames));
    return {};
}

Status BenchMeter::measureErrors(const BenchTask& task, const Image& ao, BenchPoint& point)
{
    const Result<ImageDifference> figures = compareImages(ao, *setting_->truth);
    if (!figures) return figures.diagnostics();
    if (figures->non_finite > 0)
        return Diagnostic{Code::not_finite, "the occlusion is not a number in " +
                                                std::to_string(figures->non_finite) + " pixels"};
    point.error = {figures->rmse,     figures->bias,      figures->p99,
                   figures->rmse_fit, figures->power_fit, figures->pixels};
    if (options_.budget)
        point.budget = budgetOf(ao, *setting_->truth, converged(task), precise(task));
    return {};
}

/// Empty where the device cannot draw it: then that part of the budget is not measured.
Image BenchMeter::precise(const BenchTask& task)
{
    const Stage stage = {device_, setting_->frame, setting_->view.extent};
    Result<Image> image = preciseOcclusion(stage, task.description);
    return image ? std::move(*image) : Image();
}

/// The same; kept, since all sample counts of a config converge to it.
const Image& BenchMeter::converged(const BenchTask& task)
{
    const auto known = setting_->converged.find(task.point.family);
    if (known != setting_->converged.end()) return known->second;
    const Stage stage = {device_, setting_->frame, setting_->view.extent};
    Result<Image> image = convergedOcclusion(stage, task.description, options_.interrupted);
    return setting_->converged[task.point.family] = image ? std::move(*image) : Image();
}

Status BenchMeter::writePictures(const BenchTask& task, const Image& ao, BenchPoint& point)
{
    if (options_.out_folder.empty()) return {};
    const Result<Image> difference = differencePicture(ao, *setting_->truth);
    if (!difference) return difference.diagnostics();
    std::error_code ignored;  // the first file tells
    fs::create_directories(options_.out_folder + "/pictures", ignored);
    const std::string key = keyOnDevice(task.point.key, device_.caps().name);
    const auto write = [this](std::string& name, const std::string& file, const Image& image) {
        name = "pictures/" + file + ".png";
        return writePng(options_.out_folder + "/" + name, image);
    };
    if (const Status s = write(point.ao_picture, key + "_ao", ao); !s) return s;
    if (const Status s = write(point.difference_picture, key + "_difference", *difference); !s)
        return s;
    return write(point.truth_picture, "truth_" + task.reference,
                 withOpenBackground(*setting_->truth));
}

}  // namespace crevice
