// SPDX-License-Identifier: MIT
// Open probes, counted pass by pass.
#include "tools/measure/reference/progressive_trace.h"

#include <limits>

namespace crevice {

namespace {

constexpr int kLeastPassRays = 8;  // of a TraceBatch

int passesFor(int rays, int max_passes)
{
    int passes = 1;
    while (passes * 2 <= max_passes && passes * 2 * kLeastPassRays <= rays) passes *= 2;
    return passes;
}

}  // namespace

Result<ProgressiveTrace> ProgressiveTrace::begin(const RayScene& scene, const Camera& camera,
                                                 Extent extent, const TraceOptions& options,
                                                 int max_passes)
{
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    return ProgressiveTrace(
        PixelTracer(scene, camera, extent, options, passesFor(options.rays, max_passes)));
}

ProgressiveTrace::ProgressiveTrace(const PixelTracer& tracer)
    : tracer_(tracer),
      rows_(static_cast<std::size_t>(tracer.extent().height))
{
}

void ProgressiveTrace::findSurfaces(Row& row, int y) const
{
    const auto width = static_cast<std::size_t>(extent().width);
    row.counts.assign(width, {});
    row.points.resize(width);
    for (int x = 0; x < extent().width; ++x)
        if (!tracer_.probed(x, y, row.points[x])) row.counts[x].open = -1;
}

void ProgressiveTrace::traceRow(int pass, int y)
{
    Row& row = rows_[y];
    if (row.passes == 0) findSurfaces(row, y);
    for (int x = 0; x < extent().width; ++x) {
        ProbeCount& count = row.counts[x];
        if (count.open < 0) continue;
        const ProbeCount more = tracer_.countOpen(row.points[x], x, y, pass);
        count.open += more.open;
        count.over += more.over;
    }
    if (++row.passes == passes()) row.points = {};
}

void ProgressiveTrace::readRow(int y, float* visibility) const
{
    const Row& row = rows_[y];
    for (int x = 0; x < extent().width; ++x) {
        const ProbeCount count = row.passes > 0 ? row.counts[x] : ProbeCount{-1, 0};
        const bool seen = count.open >= 0;
        const float open = count.over > 0 ? float(count.open) / float(count.over) : 1.0f;
        visibility[x] = seen ? open : std::numeric_limits<float>::quiet_NaN();
    }
}

Image ProgressiveTrace::image() const
{
    Image image(extent(), 1);
    for (int y = 0; y < extent().height; ++y) readRow(y, &image.at(0, y));
    return image;
}

}  // namespace crevice
