// SPDX-License-Identifier: MIT
// Drawing the cells of a matrix. Devices, scenes on them, depths and ground truths are kept.
#pragma once

#include "tools/measure/matrix/plan.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"

#include <crevice/renderer.h>

namespace crevice {

/// A choice's renderer, ready to draw its frame.
struct PreparedChoice {
    PreparedChoice() = default;
    PreparedChoice(PreparedChoice&&) = default;
    ~PreparedChoice()
    {
        if (renderer) (void)context->makeCurrent();  // what goes then is this context's
    }

    Context* context = nullptr;
    std::unique_ptr<HostTextures> host;
    Frame frame;  ///< As the host hands it over.
    std::unique_ptr<Renderer> renderer;
};

/// The plan must outlive it.
class MatrixStage {
public:
    MatrixStage(const MatrixPlan& plan, std::string cache_folder);
    ~MatrixStage();

    /// Why a backend cannot be had; empty where it can.
    const Diagnostics& failureOf(const std::string& backend);

    /// The outputs of a choice's settled frame, by name. Those of the last choices are kept.
    /// Errors: those of the scene's upload, of Renderer::create and of drawSettled.
    Result<std::map<std::string, Image>> pictures(const MatrixChoice& choice);

    /// A renderer of one output, or of all of them, by its own name for it. Errors: as above.
    Result<PreparedChoice> prepare(const MatrixChoice& choice, std::vector<std::string> outputs);

    /// The plan text of an output, or of all that the config has. Errors: those of compile.
    Result<std::string> planText(const MatrixChoice& choice, const std::string& output);

    /// Ground truth with the radius of the choice's config; NaN where no surface is seen.
    /// Errors: those of cachedReference.
    Result<Image> truth(const MatrixChoice& choice, int rays);

    /// 1 where no surface is seen, else 0.
    Result<Image> background(const MatrixChoice& choice);

private:
    struct Backend;

    Result<Backend*> enter(const MatrixChoice& choice);
    Result<Frame> frameOf(Backend& backend, const MatrixChoice& choice);
    Result<Image> depthOf(Backend& backend, const MatrixChoice& choice, const Frame& frame);
    Result<Description> describe(Backend& backend, const MatrixChoice& choice, const Frame& frame);

    const MatrixPlan& plan_;
    const std::string cache_folder_;
    std::map<std::string, std::unique_ptr<Backend>> backends_;
    std::vector<std::pair<MatrixChoice, std::map<std::string, Image>>> kept_;  // newest last
};

}  // namespace crevice
