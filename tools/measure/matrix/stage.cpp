// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/stage.h"

#include "core/base/text.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

namespace crevice {
namespace {

/// Of all pictures that are kept for other cells.
constexpr std::size_t kKeptFloats = 64u << 20;

std::size_t floatsOf(const std::map<std::string, Image>& pictures)
{
    std::size_t sum = 0;
    for (const auto& [name, image] : pictures) sum += image.pixels.size();
    return sum;
}

}  // namespace

/// A device, or why there is none.
struct MatrixStage::Backend {
    ~Backend()
    {
        if (open.context) (void)open.context->makeCurrent();
    }

    Diagnostics failure;
    OpenDevice open;  // goes last
    std::map<std::string, UploadedScene> scenes;
    std::map<MatrixChoice, Image> depths;
};

MatrixStage::MatrixStage(const MatrixPlan& plan, std::string cache_folder)
    : plan_(plan),
      cache_folder_(std::move(cache_folder))
{
}

MatrixStage::~MatrixStage() = default;

const Diagnostics& MatrixStage::failureOf(const std::string& backend)
{
    std::unique_ptr<Backend>& known = backends_[backend];
    if (!known) {
        known = std::make_unique<Backend>();
        Result<OpenDevice> open = openDevice(backend);
        if (open)
            known->open = std::move(*open);
        else
            known->failure = open.diagnostics();
    }
    return known->failure;
}

/// The choice's backend is current then.
Result<MatrixStage::Backend*> MatrixStage::enter(const MatrixChoice& choice)
{
    const std::string& name = plan_.matrix.value(choice, kBackendAxis).text;
    if (const Diagnostics& failure = failureOf(name); !failure.empty()) return failure;
    Backend* const backend = backends_[name].get();
    const Status current = backend->open.context->makeCurrent();
    if (!current) return current.diagnostics();
    return backend;
}

Result<Frame> MatrixStage::frameOf(Backend& backend, const MatrixChoice& choice)
{
    const std::string& name = plan_.matrix.value(choice, kSceneAxis).text;
    auto known = backend.scenes.find(name);
    if (known == backend.scenes.end()) {
        Result<UploadedScene> scene =
            UploadedScene::upload(*backend.open.device, plan_.scene(choice).scene);
        if (!scene) return scene.diagnostics();
        known = backend.scenes.emplace(name, std::move(*scene)).first;
    }
    const MatrixView& view = plan_.view(choice);
    return makeFrame(known->second, view.camera, view.extent);
}

Result<Image> MatrixStage::depthOf(Backend& backend, const MatrixChoice& choice, const Frame& frame)
{
    MatrixChoice view = choice;
    for (std::size_t axis = 0; axis < view.size(); ++axis)
        if (axis != kSceneAxis && axis != kCameraAxis && axis != kSizeAxis) view[axis] = 0;
    const auto known = backend.depths.find(view);
    if (known != backend.depths.end()) return known->second;
    Result<Image> depth = drawDepth(*backend.open.device, frame, plan_.view(choice).extent);
    if (depth) backend.depths[view] = *depth;
    return depth;
}

/// With lengths in the scene's units.
Result<Description> MatrixStage::describe(Backend& backend, const MatrixChoice& choice,
                                          const Frame& frame)
{
    Description description = plan_.subject(choice).description;
    const auto distance = [&]() -> Result<double> {
        const Result<Image> depth = depthOf(backend, choice, frame);
        if (!depth) return depth.diagnostics();
        if (const auto found = medianDistance(*depth, frame.camera)) return *found;
        return Diagnostic{Code::nothing_seen, "the camera sees no surface",
                          "choose another camera"};
    };
    const Result<std::string> lengths =
        resolveLengths(description, frame.camera, plan_.view(choice).extent,
                       plan_.scene(choice).bounds.diagonal(), distance);
    if (!lengths) return lengths.diagnostics();
    return description;
}

Result<PreparedChoice> MatrixStage::prepare(const MatrixChoice& choice,
                                            std::vector<std::string> outputs)
{
    const Result<Backend*> backend = enter(choice);
    if (!backend) return backend.diagnostics();
    Device& device = *(*backend)->open.device;
    const Result<Frame> frame = frameOf(**backend, choice);
    if (!frame) return frame.diagnostics();
    Result<Description> description = describe(**backend, choice, *frame);
    if (!description) return description.diagnostics();
    PreparedChoice prepared;
    prepared.context = (*backend)->open.context.get();
    const Extent extent = plan_.view(choice).extent;
    Result<HostTextures> host = HostTextures::make(device, *description, extent, *frame);
    if (!host) return host.diagnostics();
    prepared.host = std::make_unique<HostTextures>(std::move(*host));
    const Result<Frame> hosted = prepared.host->frameOf(*frame);
    if (!hosted) return hosted.diagnostics();
    prepared.frame = *hosted;
    auto renderer = Renderer::create(device, std::move(*description),
                                     {extent, std::move(outputs), {}}, traitsOf(*hosted));
    if (!renderer) return renderer.diagnostics();
    prepared.renderer = std::move(*renderer);
    return prepared;
}

Result<std::map<std::string, Image>> MatrixStage::pictures(const MatrixChoice& choice)
{
    for (const auto& [known, pictures] : kept_)
        if (known == choice) return pictures;
    const auto& sources = plan_.subject(choice).sources;
    std::vector<std::string> outputs;
    for (const auto& [name, source] : sources)
        if (!contains(outputs, source.output)) outputs.push_back(source.output);
    Result<PreparedChoice> prepared = prepare(choice, outputs);
    if (!prepared) return prepared.diagnostics();
    Device& device = *backends_[plan_.matrix.value(choice, kBackendAxis).text]->open.device;
    const Result<Image> first =
        drawSettled(device, *prepared->renderer, prepared->frame, outputs[0]);
    if (!first) return first.diagnostics();
    std::map<std::string, Image> pictures;
    for (const auto& [name, source] : sources) {
        Result<Image> image = readOutput(device, *prepared->renderer, source.output);
        if (!image) return image.diagnostics();
        applyView(*image, source);
        pictures[name] = std::move(*image);
    }
    kept_.emplace_back(choice, pictures);
    std::size_t floats = 0;
    for (const auto& [known, each] : kept_) floats += floatsOf(each);
    while (floats > kKeptFloats && kept_.size() > 1) {
        floats -= floatsOf(kept_.front().second);
        kept_.erase(kept_.begin());
    }
    return pictures;
}

Result<std::string> MatrixStage::planText(const MatrixChoice& choice, const std::string& output)
{
    const Result<Backend*> backend = enter(choice);
    if (!backend) return backend.diagnostics();
    const Result<Frame> frame = frameOf(**backend, choice);
    if (!frame) return frame.diagnostics();
    const Result<Description> description = describe(**backend, choice, *frame);
    if (!description) return description.diagnostics();
    const MatrixSubject& subject = plan_.subject(choice);
    std::vector<std::string> outputs = subject.exported;
    if (!output.empty()) outputs = {subject.sources.at(output).output};
    const Result<Plan> plan =
        compile(*description, traitsOf(*frame), (*backend)->open.device->caps(),
                {plan_.view(choice).extent, outputs, {}});
    if (!plan) return plan.diagnostics();
    return toText(*plan);
}

Result<Image> MatrixStage::truth(const MatrixChoice& choice, int rays)
{
    const Result<Backend*> backend = enter(choice);
    if (!backend) return backend.diagnostics();
    const Result<Frame> frame = frameOf(**backend, choice);
    if (!frame) return frame.diagnostics();
    const Result<Description> description = describe(**backend, choice, *frame);
    if (!description) return description.diagnostics();
    TraceOptions trace;
    trace.radius = findNamed(description->params, "radius")->value[0];
    trace.rays = rays;
    return cachedReference(plan_.scene(choice).scene, frame->camera, plan_.view(choice).extent,
                           trace, cache_folder_);
}

Result<Image> MatrixStage::background(const MatrixChoice& choice)
{
    const Result<Backend*> backend = enter(choice);
    if (!backend) return backend.diagnostics();
    const Result<Frame> frame = frameOf(**backend, choice);
    if (!frame) return frame.diagnostics();
    Result<Image> mask = depthOf(**backend, choice, *frame);
    if (!mask) return mask.diagnostics();
    const float far = frame->camera.reversedDepth() ? 0.0f : 1.0f;
    for (float& depth : mask->pixels) depth = depth == far;
    return mask;
}

}  // namespace crevice
