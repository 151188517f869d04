// SPDX-License-Identifier: MIT
// The host's pictures, as C describes them.
#pragma once

#include <crevice/crevice.h>
#include <crevice/device.h>

namespace crevice {

/// Errors: CV6011 for null, a struct of a wrong size, a name that is no format's, and an unknown
/// kind.
Status takeTexture(const crevice_texture* given, HostTexture& host);

}  // namespace crevice
