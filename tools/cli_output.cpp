// SPDX-License-Identifier: MIT
// Diagnostics, exit codes and progress of the crevice command.
#include "tools/cli_output.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace crevice {

int exitCodeOf(const Diagnostics& diagnostics)
{
    const auto error = std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& d) {
        return d.severity == Severity::error;
    });
    if (error == diagnostics.end()) return kExitOk;
    switch (error->code) {
    case Code::usage: return kExitUsage;
    case Code::cannot_write: return kExitOutput;
    case Code::no_egl:
    case Code::no_osmesa:
    case Code::gl_function:
    case Code::gl_version:
    case Code::gl_error:
    case Code::no_format:
    case Code::too_many:
    case Code::out_of_memory:
    case Code::context_lost:
    case Code::no_backend: return kExitMachine;
    default: return kExitBadInput;
    }
}

int report(const Diagnostics& diagnostics, bool json)
{
    if (diagnostics.empty()) return kExitOk;
    if (json)
        std::printf("{\"diagnostics\": %s}\n", toJson(diagnostics).c_str());
    else
        std::fputs(toText(diagnostics).c_str(), stderr);
    return exitCodeOf(diagnostics);
}

void append(Diagnostics& all, const Diagnostics& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { wipe(); }

void Progress::begin(std::string what)
{
    what_ = std::move(what);
    percent_ = 0;
    wipe();
    if (terminal_) std::fprintf(stderr, "%s ...", what_.c_str());
}

void Progress::update(double done)
{
    const int percent = static_cast<int>(done * 100.0);
    if (!terminal_ || percent == percent_) return;
    percent_ = percent;
    wipe();
    std::fprintf(stderr, "%s ... %d %%", what_.c_str(), percent);
}

void Progress::wipe()
{
    if (terminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace crevice
