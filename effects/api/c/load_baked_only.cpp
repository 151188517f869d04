// SPDX-License-Identifier: MIT
// The runtime, which reads no config.
#include "effects/api/c/handles.h"

namespace crevice {
namespace {

Diagnostic noReader(const char* what)
{
    return {Code::not_baked, std::string("this library reads baked effects alone, and no ") + what,
            "bake it by crevice bake, and hand over crevice_effect_desc::baked; or link "
            "crevice::crevice"};
}

}  // namespace

Result<std::unique_ptr<LoadedConfig>> loadEffect(const EffectRequest& request)
{
    if (request.baked) return loadBaked(request);
    return noReader("config");
}

Result<std::string> patchOf(const LoadedConfig&, const Description&) { return noPatch(); }

Result<std::vector<FrontLevel>> levelsOf(const char*) { return noReader("front"); }

}  // namespace crevice
