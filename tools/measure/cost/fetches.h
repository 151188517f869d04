// SPDX-License-Identifier: MIT
// How many texture fetches the fullscreen passes of a config make in a frame of a scene: drawn, and
// counted.
#pragma once

#include "tools/render/scene/options.h"

#include <crevice/config.h>

#include <map>
#include <string>

namespace crevice {

/// Fetches a frame by pass, summed over its pixels, loops counted as often as they run, on the
/// first context without a window that works. Of a config that remembers frames it is one that has
/// them. Errors: those of openDevice, CountingDevice and Renderer; a counted shader may not
/// compile.
Result<std::map<std::string, double>> countFetches(Description description, const SceneView& view);

}  // namespace crevice
