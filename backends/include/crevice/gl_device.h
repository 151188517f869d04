// SPDX-License-Identifier: MIT
// The device on a GL context: OpenGL ES 3.0 to 3.2, or desktop OpenGL that takes ES 3.0 shaders.
//
// It adopts whatever context is current: the application's own, or one of <crevice/context.h>. It
// keeps the context's state and puts it back; backends/gl/state.h lists exactly what.
//
//     auto device = makeGlDevice(eglGetProcAddress);
#pragma once

#include <crevice/device.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace crevice {

/// Finds a function of the current context by its name, "glClear"; null when there is none. Made of
/// `eglGetProcAddress`, `SDL_GL_GetProcAddress`, `glfwGetProcAddress`, or all else that takes a
/// name and gives a pointer, to void or to a function. Must not be empty.
class GlLoader {
public:
    GlLoader() = default;

    template <class Find,
              class = std::enable_if_t<std::is_pointer_v<std::invoke_result_t<Find&, const char*>>>>
    GlLoader(Find find)
    {
        if constexpr (std::is_pointer_v<Find> || std::is_constructible_v<Find, std::nullptr_t>)
            if (!find) return;
        find_ = [find = std::move(find)](const char* name) mutable {
            return reinterpret_cast<void*>(find(name));
        };
    }

    void* operator()(const char* name) const { return find_(name); }

    /// Whether it is made of something.
    explicit operator bool() const { return static_cast<bool>(find_); }

private:
    std::function<void*(const char* name)> find_;
};

/// Where a host keeps linked programs between runs, so that the next run compiles none of them: in
/// a folder, say, with a file for each. The library itself writes no file.
///
/// Both functions are called wherever a program would be compiled, on the device's thread and in
/// its context: they must not throw, and not touch GL or the device. What they refer to must
/// outlive the device. Either may be empty. Neither is called where the driver gives no binaries
/// (GL_NUM_PROGRAM_BINARY_FORMATS is 0).
///
/// A key is 16 hex digits, fit for a file's name: a hash over both shaders as they are compiled,
/// and the driver's vendor, renderer and version. So what a key stands for never changes, any entry
/// may go at any time, and one place serves all configs, devices and versions. Drivers run what is
/// in it as code: keep it where no one else can write.
struct ProgramCache {
    /// What was stored under the key; empty for nothing. Bytes that are not whole, or that the
    /// driver refuses, are ignored: the program is compiled and stored again.
    std::function<std::vector<std::uint8_t>(const std::string& key)> load;

    /// Keeps the bytes, 4 to 21 KiB on Mesa's llvmpipe, in place of what is there.
    std::function<void(const std::string& key, const std::vector<std::uint8_t>& bytes)> store;
};

struct GlDeviceOptions {
    /// Puts the host's state back after each frame and each call outside of one. Off saves some 150
    /// queries a frame; the host must then set all state that it relies on.
    bool restore_state = true;

    /// Asks for errors after each pass, and once a frame whether the context is lost, or is not the
    /// one that is current. Off saves what can be a wait for a driver's own thread.
    bool check_errors = true;

    /// Pretends a bare OpenGL ES 3.0 without extensions: for testing what falls back.
    bool ignore_extensions = false;

    /// Keeps programs between runs. Default: each run compiles its own.
    ProgramCache program_cache = {};
};

/// A device in the current context. That context must be current for every call of the device, its
/// destructor included, until a call of it or of its renderers gives CV6016: the context is lost.
/// Where none is current, or another, calls give CV6004 and leave the device as it is: make the
/// context current and call again. What is destroyed meanwhile is deleted with the next call that
/// finds the context; names that a device destroyed so leaves go with its context. That is known by
/// GL calls that do nothing without a context, as they do in Mesa and libglvnd; of another driver
/// make sure yourself, since it may crash in them. From then on the device calls no GL; every
/// further call that can fail gives CV6016, and the device and all that was made on it may be
/// destroyed at any time, whatever context is current. It asks glGetGraphicsResetStatus, which
/// reports a reset once: a host that asks too may hear nothing.
///
/// Errors: CV6003 for a function that the context lacks, CV6004 for a context that is too old or
/// when none is current, CV6005 and CV6009 when the driver fails, CV6016 when the context is lost.
Result<std::unique_ptr<Device>> makeGlDevice(const GlLoader& loader,
                                             const GlDeviceOptions& options = {});

/// Marks a device's context as lost, for a host that knows before the driver reports it: one
/// whose window system destroyed the context. Requires a device of makeGlDevice.
void abandonGlDevice(Device& device);

}  // namespace crevice
