// SPDX-License-Identifier: MIT
// Contexts and devices, and the version.
#include <crevice/context.h>

#include "effects/api/c/handles.h"

using namespace crevice;

static_assert(CREVICE_VERSION == CREVICE_PROJECT_VERSION,
              "the version of <crevice/crevice.h> is not that of the project");

struct crevice_context {
    std::unique_ptr<Context> context;
    GlLoader loader;
};

namespace {

Result<std::unique_ptr<Context>> openContext(const char* backend)
{
    if (backend) return makeContext(backend);
    auto egl = makeEglContext();
    return egl ? std::move(egl) : makeOsmesaContext();
}

ProgramCache cacheOf(const crevice_device_desc& desc)
{
    ProgramCache cache;
    if (desc.cache_load)
        cache.load = [load = desc.cache_load, user = desc.cache_user](const std::string& key) {
            std::size_t count = 0;
            const auto* bytes = static_cast<const std::uint8_t*>(load(key.c_str(), &count, user));
            return bytes ? std::vector<std::uint8_t>(bytes, bytes + count)
                         : std::vector<std::uint8_t>();
        };
    if (desc.cache_store)
        cache.store = [store = desc.cache_store, user = desc.cache_user](
                          const std::string& key, const std::vector<std::uint8_t>& bytes) {
            store(key.c_str(), bytes.data(), bytes.size(), user);
        };
    return cache;
}

Result<std::unique_ptr<Device>> makeDevice(const crevice_device_desc& desc)
{
    GlDeviceOptions options;
    options.restore_state = !desc.leave_state;
    options.check_errors = !desc.skip_checks;
    options.ignore_extensions = desc.ignore_extensions;
    options.program_cache = cacheOf(desc);
    const auto find = [loader = desc.loader, user = desc.user](const char* name) {
        return loader(name, user);
    };
    return makeGlDevice(find, options);
}

}  // namespace

int crevice_version(void) { return CREVICE_VERSION; }

crevice_error* crevice_context_create(const char* backend, crevice_context** context)
{
    if (context) *context = nullptr;
    return guarded([&]() -> Status {
        if (Status given = checkGiven(context, "the place for the context"); !given) return given;
        auto made = openContext(backend);
        if (!made) return made.diagnostics();
        GlLoader loader = (*made)->loader();
        *context = new crevice_context{std::move(*made), std::move(loader)};
        return {};
    });
}

crevice_error* crevice_context_make_current(crevice_context* context)
{
    return guarded([&]() -> Status {
        const Status given = checkGiven(context, "the context");
        return given ? context->context->makeCurrent() : given;
    });
}

void* crevice_context_find(const char* name, void* context)
{
    return name && context ? static_cast<crevice_context*>(context)->loader(name) : nullptr;
}

void crevice_context_destroy(crevice_context* context) { delete context; }

crevice_error* crevice_device_create(const crevice_device_desc* desc, crevice_device** device)
{
    if (device) *device = nullptr;
    return guarded([&]() -> Status {
        crevice_device_desc own = {};
        Status given = firstOf(take(desc, "crevice_device_desc", own),
                               checkGiven(device, "the place for the device"));
        if (given) given = checkGiven(reinterpret_cast<const void*>(own.loader), "the loader");
        if (!given) return given;
        auto made = makeDevice(own);
        if (!made) return made.diagnostics();
        *device = new crevice_device{std::move(*made)};
        return {};
    });
}

crevice_error* crevice_device_get_info(const crevice_device* device, crevice_device_info* info)
{
    return guarded([&]() -> Status {
        const Status given =
            firstOf(checkGiven(device, "the device"), check(info, "crevice_device_info"));
        if (!given) return given;
        const DeviceCaps& caps = device->device->caps();
        crevice_device_info own = {};
        own.name = caps.name.c_str();
        own.version = caps.version;
        own.software = caps.software;
        own.max_texture_size = caps.max_texture_size;
        give(own, info);
        return {};
    });
}

void crevice_device_abandon(crevice_device* device)
{
    if (device) abandonGlDevice(*device->device);
}

void crevice_device_destroy(crevice_device* device) { delete device; }
