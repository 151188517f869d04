// SPDX-License-Identifier: MIT
// One step of a stress case, from its shot to its figures.
#include "tools/measure/stress/runner.h"

#include "core/base/text.h"
#include "tools/measure/line_file.h"
#include "tools/measure/reference/tracer.h"
#include "tools/measure/taps.h"
#include "tools/render/device/poison_device.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"
#include "tools/render/target_diagnosis.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace crevice {
namespace {

constexpr float kPoison = 0.8713f;    // where a format holds no NaN
constexpr int kGroundTruthRays = 64;  // a pixel: rmse of their noise is 0.04

std::string nameIn(const std::string& setting) { return setting.substr(0, setting.find('=')); }

bool isOrdinary(const StressTask& task)
{
    return task.step == static_cast<int>(task.stress->ordinary);
}

bool drawsScene(const Description& description)
{
    return anyOf(description.imports,
                 [](const ImportDesc& each) { return each.type == ImportType::draw_list; });
}

/// Why a config that was put over the shot's geometry is none; null where it is one.
const char* missingFrom(const Description& description, const StressShot& shot)
{
    if (shot.geometry.empty()) return nullptr;
    if (shot.host && findNamed(description.imports, "depth")) return nullptr;
    if (shot.host) return "its geometry module has no counterpart for a host's depth";
    const bool positions = findNamed(description.targets, "position");
    const bool linear = findNamed(description.targets, "linear_depth");
    return positions == (shot.geometry == kPositionGeometry) &&
                   linear == (shot.geometry == kLinearGeometry)
               ? nullptr
               : "its geometry module has no such counterpart";
}

/// The format that the surface is read from: that of stored positions or distances, else of the
/// depth.
Format storedFormat(const Plan& plan)
{
    for (const char* name : {"position", "linear_depth", "depth"})
        if (const PlanTarget* target = findNamed(plan.targets, name))
            return plan.textures[target->texture].format;
    return Format::depth24;
}

/// `last`, and what is drawn before it.
std::vector<Frame> framesOf(const StressShot& shot, const Frame& last, bool remembers)
{
    std::vector<Frame> frames;
    for (const StressFrame& each : shot.before) {
        Frame frame = last;
        frame.camera = each.camera;
        if (!frame.draws.empty())
            frame.draws.back().world_from_model =
                glm::translate(glm::dmat4(1.0), each.moved) * frame.draws.back().world_from_model;
        const glm::dmat4 to_origin = glm::translate(glm::dmat4(1.0), -each.origin);
        for (DrawItem& item : frame.draws)
            item.world_from_model = to_origin * item.world_from_model;
        for (Light& light : frame.lights) light.position -= each.origin;
        frame.camera.view_from_world *= glm::inverse(to_origin);
        frames.insert(frames.end(), each.times, frame);
    }
    // Later frames read what the first left in histories; a mean of four has half of its noise.
    if (remembers && shot.before.empty() && !shot.cut) frames.resize(3, last);
    frames.push_back(last);
    frames.back().camera_cut = shot.cut;
    return frames;
}

}  // namespace

struct StressRunner::Ready {
    Description description;
    CompileOptions options;
    std::string absent;
};

struct StressRunner::Drawn {
    std::string absent;
    Image ao;
    Image next;  ///< The frame after that, of what must settle; the occlusion that dims a colour.
    std::vector<PassPicture> passes;
    Format stored = Format::none;
    TargetHealth bad;  ///< The first target that is not finite or out of range, if any.
};

std::string nameOf(const ConfigOptions& config)
{
    return config.config + (config.variant.empty() ? "" : " " + config.variant);
}

StressRunner::StressRunner(Device& device, const SourceSet& sources, std::string cache_folder)
    : poison_(std::make_unique<PoisonDevice>(device, kPoison, true)),
      floats_(std::make_unique<FloatDevice>(*poison_)),
      substitutes_(sources),
      cache_folder_(std::move(cache_folder)),
      plain_{*poison_},
      wide_{*floats_}
{
}

StressRunner::~StressRunner() = default;

Result<StressRunner::Ready> StressRunner::prepare(const StressTask& task, const StressShot& shot)
{
    Ready ready;
    const SourceSet& sources = substitutes_.over(shot.geometry);
    const Result<Description> base = loadDescription(task.config, sources);
    if (!base && !shot.geometry.empty()) {
        ready.absent = "not over " + shot.geometry + ": " + failureText(base.diagnostics());
        return ready;
    }
    if (!base) return base.diagnostics();
    ConfigOptions config = task.config;
    if (!shot.geometry.empty() && findNamed(base->params, "guard_band"))
        config.overrides.push_back("guard_band=1");
    if (const char* what = missingFrom(*base, shot)) ready.absent = what;
    if (findNamed(base->params, "radius"))
        config.overrides.push_back("radius=" + significant(shot.radius, 9));
    for (const std::string& setting : shot.settings) {
        if (!findNamed(base->params, nameIn(setting)) &&
            !findNamed(base->features, nameIn(setting)))
            ready.absent = "no '" + nameIn(setting) + "'";
        config.overrides.push_back(setting);
    }
    const std::vector<std::string> taps =
        shot.samples > 0 ? overridesFor(*base, shot.samples) : std::vector<std::string>();
    if (shot.samples > 0 && taps.empty())
        ready.absent = std::to_string(shot.samples) + " taps are outside its ranges";
    config.overrides.insert(config.overrides.end(), taps.begin(), taps.end());
    if (shot.draws && !drawsScene(*base)) ready.absent = "it draws nothing: the host does";
    if (!findNamed(base->outputs, shot.output)) ready.absent = "no output '" + shot.output + "'";
    if (!ready.absent.empty()) return ready;
    Result<Description> description = loadDescription(config, sources);
    if (!description) return description.diagnostics();
    ready.description = std::move(*description);
    ready.options.extent = shot.extent;
    ready.options.disable = {"aliasing"};
    if (shot.keep_no_ops) ready.options.disable.push_back("no_op");
    return ready;
}

/// With the renderer of `owner`, whose programs are there already, or another.
Status StressRunner::render(Stage& stage, const Ready& ready, HostTextures& host,
                            const std::vector<Frame>& frames, const std::string& owner)
{
    const Result<Frame> last = host.frameOf(frames.back());
    if (!last) return last.diagnostics();
    if (stage.of != owner || !stage.renderer->reload(ready.description, ready.options)) {
        stage.renderer.reset();
        stage.of.clear();
        auto created =
            Renderer::create(stage.device, ready.description, ready.options, traitsOf(*last));
        if (!created) return created.diagnostics();
        stage.renderer = std::move(*created);
        stage.of = owner;
    }
    for (const Frame& frame : frames) {
        const Result<Frame> hosted = host.frameOf(frame);
        if (!hosted) return hosted.diagnostics();
        if (Status done = stage.renderer->render(*hosted); !done) return done;
    }
    return {};
}

/// For what is not finite or out of range, in floats: 8 bits hide it.
Status StressRunner::look(const Plan& plan, const std::vector<WatchedTarget>& watched, Drawn& drawn)
{
    for (const WatchedTarget& each : watched) {
        Result<Image> image = readOutput(*floats_, *wide_.renderer, each.output);
        if (!image) return image.diagnostics();
        TargetHealth health = examine(*image, *image);
        examineFloats(*image, formatOf(plan, each.target), health);
        for (PassPicture& picture : drawn.passes)
            if (picture.target == each.target) picture.occlusion = std::move(*image);
        if (!health.bad()) continue;
        health.target = each.target;
        health.pass = each.pass;
        drawn.bad = std::move(health);
        drawn.passes.clear();
        break;
    }
    return {};
}

/// What the stage's renderer drew last.
Status StressRunner::show(const Stage& stage, const std::string& output, Image& picture)
{
    Result<Image> shown = readOutput(stage.device, *stage.renderer, output);
    if (!shown) return shown.diagnostics();
    picture = std::move(*shown);
    return {};
}

Result<StressRunner::Drawn> StressRunner::draw(const StressTask& task, const StressShot& shot)
{
    const bool settles = task.stress->expectation == Expectation::settles;
    const bool dims = task.stress->expectation == Expectation::dims;
    Result<Ready> ready = prepare(task, shot);
    if (!ready) return ready.diagnostics();
    Drawn drawn;
    drawn.absent = ready->absent;
    if (!drawn.absent.empty()) return drawn;
    const Result<UploadedScene> scene = UploadedScene::upload(*poison_, shot.scene);
    if (!scene) return scene.diagnostics();
    Frame frame = makeFrame(*scene, SceneCamera(), shot.extent);
    frame.camera = shot.camera;
    std::shared_ptr<const std::vector<ImportedTexture>> changed;
    if (shot.host) {
        const auto made = changedTextures(*poison_, shot);
        if (!made) return made.diagnostics();
        changed = *made;
        frame.textures = *changed;
    }
    Result<HostTextures> host =
        HostTextures::make(*poison_, ready->description, shot.extent, frame);
    if (!host) return host.diagnostics();
    const Result<Frame> hosted = host->frameOf(frame);
    if (!hosted) return hosted.diagnostics();
    const Result<Plan> plan =
        compile(ready->description, traitsOf(*hosted), poison_->caps(), ready->options);
    if (!plan) return plan.diagnostics();
    const bool needs_history = (!shot.before.empty() || shot.cut) && !settles;
    if (needs_history && !remembers(*plan)) {
        drawn.absent = "it keeps nothing from frame to frame";
        return drawn;
    }
    drawn.stored = storedFormat(*plan);
    drawn.passes = occlusionPasses(*plan, ready->description, shot.output);
    const std::vector<WatchedTarget> watched = watchAll(*plan, ready->description);

    const std::vector<Frame> frames = framesOf(shot, frame, remembers(*plan));
    const std::string owner = nameOf(task.config) + shot.geometry;
    for (Stage* stage : {&wide_, &plain_})
        if (const Status done = render(*stage, *ready, *host, frames, owner); !done)
            return done.diagnostics();
    if (const Status done = look(*plan, watched, drawn); !done) return done.diagnostics();
    if (const Status done = show(dims ? wide_ : plain_, shot.output, drawn.ao); !done)
        return done.diagnostics();
    if (dims)
        if (const Status done = show(wide_, "ao", drawn.next); !done) return done.diagnostics();
    if (!settles) return drawn;
    if (const Status done = plain_.renderer->render(*hosted); !done) return done.diagnostics();
    if (const Status done = show(plain_, shot.output, drawn.next); !done) return done.diagnostics();
    return drawn;
}

/// The ordinary step of the task's series; null where there is no picture.
const StressRunner::Drawn* StressRunner::ordinaryOf(const StressTask& task, Extent size)
{
    const std::string key = nameOf(task.config) + ", " + task.stress->name;
    if (ordinary_of_ != key) {
        ordinary_of_ = key;
        const StressStep& step = task.stress->steps[task.stress->ordinary];
        Result<Drawn> drawn = draw(task, task.stress->shot(step.value, size));
        ordinary_ = std::make_unique<Drawn>(drawn ? std::move(*drawn) : Drawn());
    }
    return ordinary_->ao.pixels.empty() ? nullptr : ordinary_.get();
}

/// With the ordinary picture, which is the exact answer of each step that must be the same.
void StressRunner::compare(const StressTask& task, Extent size, const StressShot& shot,
                           StressDrawing& done)
{
    if (task.stress->expectation != Expectation::same) return;
    const Drawn* ordinary = ordinaryOf(task, size);
    if (!ordinary) {
        done.record.absent = "the ordinary picture cannot be drawn";
        return;
    }
    const PictureChange change = changeBetween(ordinary->ao, done.ao, shot);
    done.record.change = change.change;
    if (isOrdinary(task)) return;
    done.record.exact = 1 - change.ordinary;
    done.record.occlusion = 1 - change.mean;
}

/// With the ground truth: the ordinary step, and each that has no other exact answer.
void StressRunner::compareToTruth(const StressTask& task, const StressShot& shot,
                                  StressDrawing& done) const
{
    const Expectation expected = task.stress->expectation;
    const bool known = expected == Expectation::open || expected == Expectation::one ||
                       (expected == Expectation::same && !isOrdinary(task));
    if (known || shot.output != "ao" ||
        std::min(shot.extent.width, shot.extent.height) < kLeastSide)
        return;
    Result<Image> ground_truth = cachedReference(shot.scene, shot.camera, shot.extent,
                                                 {shot.radius, kGroundTruthRays}, cache_folder_);
    if (!ground_truth) return;
    describeError(done.ao, *ground_truth, done.record);
    done.ground_truth = std::move(*ground_truth);
}

StressDrawing StressRunner::measure(const StressTask& task, Extent size)
{
    StressDrawing done;
    StressRecord& record = done.record;
    record.config = nameOf(task.config);
    record.case_name = task.stress->name;
    record.step = task.step;
    const StressShot shot = task.stress->shot(task.stress->steps[task.step].value, size);
    Result<Drawn> drawn = draw(task, shot);
    if (!drawn) {
        record.refusal = failureText(drawn.diagnostics());
        return done;
    }
    record.absent = drawn->absent;
    if (!record.absent.empty()) return done;
    done.ao = std::move(drawn->ao);
    record.bad_target = drawn->bad.target;
    record.bad_pass = drawn->bad.pass;
    record.bad_pixels = static_cast<long long>(drawn->bad.not_numbers + drawn->bad.infinite);
    record.out_of_range = static_cast<long long>(drawn->bad.out_of_range);
    record.bad_x = drawn->bad.first_bad.x;
    record.bad_y = drawn->bad.first_bad.y;
    record.bad_value = std::isfinite(drawn->bad.first_value) ? drawn->bad.first_value : 0;
    record.stored = formatInfo(drawn->stored).name;
    record.radius_px = radiusInPixels(shot);
    record.height_px = shot.extent.height;
    describeOcclusion(done.ao, record);
    describeSurface(done.ao, shot, drawn->stored, record);
    compareToTruth(task, shot, done);
    compare(task, size, shot, done);
    if (!drawn->next.pixels.empty() && task.stress->expectation == Expectation::settles)
        record.change = shareChanged(done.ao, drawn->next, kRestlessPixel);
    else if (const Drawn* without = drawn->next.pixels.empty() ? nullptr : ordinaryOf(task, size))
        record.change = errorOfLight(without->ao, done.ao, drawn->next);
    const std::vector<PassPicture> none;
    record.departing_pass = departingPass(*task.stress, shot, drawn->passes,
                                          ordinary_ ? ordinary_->passes : none, record);
    return done;
}

}  // namespace crevice
