// SPDX-License-Identifier: MIT
// Sample kernels and rotation noise.
#include "core/sampling/generators.h"

#include "core/sampling/random.h"
#include "tests/support/catch.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace crevice;

namespace {

using Kernel = std::pair<std::string, std::string>;  // shape, lengths

std::vector<Kernel> allKernels()
{
    std::vector<Kernel> all;
    for (const std::string& shape : shapeNames())
        for (const std::string& lengths : lengthsNames()) all.emplace_back(shape, lengths);
    return all;
}

std::vector<glm::vec3> kernelOf(bool hemisphere, int count, const Kernel& of, unsigned seed)
{
    const auto kernel = makeKernel({hemisphere, count, of.first, of.second, seed});
    REQUIRE(kernel.ok());
    return *kernel;
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

glm::dvec3 mean(const std::vector<glm::vec3>& offsets)
{
    glm::dvec3 sum(0.0);
    for (const glm::vec3& offset : offsets) sum += glm::dvec3(offset);
    return sum / double(offsets.size());
}

/// The share of the offsets that are shorter than `length`.
double shareWithin(const std::vector<glm::vec3>& offsets, float length)
{
    const auto inside = [&](const glm::vec3& offset) { return glm::length(offset) < length; };
    return double(std::count_if(offsets.begin(), offsets.end(), inside)) / double(offsets.size());
}

double angleInTurns(const Image& noise, int pixel)
{
    const double x = noise.pixels[std::size_t(pixel) * 4];
    const double y = noise.pixels[std::size_t(pixel) * 4 + 1];
    const double turns = std::atan2(y, x) / 6.283185307179586;
    return turns < 0 ? turns + 1 : turns;
}

}  // namespace

TEST_CASE("random numbers fill 0 to 1 evenly")
{
    double sum = 0, square = 0;
    constexpr int kCount = 100000;
    for (unsigned i = 0; i < kCount; ++i) {
        const float number = randomFloat(7, i);
        REQUIRE(number >= 0.0f);
        REQUIRE(number < 1.0f);
        sum += number;
        square += double(number) * number;
    }
    CHECK(sum / kCount == Approx(0.5).margin(0.005));
    CHECK(square / kCount == Approx(1.0 / 3).margin(0.005));
}

TEST_CASE("kernels have as many offsets as asked for, none longer than 1 but in the cube")
{
    const Kernel of = GENERATE(from_range(allKernels()));
    const bool hemisphere = GENERATE(false, true);
    const float lowest = hemisphere ? 0.0f : -1.0f;
    for (int count = 1; count <= kMaxKernelSize; ++count) {
        const std::vector<glm::vec3> kernel = kernelOf(hemisphere, count, of, 3);
        REQUIRE(int(kernel.size()) == count);
        bool inside = true;  // one check a kernel: half a million of them take minutes
        for (const glm::vec3& offset : kernel) {
            inside = inside && (of.first == "cube" || glm::length(glm::dvec3(offset)) <= 1.0);
            for (int i = 0; i < 3; ++i) inside = inside && std::abs(offset[i]) < 1.0f;
            inside = inside && offset.z > lowest;
        }
        REQUIRE(inside);
    }
}

TEST_CASE("a sphere favours no direction and a hemisphere has the mean height of its kernel")
{
    const Kernel of = GENERATE(from_range(allKernels()));
    INFO(of.first << " " << of.second);
    CHECK(glm::length(mean(manyOffsets(false, of))) < 0.02);
    const glm::dvec3 hemisphere = mean(manyOffsets(true, of));
    CHECK(glm::length(glm::dvec2(hemisphere)) < 0.02);
    // Of a ball the mean length 3/4 times the mean cosine 1/2, of a cube half of its upper side. Of
    // rays half of the mean of |z| / |v| over the cube, 0.5156 by numerical integration.
    const std::map<std::string, double> heights = {
        {"ball", 0.375}, {"cube", 0.5}, {"rays", 0.2578}};
    const std::map<std::string, double> ramps = {{"even", 1}, {"linear", 0.55}, {"quadratic", 0.4}};
    CHECK(hemisphere.z == Approx(heights.at(of.first) * ramps.at(of.second)).margin(0.006));
}

TEST_CASE("the ball's kernel fills its volume and the cube reaches its corners")
{
    const std::vector<glm::vec3> ball = manyOffsets(false, {"ball", "even"});
    for (float length : {0.5f, 0.75f, 0.9f})
        CHECK(shareWithin(ball, length) == Approx(std::pow(length, 3)).margin(0.01));
    CHECK(shareWithin(manyOffsets(false, {"cube", "even"}), 1.0f) == Approx(0.5236).margin(0.01));
}

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

TEST_CASE("the first offsets of kernels with a ramp are the near ones")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        const auto quadratic = kernelOf(false, 64, {"rays", "quadratic"}, seed);
        const auto linear = kernelOf(false, 64, {"rays", "linear"}, seed);
        CHECK(glm::length(quadratic[0]) <= 0.1f);
        CHECK(glm::length(linear[0]) <= 0.1f);
        CHECK(glm::length(quadratic[32]) <= 0.325f);
        CHECK(glm::length(linear[32]) <= 0.55f);
    }
}

TEST_CASE("a seed gives the same numbers again and another seed gives others")
{
    for (const Kernel& of : allKernels()) {
        const auto kernel = kernelOf(true, 16, of, 5);
        CHECK(kernel == kernelOf(true, 16, of, 5));
        CHECK(kernel != kernelOf(true, 16, of, 6));
    }
    for (const auto make : {makeRotationNoise, makeVectorNoise}) {
        CHECK(make(4, 1)->pixels == make(4, 1)->pixels);
        CHECK(make(4, 1)->pixels != make(4, 2)->pixels);
    }
}

TEST_CASE("vector noise fills the square with independent vectors")
{
    const Image noise = *makeVectorNoise(kMaxNoiseSize, 3);
    double sum[2] = {}, square[2] = {};
    const int count = kMaxNoiseSize * kMaxNoiseSize;
    for (int i = 0; i < count; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            const double value = noise.pixels[std::size_t(i) * 4 + axis];
            REQUIRE(std::abs(value) < 1.0);
            sum[axis] += value;
            square[axis] += value * value;
        }
    for (int axis = 0; axis < 2; ++axis) {
        CHECK(sum[axis] / count == Approx(0).margin(0.03));
        CHECK(square[axis] / count == Approx(1.0 / 3).margin(0.02));
    }
    CHECK_FALSE(makeVectorNoise(0, 1).ok());
    CHECK_FALSE(makeVectorNoise(kMaxNoiseSize + 1, 1).ok());
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
    const Image vectors = *makeVectorNoise(4, 1);
    CHECK(vectors.at(3, 1, 0) == -0x1.faad18p-3f);
    CHECK(vectors.at(3, 1, 1) == 0x1.a56c7ap-1f);
    const Image noise = *makeRotationNoise(4, 1);
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
        const Result<Image> noise = makeRotationNoise(size, 9);
        REQUIRE(noise.ok());
        CHECK(noise->extent == Extent{size, size});
        CHECK(noise->channels == 4);
        const int count = size * size;
        std::set<int> strata;
        for (int i = 0; i < count; ++i) {
            const float* pixel = &noise->pixels[std::size_t(i) * 4];
            CHECK(std::hypot(double(pixel[0]), double(pixel[1])) == Approx(1.0).margin(1e-6));
            CHECK(pixel[2] == 0.0f);
            CHECK(pixel[3] == 0.0f);
            // The first stratum begins at half a turn.
            strata.insert(int(std::fmod(angleInTurns(*noise, i) + 0.5, 1.0) * count));
        }
        CHECK(int(strata.size()) == count);
    }
}

TEST_CASE("rotation noise is shuffled, not a ramp")
{
    const Image noise = *makeRotationNoise(16, 1);
    double step = 0;
    for (int i = 1; i < 256; ++i) {
        const double turn = std::abs(angleInTurns(noise, i) - angleInTurns(noise, i - 1));
        step += std::min(turn, 1 - turn) / 255;
    }
    CHECK(step == Approx(0.25).margin(0.03));  // what independent directions have
}

TEST_CASE("a generator that is asked for the impossible says what is possible")
{
    for (int count : {-1, 0, kMaxKernelSize + 1}) {
        const auto kernel = makeKernel({true, count, "ball", "even", 1});
        REQUIRE(kernel.diagnostics().size() == 1);
        CHECK(kernel.diagnostics()[0].code == Code::out_of_range);
        CHECK(kernel.diagnostics()[0].message.find("[1, " + std::to_string(kMaxKernelSize) + "]") !=
              std::string::npos);
    }
    for (int size : {-1, 0, kMaxNoiseSize + 1})
        CHECK(makeRotationNoise(size, 1).diagnostics()[0].code == Code::out_of_range);
    const auto kernel = makeKernel({true, 4, "rays", "liner", 1});
    REQUIRE(kernel.diagnostics().size() == 1);
    CHECK(kernel.diagnostics()[0].code == Code::bad_enum);
    CHECK(kernel.diagnostics()[0].help.find("linear") != std::string::npos);
}

TEST_CASE("generators are known by name")
{
    CHECK(generatorNames() == std::vector<std::string>{"sphere_kernel", "hemisphere_kernel",
                                                       "rotation_noise", "vector_noise"});
    CHECK(generatesTexture("rotation_noise"));
    CHECK(generatesTexture("vector_noise"));
    CHECK_FALSE(generatesTexture("sphere_kernel"));
}
