// SPDX-License-Identifier: MIT
// The ray tracer's picture in passes, row by row: what has been traced can be looked at any time.
//
// No threads are made here: rows may be traced on any number of them, each row on one at a time.
// After all passes of all rows the picture is that of traceAmbientOcclusion() with the same
// RayScene, bit by bit.
#pragma once

#include "tools/measure/reference/pixel_tracer.h"

namespace crevice {

/// Most passes that are useful: each then has an even share of the probes.
constexpr int kMaxTracePasses = 64;

class ProgressiveTrace {
public:
    /// The scene must outlive it. There are at most `max_passes` passes, of at least 8 rays where
    /// that many are asked for. The memory of a row is taken when it is traced first: 52 bytes a
    /// pixel, and 4 of one pass alone.
    ///
    /// Errors: those of checkTrace().
    static Result<ProgressiveTrace> begin(const RayScene& scene, const Camera& camera,
                                          Extent extent, const TraceOptions& options,
                                          int max_passes = kMaxTracePasses);

    /// A power of two.
    int passes() const { return tracer_.passes(); }
    Extent extent() const { return tracer_.extent(); }

    /// Requires `pass` in [0, passes()), each once for a row. They may come in any order; in their
    /// own the picture is best after each. Rows are counted from the bottom up.
    void traceRow(int pass, int y);

    /// Visibilities of the row by the passes so far, extent().width of them: 1 open to 0 blocked;
    /// NaN where there is no surface and in a row that no pass has traced.
    void readRow(int y, float* visibility) const;

    /// All rows, one channel.
    Image image() const;

private:
    // -1 where there is no surface.
    struct Row {
        std::vector<ProbeCount> counts;   // open: -1 in the background
        std::vector<ProbedPoint> points;  // kept while there are passes to come
        int passes = 0;
    };

    ProgressiveTrace(const PixelTracer& tracer);

    void findSurfaces(Row& row, int y) const;

    PixelTracer tracer_;
    std::vector<Row> rows_;
};

}  // namespace crevice
