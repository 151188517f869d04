// SPDX-License-Identifier: MIT
// OpenGL ES through EGL, without a window system.
#include <crevice/context.h>

#include "backends/context/dynamic_library.h"
#include "backends/gl/failure.h"

#define EGL_EGL_PROTOTYPES 0  // found at run time, never linked
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>

namespace crevice {

namespace {

#define CREVICE_EGL_FUNCTIONS(X) \
    X(BindAPI, BINDAPI) \
    X(ChooseConfig, CHOOSECONFIG) \
    X(CreateContext, CREATECONTEXT) \
    X(CreatePbufferSurface, CREATEPBUFFERSURFACE) \
    X(DestroyContext, DESTROYCONTEXT) \
    X(DestroySurface, DESTROYSURFACE) \
    X(GetDisplay, GETDISPLAY) \
    X(GetError, GETERROR) \
    X(GetProcAddress, GETPROCADDRESS) \
    X(Initialize, INITIALIZE) \
    X(MakeCurrent, MAKECURRENT) \
    X(QueryAPI, QUERYAPI) \
    X(QueryString, QUERYSTRING)

struct EglApi {
#define CREVICE_EGL_MEMBER(name, upper) PFNEGL##upper##PROC name = nullptr;
    CREVICE_EGL_FUNCTIONS(CREVICE_EGL_MEMBER)
#undef CREVICE_EGL_MEMBER
};

using Notes = std::vector<Note>;

const char* const kEglHelp =
    "EGL is in Debian's packages libegl1 and libgl1-mesa-dri; the backend 'osmesa' needs neither";

std::string errorText(const EglApi& egl)
{
    char text[32];
    std::snprintf(text, sizeof text, "EGL error 0x%04X", egl.GetError());
    return text;
}

/// True when the space-separated list that EGL gives for `display` holds `name`.
bool hasExtension(const EglApi& egl, EGLDisplay display, const std::string& name)
{
    const char* list = egl.QueryString(display, EGL_EXTENSIONS);
    if (!list) return false;
    return (" " + std::string(list) + " ").find(" " + name + " ") != std::string::npos;
}

Result<EglApi> loadEgl()
{
    Result<void*> library = openLibrary({"libEGL.so.1", "libEGL.so"}, Code::no_egl, kEglHelp);
    if (!library) return library.diagnostics();
    EglApi api;
#define CREVICE_EGL_LOAD(name, upper) \
    api.name = reinterpret_cast<PFNEGL##upper##PROC>(findSymbol(*library, "egl" #name)); \
    if (!api.name) \
        return failure(Code::no_egl, "the EGL library has no function egl" #name, kEglHelp);
    CREVICE_EGL_FUNCTIONS(CREVICE_EGL_LOAD)
#undef CREVICE_EGL_LOAD
    return api;
}

// The display is never terminated: eglTerminate would take the contexts of everyone in the process
// who uses the same display, this library's and the host's.
class EglContext final : public Context {
public:
    EglContext(const EglApi& egl, EGLDisplay display, EGLContext handle, EGLSurface surface)
        : egl_(egl),
          display_(display),
          handle_(handle),
          surface_(surface)
    {
    }

    ~EglContext() override
    {
        releaseIfCurrent();
        if (surface_ != EGL_NO_SURFACE) egl_.DestroySurface(display_, surface_);
        egl_.DestroyContext(display_, handle_);
    }

    GlLoader loader() const override
    {
        auto find = egl_.GetProcAddress;
        return [find](const char* name) { return reinterpret_cast<void*>(find(name)); };
    }

    void describe(const std::string& way) { Context::describe("EGL " + way); }

private:
    Status bind() override
    {
        if (egl_.MakeCurrent(display_, surface_, surface_, handle_)) return {};
        return failure(Code::no_egl, "eglMakeCurrent failed: " + errorText(egl_), kEglHelp);
    }

    void release() override
    {
        egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

    const EglApi& egl_;
    EGLDisplay display_;
    EGLContext handle_;
    EGLSurface surface_;
};

EGLContext createHandle(const EglApi& egl, EGLDisplay display, EGLConfig config)
{
    const EGLenum host_api = egl.QueryAPI();
    egl.BindAPI(EGL_OPENGL_ES_API);
    EGLContext handle = EGL_NO_CONTEXT;
    for (EGLint minor = 2; minor >= 0 && handle == EGL_NO_CONTEXT; --minor) {
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, minor,
                                     EGL_NONE};
        handle = egl.CreateContext(display, config, EGL_NO_CONTEXT, attributes);
    }
    if (host_api != EGL_NONE) egl.BindAPI(host_api);
    return handle;
}

/// A context on `display`, current; or null with a note that says why.
std::unique_ptr<Context> openDisplay(const EglApi& egl, EGLDisplay display, const std::string& way,
                                     Notes& notes)
{
    auto fail = [&](const char* call) {
        notes.push_back({{}, way + ": " + call + " failed: " + errorText(egl)});
        return nullptr;
    };
    if (display == EGL_NO_DISPLAY) return fail("getting the display");
    if (!egl.Initialize(display, nullptr, nullptr)) return fail("eglInitialize");

    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl.ChooseConfig(display, wanted, &config, 1, &count) || count == 0)
        return fail("eglChooseConfig for OpenGL ES 3");

    EGLSurface surface = EGL_NO_SURFACE;
    if (!hasExtension(egl, display, "EGL_KHR_surfaceless_context")) {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface = egl.CreatePbufferSurface(display, config, size);
        if (surface == EGL_NO_SURFACE) return fail("eglCreatePbufferSurface");
    }
    EGLContext handle = createHandle(egl, display, config);
    if (handle == EGL_NO_CONTEXT) {
        fail("eglCreateContext for OpenGL ES 3");
        if (surface != EGL_NO_SURFACE) egl.DestroySurface(display, surface);
        return nullptr;
    }
    auto context = std::make_unique<EglContext>(egl, display, handle, surface);
    if (Status status = context->makeCurrent(); !status) {
        notes.push_back({{}, way + ": " + status.diagnostics().front().message});
        return nullptr;
    }
    context->describe(way);
    return context;
}

PFNEGLGETPLATFORMDISPLAYEXTPROC platformDisplayFunction(const EglApi& egl)
{
    return reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl.GetProcAddress("eglGetPlatformDisplayEXT"));
}

std::unique_ptr<Context> trySurfaceless(const EglApi& egl, Notes& notes)
{
    auto get_display = platformDisplayFunction(egl);
    if (!get_display || !hasExtension(egl, EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        notes.push_back({{}, "surfaceless: EGL_MESA_platform_surfaceless is not there"});
        return nullptr;
    }
    EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    return openDisplay(egl, display, "surfaceless", notes);
}

std::unique_ptr<Context> tryDevices(const EglApi& egl, Notes& notes)
{
    auto get_display = platformDisplayFunction(egl);
    auto query =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (!get_display || !query || !hasExtension(egl, EGL_NO_DISPLAY, "EGL_EXT_platform_device") ||
        !query(0, nullptr, &count) || count == 0) {
        notes.push_back({{}, "device: EGL_EXT_platform_device is not there or knows no device"});
        return nullptr;
    }
    std::vector<EGLDeviceEXT> devices(count);
    query(count, devices.data(), &count);
    for (int i = 0; i < count; ++i) {
        EGLDisplay display = get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (auto context = openDisplay(egl, display, "device " + std::to_string(i), notes))
            return context;
    }
    return nullptr;
}

std::unique_ptr<Context> tryDefault(const EglApi& egl, Notes& notes)
{
    return openDisplay(egl, egl.GetDisplay(EGL_DEFAULT_DISPLAY), "default display", notes);
}

}  // namespace

Result<std::unique_ptr<Context>> makeEglContext()
{
    static const Result<EglApi> egl = loadEgl();
    if (!egl) return egl.diagnostics();
    Notes notes;
    for (auto attempt : {trySurfaceless, tryDevices, tryDefault})
        if (std::unique_ptr<Context> context = attempt(*egl, notes)) return context;
    Diagnostic error = failure(Code::no_egl, "EGL gives no OpenGL ES 3 context", kEglHelp);
    error.notes = std::move(notes);
    return error;
}

}  // namespace crevice
