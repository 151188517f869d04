// SPDX-License-Identifier: MIT
#include "tools/measure/motion/table.h"

#include "core/base/text.h"
#include "tools/render/camera_path.h"

namespace crevice {
namespace {

/// Of the frames since surfaces were uncovered, those that the table shows.
constexpr int kShownFrames[] = {1, 4, 16};

std::string figure(double value) { return fixed(value, 4); }

std::string changeCell(const MotionFigures& motion, const char* path)
{
    const auto found = motion.paths.find(path);
    if (found == motion.paths.end()) return "";
    const ChangeFigures& change = found->second;
    return figure(change.rms) + ", " + fixed(change.p99, 3) + ", " + fixed(change.p999, 3);
}

std::string uncoveredCell(const MotionFigures& motion, int frames)
{
    for (const UncoveredFigures& each : motion.uncovered)
        if (each.frames == frames) return figure(each.rmse);
    return "";
}

}  // namespace

std::string motionTable(const std::vector<MotionRow>& rows)
{
    std::string head = "| config | at rest |", line = "|---|---|";
    for (const CameraPath& path : kCameraPaths)
        head += " " + std::string(path.name) + " |", line += "---|";
    head += " error in the pan | settles after |";
    for (const int frames : kShownFrames) head += " uncovered " + std::to_string(frames) + " |";
    head += " there at rest |\n";
    std::string text = head + line + "---|---|---|---|---|---|\n";
    for (const MotionRow& row : rows) {
        const MotionFigures& motion = row.motion;
        text += "| `" + row.name + "` | " + figure(row.rest) + " |";
        for (const CameraPath& path : kCameraPaths)
            text += " " + changeCell(motion, path.name) + " |";
        const auto pan = motion.paths.find("pan");
        text += " " + (pan == motion.paths.end() ? "" : figure(pan->second.rmse)) + " |";
        const int settled = motion.settled_after;
        text += " " + (settled > 0 ? std::to_string(settled) : "never") + " |";
        for (const int frames : kShownFrames) text += " " + uncoveredCell(motion, frames) + " |";
        text += " " + figure(motion.uncovered_rest) + " |\n";
    }
    return text;
}

}  // namespace crevice
