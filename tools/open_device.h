// SPDX-License-Identifier: MIT
// A context without a window and the device in it: what --backend asks for.
#pragma once

#include "backends/context.h"
#include "core/device.h"

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace crevice {

/// The device goes before the context it lives in.
struct OpenDevice {
    std::unique_ptr<Context> context;
    std::unique_ptr<Device> device;
};

/// Adds --backend.
void addBackendOption(CLI::App& app, std::string& backend);

/// "egl", "osmesa", or "" for the first of these that works, with a warning where that is not EGL.
/// Errors: those of makeContext and makeGlDevice.
Result<OpenDevice> openDevice(const std::string& backend);

}  // namespace crevice
