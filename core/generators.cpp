// SPDX-License-Identifier: MIT
// Sample kernels and rotation noise.
//
// The same numbers on every platform: integers are hashed, everything after that is + - * / and
// sqrt in double, which IEEE 754 fixes to the last bit, rounded to float once at the end. A compiler
// that fuses a multiply and an add moves the last bit of a double; the float is still the same.
// The C library's sin, cos and <random> differ between platforms and are not used.
#include "core/generators.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace crevice {

namespace {

/// A PCG output function over one step of its generator [Jarzynski, Olano 2020].
std::uint32_t pcg(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

std::uint32_t hash(unsigned seed, unsigned index)
{
    return pcg(index + pcg(seed));
}

struct Vector {
    double x = 0, y = 0, z = 0;

    double lengthSquared() const { return x * x + y * y + z * z; }
};

/// The numbers of one seed, one after the other.
class Stream {
public:
    explicit Stream(unsigned seed) : seed_(seed) {}

    /// In [0, 1).
    double number() { return randomFloat(seed_, index_++); }

    /// In (-1, 1): odd multiples of 2^-24, so that a float holds it exactly and none is 0.
    double signedNumber() { return 2.0 * number() - 1.0 + 0x1p-24; }

    /// In [0, count).
    int integer(int count) { return int(hash(seed_, index_++) % unsigned(count)); }

    Vector inCube()
    {
        const double x = signedNumber(), y = signedNumber(), z = signedNumber();
        return {x, y, z};
    }

    /// Uniform in volume, by rejection. The squared length has at most 50 bits, so a double holds
    /// it exactly and every platform rejects the same points.
    Vector inBall()
    {
        Vector point = inCube();
        while (point.lengthSquared() > 1.0) point = inCube();
        return point;
    }

private:
    unsigned seed_;
    unsigned index_ = 0;
};

enum class Distribution { uniform, cube, linear, accelerated };

const std::vector<std::string>& distributionNames()
{
    static const std::vector<std::string> names = {"uniform", "cube", "linear", "accelerated"};
    return names;
}

/// Share of its random length that the first offset keeps [Chapman 2013].
constexpr double kInnermost = 0.1;

/// Offset `index` of `count`, in the whole cube or sphere.
Vector makeOffset(Stream& stream, Distribution distribution, int index, int count)
{
    if (distribution == Distribution::cube) return stream.inCube();
    const Vector point = stream.inBall();
    if (distribution == Distribution::uniform) return point;
    const double t = double(index) / count;
    const double along = distribution == Distribution::linear ? t : t * t;
    const double length = stream.number() * (kInnermost + (1.0 - kInnermost) * along);
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
void direction(double turns, float& x, float& y)
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
    x = float(cosine);
    y = float(sine * angle);
}

}  // namespace

float randomFloat(unsigned seed, unsigned index)
{
    return float(hash(seed, index) >> 8) * 0x1p-24f;
}

Result<std::vector<glm::vec3>> makeKernel(bool hemisphere, int count, std::string_view distribution,
                                          unsigned seed)
{
    const std::vector<std::string>& names = distributionNames();
    const auto found = std::find(names.begin(), names.end(), distribution);
    if (found == names.end())
        return Diagnostic{Code::bad_enum,
                          "there is no distribution '" + std::string(distribution) + "'",
                          {}, {}, {}, suggestName(distribution, names, "distributions")};
    if (count < 1 || count > kMaxKernelSize) return rangeError("count", count, kMaxKernelSize);

    Stream stream(seed);
    std::vector<glm::vec3> kernel;
    for (int i = 0; i < count; ++i) {
        const Vector offset = makeOffset(stream, Distribution(found - names.begin()), i, count);
        kernel.emplace_back(offset.x, offset.y, hemisphere ? std::abs(offset.z) : offset.z);
    }
    return kernel;
}

Result<Image> makeRotationNoise(int size, unsigned seed)
{
    if (size < 1 || size > kMaxNoiseSize) return rangeError("size", size, kMaxNoiseSize);
    const int count = size * size;
    std::vector<int> strata(static_cast<std::size_t>(count));
    Stream stream(seed);
    for (int i = 0; i < count; ++i) {  // shuffles while it fills, so that neighbours differ
        const int other = stream.integer(i + 1);
        strata[std::size_t(i)] = strata[std::size_t(other)];
        strata[std::size_t(other)] = i;
    }
    Image noise({size, size}, 4);
    for (int i = 0; i < count; ++i) {
        const double turns = (strata[std::size_t(i)] + stream.number()) / count - 0.5;
        direction(turns, noise.pixels[std::size_t(i) * 4], noise.pixels[std::size_t(i) * 4 + 1]);
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
