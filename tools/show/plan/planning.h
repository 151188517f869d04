// SPDX-License-Identifier: MIT
// Planning a config where there is no graphics device: what validate and explain work on.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/render/glsl/glsl_check.h"

namespace crevice {

/// What every OpenGL ES 3.0 device has, and float targets.
DeviceCaps usualCaps();

/// What a scene usually has: a light, textures, alpha tests, highlights.
SceneTraits usualTraits();

constexpr Extent kUsualExtent = {960, 540};

/// The plan of a config under a variant on `usualCaps` for `usualTraits`, once it plans for every
/// other scene and camera too: with each trait changed, and with all that a scene can have. Errors:
/// those of compile for all of the plans, and of `shaders` on them, each with a note that says
/// where it was found. Its bytes are those of the largest of the plans.
Result<Plan> planForEveryScene(const Result<Description>& description, const std::string& variant,
                               Extent extent, GlslCheck& shaders);

}  // namespace crevice
