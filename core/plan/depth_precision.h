// SPDX-License-Identifier: MIT
// The depth resolution of a format through a camera, and how far that serves a radius,
// which is the length that a config has formats resolve. What a plan chooses formats by and warns
// of; pure figures, in scene units.
//
// Window depth is straight in 1 / distance: a step s of it is z^2 (1/near - 1/far) s at distance z
// of a perspective camera, off-centre or not, reversed or not, and (far - near) s of an
// orthographic one. Floats stored as they are have steps of 2^floor(log2 z) times that of 1.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// A radius counts as resolved where steps are no more than this share of it.
constexpr double kResolvedShare = 0.1;

// Steps, in radii, that nobody sees where draws lie. A horizon raised by an angle blocks the square
// of its sine of an open surface; half a step of 8 bits is 0.002.

/// Of what is marched over. Above 0.0002 radii a point is lifted by up to ten steps, since its lift
/// is stored in two bits (effects/common/tolerance.glsl), and normals rebuilt from depth tilt. The
/// limit is measured, by the figures in docs/reference/formats.md.
constexpr double kUnseenMarched = 0.0006;

/// Of what the offsets of a kernel over the surface are compared with, which lie half the radius
/// away; their surface and the point itself round: sin^2(2 * 2 * 0.01) = 0.0016. Where the kernel
/// has a margin above that, steps within it are not seen either.
constexpr double kUnseenProbed = 0.01;

/// Of what a kernel all round the point is compared with. Its offsets lie on both sides of the
/// surface, and a step decides all within it: of a ball 3/4 * 0.0027 = 0.002, no squared angle.
constexpr double kUnseenAround = 0.0027;

/// Of the depth test alone, which confuses surfaces that lie no farther apart, next to where they
/// meet. Occlusion reaches a radius to either side of there, so a picture of which a sixth is
/// occluded changes by 0.16 * 0.02 / 2.
constexpr double kUnseenHidden = 0.02;

/// Where a radius covers fewer pixels, estimators fade: nothing is asked of a format there.
constexpr double kLeastRadiusPixels = 2.0;

/// Smaller steps are lost before a texture keeps them: a rasteriser makes depth of -1..1 in floats.
constexpr double kDrawnDepthStep = 1.0 / (1 << 24);

/// As little of that counts for the depth test. Where a texture holds finer steps, next to 0, only
/// vertices round: by half a step of -1..1 at most, a quarter of it in 0..1, and those at one
/// distance alike, so that what lies in front stays there.
constexpr double kHiddenDepthStep = kDrawnDepthStep / 4;

/// What a texture that surfaces are read from holds.
struct StoredSurface {
    Semantic semantic = Semantic::other;  ///< Of a colour format; one of depth holds window depth.
    Format format = Format::none;
    bool drawn = true;    ///< By a rasteriser, not a shader, nor a host that may clip at depth 0.
    bool hidden = false;  ///< Looked at by the depth test alone: nothing reads it.
};

/// What `target` holds in `format`.
StoredSurface storedSurface(const Description& description, const TargetDesc& target,
                            Format format);

/// What is asked of a format: steps of at most `step` up to `distance`. All 0 where nothing is.
struct PrecisionNeed {
    double step = 0;
    double distance = 0;
};

/// What a radius asks: a tenth of it, up to the far plane or to where it covers two pixels.
PrecisionNeed precisionNeed(const SceneTraits& traits, double radius, int height);

/// The param that formats have to resolve: of the lengths the one of the least value, or null.
const ParamDesc* resolvedLength(const Description& description);

/// The need of a config at the present value of that; none where there is none.
PrecisionNeed precisionNeed(const Description& description, const SceneTraits& traits, int height);

/// Distance between neighbours of the format at `value` >= 0; infinite above the largest it holds.
double formatStep(Format format, double value);

/// How far apart two surfaces about `distance` must lie in view depth to be distinguished; 0 where
/// what is stored is no surface. In an orthographic view the distance counts from the near plane.
double viewStep(const SceneTraits& traits, const StoredSurface& stored, double distance);

/// The distance up to which the need is met: `need.distance` where in full, 0 where nowhere.
double resolvedDistance(const SceneTraits& traits, const StoredSurface& stored,
                        const PrecisionNeed& need);

/// Of the target's preference list and the device: the first format that meets the config's need,
/// else the one that meets it farthest; never one that does not filter for a target that is read
/// so. The list's first where the device renders to none.
Format chooseFormat(const Description& description, const TargetDesc& target,
                    const SceneTraits& traits, const DeviceCaps& caps, int height);

}  // namespace crevice
