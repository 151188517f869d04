// SPDX-License-Identifier: MIT
// What the page shows: a corner of a room with stairs, boxes and a ball.
#pragma once

#include <crevice/frame.h>

namespace example {

/// Uploads the meshes, which live as long as the device, and fills in draws, materials and lights.
/// Errors: those of Device::createMesh.
crevice::Status addScene(crevice::Device& device, crevice::Frame& frame);

/// Looks at the corner from `turn_rad` beside its diagonal.
crevice::Camera cameraAt(float turn_rad, crevice::Extent extent);

}  // namespace example
