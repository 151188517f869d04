// SPDX-License-Identifier: MIT
// Ablation: what each optimization saves by itself.
//
// A config is drawn in situations that a host meets: a moving camera, a moving light, nothing that
// moves, occlusion that is off, occlusion alone. In each, renderers with all optimizations, without
// one of them and with none take turns (see tools/bench/times.h). What counts is a whole frame, the
// wait for the GPU included: on a software renderer by the processor time of the process, elsewhere
// by the wall clock.
//
// Results are JSON Lines, FOLDER/ablation.jsonl, one line an optimization, situation, scene and
// config.
#pragma once

#include <crevice/device.h>

#include "tools/bench/bench.h"

#include <functional>
#include <string>
#include <vector>

namespace crevice {

struct AblationRow {
    std::string key;  ///< Of the task, on its device.
    std::string config;
    std::string scene;
    std::string camera;
    Extent extent;
    std::string situation;     ///< "moving camera", "moving light", "still", "off", "ao alone".
    std::string optimization;  ///< Switched off; empty: none is, "all": all are.
    TimeFigures ms;            ///< A frame.
    /// Over the time with all optimizations, turn by turn; 1 where `optimization` is empty.
    TimeFigures factor;
    double texture_bytes = 0;
    int elided = 0;     ///< Passes, attachments and textures that the plan leaves out.
    std::string clock;  ///< As BenchSample has it, never "query".
    int repeats = 0;    ///< Turns.
    std::string device;
    std::string version;  ///< Of crevice.
};

/// One line, without the line feed.
std::string toJsonLine(const AblationRow& row);

/// Reads FOLDER/ablation.jsonl of each folder among the paths, or beside each file; none is no
/// error. Of two lines with one identity on one device the later one holds.
///
/// Errors: those of readLines.
Result<std::vector<AblationRow>> readAblation(const std::vector<std::string>& paths);

/// The rows of a task: every situation by every optimization; few or none where it is interrupted
/// between turns.
///
/// Errors: those of the device and the renderer.
Result<std::vector<AblationRow>> ablate(Device& device, const BenchTask& task,
                                        const BenchView& view, int repeats,
                                        const std::function<bool()>& interrupted);

/// What the engine of tools/measure needs to time every situation by every optimization for each
/// task of a plan; `known` is what the file has. The device and the plan must outlive it.
MeasureJob ablationJob(Device& device, const BenchPlan& plan, const std::vector<AblationRow>& known,
                       int repeats, std::function<bool()> interrupted);

/// Those of a task.
std::vector<AblationRow> rowsOf(const std::vector<AblationRow>& rows, const std::string& key);

/// For people: a line a situation, milliseconds with all optimizations, then the factors without.
std::string toText(const std::vector<AblationRow>& rows);

}  // namespace crevice
