// SPDX-License-Identifier: MIT
// Another program run to its end: what goes in, and all that it prints.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct ProgramRun {
    bool ended = false;   ///< It ended by itself, within the time.
    int exit_code = 0;    ///< Then.
    std::string output;   ///< Of stdout and stderr, in the order in which they were written.
    std::string failure;  ///< Why it did not end so: "it was ended by signal 11"; else empty.
};

/// Runs the program at `path` with `input` on its standard input and the `variables`
/// ("NAME=value") over this process's environment, and waits until it ends, at most `time_s`
/// seconds.
ProgramRun runProgram(const std::string& path, const std::vector<std::string>& variables,
                      const std::string& input, double time_s);

}  // namespace crevice
