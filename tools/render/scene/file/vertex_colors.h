// SPDX-License-Identifier: MIT
// Colours of vertices, which devices do not draw, as textures.
#pragma once

#include <crevice/device.h>
#include <crevice/image.h>

namespace crevice {

/// `colors` has four numbers for each vertex. Gives each triangle corners of its own, whose texture
/// coordinates are those of the texture that is returned: a block of 2 x 2 texels for each, between
/// whose middles its colours run straight. Empty, and nothing changed, where there would be more
/// than `most_texels`.
Image paintedCorners(const std::vector<float>& colors, double most_texels, MeshDesc& mesh);

}  // namespace crevice
