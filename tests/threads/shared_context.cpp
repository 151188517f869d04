// SPDX-License-Identifier: MIT
#include "tests/threads/shared_context.h"

#include <dlfcn.h>

namespace crevice {

namespace {

/// Displays, configs and contexts: no header of EGL or OSMesa is needed, which may be missing.
using Handle = void*;

/// A function of a library that is loaded already.
template <class Function>
Function* find(const char* library, const char* name)
{
    void* handle = dlopen(library, RTLD_LAZY);
    return handle ? reinterpret_cast<Function*>(dlsym(handle, name)) : nullptr;
}

template <class Function>
Function* egl(const char* name)
{
    return find<Function>("libEGL.so.1", name);
}

template <class Function>
Function* osmesa(const char* name)
{
    return find<Function>("libOSMesa.so.8", name);
}

class SharedEgl final : public SharedContext {
public:
    SharedEgl() : display_(egl<Handle()>("eglGetCurrentDisplay")())
    {
        constexpr int kNone = 0x3038, kConfigId = 0x3028, kMajorVersion = 0x3098;
        const Handle other = egl<Handle()>("eglGetCurrentContext")();
        int config_id = 0, count = 0;
        egl<unsigned(Handle, Handle, int, int*)>("eglQueryContext")(display_, other, kConfigId,
                                                                    &config_id);
        const int wanted[] = {kConfigId, config_id, kNone};
        Handle config = nullptr;
        egl<unsigned(Handle, const int*, Handle*, int, int*)>("eglChooseConfig")(
            display_, wanted, &config, 1, &count);
        const int attributes[] = {kMajorVersion, 3, kNone};
        handle_ = egl<Handle(Handle, Handle, Handle, const int*)>("eglCreateContext")(
            display_, config, other, attributes);
    }
    ~SharedEgl() override { egl<unsigned(Handle, Handle)>("eglDestroyContext")(display_, handle_); }

    bool there() const { return handle_ != nullptr; }
    bool makeCurrent() override
    {
        const auto call = egl<unsigned(Handle, Handle, Handle, Handle)>("eglMakeCurrent");
        return call(display_, nullptr, nullptr, handle_) == 1;
    }

private:
    Handle display_;
    Handle handle_ = nullptr;
};

class SharedOsmesa final : public SharedContext {
public:
    SharedOsmesa()
    {
        constexpr int kFormat = 0x22, kRgba = 0x1908, kProfile = 0x33, kCore = 0x34;
        constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37;
        const int attributes[] = {kFormat, kRgba,         kProfile, kCore, kMajorVersion,
                                  4,       kMinorVersion, 5,        0};
        const Handle other = osmesa<Handle()>("OSMesaGetCurrentContext")();
        handle_ =
            osmesa<Handle(const int*, Handle)>("OSMesaCreateContextAttribs")(attributes, other);
    }
    ~SharedOsmesa() override { osmesa<void(Handle)>("OSMesaDestroyContext")(handle_); }

    bool there() const { return handle_ != nullptr; }
    bool makeCurrent() override
    {
        constexpr unsigned kUnsignedByte = 0x1401;
        const auto call =
            osmesa<unsigned char(Handle, void*, unsigned, int, int)>("OSMesaMakeCurrent");
        return call(handle_, pixel_, kUnsignedByte, 1, 1) == 1;
    }

private:
    Handle handle_ = nullptr;
    unsigned char pixel_[4] = {};  // OSMesa wants a framebuffer
};

template <class Kind>
std::unique_ptr<SharedContext> made()
{
    auto context = std::make_unique<Kind>();
    return context->there() ? std::unique_ptr<SharedContext>(std::move(context)) : nullptr;
}

}  // namespace

std::unique_ptr<SharedContext> SharedContext::make(const std::string& backend)
{
    if (backend == "osmesa") return made<SharedOsmesa>();
    return backend == "egl" ? made<SharedEgl>() : nullptr;
}

}  // namespace crevice
