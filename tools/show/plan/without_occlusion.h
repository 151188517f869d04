// SPDX-License-Identifier: MIT
// What a config would draw without its ambient occlusion.
#pragma once

#include <crevice/compile.h>

namespace crevice {

/// The config with its param `intensity` at 0; as it is where it has none.
Description withoutOcclusion(Description description);

/// For each pass of the plan: whether it draws geometry for the occlusion alone, such as back faces
/// or, with forward lighting, depth ahead of the light. Those are its draw passes that a plan for
/// all outputs of the config lacks without occlusion. Extent and `disable` come from `options`.
///
/// Errors: those of `compile`.
Result<std::vector<bool>> ownGeometry(const Plan& plan, const Description& description,
                                      const SceneTraits& traits, const DeviceCaps& caps,
                                      CompileOptions options);

}  // namespace crevice
