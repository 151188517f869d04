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

bool GlTimers::begin(const GlApi& gl, int slot)
{
    if (!exist_) return false;
    while (queries_.size() < kMaxTimers) queries_.push_back(GlQuery::make(gl));
    measured_[slot] = false;
    if (host_measures_) return true;            // and the slot stays void
    if (measured_.none()) voidIfDisturbed(gl);  // what happened before the first does not matter
    measured_[slot] = true;
    gl.BeginQuery(GL_TIME_ELAPSED_EXT, queries_[slot].name());
    return true;
}

bool GlTimers::isReady(const GlApi& gl, int slot) const
{
    if (!measured_[slot]) return true;
    GLuint ready = GL_FALSE;
    gl.GetQueryObjectuiv(queries_[slot].name(), GL_QUERY_RESULT_AVAILABLE, &ready);
    return ready != GL_FALSE;
}

double GlTimers::read(const GlApi& gl, int slot)
{
    if (!waits_ && !isReady(gl, slot)) measured_[slot] = false;
    if (!measured_[slot]) return -1;
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64v(queries_[slot].name(), GL_QUERY_RESULT, &nanoseconds);
    voidIfDisturbed(gl);
    return measured_[slot] ? static_cast<double>(nanoseconds) * 1e-6 : -1;
}

/// Whatever is measured and unread may have run while the GPU was disturbed; asking forgets that.
void GlTimers::voidIfDisturbed(const GlApi& gl)
{
    GLint disjoint = 0;
    if (tells_disjoint_) gl.GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    if (disjoint != 0) measured_.reset();
}

}  // namespace crevice
