// SPDX-License-Identifier: MIT
// Sample kernels and rotation noise.
//
// The same numbers on every platform: integers are hashed, everything after that is + - * / and
// sqrt in double, which IEEE 754 fixes to the last bit, rounded to float once at the end. A
// compiler that fuses a multiply and an add moves the last bit of a double; the float is still the
// same. The C library's sin, cos and <random> differ between platforms and are not used.
#include "core/sampling/generators.h"

#include "core/base/text.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace crevice {
namespace {

/// In (-1, 1): odd multiples of 2^-24, so that a float holds it exactly and none is 0.
double signedNumber(Stream& stream) { return 2.0 * stream.number() - 1.0 + 0x1p-24; }

/// Points that fill the cube (-1, 1)^3 evenly however many are taken, from a start of the seed's:
/// R3 [Roberts 2018]. Integers step round, so that every platform has the same.
struct EvenPoints {
    std::uint32_t at[3];

    glm::dvec3 next()
    {
        // 2^32 over g, g^2 and g^3, where g^4 = g + 1.
        constexpr std::uint32_t kSteps[3] = {3518319155u, 2882110345u, 2360945575u};
        glm::dvec3 point;
        for (int i = 0; i < 3; ++i) {
            at[i] += kSteps[i];
            point[i] = (at[i] >> 8) * 0x1p-23 - 1.0 + 0x1p-24;
        }
        return point;
    }
};

/// Uniform in volume, by rejection: alike everywhere, as squared lengths of 50 bits are exact.
glm::dvec3 inBall(EvenPoints& points)
{
    glm::dvec3 point = points.next();
    while (glm::dot(point, point) > 1.0) point = points.next();
    return point;
}

/// Share of its random length that the first offset keeps [Chapman 2013].
constexpr double kInnermost = 0.1;

/// A point of the whole cube or on one of its rays, times `scale`.
glm::dvec3 randomOffset(Stream& stream, bool on_ray, double scale)
{
    glm::dvec3 point;
    for (int i = 0; i < 3; ++i) point[i] = signedNumber(stream);
    if (on_ray) scale *= stream.number() / std::sqrt(glm::dot(point, point));
    return point * scale;
}

Status checkName(const std::string& name, const std::vector<std::string>& names, const char* what)
{
    if (contains(names, name)) return {};
    return Diagnostic{Code::bad_enum, "'" + name + "' is none of the " + what + " of a kernel",
                      suggestName(name, names, what)};
}

Status checkCount(const GeneratorDesc& desc)
{
    const int most = mostCount(desc.generator);
    if (desc.count >= 1 && desc.count <= most) return {};
    return Diagnostic{Code::out_of_range, "count " + std::to_string(desc.count) +
                                              " is outside [1, " + std::to_string(most) + "]"};
}

/// (cos, sin) of an angle in turns, [-0.5, 0.5]: nested Taylor series. 16 terms are exact to 1e-15.
glm::dvec2 direction(double turns)
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
    return {cosine, sine * angle};
}

/// The numbers from 0 to count - 1, shuffled while they are filled in.
std::vector<int> permutation(Stream& stream, int count)
{
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i) {
        numbers.push_back(i);
        std::swap(numbers.back(), numbers[std::size_t(stream.integer(i + 1))]);
    }
    return numbers;
}

}  // namespace

bool generatesTexture(std::string_view generator) { return endsWith(generator, "_noise"); }

Result<std::vector<glm::vec3>> makeKernel(const GeneratorDesc& desc)
{
    Status status = checkCount(desc);
    if (status) status = checkName(desc.shape, kShapeNames, "shapes");
    if (status) status = checkName(desc.lengths, kLengthsNames, "lengths");
    if (!status) return status.diagnostics();
    const bool hemisphere = desc.generator == "hemisphere_kernel";
    Stream stream{desc.seed};
    EvenPoints points{
        {randomBits(desc.seed, 0), randomBits(desc.seed, 1), randomBits(desc.seed, 2)}};
    std::vector<glm::vec3> kernel;
    for (int i = 0; i < desc.count; ++i) {
        const double t = double(i) / desc.count;
        const double ramp =
            kInnermost + (1.0 - kInnermost) * (desc.lengths == "linear" ? t : t * t);
        const double scale = desc.lengths == "even" ? 1.0 : ramp;
        const glm::dvec3 offset = desc.shape == "ball"
                                      ? inBall(points) * scale
                                      : randomOffset(stream, desc.shape == "rays", scale);
        kernel.emplace_back(offset.x, offset.y, hemisphere ? std::abs(offset.z) : offset.z);
    }
    return kernel;
}

Result<Image> makeNoise(const GeneratorDesc& desc)
{
    if (Status status = checkCount(desc); !status) return status.diagnostics();
    const int count = desc.count * desc.count;
    const bool rotation = desc.generator == "rotation_noise";
    Stream stream{desc.seed};
    const std::vector<int> strata = permutation(stream, rotation ? count : 0);
    Image noise({desc.count, desc.count}, 4);
    for (int i = 0; i < count; ++i) {
        glm::dvec2 at;
        if (rotation)
            at = direction((strata[std::size_t(i)] + stream.number()) / count - 0.5);
        else
            for (int axis = 0; axis < 2; ++axis) at[axis] = signedNumber(stream);
        noise.pixels[std::size_t(i) * 4] = float(at.x);
        noise.pixels[std::size_t(i) * 4 + 1] = float(at.y);
    }
    return noise;
}

}  // namespace crevice
