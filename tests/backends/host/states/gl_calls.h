// SPDX-License-Identifier: MIT
// What tests call of GL by name: functions that the library has no need of.
#pragma once

#include "backends/gl/api.h"

#include <array>

namespace crevice {

/// Room for whatever a name may give: lists of formats are long.
using Numbers = std::array<GLint, 4096>;

class GlCalls {
public:
    explicit GlCalls(GlLoader load) : load_(std::move(load)) {}

    /// Calls the function with arguments of exactly its types, or does nothing where there is none.
    /// A context that lacks it raises an error, which `quiet` takes.
    template <class... Args>
    void operator()(const char* name, Args... args) const
    {
        const auto [entry, fresh] = found_.emplace(name, nullptr);
        if (fresh) entry->second = load_(name);
        if (entry->second) reinterpret_cast<void(GL_APIENTRYP)(Args...)>(entry->second)(args...);
    }

private:
    GlLoader load_;
    mutable std::map<std::string, void*, std::less<>> found_;
};

/// Takes all pending errors and returns the first.
inline GLenum quiet(const GlApi& gl)
{
    const GLenum first = gl.GetError();
    for (GLenum error = first; error != GL_NO_ERROR; error = gl.GetError()) {
    }
    return first;
}

/// What changes by itself: the time, free memory, whether the GPU was disturbed, and the log of
/// errors, which asking fills. And two that crash Mesa 22.3.6 on llvmpipe: identifiers of the
/// device, and GL_CURRENT_MATRIX_ARB where the unit has none.
inline bool neverAsked(GLenum name)
{
    const bool memory = (name >= 0x9047 && name <= 0x904B) || (name >= 0x87FB && name <= 0x87FD);
    const bool device = name >= 0x9597 && name <= 0x959A;
    const bool matrix = name == 0x8641 || name == 0x88B7;
    const bool log = name == GL_DEBUG_LOGGED_MESSAGES || name == 0x8243;
    return memory || device || matrix || log || name == GL_TIMESTAMP_EXT ||
           name == GL_GPU_DISJOINT_EXT;
}

/// GL's names that `call` takes without an error. Whatever a context knows is found, without a list
/// that could miss a piece of state.
template <class Call>
std::vector<GLenum> acceptedNames(const GlApi& gl, Call call)
{
    constexpr GLenum kLast = 0x9FFF;
    std::vector<GLenum> names;
    quiet(gl);
    for (GLenum name = 1; name <= kLast; ++name) {
        if (neverAsked(name)) continue;
        call(name);
        if (quiet(gl) == GL_NO_ERROR) names.push_back(name);
    }
    return names;
}

}  // namespace crevice
