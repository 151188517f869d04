// SPDX-License-Identifier: MIT
// Linked programs that the host keeps between runs: <crevice/gl_device.h> says how it does.
//
// Sources
//   OpenGL ES 3.0.6, section 2.12.5 - program binaries.
//   GL_ARB_get_program_binary - the same for desktop OpenGL before 4.1.
#pragma once

#include <crevice/gl_device.h>

#include "backends/gl/objects.h"
#include "core/base/content_hash.h"

#include <string>
#include <vector>

namespace crevice {

class GlProgramCache {
public:
    /// Keeps nothing.
    GlProgramCache() = default;

    /// Reads who the driver is and which formats its binaries have. Keeps nothing where it has
    /// none.
    GlProgramCache(const GlApi& gl, ProgramCache host);

    /// What the host knows a program by: a hash over the driver and both stages' text, which says
    /// where attributes and outputs lie. Empty when nothing is kept.
    std::string key(const ProgramDesc& desc) const;

    /// A linked program out of what the host kept; its name is 0 when there is none, or none that
    /// this driver takes. Leaves no GL error.
    GlProgram load(GlApi& gl, const std::string& key) const;

    /// To be called before a program is linked that is to be stored.
    void announce(const GlApi& gl, GLuint program) const;

    /// Hands a linked program to the host. Leaves no GL error.
    void store(GlApi& gl, const std::string& key, GLuint program) const;

private:
    bool loads() const { return !formats_.empty() && host_.load; }
    bool stores() const { return !formats_.empty() && host_.store; }

    ProgramCache host_;
    std::vector<GLint> formats_;  // that the driver takes; none keeps nothing
    ContentHash driver_;
};

}  // namespace crevice
