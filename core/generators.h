// SPDX-License-Identifier: MIT
// Numbers made on load: sample kernels and rotation noise, the same on every platform.
//
// Sources
//   Mittring 2007, "Finding Next Gen: CryEngine 2", SIGGRAPH course, chapter 8 - the sphere.
//   Filion, McNaughton 2008, "StarCraft II: Effects & Techniques" - the hemisphere.
//   Chapman 2013, "SSAO Tutorial" - offsets that cluster near the origin, a small tiled rotation.
//   Jarzynski, Olano 2020, "Hash Functions for GPU Rendering" - the PCG hash behind the numbers.
#pragma once

#include "core/image.h"
#include "core/result.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace crevice {

/// Most offsets that one kernel may hold: as vec3 uniforms they take 128 of the 224 vectors that
/// every OpenGL ES 3.0 device has for a fragment shader.
constexpr int kMaxKernelSize = 128;

/// Longest side of a noise texture, in pixels.
constexpr int kMaxNoiseSize = 64;

/// Where the offsets of a kernel lie.
///
/// `distribution` is one of
///   "uniform"           uniform in volume
///   "cube"              uniform in the cube (-1, 1)^3, not cut to the sphere (OGLdev 45)
///   "linear"            random direction, random length, times lerp(0.1, 1, i / n)
///   "accelerated"       random direction, random length, times lerp(0.1, 1, (i / n)^2) (Chapman)
/// Errors: CV4001 for a count outside [1, kMaxKernelSize], CV3005 for another distribution.
Result<std::vector<glm::vec3>> makeKernel(bool hemisphere, int count, std::string_view distribution,
                                          unsigned seed);

/// size x size pixels of (x, y, 0, 0): unit vectors in random directions, each with the angle of its
/// own stratum, so that a size x size box filter sees all directions evenly.
/// Errors: CV4001 for a size outside [1, kMaxNoiseSize].
Result<Image> makeRotationNoise(int size, unsigned seed);

/// The generators' names as JSON has them: "sphere_kernel", "hemisphere_kernel", "rotation_noise".
const std::vector<std::string>& generatorNames();
bool generatesTexture(std::string_view generator);

/// A stratum-free uniform number in [0, 1) for (seed, index); the source of all of the above.
float randomFloat(unsigned seed, unsigned index);

}  // namespace crevice
