// SPDX-License-Identifier: MIT
// Estimates of the bytes that a plan moves, and all that it and its frames leave out.
#pragma once

#include <crevice/plan.h>

namespace crevice {

/// Of all views in one frame, with one texel of each input a pixel.
struct MovedBytes {
    double read = 0;
    double loaded = 0;   ///< Of `read`: what tiled GPUs load before they draw, the pass's mask.
    double written = 0;  ///< What they store when a tile is drawn.
};

MovedBytes movedBytes(const Plan& plan, const PlanPass& pass);
MovedBytes movedBytes(const Plan& plan);

/// GL textures that the plan has, with the second copies that history needs.
std::size_t textureCount(const Plan& plan);

/// What the plan says, the textures that targets share, and what each frame may leave out.
std::vector<Elided> allElided(const Plan& plan);

}  // namespace crevice
