// SPDX-License-Identifier: MIT
// The ray tracer, against closed forms and against itself.
#include "tests/tools/reference/tracer_shot.h"

#include <cstring>
#include <limits>

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Looks straight down: the picture's right is +x, its top is -z; `half` to each side.
Camera fromAbove(float half, const glm::vec3& center = glm::vec3(0.0f))
{
    return {glm::lookAt(center + glm::vec3(0, 20, 0), center, glm::vec3(0, 0, -1)),
            glm::ortho(-half, half, -half, half, 1.0f, 30.0f)};
}

Camera perspective(const glm::mat4& clip_from_view)
{
    const glm::vec3 eye = {1, 2, 3}, at = {0, 0.3f, 0}, up = {0, 1, 0};
    return {glm::lookAt(eye, at, up), clip_from_view};
}

const glm::mat4 kLens = glm::perspective(0.9f, 1.0f, 0.1f, 100.0f);

Image trace(const Scene& scene, const Camera& camera, Extent extent, double radius, int rays)
{
    TraceOptions options;
    options.radius = radius;
    options.rays = rays;
    const auto image = traceAmbientOcclusion(scene, camera, extent, options);
    INFO(toText(image.diagnostics()));
    REQUIRE(image.ok());
    return *image;
}

bool sameBits(const Image& a, const Image& b)
{
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

/// Over as many columns as `a` has.
double meanDifference(const Image& a, const Image& b)
{
    double sum = 0;
    for (int y = 0; y < a.extent.height; ++y)
        for (int x = 0; x < a.extent.width; ++x) sum += std::abs(a.at(x, y) - b.at(x, y));
    return sum / static_cast<double>(a.pixels.size());
}

Scene cornerWithSphere()
{
    Scene scene = sceneOf({kFloor, kWall, makeSphere(0.5f, 24)});
    scene.instances[2].world_from_model = glm::translate(glm::mat4(1), {0.2f, 0.5f, 0.8f});
    return scene;
}

}  // namespace

TEST_CASE("an inner corner darkens by the closed form")
{
    // Cosine-weighted directions are even on the unit disc; those that reach the wall within the
    // radius are the segment beyond distance / radius.
    constexpr double kRadius = 2.0;
    const Scene scene = sceneOf({kFloor, kWall});
    const Image image = trace(scene, fromAbove(2, {0, 0, 2}), {4, 32}, kRadius, 4096);
    for (int y = 0; y < 32; ++y) {
        const double distance = 2.0 - (2.0 * (y + 0.5) / 32 - 1.0) * 2.0;
        const double part = std::min(distance / kRadius, 1.0);
        const double expected = 1.0 - (std::acos(part) - part * std::sqrt(1 - part * part)) / kPi;
        for (int x = 0; x < 4; ++x) CHECK(image.at(x, y) == Approx(expected).margin(0.003));
    }
}

TEST_CASE("what sees no surface is not a number")
{
    const Image image = trace(sceneOf({makeSphere(1, 16)}), fromAbove(2), {16, 16}, 1, 4);
    CHECK(std::isnan(image.at(0, 0)));
    CHECK(image.at(8, 8) == 1.0f);
}

TEST_CASE("the picture does not depend on the number of threads or on the run")
{
    TraceOptions options;
    options.rays = 16;
    options.threads = 1;
    const Scene scene = cornerWithSphere();
    const auto alone = traceAmbientOcclusion(scene, perspective(kLens), {32, 32}, options);
    options.threads = 3;
    const auto shared = traceAmbientOcclusion(scene, perspective(kLens), {32, 32}, options);
    REQUIRE(alone.ok());
    REQUIRE(shared.ok());
    CHECK(sameBits(*alone, *shared));
}

TEST_CASE("a radius of zero leaves every surface open, and more radius never opens it")
{
    const Scene scene = cornerWithSphere();
    Image last = trace(scene, perspective(kLens), {24, 24}, 0, 64);
    for (const float value : last.pixels) CHECK(value == 1.0f);
    for (const double radius : {0.1, 0.5, 2.0, 8.0}) {
        const Image image = trace(scene, perspective(kLens), {24, 24}, radius, 64);
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
            CHECK(image.pixels[k] <= last.pixels[k] + 1.5f / 64);
        last = image;
    }
}

TEST_CASE("reversed depth, an infinite far plane and a shifted lens see the same")
{
    const Scene scene = cornerWithSphere();
    const Image image = trace(scene, perspective(kLens), {32, 32}, 1, 64);
    const auto off = [&](const glm::mat4& lens, Extent extent) {
        return meanDifference(trace(scene, perspective(lens), extent, 1, 64), image);
    };
    const glm::mat4 reversed = glm::scale(glm::mat4(1), {1, 1, -1});
    const glm::mat4 infinite = glm::infinitePerspective(0.9f, 1.0f, 0.1f);
    CHECK(off(reversed * kLens, {32, 32}) < 0.002);
    CHECK(off(infinite, {32, 32}) < 0.002);
    CHECK(off(reversed * infinite, {32, 32}) < 0.002);
    const float top = 0.1f * std::tan(0.45f);
    CHECK(off(glm::frustum(-top, 0.0f, -top, top, 0.1f, 100.0f), {16, 32}) < 0.002);  // left half
}

TEST_CASE("noise is about what docs/reference/bench.md says of each number of rays")
{
    const Scene scene = cornerWithSphere();
    const Image exact = trace(scene, perspective(kLens), {24, 24}, 1, 8192);
    const std::pair<int, double> rows[] = {
        {64, 0.014}, {128, 0.008}, {256, 0.005}, {512, 0.003}, {1024, 0.002}};
    for (const auto& [rays, limit] : rows) {
        const Image image = trace(scene, perspective(kLens), {24, 24}, 1, rays);
        double sum = 0;
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
            sum += std::pow(image.pixels[k] - exact.pixels[k], 2.0);
        const double noise = std::sqrt(sum / static_cast<double>(image.pixels.size()));
        CHECK(noise <= limit * 1.25);
        CHECK(noise >= limit / 2);
    }
}

TEST_CASE("options and cameras that cannot be traced are refused")
{
    const auto codeOf = [](const Camera& camera, Extent extent, double radius, int rays) {
        TraceOptions options;
        options.radius = radius;
        options.rays = rays;
        const auto image = traceAmbientOcclusion(sceneOf({kFloor}), camera, extent, options);
        return image.ok() ? Code::internal : image.diagnostics()[0].code;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(codeOf(fromAbove(1), {4, 4}, -1, 4) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, nan, 4) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, 1, 0) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, 1, kMaxTraceRays + 1) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {0, 4}, 1, 4) == Code::bad_size);
    CHECK(codeOf({glm::mat4(1), glm::mat4(0)}, {4, 4}, 1, 4) == Code::bad_input);
}

TEST_CASE("progress ends at one")
{
    TraceOptions options;
    options.rays = 1;
    options.threads = 1;
    double last = 0;
    options.progress = [&](double done) {
        CHECK(done > last);
        last = done;
    };
    REQUIRE(traceAmbientOcclusion(sceneOf({kFloor}), fromAbove(1), {4, 9}, options).ok());
    CHECK(last == 1.0);
}
