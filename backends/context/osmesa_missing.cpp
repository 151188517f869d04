// SPDX-License-Identifier: MIT
// Stands in for osmesa.cpp in a build without OSMesa.
#include <crevice/context.h>

#include "backends/gl/failure.h"

namespace crevice {

Result<std::unique_ptr<Context>> makeOsmesaContext()
{
    return failure(Code::no_backend, "crevice was built without the backend 'osmesa'",
                   "install libosmesa6-dev and configure with -DCREVICE_OSMESA=ON, or use 'egl'");
}

}  // namespace crevice
