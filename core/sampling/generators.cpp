// SPDX-License-Identifier: MIT
// Sample kernels and rotation noise.
//
// The same numbers on every platform: integers are hashed, everything after that is + - * / and
// sqrt in double, which IEEE 754 fixes to the last bit, rounded to float once at the end. A compiler
// that fuses a multiply and an add moves the last bit of a double; the float is still the same.
// The C library's sin, cos and <random> differ between platforms and are not used.
#include "core/sampling/generators.h"

#include "core/sampling/sequences.h"

#include <algorithm>
#include <cmath>

namespace crevice {

static_assert(kMaxKernelSize <= kMaxSequenceSize);

namespace {

struct Vector {
    double x = 0, y = 0, z = 0;

    double lengthSquared() const { return x * x + y * y + z * z; }
};

/// In (-1, 1): odd multiples of 2^-24, so that a float holds it exactly and none is 0.
double signedNumber(Stream& stream)
{
    return 2.0 * stream.number() - 1.0 + 0x1p-24;
}

Vector inCube(Stream& stream)
{
    const double x = signedNumber(stream), y = signedNumber(stream), z = signedNumber(stream);
    return {x, y, z};
}

/// Uniform in volume, by rejection. The squared length has at most 50 bits, so a double holds
/// it exactly and every platform rejects the same points.
Vector inBall(Stream& stream)
{
    Vector point = inCube(stream);
    while (point.lengthSquared() > 1.0) point = inCube(stream);
    return point;
}

enum class Distribution { uniform, cube, linear, accelerated };
enum class Sequence { random, stratified, low_discrepancy };

/// Share of its random length that the first offset keeps [Chapman 2013].
constexpr double kInnermost = 0.1;

/// Of the length of offset `index` of `count`: what its distribution multiplies it by.
double lengthScale(Distribution distribution, int index, int count)
{
    const double t = double(index) / count;
    const double along = distribution == Distribution::linear ? t : t * t;
    return kInnermost + (1.0 - kInnermost) * along;
}

/// Offset `index` of `count`, in the whole cube or sphere, from independent numbers.
Vector randomOffset(Stream& stream, Distribution distribution, int index, int count)
{
    if (distribution == Distribution::cube) return inCube(stream);
    const Vector point = inBall(stream);
    if (distribution == Distribution::uniform) return point;
    const double length = stream.number() * lengthScale(distribution, index, count);
    const double scale = length / std::sqrt(point.lengthSquared());
    return {point.x * scale, point.y * scale, point.z * scale};
}

Diagnostic rangeError(const char* what, int value, int most)
{
    return {Code::out_of_range, std::string(what) + " " + std::to_string(value) +
                                    " is outside [1, " + std::to_string(most) + "]"};
}

/// (cos, sin) of an angle in turns, [-0.5, 0.5]: their Taylor series, nested. 16 terms leave an
/// error of about 1e-15, far below what a float shows.
void direction(double turns, double& x, double& y)
{
    constexpr int kTerms = 16;
    constexpr double kTwoPi = 6.283185307179586;
    const double angle = kTwoPi * turns;
    const double square = angle * angle;
    double cosine = 1.0, sine = 1.0;
    for (int i = 2 * kTerms; i > 0; i -= 2) {
        cosine = 1.0 - square / (i * (i - 1.0)) * cosine;
        sine = 1.0 - square / (i * (i + 1.0)) * sine;
    }
    x = cosine;
    y = sine * angle;
}

/// Of a number in (0, 1], by Newton's method. From 1 each step takes off at most a third, so that 20
/// reach the root of 2^-25; the rest double the digits.
double cubeRoot(double number)
{
    constexpr int kSteps = 25;
    double root = 1.0;
    for (int i = 0; i < kSteps; ++i) root -= (root - number / (root * root)) / 3.0;
    return root;
}

/// A point of the unit cube, carried into the distribution so that equal volumes of the cube hold
/// equal shares of it; `height` is evenly spread over the unit sphere or hemisphere (Archimedes).
Vector warped(const CubePoint& point, Distribution distribution, bool hemisphere, int index, int count)
{
    const double height = hemisphere ? point[1] : 2.0 * point[1] - 1.0;
    if (distribution == Distribution::cube)
        return {2.0 * point[0] - 1.0, 2.0 * point[2] - 1.0, height};
    const double length = distribution == Distribution::uniform
                              ? cubeRoot(point[2])
                              : point[2] * lengthScale(distribution, index, count);
    const double across = length * std::sqrt(1.0 - height * height);
    double x, y;
    direction(point[0] - 0.5, x, y);
    return {across * x, across * y, length * height};
}

std::vector<glm::vec3> randomKernel(const KernelDesc& desc, Distribution distribution)
{
    Stream stream(desc.seed);
    std::vector<glm::vec3> kernel;
    for (int i = 0; i < desc.count; ++i) {
        const Vector offset = randomOffset(stream, distribution, i, desc.count);
        kernel.emplace_back(offset.x, offset.y, desc.hemisphere ? std::abs(offset.z) : offset.z);
    }
    return kernel;
}

std::vector<glm::vec3> evenKernel(const KernelDesc& desc, Distribution distribution,
                                  const std::vector<CubePoint>& points)
{
    std::vector<glm::vec3> kernel;
    for (const CubePoint& point : points) {
        const int index = static_cast<int>(kernel.size());
        const Vector offset = warped(point, distribution, desc.hemisphere, index, desc.count);
        kernel.emplace_back(offset.x, offset.y, offset.z);
    }
    return kernel;
}

/// Where a word is in its list. Errors: CV3005.
Result<std::size_t> indexOf(std::string_view word, const std::vector<std::string>& words,
                            const std::string& what)
{
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    return Diagnostic{Code::bad_enum, "there is no " + what + " '" + std::string(word) + "'",
                      {}, {}, {}, suggestName(word, words, what + "s")};
}

}  // namespace

const std::vector<std::string>& distributionNames()
{
    static const std::vector<std::string> names = {"uniform", "cube", "linear", "accelerated"};
    return names;
}

const std::vector<std::string>& sequenceNames()
{
    static const std::vector<std::string> names = {"random", "stratified", "low_discrepancy"};
    return names;
}

Result<std::vector<glm::vec3>> makeKernel(const KernelDesc& desc)
{
    const Result<std::size_t> found = indexOf(desc.distribution, distributionNames(), "distribution");
    if (!found) return found.diagnostics();
    const Result<std::size_t> sequence = indexOf(desc.sequence, sequenceNames(), "sequence");
    if (!sequence) return sequence.diagnostics();
    if (desc.count < 1 || desc.count > kMaxKernelSize)
        return rangeError("count", desc.count, kMaxKernelSize);

    const Distribution distribution = Distribution(*found);
    switch (Sequence(*sequence)) {
        case Sequence::random: break;
        case Sequence::stratified:
            return evenKernel(desc, distribution, stratifiedPoints(desc.count, desc.seed));
        case Sequence::low_discrepancy:
            return evenKernel(desc, distribution, lowDiscrepancyPoints(desc.count, desc.seed));
    }
    return randomKernel(desc, distribution);
}

Result<Image> makeRotationNoise(int size, unsigned seed)
{
    if (size < 1 || size > kMaxNoiseSize) return rangeError("size", size, kMaxNoiseSize);
    const int count = size * size;
    Stream stream(seed);
    const std::vector<int> strata = stream.permutation(count);
    Image noise({size, size}, 4);
    for (int i = 0; i < count; ++i) {
        const double turns = (strata[std::size_t(i)] + stream.number()) / count - 0.5;
        double x, y;
        direction(turns, x, y);
        noise.pixels[std::size_t(i) * 4] = float(x);
        noise.pixels[std::size_t(i) * 4 + 1] = float(y);
    }
    return noise;
}

const std::vector<std::string>& generatorNames()
{
    static const std::vector<std::string> names = {"sphere_kernel", "hemisphere_kernel",
                                                   "rotation_noise"};
    return names;
}

bool generatesTexture(std::string_view generator)
{
    return generator == "rotation_noise";
}

}  // namespace crevice
