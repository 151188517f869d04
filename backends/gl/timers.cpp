// SPDX-License-Identifier: MIT
#include "backends/gl/timers.h"

namespace crevice {

GlTimers GlTimers::make(const GlApi& gl, const GlInfo& info)
{
    GlTimers timers;
    if (!gl.GetQueryObjectui64v) return timers;
    GLint bits = 0;  // 0 where a driver has the functions and no clock behind them
    gl.GetQueryiv(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    if (bits == 0) return timers;
    timers.exist_ = true;
    timers.waits_ = !info.web;
    timers.tells_disjoint_ = !info.desktop;
    return timers;
}

void GlTimers::beginFrame(const GlApi& gl)
{
    if (!exist_) return;
    GLint query = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED_EXT, GL_CURRENT_QUERY, &query);
    host_measures_ = query != 0;
}

void GlTimers::begin(const GlApi& gl, GlTimer& timer)
{
    if (timer.query.name() == 0) timer.query = GlQuery::make(gl);
    timer.measured = 0;
    if (host_measures_) return;           // and the timer stays void
    if (!measures_) voidIfDisturbed(gl);  // what happened before the first does not matter
    measures_ = true;
    timer.measured = disturbances_;
    gl.BeginQuery(GL_TIME_ELAPSED_EXT, timer.query.name());
}

bool GlTimers::isReady(const GlApi& gl, const GlTimer& timer) const
{
    if (timer.measured != disturbances_) return true;
    GLuint ready = GL_FALSE;
    gl.GetQueryObjectuiv(timer.query.name(), GL_QUERY_RESULT_AVAILABLE, &ready);
    return ready != GL_FALSE;
}

double GlTimers::read(const GlApi& gl, const GlTimer& timer)
{
    if (timer.measured != disturbances_ || (!waits_ && !isReady(gl, timer))) return -1;
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64v(timer.query.name(), GL_QUERY_RESULT, &nanoseconds);
    voidIfDisturbed(gl);
    return timer.measured == disturbances_ ? static_cast<double>(nanoseconds) * 1e-6 : -1;
}

/// Whatever is measured and unread may have run while the GPU was disturbed; asking forgets that.
void GlTimers::voidIfDisturbed(const GlApi& gl)
{
    GLint disjoint = 0;
    if (tells_disjoint_) gl.GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    if (disjoint == 0) return;
    ++disturbances_;
    measures_ = false;
}

}  // namespace crevice
