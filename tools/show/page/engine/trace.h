// SPDX-License-Identifier: MIT
// Ray tracing in a worker of the page: a scene and a camera in, rows of visibility out.
#pragma once

#include "tools/measure/reference/progressive_trace.h"
#include "tools/measure/reference/ray_scene.h"

#include <memory>
#include <optional>
#include <string>

namespace crevice::page {

class Trace {
public:
    /// Takes the scene, as sceneBytes has it. Errors: those of sceneFromBytes.
    Status setScene(std::string_view bytes);

    /// Builds the tree for the camera's eye and begins anew. Errors: those of chooseCamera and
    /// ProgressiveTrace::begin.
    Status begin(const std::string& camera, Extent extent, const TraceOptions& options);

    ProgressiveTrace& progress() { return *progress_; }

private:
    Scene scene_;
    Bounds bounds_;
    std::unique_ptr<RayScene> tree_;
    std::optional<ProgressiveTrace> progress_;
};

}  // namespace crevice::page
