// SPDX-License-Identifier: MIT
// What the lists of stress cases share, and the lists themselves.
#pragma once

#include "tools/measure/stress/case.h"
#include "tools/measure/stress/scenes.h"

#include <initializer_list>

namespace crevice {

/// "0.5", "1000", "1e+06".
std::vector<StressStep> steps(std::initializer_list<double> values);

/// 10^first and so on to 10^last, as "1e-3".
std::vector<StressStep> decades(int first, int last);

/// Kinds, whose values count from 0.
std::vector<StressStep> kinds(std::initializer_list<const char*> labels);

/// Sizes of pictures, and the one that a step's value stands for. The first is ordinary.
std::vector<StressStep> shapes();
Extent shapeOf(double kind);

/// From 1:10 to 1e-4:1e7, by powers of ten of the near distance.
std::vector<StressStep> nearFarSteps();
StressView nearFarView(double power);

/// A block, in pixels, of means that noise leaves alone: as wide as the radius on screen at the
/// middle distance. What is larger says less of where the occlusion is.
int noiseBlock(Extent size);

// Conditions that several cases break under.
const StressCondition kTallRadius = {"where the radius is taller than {} screens",
                                     Quantity::screens};
const StressCondition kSmallRadius = {"where the radius is smaller than {} pixels",
                                      Quantity::pixels};
const StressCondition kWideNearFar = {"where near:far is wider than {}"};
const StressCondition kNarrowNearFar = {"where near:far is narrower than {}"};
const StressCondition kTurned = {"more than {} degrees off facing the camera"};
const StressCondition kFacing = {"less than {} degrees off facing the camera"};
const StressCondition kManyTaps = {"with more than {} taps a pixel"};
const StressCondition kFewTaps = {"with fewer than {} taps a pixel"};
const StressCondition kPictureSize = {"in a picture of {}"};

/// A plane and the test scene as `view` sees them.
StressShot planeShot(const StressView& view, Extent size, double distance, double tilt_degrees);
StressShot sceneShot(const StressView& view, Extent size, Scene scene = testScene());

/// From where the test scene is seen.
StressView testView();

std::vector<StressCase> planeCases();    ///< Flat planes.
std::vector<StressCase> sameCases();     ///< What must not change the test scene.
std::vector<StressCase> cameraCases();   ///< Flips, turns, walks; low eyes.
std::vector<StressCase> frameCases();    ///< Several frames.
std::vector<StressCase> extremeCases();  ///< Radii, sizes, no-ops; broken meshes and lights.
std::vector<StressCase> hostCases();     ///< Other geometry; a host's depth and normals.

}  // namespace crevice
