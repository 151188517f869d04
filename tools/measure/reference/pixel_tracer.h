// SPDX-License-Identifier: MIT
// The rays of one pixel: the one that finds its surface, and those that probe what is open there.
#pragma once

#include "tools/measure/reference/tracer.h"

#include <atomic>
#include <thread>

namespace crevice {

/// Errors: CV4001 for options outside their ranges, CV4005 for an empty extent, CV6011 for a
/// projection that has no inverse.
Status checkTrace(const Camera& camera, Extent extent, const TraceOptions& options);

/// CV7008: what a trace of a camera that sees no surface ends with.
Diagnostic nothingSeen();

/// A Hammersley point on the unit disc; the hemisphere's direction lies above it (Malley).
struct Probe {
    float radius_squared;  ///< Before its rotation.
    float cosine, sine;    ///< Of the angle.
};

/// Directions over a surface that probe what is open: an even share of the cosine-weighted
/// hemisphere each, in passes that are spread as evenly by themselves.
struct ProbePasses {
    std::vector<Probe> probes;
    std::vector<int> begins;  ///< Of each pass in `probes`, and then their number.
};

/// Where the probes of a pixel begin.
struct ProbedPoint {
    glm::dvec3 origin;    ///< Relative to RayScene::center().
    glm::vec3 geometric;  ///< The triangle's normal.
    glm::vec3 normal;     ///< What the probes are spread about.
};

/// Probes over a surface's plane, and how many of them are open.
struct ProbeCount {
    int open = 0;
    int over = 0;
};

/// Requires what checkTrace() checks. The scene must outlive it. Safe to use from any number of
/// threads.
class PixelTracer {
public:
    PixelTracer(const RayScene& scene, const Camera& camera, Extent extent,
                const TraceOptions& options, int passes);

    /// What the centre of a pixel sees; false for the background.
    bool surface(int x, int y, TraceHit& hit) const;

    /// The same for its probes.
    bool probed(int x, int y, ProbedPoint& point) const;

    /// Probes of a pass at the pixel's surface. About a normal that leans from the surface's plane
    /// some lie below that, where no light comes from in any case: they do not count.
    ProbeCount countOpen(const ProbedPoint& point, int x, int y, int pass) const;

    int passes() const { return static_cast<int>(passes_.begins.size()) - 1; }
    int probes(int pass) const { return passes_.begins[pass + 1] - passes_.begins[pass]; }
    Extent extent() const { return extent_; }

private:
    double depthOrder(const glm::dvec4& view) const;
    TraceRay primaryRay(int x, int y) const;

    const RayScene& scene_;
    const glm::dmat4 view_from_clip_;
    const glm::dmat4 world_from_view_;
    const bool orthographic_;
    const Extent extent_;
    const double radius_;
    const ProbePasses passes_;
};

/// Most passes that are useful: each then has an even share of the probes.
constexpr int kMaxTracePasses = 64;

/// The picture in passes, row by row: what has been traced can be looked at any time.
///
/// No threads are made here: rows may be traced on any number of them, each row on one at a time.
/// After all passes of all rows the picture is that of traceAmbientOcclusion() with the same
/// RayScene, bit by bit.
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

/// Calls `work(item)` for each item of [0, count), dealt out one by one to `threads` threads, this
/// one among them; 0 takes one a processor. Returns when all is done. In the browser, where
/// threads cannot be had, this one does it all.
template <class Work>
void onProcessors(int threads, int count, const Work& work)
{
    std::atomic<int> next = 0;
    const auto take = [&] {
        for (int item = next++; item < count; item = next++) work(item);
    };
#ifdef __EMSCRIPTEN__
    threads = 1;
#endif
    const unsigned all = threads > 0 ? threads : std::thread::hardware_concurrency();
    std::vector<std::thread> helpers;
    for (unsigned k = 1; k < all; ++k) helpers.emplace_back(take);
    take();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace crevice
