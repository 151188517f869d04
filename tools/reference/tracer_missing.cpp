// SPDX-License-Identifier: MIT
// Stands in for the ray tracer where Embree was not found.
#include "tools/reference/tracer.h"

namespace crevice {

namespace {

Diagnostic noTracer()
{
    Diagnostic error = {Code::no_backend, "this build has no ray tracer: Embree 3 was not found"};
    error.help = "install it with 'apt-get install libembree-dev' and run cmake again";
    return error;
}

}  // namespace

Result<Image> traceAmbientOcclusion(const Scene&, const Camera&, Extent, const TraceOptions&)
{
    return noTracer();
}

Result<SurfaceMap> traceSurfaces(const Scene&, const Camera&, Extent) { return noTracer(); }

bool canTrace() { return false; }

}  // namespace crevice
