// SPDX-License-Identifier: MIT
// Stands in for the device that rewrites shaders where glslang or SPIRV-Cross was not found.
#include "tools/render/device/mediump_device.h"

namespace crevice {

Result<std::unique_ptr<Device>> makeMediumpDevice(std::unique_ptr<Device>, Mediump)
{
    Diagnostic error = {
        Code::no_backend,
        "this build cannot choose a precision: glslang or SPIRV-Cross was not found"};
    error.help =
        "install them with 'apt-get install glslang-dev libspirv-cross-c-shared-dev' and "
        "run cmake again";
    return error;
}

bool canRewriteMediump() { return false; }

}  // namespace crevice
