// SPDX-License-Identifier: MIT
#include "backends/context/dynamic_library.h"

#include "backends/gl/failure.h"

#include <dlfcn.h>

namespace crevice {

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
