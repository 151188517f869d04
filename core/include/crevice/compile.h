// SPDX-License-Identifier: MIT
// From a description to a plan.
//
// `compile` is a pure and deterministic function: no GL, no clock, no files. The same input gives
// the same plan on every machine, so tests compare plans as text.
#pragma once

#include <crevice/config.h>
#include <crevice/plan.h>

namespace crevice {

/// Plans a description for a scene, a device and a size. The description's param and feature values
/// are the ones in force. Warnings come with the plan. Requires a description that `decode` made.
///
/// Errors: CV2xxx graph optimizations, CV4005 and CV6xxx for what the device cannot do, CV5xxx for
/// what GLSL and config disagree about; all of them, each at its place in the config or the shader.
///
/// One that was baked is planned by what was baked.
Result<Plan> compile(const Description& description, const SceneTraits& traits,
                     const DeviceCaps& caps, const CompileOptions& options);

/// `compile` as a planner.
std::shared_ptr<const PlanMaker> compilingPlanMaker();

}  // namespace crevice
