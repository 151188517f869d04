// SPDX-License-Identifier: MIT
// The words in which plans are printed.
#pragma once

#include <crevice/plan.h>

namespace crevice {

const char* nameOf(LoadOp load);
const char* nameOf(StoreOp store);
const char* nameOf(InputKind kind);
const char* nameOf(UniformSource source);

/// What a sampler reads: a target's, generated value's or import's name, "material" or a number.
std::string sourceName(const Plan& plan, const PlanInput& input);

/// "256x144".
std::string sizeText(const Extent& extent);

/// "288.0 KiB".
std::string bytesText(double bytes);

/// ", 4 samples"; nothing for one.
std::string samplesText(int samples);

/// The texture behind a target of the plan.
const PlanTexture& textureOf(const Plan& plan, int target);

}  // namespace crevice
