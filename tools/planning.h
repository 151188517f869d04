// SPDX-License-Identifier: MIT
// Planning a config where there is no graphics device: what validate and explain work on.
#pragma once

#include "core/plan.h"
#include "tools/config_options.h"

namespace crevice {

/// What every OpenGL ES 3.0 device has, and float targets.
DeviceCaps usualCaps();

/// A scene that has one of everything, so that no pass is left out for want of it.
SceneTraits fullTraits();

/// Loads a config and plans it at 960x540 on `usualCaps` for `fullTraits`.
/// Errors: those of loadDescription and compile; warnings come with the plan.
Result<Plan> planWithoutDevice(const ConfigOptions& options, const SourceSet& sources);

}  // namespace crevice
