// SPDX-License-Identifier: MIT
// What the host hands over to be read: whether it is what the host says, and copies of what no
// shader can read as it is.
//
// Sources
//   OpenGL ES 3.0.6, section 4.3.3 - copies of depth, between images of one format alone.
#pragma once

#include "backends/gl/objects.h"
#include "backends/gl/state.h"

namespace crevice {

/// Whether a host's texture that is read as it is has the kind, format and size that it is said to
/// have. Puts in the format where none is said. Clobbers unit 0 and the read framebuffer.
///
/// Errors: CV6011 with what it has instead, and the way out.
Status checkHostTexture(GlApi& gl, GlState& state, HostTexture& host);

/// A texture of the device's with what the host has elsewhere.
class GlHostCopy {
public:
    GlHostCopy() = default;

    /// Makes the texture and copies into it. Puts in the format where none is said. Clobbers unit 0
    /// and both framebuffers.
    ///
    /// Errors: CV6011 where there is nothing of that kind, format, layer or size; CV6005, CV6009.
    static Result<GlHostCopy> make(GlApi& gl, GlState& state, HostTexture& host);

    /// Copies again. Clobbers both framebuffers. Errors: CV6005, CV6011.
    Status update(GlApi& gl) const;

    /// Where nothing is copied, 0.
    GLuint texture() const { return texture_.name(); }

private:
    Status allocate(GlApi& gl, GlState& state, GLenum internal);

    HostTexture host_;
    GlFramebuffer from_;  // nothing where the host's own is read
    GlFramebuffer into_;
    GlTexture texture_;
};

}  // namespace crevice
