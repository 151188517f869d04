// SPDX-License-Identifier: MIT
// Light for scenes from files.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// Files give candela, lux, watts or fractions. What counts is what arrives: colour becomes the
/// light at the scene's centre, as a part of what the brightest light brings there. Lights that
/// are off stay so; where what one brings is no number, all go.
void normalizeLights(Scene& scene);

/// Gives a scene without lights one over the shoulder of whoever looks at it from the front, so
/// that it can be seen.
void addDefaultLight(Scene& scene);

}  // namespace crevice
