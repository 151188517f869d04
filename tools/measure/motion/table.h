// SPDX-License-Identifier: MIT
// Figures of motion as a table to read.
#pragma once

#include "tools/measure/motion/figures.h"

namespace crevice {

struct MotionRow {
    std::string name;
    double rest = 0;  ///< The error of a still camera.
    MotionFigures motion;
};

/// In Markdown, a row each: the error at rest, the change along each path (rms, 99th and 99.9th
/// percentile), the error in a pan, the frames to settle, the error where surfaces were uncovered.
std::string motionTable(const std::vector<MotionRow>& rows);

}  // namespace crevice
