// SPDX-License-Identifier: MIT
// The one place where a renderer meets the compiler.
#include <crevice/renderer.h>

#include <crevice/compile.h>

namespace crevice {

Result<std::unique_ptr<Renderer>> Renderer::create(Device& device, Description description,
                                                   const CompileOptions& options,
                                                   const SceneTraits& traits)
{
    if (!description.planner) description.planner = compilingPlanMaker();
    return createPlanned(device, std::move(description), options, traits);
}

}  // namespace crevice
