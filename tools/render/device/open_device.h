// SPDX-License-Identifier: MIT
// A context without a window and the device in it: what --backend asks for.
#pragma once

#include <crevice/context.h>
#include <crevice/device.h>

#include "tools/render/device/program_folder.h"

namespace CLI {
class App;
}

namespace crevice {

enum class Mediump {
    full,  ///< Computed in 32 bits, as on a desktop.
    /// Rounded to half floats and 16-bit integers after each step, as on a phone at its worst.
    half,
};

/// Draws on `device` with every shader rewritten; its name says so. Its createProgram fails with
/// CV5001 where glslang does not understand a shader. Errors: CV6012 where crevice was built
/// without glslang and SPIRV-Cross.
Result<std::unique_ptr<Device>> makeMediumpDevice(std::unique_ptr<Device> device, Mediump mediump);

/// The module `words`, all else as it was; none of its values is mediump any more. Of locations and
/// bindings only those of vertex inputs and fragment outputs stay: everything else goes by name.
std::vector<std::uint32_t> rewriteMediump(const std::vector<std::uint32_t>& words, Mediump mediump);

/// Whether this build can make one.
bool canRewriteMediump();

/// The device goes before the context it lives in, and before who keeps its programs.
struct OpenDevice {
    std::unique_ptr<Context> context;
    std::unique_ptr<ProgramFolder> programs;  ///< Null without --program-cache.
    std::unique_ptr<Device> device;
};

void addBackendOption(CLI::App& app, std::string& backend);      ///< --backend
void addPrecisionOption(CLI::App& app, std::string& precision);  ///< --precision
void addProgramCacheOption(CLI::App& app, std::string& folder);  ///< --program-cache

/// "egl", "osmesa", or "" for the first of these that works, with a warning where that is not EGL.
/// With a precision of "full" or "half" the device is that of makeMediumpDevice; "" leaves mediump
/// to the driver. A `program_folder` keeps programs between runs. Errors: those of makeContext,
/// makeGlDevice, makeMediumpDevice and ProgramFolder::open.
Result<OpenDevice> openDevice(const std::string& backend, const std::string& precision = {},
                              const std::string& program_folder = {});

}  // namespace crevice
