// SPDX-License-Identifier: MIT
// Drawing the cells of a matrix. Devices, scenes on them and the last pictures are kept.
#pragma once

#include "core/base/text.h"
#include "tools/measure/matrix/plan.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

#include <crevice/renderer.h>

namespace crevice {

/// Of all pictures that are kept for other cells.
constexpr std::size_t kKeptFloats = 64u << 20;

/// A choice on its device, whose context is current after MatrixStage::enter.
struct EnteredChoice {
    OpenDevice* open;
    Frame frame;              ///< Of the scene.
    Description description;  ///< With lengths in the scene's units.
};

/// A choice's renderer, ready to draw its frame.
struct PreparedChoice : EnteredChoice {
    explicit PreparedChoice(EnteredChoice entered) : EnteredChoice(std::move(entered)) {}
    PreparedChoice(PreparedChoice&&) = default;
    ~PreparedChoice()
    {
        if (drawn.renderer) (void)open->context->makeCurrent();  // what goes then is this context's
    }

    Drawn drawn = {};
};

/// The plan must outlive it.
class MatrixStage {
public:
    explicit MatrixStage(const MatrixPlan& plan) : plan_(plan) {}
    ~MatrixStage()
    {
        for (auto& [name, backend] : backends_) {
            if (backend.open.context) (void)backend.open.context->makeCurrent();
            backend.scenes.clear();
        }
    }

    /// Why a choice's backend cannot be had; empty where it can.
    const Diagnostics& failureOf(const MatrixChoice& choice) { return backendOf(choice).failure; }

    /// Errors: those of openDevice, of the scene's upload and of resolveLengths.
    Result<EnteredChoice> enter(const MatrixChoice& choice)
    {
        Backend& backend = backendOf(choice);
        if (!backend.failure.empty()) return backend.failure;
        if (const Status current = backend.open.context->makeCurrent(); !current)
            return current.diagnostics();
        Device& device = *backend.open.device;
        const MatrixShot& shot = plan_.shots.at(choice);
        const std::string& name = plan_.matrix.value(choice, kSceneAxis).text;
        auto scene = backend.scenes.find(name);
        if (scene == backend.scenes.end()) {
            Result<UploadedScene> uploaded = UploadedScene::upload(device, shot.scene->scene);
            if (!uploaded) return uploaded.diagnostics();
            scene = backend.scenes.emplace(name, std::move(*uploaded)).first;
        }
        EnteredChoice entered{&backend.open, makeFrame(scene->second, shot.camera, shot.extent),
                              shot.subject->description};
        const Result<std::string> lengths = resolveLengths(
            entered.description, entered.frame.camera, shot.extent, shot.scene->bounds.diagonal(),
            [&] { return medianDistance(device, entered.frame, shot.extent); });
        if (!lengths) return lengths.diagnostics();
        return entered;
    }

    /// A renderer of outputs by the config's own names for them. Errors: also those of
    /// Renderer::create.
    Result<PreparedChoice> prepare(const MatrixChoice& choice, std::vector<std::string> outputs)
    {
        Result<EnteredChoice> entered = enter(choice);
        if (!entered) return entered.diagnostics();
        PreparedChoice prepared(std::move(*entered));
        const Status ready =
            prepared.drawn.prepare(*prepared.open->device, prepared.description, prepared.frame,
                                   {plan_.shots.at(choice).extent, std::move(outputs), {}});
        if (!ready) return ready.diagnostics();
        return prepared;
    }

    /// The outputs of a choice's settled frame, by name. Errors: also those of drawSettled.
    Result<std::map<std::string, Image>> pictures(const MatrixChoice& choice)
    {
        if (const auto known = kept_.find(choice); known != kept_.end()) return known->second;
        const auto& sources = plan_.shots.at(choice).subject->sources;
        std::vector<std::string> outputs;
        for (const auto& [name, source] : sources)
            if (!contains(outputs, source.output)) outputs.push_back(source.output);
        Result<PreparedChoice> prepared = prepare(choice, outputs);
        if (!prepared) return prepared.diagnostics();
        Device& device = *prepared->open->device;
        const Drawn& drawn = prepared->drawn;
        const auto first = drawSettled(device, *drawn.renderer, drawn.frame, outputs[0]);
        if (!first) return first.diagnostics();
        std::map<std::string, Image> pictures;
        for (const auto& [name, source] : sources) {
            Result<Image> image = readOutput(device, *drawn.renderer, source.output);
            if (!image) return image.diagnostics();
            applyView(*image, source);
            kept_floats_ += image->pixels.size();
            pictures[name] = std::move(*image);
        }
        if (kept_floats_ > kKeptFloats) {
            kept_.clear();
            kept_floats_ = 0;
        }
        kept_[choice] = pictures;
        return pictures;
    }

    /// The plan text of an output, or of all that the config has. Errors: also those of compile.
    Result<std::string> planText(const MatrixChoice& choice, const std::string& output)
    {
        const Result<EnteredChoice> entered = enter(choice);
        if (!entered) return entered.diagnostics();
        const MatrixShot& shot = plan_.shots.at(choice);
        std::vector<std::string> outputs = shot.subject->exported;
        if (!output.empty()) outputs = {shot.subject->sources.at(output).output};
        const Result<Plan> plan =
            compile(entered->description, traitsOf(entered->frame), entered->open->device->caps(),
                    {shot.extent, outputs, {}});
        if (!plan) return plan.diagnostics();
        return toText(*plan);
    }

    /// Ground truth with the radius of the choice's config; NaN where no surface is seen.
    /// Errors: also those of cachedReference.
    Result<Image> truth(const MatrixChoice& choice, int rays, const std::string& cache_folder)
    {
        const Result<EnteredChoice> entered = enter(choice);
        if (!entered) return entered.diagnostics();
        const MatrixShot& shot = plan_.shots.at(choice);
        const TraceOptions trace = {findNamed(entered->description.params, "radius")->value[0],
                                    rays};
        return cachedReference(shot.scene->scene, entered->frame.camera, shot.extent, trace,
                               cache_folder);
    }

    /// 1 where no surface is seen, else 0. Errors: also those of drawDepth.
    Result<Image> background(const MatrixChoice& choice)
    {
        const Result<EnteredChoice> entered = enter(choice);
        if (!entered) return entered.diagnostics();
        Result<Image> mask =
            drawDepth(*entered->open->device, entered->frame, plan_.shots.at(choice).extent);
        const float far = entered->frame.camera.reversedDepth() ? 0.0f : 1.0f;
        if (mask)
            for (float& depth : mask->pixels) depth = depth == far;
        return mask;
    }

private:
    struct Backend {
        Diagnostics failure = {};
        OpenDevice open = {};  // goes last
        std::map<std::string, UploadedScene> scenes = {};
    };

    Backend& backendOf(const MatrixChoice& choice)
    {
        const std::string& name = plan_.matrix.value(choice, kBackendAxis).text;
        const auto known = backends_.find(name);
        if (known != backends_.end()) return known->second;
        Backend& backend = backends_[name];
        Result<OpenDevice> open = openDevice(name);
        if (open)
            backend.open = std::move(*open);
        else
            backend.failure = open.diagnostics();
        return backend;
    }

    const MatrixPlan& plan_;
    std::map<std::string, Backend> backends_;
    std::map<MatrixChoice, std::map<std::string, Image>> kept_;
    std::size_t kept_floats_ = 0;
};

}  // namespace crevice
