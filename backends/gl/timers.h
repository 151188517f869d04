// SPDX-License-Identifier: MIT
// The GPU's time by query objects: GL_EXT_disjoint_timer_query on OpenGL ES, timer queries on
// desktop OpenGL.
#pragma once

#include "backends/gl/caps.h"
#include "backends/gl/objects.h"

#include <bitset>

namespace crevice {

/// Measures into slots as Device::beginTimer, endTimer and readTimer have it.
class GlTimers {
public:
    /// No timers: `begin` always refuses.
    GlTimers() = default;

    /// Has timers where the context does; `settleOptional` must have found their functions. Do not
    /// make any on a software renderer: llvmpipe (Mesa 22.3.6) has the extension and counts next to
    /// nothing, 1.1 ms for a pass of 240 ms.
    static GlTimers make(const GlApi& gl, const GlInfo& info);

    /// Nothing is measured in a frame within a timer query of the host.
    void beginFrame(const GlApi& gl);

    bool begin(const GlApi& gl, int slot);
    void end(const GlApi& gl) const
    {
        if (!host_measures_) gl.EndQuery(GL_TIME_ELAPSED_EXT);
    }
    bool isReady(const GlApi& gl, int slot) const;
    double read(const GlApi& gl, int slot);
    bool exist() const { return !queries_.empty(); }

private:
    void voidIfDisturbed(const GlApi& gl);

    std::vector<GlQuery> queries_;      // by slot; empty where there are no timers
    bool host_measures_ = false;        // this frame
    bool tells_disjoint_ = false;       // desktop OpenGL does not
    std::bitset<kMaxTimers> measured_;  // and nothing disturbed the GPU since
};

}  // namespace crevice
