// SPDX-License-Identifier: MIT
// The values of a description's params and features: checked, and carried over to another one.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// In the order of the description's lists.
struct Values {
    std::vector<std::array<float, 4>> params = {};
    std::vector<int> features = {};
};

/// Whether all components are `value`: where a no-op holds.
bool isAll(const std::array<float, 4>& values, ParamType type, float value);

Values valuesOf(const Description& description);

/// What a sampler may read: targets, histories, generated textures and those of the host.
std::vector<std::string> textureNames(const Description& description);

/// Whether the param's value may be relative to the scene, and whether it is.
bool isLength(const ParamDesc& param);
bool isRelative(const ParamDesc& param);

constexpr const char* kLengthForms =
    "write 0.5 in scene units, \"5%\" of the scene's diagonal, or \"40px\" of the view's height at "
    "its median depth";

/// Reads "5%" or "40px", without blanks and not below 0. Another text leaves the value as it is.
bool takeLength(std::string_view text, std::array<float, 4>& value);

/// The param's value, in scene units and its range where it is relative: NaN where the scale of the
/// scene is not known. A fourth number is the most percent of the view's height that it may be,
/// where its distance is known. `height` is the view's, in pixels.
std::array<float, 4> sceneUnits(const ParamDesc& param, const SceneTraits& traits, int height);

/// Gives params and features the values that the present word of a feature sets, if it sets any.
void applyLevel(Description& description, std::string_view feature);

/// The values that `now` would have, were nothing changed in it since `loaded` but features that
/// set values: what differs from them was set by itself.
Values untouched(const Values& loaded, const Description& now);

/// Whether the param may have that value. Errors: CV4001, CV4003, CV3006.
Status checkValue(const ParamDesc& param, const float* values, int count);

/// Sets in `next`, which may be of another config, what `now` has and `loaded` has not. The
/// warnings CV4006 name what cannot be set there.
Diagnostics carryOver(const Values& loaded, const Description& now, Description& next);

}  // namespace crevice
