// SPDX-License-Identifier: MIT
// Stands in for what needs glslang where glslang or SPIRV-Cross was not found.
#include "tools/render/device/open_device.h"
#include "tools/render/glsl/glsl_check.h"

namespace crevice {
namespace {

Diagnostic missing(const std::string& what)
{
    return Diagnostic{
        Code::no_backend, what + ": glslang or SPIRV-Cross was not found",
        "install them with 'apt-get install glslang-dev libspirv-cross-c-shared-dev' and "
        "run cmake again"};
}

}  // namespace

Result<std::unique_ptr<Device>> makeMediumpDevice(std::unique_ptr<Device>, Mediump)
{
    return missing("this build cannot choose a precision");
}

bool canRewriteMediump() { return false; }

Diagnostics warnUnchecked()
{
    return {asWarning(missing("this build does not compile shaders to check them"))};
}

void GlslCheck::add(const Plan&, const std::string&) {}

Diagnostics GlslCheck::check(const Description&, Device*) { return {}; }

}  // namespace crevice
