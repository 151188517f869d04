// SPDX-License-Identifier: MIT
// GL contexts without a window, for tools, tests and servers. An application that has a context of
// its own needs none of this: it hands its loader to `makeGlDevice`.
//
// EGL and OSMesa are opened when a context is asked for; nothing links them.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/gl_device.h>

#include <memory>
#include <string>
#include <string_view>

namespace crevice {

/// An offscreen context. It has no framebuffer of its own to draw to: render to textures.
///
/// Several may live at once; one at a time is current on a thread. Use and destroy it on one
/// thread. All that was made in it, a Device too, must be destroyed before it, and while it is
/// current.
class Context {
public:
    /// If it is current it is let go first; then it is destroyed.
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes it current on this thread. The crevice context that was current is let go by its own
    /// library first: of EGL and OSMesa each knows its own alone, and would take it for current
    /// still.
    ///
    /// Errors: CV6001 or CV6002 when the library refuses.
    Status makeCurrent();

    /// Finds functions while it is current.
    virtual GlLoader loader() const = 0;

    /// For people: the way it was made, renderer and version.
    const std::string& description() const { return description_; }

protected:
    Context() = default;

    virtual Status bind() = 0;
    virtual void release() = 0;

    /// For the destructors of subclasses: lets go if current.
    void releaseIfCurrent();

    /// Sets the description to `way` and what the current context says of itself.
    void describe(const std::string& way);

private:
    std::string description_;
};

/// OpenGL ES 3.2, 3.1 or 3.0 through EGL, and makes it current. Tries Mesa's surfaceless platform,
/// then each EGL device, then the default display with a 1x1 buffer.
///
/// Errors: CV6001, with a note for each way that was tried.
Result<std::unique_ptr<Context>> makeEglContext();

/// Desktop OpenGL 4.5 core down to 3.3 core, rendered by the CPU through OSMesa, and makes it
/// current. Such a context takes GLSL ES through ARB_ES3_compatibility.
///
/// Errors: CV6002; CV6012 when built without OSMesa.
Result<std::unique_ptr<Context>> makeOsmesaContext();

/// One of the above by name: "egl" or "osmesa". Errors: theirs; CV6012 for another name.
Result<std::unique_ptr<Context>> makeContext(std::string_view backend);

}  // namespace crevice
