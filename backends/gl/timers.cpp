// SPDX-License-Identifier: MIT
#include "backends/gl/timers.h"

#include <utility>

namespace crevice {

GlTimers GlTimers::make(const GlApi& gl, const GlInfo& info)
{
    GlTimers timers;
    if (!gl.GetQueryObjectui64v) return timers;
    GLint bits = 0;  // 0 where a driver has the functions and no clock behind them
    gl.GetQueryiv(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    if (bits == 0) return timers;
    timers.tells_disjoint_ = !info.desktop;
    for (int i = 0; i < kMaxTimers; ++i) timers.queries_.push_back(GlQuery::make(gl));
    return timers;
}

void GlTimers::beginFrame(const GlApi& gl)
{
    if (queries_.empty()) return;
    GLint query = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED_EXT, GL_CURRENT_QUERY, &query);
    host_measures_ = query != 0;
}

bool GlTimers::begin(const GlApi& gl, int slot)
{
    if (queries_.empty()) return false;
    if (std::exchange(read_, false)) {
        (void)takeDisjoint(gl);  // what happened before does not matter
        disturbed_ = false;
        measured_.reset();
    }
    if (host_measures_) return true;  // and the slot stays void
    measured_[slot] = true;
    gl.BeginQuery(GL_TIME_ELAPSED_EXT, queries_[slot].name());
    return true;
}

double GlTimers::read(const GlApi& gl, int slot)
{
    read_ = true;
    if (!measured_[slot]) return -1;
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64v(queries_[slot].name(), GL_QUERY_RESULT, &nanoseconds);
    disturbed_ = takeDisjoint(gl) || disturbed_;
    return disturbed_ ? -1 : static_cast<double>(nanoseconds) * 1e-6;
}

/// Whether the GPU was disturbed since the last call; asking forgets it.
bool GlTimers::takeDisjoint(const GlApi& gl) const
{
    GLint disjoint = 0;
    if (tells_disjoint_) gl.GetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
    return disjoint != 0;
}

}  // namespace crevice
