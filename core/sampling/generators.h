// SPDX-License-Identifier: MIT
// Numbers made on load: sample kernels and rotation noise, the same on every platform.
//
// Sources: Mittring 2007 - the sphere; Filion, McNaughton 2008 - the hemisphere; Chapman 2013 -
// offsets that cluster near the origin, a small tiled rotation; Roberts 2018 - R3, for the ball;
// Jarzynski, Olano 2020 - the PCG hash behind every number.
#pragma once

#include <crevice/frame.h>

namespace crevice {

/// Most offsets that one kernel may hold. Each is a uniform vector, of which some OpenGL ES 3.0
/// devices have 224 for a fragment shader: `compile` refuses there what does not fit (CV6008).
constexpr int kMaxKernelSize = 256;

/// Longest side of a noise texture, in pixels.
constexpr int kMaxNoiseSize = 64;

/// Where the offsets of a kernel lie:
///   "ball"  in the unit ball, uniform in volume, and evenly however few they are [Roberts 2018]
///   "cube"  at random in the cube (-1, 1)^3, not cut to the ball [Meiri n.d.]
///   "rays"  a random vector in the cube, normalised, times a random length [de Vries 2020]
inline const std::vector<std::string> kShapeNames = {"ball", "cube", "rays"};

/// What offset i of n is multiplied by:
///   "even"       1
///   "linear"     lerp(0.1, 1, i / n)
///   "quadratic"  lerp(0.1, 1, (i / n)^2) [Chapman 2013]
inline const std::vector<std::string> kLengthsNames = {"even", "linear", "quadratic"};

/// What makes the numbers:
///   "sphere_kernel"      offsets
///   "hemisphere_kernel"  ... with z >= 0 only
///   "rotation_noise"     pixels of (x, y, 0, 0): unit vectors in random directions, each with the
///                        angle of its own stratum, so that a box filter of the noise's size sees
///                        all directions evenly
///   "vector_noise"       ... vectors in the square (-1, 1)^2, independent of each other, as most
///                        authors have them [de Vries 2020; Lettier 2019]
inline const std::vector<std::string> kGeneratorNames = {"sphere_kernel", "hemisphere_kernel",
                                                         "rotation_noise", "vector_noise"};

bool generatesTexture(std::string_view generator);

/// The offsets of a kernel, and the square image of a noise.
/// Errors: CV4001 for a count above `mostCount` or below 1, CV3005 for no known shape or lengths.
Result<std::vector<glm::vec3>> makeKernel(const GeneratorDesc& desc);
Result<Image> makeNoise(const GeneratorDesc& desc);

/// The most offsets, or pixels along a side, that the generator makes.
inline int mostCount(std::string_view generator)
{
    return generatesTexture(generator) ? kMaxNoiseSize : kMaxKernelSize;
}

/// A PCG output function over one step of its generator [Jarzynski, Olano 2020].
inline std::uint32_t pcg(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// 32 random bits for (seed, index).
inline std::uint32_t randomBits(unsigned seed, unsigned index) { return pcg(index + pcg(seed)); }

/// A uniform number in [0, 1) for (seed, index).
inline float randomFloat(unsigned seed, unsigned index)
{
    return float(randomBits(seed, index) >> 8) * 0x1p-24f;
}

/// The numbers of one seed, one after the other.
struct Stream {
    unsigned seed;
    unsigned index = 0;

    /// In [0, 1).
    double number() { return randomFloat(seed, index++); }

    /// In [0, count).
    int integer(int count) { return int(randomBits(seed, index++) % unsigned(count)); }
};

}  // namespace crevice
