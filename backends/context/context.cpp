// SPDX-License-Identifier: MIT
#include <crevice/context.h>

#include "backends/context/dynamic_library.h"
#include "backends/gl/api.h"
#include "backends/gl/failure.h"

#include <dlfcn.h>

namespace crevice {

namespace {

thread_local Context* current_context = nullptr;

}  // namespace

Status Context::makeCurrent()
{
    if (current_context != this) {
        if (current_context) current_context->release();
        current_context = nullptr;
    }
    Status status = bind();
    if (status) current_context = this;
    return status;
}

void Context::releaseIfCurrent()
{
    if (current_context != this) return;
    release();
    current_context = nullptr;
}

void Context::describe(const std::string& way)
{
    description_ = way;
    auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(loader()("glGetString"));
    if (!get_string) return;
    for (GLenum name : {GL_RENDERER, GL_VERSION})
        if (const GLubyte* text = get_string(name))
            description_ += std::string(", ") + reinterpret_cast<const char*>(text);
}

Result<std::unique_ptr<Context>> makeContext(std::string_view backend)
{
    if (backend == "egl") return makeEglContext();
    if (backend == "osmesa") return makeOsmesaContext();
    return failure(Code::no_backend, "there is no backend '" + std::string(backend) + "'",
                   suggestName(backend, {"egl", "osmesa"}, "backends"));
}

Result<void*> openLibrary(const std::vector<std::string>& names, Code code, const std::string& help)
{
    assert(!names.empty());
    Diagnostic error = failure(code, "the library " + names.front() + " cannot be opened", help);
    for (const std::string& name : names) {
        // RTLD_LOCAL: OSMesa and GLES export the same names and must not see each other's.
        if (void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
        const char* reason = dlerror();
        error.notes.push_back({{}, reason ? reason : name});
    }
    return error;
}

void* findSymbol(void* library, const char* name) { return dlsym(library, name); }

}  // namespace crevice
