// SPDX-License-Identifier: MIT
// Sample kernels and rotation noise.
#include "core/sampling/generators.h"

#include "core/base/text.h"
#include "tests/support/need.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace crevice;

namespace {

using Kernel = std::pair<std::string, std::string>;  // shape, lengths

std::vector<Kernel> allKernels()
{
    std::vector<Kernel> all;
    for (const std::string& shape : kShapeNames)
        for (const std::string& lengths : kLengthsNames) all.emplace_back(shape, lengths);
    return all;
}

GeneratorDesc kernelDesc(bool hemisphere, int count, const Kernel& of, unsigned seed)
{
    const char* const generator = hemisphere ? "hemisphere_kernel" : "sphere_kernel";
    return {{"kernel"}, generator, count, of.first, of.second, seed};
}

GeneratorDesc noiseDesc(const char* generator, int size, unsigned seed)
{
    return {{"noise"}, generator, size, "ball", "even", seed};
}

std::vector<glm::vec3> kernelOf(bool hemisphere, int count, const Kernel& of, unsigned seed)
{
    return need(makeKernel(kernelDesc(hemisphere, count, of, seed)));
}

/// The offsets of kernels of the largest size with the seeds 0 to 199, next to each other.
std::vector<glm::vec3> manyOffsets(bool hemisphere, const Kernel& of)
{
    std::vector<glm::vec3> all;
    for (unsigned seed = 0; seed < 200; ++seed)
        for (const glm::vec3& offset : kernelOf(hemisphere, kMaxKernelSize, of, seed))
            all.push_back(offset);
    return all;
}
double angleInTurns(const Image& noise, int pixel)
{
    const double x = noise.pixels[std::size_t(pixel) * 4];
    const double y = noise.pixels[std::size_t(pixel) * 4 + 1];
    const double turns = std::atan2(y, x) / 6.283185307179586;
    return turns < 0 ? turns + 1 : turns;
}

}  // namespace

TEST_CASE("a ball's few offsets lie evenly to either side of any plane through the middle")
{
    // Root mean square of the share on one side, less a half, over many planes and seeds. At random
    // it is 0.5 / sqrt(count).
    const std::vector<glm::vec3> normals = manyOffsets(false, {"cube", "even"});
    const auto unevenness = [&](const char* shape, int count) {
        double sum = 0;
        for (unsigned seed = 0; seed < 100; ++seed) {
            const std::vector<glm::vec3> kernel = kernelOf(false, count, {shape, "even"}, seed);
            for (std::size_t i = 0; i < 100; ++i) {
                const auto above = [&](const glm::vec3& v) { return glm::dot(v, normals[i]) > 0; };
                const auto found = std::count_if(kernel.begin(), kernel.end(), above);
                sum += std::pow(double(found) / count - 0.5, 2);
            }
        }
        return std::sqrt(sum / 1e4);
    };
    for (const int count : {16, 64, 250}) {
        INFO(count << ": " << unevenness("ball", count) << " " << unevenness("cube", count));
        CHECK(unevenness("cube", count) == Approx(0.5 / std::sqrt(count)).epsilon(0.1));
        CHECK(unevenness("ball", count) < 0.6 * unevenness("cube", count));
    }
}

TEST_CASE("rays have the mean length that their ramp gives, and favour the cube's corners")
{
    // Half of the mean of lerp(0.1, 1, t) and of lerp(0.1, 1, t^2) over t in [0, 1).
    const auto meanLength = [](const char* lengths) {
        double sum = 0;
        const std::vector<glm::vec3> offsets = manyOffsets(true, {"rays", lengths});
        for (const glm::vec3& offset : offsets) sum += glm::length(offset);
        return sum / double(offsets.size());
    };
    CHECK(meanLength("linear") == Approx(0.5 * 0.55).margin(0.005));
    CHECK(meanLength("quadratic") == Approx(0.5 * 0.4).margin(0.005));
    // Of |x|, |y| and |z| of a direction the least is larger towards corners: 0.2099 in the mean on
    // a sphere, 0.2470 of normalised vectors of a cube, by numerical integration.
    double least = 0;
    const std::vector<glm::vec3> rays = manyOffsets(false, {"rays", "even"});
    for (const glm::vec3& ray : rays) {
        const glm::vec3 size = glm::abs(ray) / glm::length(ray);
        least += std::min({size.x, size.y, size.z});
    }
    CHECK(least / double(rays.size()) == Approx(0.2470).margin(0.004));
}

TEST_CASE("a seed gives the same numbers again and another seed gives others")
{
    for (const Kernel& of : allKernels()) {
        const auto kernel = kernelOf(true, 16, of, 5);
        CHECK(kernel == kernelOf(true, 16, of, 5));
        CHECK(kernel != kernelOf(true, 16, of, 6));
    }
    for (const char* generator : {"rotation_noise", "vector_noise"}) {
        const Result<Image> noise = makeNoise(noiseDesc(generator, 4, 1));
        CHECK(noise->pixels == makeNoise(noiseDesc(generator, 4, 1))->pixels);
        CHECK(noise->pixels != makeNoise(noiseDesc(generator, 4, 2))->pixels);
    }
}

TEST_CASE("the numbers are these on every platform")
{
    CHECK(randomFloat(0, 0) == 0x1.85f018p-3f);
    CHECK(randomFloat(1, 2) == 0x1.bf61cep-1f);
    CHECK(randomFloat(12345, 678) == 0x1.b6dd6p-3f);
    CHECK(kernelOf(false, 4, {"ball", "even"}, 1)[3] ==
          glm::vec3(-0x1.256b9p-4f, -0x1.c0871ap-1f, -0x1.d42dd4p-2f));
    CHECK(kernelOf(true, 4, {"cube", "even"}, 1)[3] ==
          glm::vec3(0x1.282f1cp-2f, 0x1.44405cp-2f, 0x1.3fad44p-2f));
    CHECK(kernelOf(true, 4, {"rays", "linear"}, 1)[3] ==
          glm::vec3(0x1.07b2c2p-1f, 0x1.204092p-2f, 0x1.92962ap-2f));
    CHECK(kernelOf(true, 4, {"cube", "quadratic"}, 1)[3] ==
          glm::vec3(0x1.671f86p-3f, 0x1.8927a2p-3f, 0x1.839bbp-3f));
    const Image vectors = *makeNoise(noiseDesc("vector_noise", 4, 1));
    CHECK(vectors.at(3, 1, 0) == -0x1.faad18p-3f);
    CHECK(vectors.at(3, 1, 1) == 0x1.a56c7ap-1f);
    const Image noise = *makeNoise(noiseDesc("rotation_noise", 4, 1));
    CHECK(noise.at(0, 0, 0) == 0x1.7251c4p-8f);
    CHECK(noise.at(0, 0, 1) == 0x1.fffde8p-1f);
    CHECK(noise.at(3, 1, 0) == -0x1.e8948p-1f);
    CHECK(noise.at(3, 1, 1) == 0x1.322904p-2f);
    CHECK(noise.at(3, 3, 0) == -0x1.f9185ep-1f);
    CHECK(noise.at(3, 3, 1) == -0x1.4f35bep-3f);
}

TEST_CASE("rotation noise holds unit vectors, each in a stratum of its own")
{
    for (int size : {1, 2, 3, 4, 5, 8, kMaxNoiseSize}) {
        const Image noise = need(makeNoise(noiseDesc("rotation_noise", size, 9)));
        CHECK(noise.extent == Extent{size, size});
        CHECK(noise.channels == 4);
        const int count = size * size;
        std::set<int> strata;
        for (int i = 0; i < count; ++i) {
            const float* pixel = &noise.pixels[std::size_t(i) * 4];
            CHECK(std::hypot(double(pixel[0]), double(pixel[1])) == Approx(1.0).margin(1e-6));
            CHECK(pixel[2] == 0.0f);
            CHECK(pixel[3] == 0.0f);
            // The first stratum begins at half a turn.
            strata.insert(int(std::fmod(angleInTurns(noise, i) + 0.5, 1.0) * count));
        }
        CHECK(int(strata.size()) == count);
    }
}

TEST_CASE("a generator that is asked for the impossible says what is possible")
{
    const std::string range = "[1, " + std::to_string(kMaxKernelSize) + "]";
    for (int count : {-1, 0, kMaxKernelSize + 1}) {
        const auto kernel = makeKernel(kernelDesc(true, count, {"ball", "even"}, 1));
        CHECK(has(onlyError(kernel, Code::out_of_range).message, range));
    }
    for (int size : {-1, 0, kMaxNoiseSize + 1})
        onlyError(makeNoise(noiseDesc("rotation_noise", size, 1)), Code::out_of_range);
    const auto kernel = makeKernel(kernelDesc(true, 4, {"rays", "liner"}, 1));
    CHECK(has(onlyError(kernel, Code::bad_enum).help, "linear"));
}

TEST_CASE("generators are known by name")
{
    CHECK(kGeneratorNames == std::vector<std::string>{"sphere_kernel", "hemisphere_kernel",
                                                      "rotation_noise", "vector_noise"});
    CHECK(generatesTexture("rotation_noise"));
    CHECK(generatesTexture("vector_noise"));
    CHECK_FALSE(generatesTexture("sphere_kernel"));
}
