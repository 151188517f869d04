// SPDX-License-Identifier: MIT
// OSMesa: desktop OpenGL on the CPU, without display or driver. Newer Mesa has dropped it, so it is
// optional, and osmesa_missing.cpp takes this file's place where its header is not found.
#include <crevice/context.h>

#include "backends/context/dynamic_library.h"
#include "backends/gl/failure.h"

#include <GL/osmesa.h>

#include <array>

namespace crevice {

namespace {

#define CREVICE_OSMESA_FUNCTIONS(X) \
    X(CreateContextAttribs) \
    X(DestroyContext) \
    X(GetProcAddress) \
    X(MakeCurrent)

struct OsmesaApi {
#define CREVICE_OSMESA_MEMBER(name) decltype(&OSMesa##name) name = nullptr;
    CREVICE_OSMESA_FUNCTIONS(CREVICE_OSMESA_MEMBER)
#undef CREVICE_OSMESA_MEMBER
};

const char* const kOsmesaHelp =
    "OSMesa is in Debian's package libosmesa6; the backend 'egl' needs none";

Result<OsmesaApi> loadOsmesa()
{
    Result<void*> library = openLibrary({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"},
                                        Code::no_osmesa, kOsmesaHelp);
    if (!library) return library.diagnostics();
    OsmesaApi api;
#define CREVICE_OSMESA_LOAD(name) \
    api.name = reinterpret_cast<decltype(api.name)>(findSymbol(*library, "OSMesa" #name)); \
    if (!api.name) \
        return failure(Code::no_osmesa, "the OSMesa library has no function OSMesa" #name, \
                       kOsmesaHelp);
    CREVICE_OSMESA_FUNCTIONS(CREVICE_OSMESA_LOAD)
#undef CREVICE_OSMESA_LOAD
    return api;
}

class OsmesaContext final : public Context {
public:
    OsmesaContext(const OsmesaApi& api, OSMesaContext handle) : api_(api), handle_(handle) {}

    ~OsmesaContext() override
    {
        releaseIfCurrent();
        api_.DestroyContext(handle_);
    }

    GlLoader loader() const override
    {
        auto find = api_.GetProcAddress;
        return [find](const char* name) { return reinterpret_cast<void*>(find(name)); };
    }

    void describe() { Context::describe("OSMesa"); }

private:
    Status bind() override
    {
        if (api_.MakeCurrent(handle_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1)) return {};
        return failure(Code::no_osmesa, "OSMesaMakeCurrent failed", kOsmesaHelp);
    }

    void release() override { api_.MakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

    const OsmesaApi& api_;
    OSMesaContext handle_;
    std::array<unsigned char, 4> buffer_ = {};  // one RGBA pixel: OSMesa wants a framebuffer
};

OSMesaContext createCore(const OsmesaApi& api)
{
    const int versions[][2] = {{4, 5}, {4, 3}, {4, 1}, {3, 3}};
    for (const auto& version : versions) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  version[0],
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  version[1],
                                  0};
        if (OSMesaContext handle = api.CreateContextAttribs(attributes, nullptr)) return handle;
    }
    return nullptr;
}

}  // namespace

Result<std::unique_ptr<Context>> makeOsmesaContext()
{
    static const Result<OsmesaApi> api = loadOsmesa();
    if (!api) return api.diagnostics();
    OSMesaContext handle = createCore(*api);
    if (!handle)
        return failure(Code::no_osmesa, "OSMesa gives no OpenGL 3.3 core context", kOsmesaHelp);
    auto context = std::make_unique<OsmesaContext>(*api, handle);
    if (Status status = context->makeCurrent(); !status) return status.diagnostics();
    context->describe();
    return std::unique_ptr<Context>(std::move(context));
}

}  // namespace crevice
