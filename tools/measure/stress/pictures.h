// SPDX-License-Identifier: MIT
// The pictures that a stress run keeps: of failures, and of the last step before each breakdown
// point.
#pragma once

#include "tools/measure/stress/breakdown.h"

#include <functional>
#include <string>
#include <vector>

namespace crevice {

/// Where the picture of a step lies, and the ground truth's, below the run's folder.
std::string pictureOf(const StressRecord& record);
std::string truthPictureOf(const StressRecord& record);

/// Writes both, the latter where there is one. Errors: CV7007.
Status keepPictures(const std::string& folder, const StressDrawing& done);

/// What draws the pictures before and after each point that the folder lacks: which step is the
/// last that holds is known when all are drawn. `steps` are the run's, as stressJob has made them
/// of `tasks`, which must outlive the job.
MeasureJob pictureJob(const std::vector<StressTask>& tasks, const MeasureJob& steps,
                      const std::vector<BreakdownPoint>& points, const std::string& folder,
                      std::function<StressDrawing(const StressTask&)> measure);

}  // namespace crevice
