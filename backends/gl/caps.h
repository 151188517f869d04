// SPDX-License-Identifier: MIT
// What the current context is and can do; read once, when a device is made.
#pragma once

#include <crevice/device.h>

#include "backends/gl/api.h"

#include <string>
#include <vector>

namespace crevice {

/// Texture units that are used at most; a context has more, over all stages.
constexpr int kMaxTextureUnits = 32;

struct GlInfo {
    bool desktop = false;
    bool web = false;                     ///< WebGL 2, as Emscripten shows it.
    bool bare = false;                    ///< Pretends to have no extensions.
    int native_version = 0;               ///< 320 for OpenGL ES 3.2, 450 for desktop OpenGL 4.5.
    int version = 0;                      ///< OpenGL ES version that it is, or is compatible with.
    std::vector<std::string> extensions;  ///< Sorted.

    bool has(const char* extension) const;
};

/// `ignore_extensions` pretends a bare OpenGL ES 3.0, whatever the context is.
///
/// Errors: CV6004 for anything that does not take OpenGL ES 3.0 shaders.
Result<GlInfo> readInfo(const GlApi& gl, bool ignore_extensions);

/// Nulls the optional functions that the context does not promise: loaders give pointers for those
/// too. Finds those that an extension brings by their names there.
void settleOptional(GlApi& gl, const GlInfo& info, const GlLoader& load);

/// Limits, and which formats can be rendered to: first by the rules, then by trying. Clobbers the
/// bindings of unit 0's texture and of the draw framebuffer.
DeviceCaps readCaps(GlApi& gl, const GlInfo& info);

/// True when a linear filter may be used on the format; else sampling it would give black.
bool canFilter(const GlInfo& info, Format format);

}  // namespace crevice
