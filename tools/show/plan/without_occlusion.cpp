// SPDX-License-Identifier: MIT
// Plans with and without occlusion, compared.
#include "tools/show/plan/without_occlusion.h"

namespace crevice {
namespace {

constexpr const char* kIntensity = "intensity";

}  // namespace

Description withoutOcclusion(Description description)
{
    for (ParamDesc& param : description.params)
        if (param.name == kIntensity) param.value.fill(0);
    return description;
}

Result<std::vector<bool>> ownGeometry(const Plan& plan, const Description& description,
                                      const SceneTraits& traits, const DeviceCaps& caps,
                                      CompileOptions options)
{
    options.outputs.clear();
    const Result<Plan> without = compile(withoutOcclusion(description), traits, caps, options);
    if (!without) return without.diagnostics();
    std::vector<bool> own;
    for (const PlanPass& pass : plan.passes)
        own.push_back(pass.type == PassType::draw && !findNamed(without->passes, pass.name));
    return own;
}

}  // namespace crevice
