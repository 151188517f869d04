// SPDX-License-Identifier: MIT
// What the host has an output drawn into.
#pragma once

#include "backends/gl/objects.h"

#include <crevice/device.h>

namespace crevice {

/// Errors: CV6011 for a rectangle without pixels, or with some that no framebuffer has.
Status checkRectangle(const HostFramebuffer& host);

/// Binds the host's framebuffer for drawing, or its texture, which then is attached to what is
/// returned.
GlFramebuffer bindHostTarget(const GlApi& gl, const HostFramebuffer& host);

/// Of what is bound so. Errors: CV6005 for what GL does not draw into; CV6011 where it ends before
/// the rectangle does, and GL says so: not of the default framebuffer.
Status checkHostTarget(const GlApi& gl, const HostFramebuffer& host);

}  // namespace crevice
