// SPDX-License-Identifier: MIT
// Texels that come back without a wait: the GPU copies one into a buffer, and a fence says when.
#pragma once

#include "backends/gl/copy.h"

#include <array>
#include <memory>

namespace crevice {

struct GlSyncDelete {
    const GlApi* gl = nullptr;
    void operator()(GLsync sync) const { gl->DeleteSync(sync); }
};
using GlFence = std::unique_ptr<std::remove_pointer_t<GLsync>, GlSyncDelete>;

/// Of one texture: at most one read at a time.
struct GlRead {
    GlBuffer buffer;  ///< Nothing before the first.
    GlFence done;     ///< Null while nothing is read.
};

/// Reads as Device::beginRead and takeRead have it.
class GlReads {
public:
    /// `nearest` is a sampler without a filter. Errors: CV6005, CV6009, CV6016.
    Status begin(GlApi& gl, GlState& state, const GlCopier& copier, GlRead& read, GLuint texture,
                 GLuint nearest);

    /// Requires the state that a frame has.
    static std::optional<std::array<float, 4>> take(const GlApi& gl, GlRead& read);

private:
    void make(const GlApi& gl, GlState& state, GlRead& read);

    GlTexture bits_;             // one texel ...
    GlFramebuffer framebuffer_;  // ... to draw into
};

}  // namespace crevice
