// SPDX-License-Identifier: MIT
// What the passes of a plan are for, so that the cost of ambient occlusion can be told from that of
// the picture.
#pragma once

#include <crevice/plan.h>

namespace crevice {

enum class PassRole {
    ao,               ///< Fullscreen, on the way from depth to the output `ao`.
    geometry_for_ao,  ///< Draws the scene, and only AO reads what it writes: back faces, layers.
    geometry,         ///< Draws the scene for AO and for the picture; its depth is the scene's own.
    picture,          ///< All else: lighting, what it reads.
};

/// "AO", "geometry for AO", ...
const char* nameOf(PassRole role);

/// One for each pass of the plan. Where it has no output `ao`, all outputs count as such.
std::vector<PassRole> passRoles(const Plan& plan);

/// Bytes a frame of colour attachments that passes of the role `geometry` store for AO alone, such
/// as normals.
double bytesForAo(const Plan& plan, const std::vector<PassRole>& roles);

}  // namespace crevice
