// SPDX-License-Identifier: MIT
// The engine under bench: tasks with keys, measured one after the other into a file.
//
// What the file has under a task's key is not measured again, so a run that was stopped goes on
// where it stopped, and files from several machines merge by putting one after the other. What a
// task is and how it is measured is the caller's; no GL is needed here.
#pragma once

#include "tools/measure/line_file.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace crevice {

struct MeasureTask {
    std::string key;    ///< Changes with all that decides the figures.
    std::string title;  ///< "learnopengl samples=16, room, 960x540".
    /// Why it cannot be measured, where that is known beforehand; else empty.
    std::string failure;
};

/// What a task came to.
struct Measured {
    /// For the file, without the last line feed: all of them or none. May be empty.
    std::string lines;
    std::string outcome;  ///< For people, in a few words.
};

/// What is to be measured.
struct MeasureJob {
    std::vector<MeasureTask> tasks;
    std::set<std::string> done;  ///< Keys that the file has figures of.

    /// Measures the task of that index. CV7007 ends the run, any other error becomes the task's
    /// failure; a warning is said once.
    std::function<Result<Measured>(std::size_t task)> measure;

    /// The line of a task that failed. Without this function the file has none; the task is tried
    /// again anyway.
    std::function<std::string(std::size_t task, const std::string& failure)> failure_line = {};
};

/// The world around the engine; tests put in their own.
struct MeasureWorld {
    std::function<double()> seconds;    ///< A clock.
    std::function<bool()> interrupted;  ///< A task that was under way is then dropped.
    std::function<void(const std::string& title)> begin;  ///< A task.
    std::function<void(const std::string& line)> say;
    double time_budget_s = 0;  ///< No task is begun after it; 0: no limit.
};

struct MeasureSummary {
    int measured = 0;
    int kept = 0;                       ///< The file had figures of them.
    std::vector<std::string> failures;  ///< Title and reason.
    std::vector<std::string> missing;   ///< Titles of tasks that nobody began.
    bool interrupted = false;
    Status written;
};

/// Measures every task that is not done and adds it to the file.
MeasureSummary measureAll(const MeasureJob& job, LineFile& file, const MeasureWorld& world);

/// The key of a task on a device.
std::string keyOnDevice(const std::string& task_key, const std::string& device);

/// The first that is an error; `diagnostics` has one.
const Diagnostic& firstError(const Diagnostics& diagnostics);

/// "my.frag:12:3: CV5001: the message": the first error, as a task's failure has it.
std::string failureText(const Diagnostics& diagnostics);

}  // namespace crevice
