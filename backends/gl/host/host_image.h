// SPDX-License-Identifier: MIT
// What a framebuffer of the host's has attached: what numbers that holds, and how large it is.
//
// Sources
//   OpenGL ES 3.0.6, section 6.1.13 - what a framebuffer's attachment holds.
#pragma once

#include "backends/gl/api.h"

#include <crevice/device.h>

namespace crevice {

/// What an image holds: bits of red, green, blue, alpha and depth, and what kind of numbers.
struct GlHeld {
    GLint bits[5] = {};
    GLint stencil = 0;
    GLint type = GL_NONE;
    bool srgb = false;

    /// Whether it can be taken for that format: drivers may hold more bits than were asked for.
    bool fits(Format format) const;

    /// What depth it is.
    Format depthFormat() const;
    bool empty() const;
};

/// What is attached at `point` of the framebuffer that is bound to `target`; a type of GL_NONE
/// where there is nothing.
GlHeld readHeld(const GlApi& gl, GLenum target, GLenum point);

std::string textOf(const GlHeld& held);

constexpr int kLastPixel = 0x7ffffffe;

/// Whether a picture's pixels lie within [0, kLastPixel], so that where it ends is an int.
bool isCountable(int x, int y, Extent extent);

/// "640x480".
std::string sizeText(Extent extent);

/// How large what is attached there is; 0x0 where GL does not tell: of the default framebuffer, and
/// on OpenGL ES 3.0 of textures. Binds another renderbuffer.
Extent askSize(const GlApi& gl, GLenum target, GLenum point);

}  // namespace crevice
