// SPDX-License-Identifier: MIT
// A context without a window and the device in it: what --backend asks for.
#pragma once

#include <crevice/context.h>

#include "tools/render/device/program_folder.h"

namespace CLI {
class App;
}

namespace crevice {

/// The device goes before the context it lives in, and before who keeps its programs.
struct OpenDevice {
    std::unique_ptr<Context> context;
    std::unique_ptr<ProgramFolder> programs;  ///< Null without --program-cache.
    std::unique_ptr<Device> device;
};

/// Adds --backend.
void addBackendOption(CLI::App& app, std::string& backend);

/// Adds --precision.
void addPrecisionOption(CLI::App& app, std::string& precision);

/// Adds --program-cache.
void addProgramCacheOption(CLI::App& app, std::string& folder);

/// "egl", "osmesa", or "" for the first of these that works, with a warning where that is not EGL.
/// With a precision of "full" or "half" the device is that of makeMediumpDevice; "" leaves mediump
/// to the driver. A `program_folder` keeps programs between runs. Errors: those of makeContext,
/// makeGlDevice, makeMediumpDevice and ProgramFolder::open.
Result<OpenDevice> openDevice(const std::string& backend, const std::string& precision = {},
                              const std::string& program_folder = {});

}  // namespace crevice
