// SPDX-License-Identifier: MIT
// Texels that come back without a wait: the GPU copies one into a buffer, and a fence says when.
#pragma once

#include "backends/gl/copy.h"

#include <array>

namespace crevice {

/// Reads into slots as Device::beginRead and takeRead have it.
class GlReads {
public:
    GlReads() = default;
    GlReads(const GlReads&) = delete;
    GlReads& operator=(const GlReads&) = delete;
    ~GlReads() { forget(); }

    /// `nearest` is a sampler without a filter. Errors: CV6005, CV6009, CV6016.
    Status begin(GlApi& gl, GlState& state, const GlCopier& copier, int slot, GLuint texture,
                 GLuint nearest);

    /// Changes a buffer's binding and puts it back.
    std::optional<std::array<float, 4>> take(const GlApi& gl, int slot);

private:
    struct Slot {
        GlBuffer buffer;
        GLsync done = nullptr;  // null while nothing is read
    };

    void make(GlApi& gl, GlState& state, Slot& slot);
    void forget();

    const GlApi* gl_ = nullptr;  // null before the first read
    GlTexture bits_;             // one texel ...
    GlFramebuffer framebuffer_;  // ... to draw into
    Slot slots_[kMaxReads];
};

}  // namespace crevice
