// SPDX-License-Identifier: MIT
// GL errors that the host left pending: set aside while the device looks for its own, and raised
// again after, so that the host's next glGetError finds them.
#pragma once

#include "backends/gl/api.h"

namespace crevice {

class HostErrors {
public:
    /// Takes what is pending. Abandons the table of a context that is lost.
    void take(GlApi& gl);

    /// Makes calls that do nothing but raise the same errors. GL_OUT_OF_MEMORY cannot be raised so:
    /// `takeMemoryWarning` has it.
    void raise(const GlApi& gl);

    /// A warning CV6009 where the host had left GL_OUT_OF_MEMORY; forgets it.
    Diagnostics takeMemoryWarning();

private:
    bool enum_ = false;
    bool value_ = false;
    bool operation_ = false;
    bool framebuffer_ = false;
    bool memory_ = false;
};

}  // namespace crevice
