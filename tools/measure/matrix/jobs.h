// SPDX-License-Identifier: MIT
// Parts of one work in processes side by side.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace crevice {

/// Has a line arrive at the parent.
using SendLine = std::function<void(const std::string& line)>;

/// Runs `work` for each job from 0 on in a copy of this process, and has every whole line taken as
/// it arrives. An interrupt is passed on, and their end awaited. Requires that nothing was drawn.
/// Returns how jobs ended that did not do so by themselves: "a process was ended by signal 11".
std::vector<std::string> runJobs(int jobs, const std::function<void(int job, SendLine send)>& work,
                                 const std::function<void(const std::string& line)>& take);

}  // namespace crevice
