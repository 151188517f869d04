// SPDX-License-Identifier: MIT
// The GPU's time by query objects: GL_EXT_disjoint_timer_query on OpenGL ES,
// EXT_disjoint_timer_query_webgl2 in WebGL 2, timer queries on desktop OpenGL.
#pragma once

#include "backends/gl/caps.h"
#include "backends/gl/objects.h"

namespace crevice {

/// What a timer of the device consists of.
struct GlTimer {
    GlQuery query = {};  ///< Made when it is first to measure.
    int measured = 0;    ///< After so many disturbances, from 1; 0 when it holds nothing.
};

/// Measures as Device::beginTimer, endTimer and readTimer have it.
class GlTimers {
public:
    /// No timers: nothing may measure.
    GlTimers() = default;

    /// Has timers where the context does; `settleOptional` must have found their functions. Do not
    /// make any on a software renderer: llvmpipe (Mesa 22.3.6) has the extension and counts next to
    /// nothing, 1.1 ms for a pass of 240 ms.
    static GlTimers make(const GlApi& gl, const GlInfo& info);

    /// Nothing is measured in a frame within a timer query of the host.
    void beginFrame(const GlApi& gl);

    void begin(const GlApi& gl, GlTimer& timer);
    void end(const GlApi& gl) const
    {
        if (!host_measures_) gl.EndQuery(GL_TIME_ELAPSED_EXT);
    }
    bool isReady(const GlApi& gl, const GlTimer& timer) const;
    double read(const GlApi& gl, const GlTimer& timer);
    bool exist() const { return exist_; }

private:
    void voidIfDisturbed(const GlApi& gl);

    bool exist_ = false;
    bool waits_ = true;            // for results; WebGL does not
    bool host_measures_ = false;   // this frame
    bool tells_disjoint_ = false;  // desktop OpenGL does not
    int disturbances_ = 1;         // known of, counted from 1
    bool measures_ = false;        // has measured since the last of them
};

}  // namespace crevice
