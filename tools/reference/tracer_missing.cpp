// SPDX-License-Identifier: MIT
// Stands in for the ray tracer where Embree was not found.
#include "tools/reference/tracer.h"

namespace crevice {

Result<Image> traceAmbientOcclusion(const Scene&, const Camera&, Extent, const TraceOptions&)
{
    Diagnostic error = {Code::no_backend, "this build has no ray tracer: Embree 3 was not found"};
    error.help = "install it with 'apt-get install libembree-dev' and run cmake again";
    return error;
}

bool canTrace() { return false; }

}  // namespace crevice
