// SPDX-License-Identifier: MIT
// The device on a GL context: OpenGL ES 3.0 to 3.2, or desktop OpenGL that takes ES 3.0 shaders.
//
// It adopts whatever context is current: the application's own, or one of backends/context.h. It
// keeps the context's state and puts it back; backends/gl_state.h lists exactly what.
//
//     auto device = makeGlDevice([](const char* name) { return (void*)eglGetProcAddress(name); });
#pragma once

#include "backends/gl_loader.h"
#include "core/device.h"

#include <memory>

namespace crevice {

struct GlDeviceOptions {
    /// Puts the host's state back after each frame and each call outside of one. Off saves some 130
    /// queries a frame; the host must then set all state that it relies on.
    bool restore_state = true;

    /// Asks for errors after each pass, and whether the context is lost once a frame. Off saves what
    /// can be a wait for a driver's own thread.
    bool check_errors = true;

    /// Pretends a bare OpenGL ES 3.0 without extensions: for testing what falls back.
    bool ignore_extensions = false;
};

/// A device in the current context. That context must be current for every call of the device, its
/// destructor included, until a call of it or of its renderers gives CV6016: the context is lost.
/// From then on the device calls no GL; every further call that can fail gives CV6016, and the device
/// and all that was made on it may be destroyed at any time, whatever context is current. It asks
/// glGetGraphicsResetStatus, which tells of a reset once: a host that asks too may hear nothing.
///
/// Errors: CV6003 for a function that the context lacks, CV6004 for a context that is too old or
/// when none is current, CV6005 and CV6009 when the driver fails, CV6016 when the context is lost.
Result<std::unique_ptr<Device>> makeGlDevice(const GlLoader& loader,
                                             const GlDeviceOptions& options = {});

/// Tells a device that its context is lost, for a host that knows before the driver says so: one
/// whose window system destroyed the context. Requires a device of makeGlDevice.
void abandonGlDevice(Device& device);

}  // namespace crevice
