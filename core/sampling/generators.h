// SPDX-License-Identifier: MIT
// Numbers made on load: sample kernels and rotation noise, the same on every platform.
//
// Sources: Mittring 2007 - the sphere; Filion, McNaughton 2008 - the hemisphere; Chapman 2013 -
// offsets that cluster near the origin, a small tiled rotation; Roberts 2018 - R3, for the ball;
// Jarzynski, Olano 2020 - the PCG hash behind every number.
#pragma once

#include <crevice/image.h>
#include <crevice/result.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace crevice {

/// Most offsets that one kernel may hold. Each is a uniform vector, of which some OpenGL ES 3.0
/// devices have 224 for a fragment shader: `compile` refuses there what does not fit (CV6008).
constexpr int kMaxKernelSize = 256;

/// Longest side of a noise texture, in pixels.
constexpr int kMaxNoiseSize = 64;

/// What a kernel is made of.
struct KernelDesc {
    bool hemisphere = true;        ///< Offsets with z >= 0 only.
    int count = 16;                ///< [1, kMaxKernelSize].
    std::string shape = "ball";    ///< Where the offsets lie; see shapeNames().
    std::string lengths = "even";  ///< How their lengths grow; see lengthsNames().
    unsigned seed = 1;
};

/// The offsets of a kernel, `count` of them.
/// Errors: CV4001 for a count outside its range, CV3005 for another shape or other lengths.
Result<std::vector<glm::vec3>> makeKernel(const KernelDesc& desc);

/// Where the offsets of a kernel lie:
///   "ball"  in the unit ball, uniform in volume, and evenly however few they are [Roberts 2018]
///   "cube"  at random in the cube (-1, 1)^3, not cut to the ball [Meiri n.d.]
///   "rays"  a random vector in the cube, normalised, times a random length [de Vries 2020]
const std::vector<std::string>& shapeNames();

/// What offset i of n is multiplied by:
///   "even"       1
///   "linear"     lerp(0.1, 1, i / n)
///   "quadratic"  lerp(0.1, 1, (i / n)^2) [Chapman 2013]
const std::vector<std::string>& lengthsNames();

/// size x size pixels of (x, y, 0, 0): unit vectors in random directions, each with the angle of
/// its own stratum, so that a size x size box filter sees all directions evenly. Errors: CV4001 for
/// a size outside [1, kMaxNoiseSize].
Result<Image> makeRotationNoise(int size, unsigned seed);

/// size x size pixels of (x, y, 0, 0): vectors in the square (-1, 1)^2, independent of each other,
/// as most authors have them [de Vries 2020; Lettier 2019]. Errors: those of makeRotationNoise.
Result<Image> makeVectorNoise(int size, unsigned seed);

/// The generators' names as JSON has them: "sphere_kernel", "hemisphere_kernel", "rotation_noise",
/// "vector_noise".
const std::vector<std::string>& generatorNames();
bool generatesTexture(std::string_view generator);

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
class Stream {
public:
    explicit Stream(unsigned seed) : seed_(seed) {}

    /// In [0, 1).
    double number() { return randomFloat(seed_, index_++); }

    /// In [0, count).
    int integer(int count) { return int(randomBits(seed_, index_++) % unsigned(count)); }

private:
    unsigned seed_;
    unsigned index_ = 0;
};

}  // namespace crevice
