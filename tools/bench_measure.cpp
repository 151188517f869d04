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

const char* const kDepthModule = "bench/depth.json";
const char* const kFloorModule = "bench/depth_copy.json";

/// One copy of the depth texture is over so quickly that its time is mostly noise: a turn of it goes on
/// for about as long as the scheduler lets another process run, or for so many frames.
constexpr double kFloorTurnMs = 40.0;
constexpr int kFloorTurnFrames = 256;

const char* const kYardstick = "learnopengl";

Image withOpenBackground(Image truth)
{
    for (float& value : truth.pixels)
        if (std::isnan(value)) value = 1.0f;
    return truth;
}

/// A renderer that takes its turn in the timing, and what its turns cost.
struct Turns {
    Renderer* renderer;
    const Frame* frame;
    double least_ms;  ///< A turn goes on until its passes took as long.
    std::vector<FrameTimes> frames = {};  ///< The first of each turn.
    std::vector<double> costs = {};       ///< The mean of each turn.

    Status take(bool counts)
    {
        double sum = 0;
        int drawn = 0;
        do {
            const Result<FrameTimes> times = timeFrame(*renderer, *frame);
            if (!times) return times.diagnostics();
            sum += occlusionCost(renderer->plan(), *times);
            ++drawn;
            if (counts && drawn == 1) frames.push_back(*times);
        } while (sum < least_ms && drawn < kFloorTurnFrames);
        if (counts) costs.push_back(sum / drawn);
        return {};
    }

    double medianCost() const { return timeFigures(costs).median; }
};

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

    /// Draws the depth and takes from it what every point needs: the floor and the radius on screen.
    Status makeFloor(Device& device, const SourceSet& sources, double radius);

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
    std::unique_ptr<Renderer> depth;
    std::unique_ptr<Renderer> floor;
    Frame floor_frame;
    std::unique_ptr<Renderer> yardstick;  ///< Null where the device cannot draw it.
    std::map<std::string, Image> converged;  ///< By family.
};

Status BenchMeter::Setting::makeFloor(Device& device, const SourceSet& sources, double radius)
{
    const Result<Description> drawn = loadDescription({kDepthModule, {}, {}, {}}, sources);
    if (!drawn) return drawn.diagnostics();
    auto depth_renderer = makeRenderer(device, *drawn, {"depth"});
    if (!depth_renderer) return depth_renderer.diagnostics();
    depth = std::move(*depth_renderer);
    if (const Status done = depth->render(frame); !done) return done;
    const Result<Image> image = readOutput(device, *depth, "depth");
    if (!image) return image.diagnostics();
    radius_px = radiusOnScreen(radius, frame.camera, *image);

    const Result<Description> copied = loadDescription({kFloorModule, {}, {}, {}}, sources);
    if (!copied) return copied.diagnostics();
    floor_frame.textures = {{"depth", depth->output("depth")}};
    auto copy = Renderer::create(device, *copied, {view.extent, {}, {}}, traitsOf(floor_frame));
    if (!copy) return copy.diagnostics();
    floor = std::move(*copy);
    return {};
}

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

    if (const Status made = setting->makeFloor(device_, sources_, task.point.radius); !made)
        return made;

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
    std::vector<Turns> turns = {{&renderer, &setting_->frame, 0.0},
                                {setting_->floor.get(), &setting_->floor_frame, kFloorTurnMs}};
    if (setting_->yardstick) turns.push_back({setting_->yardstick.get(), &setting_->frame, 0.0});
    for (int repeat = -1; repeat < options_.repeats && !options_.interrupted(); ++repeat)
        for (Turns& each : turns)
            if (const Status drawn = each.take(repeat >= 0); !drawn) return drawn;  // -1 warms up
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
    point.cost = timeFigures(turns[0].costs);
    const double cost = point.cost.median;
    point.ratio_floor = ratio(cost, turns[1].medianCost());
    if (turns.size() > 2) point.ratio_learnopengl = ratio(cost, turns[2].medianCost());
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
    const Image open(ao.extent, 1, 1.0f);
    if (const auto without = compareImages(open, *setting_->truth))
        point.error_without_ao = without->rmse;
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
