// SPDX-License-Identifier: MIT
// Sets the values of a context, all but its switches and bindings, to what GL allows.
#pragma once

#include "tests/backends/host/states/gl_calls.h"
#include "tests/backends/host/states/random.h"

namespace crevice {

class Settings {
public:
    /// Asks for the names of hints and of pixel storage.
    Settings(const GlApi& gl, const GlCalls& calls);

    void randomize(Random& random) const;

private:
    const GlApi& gl_;
    const GlCalls& calls_;
    std::vector<GLenum> hints_, pixel_stores_;
};

}  // namespace crevice
